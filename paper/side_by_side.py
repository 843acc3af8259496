# SPDX-License-Identifier: MIT
"""One HTML page with the figures and tables of several machines side by side, the verdict of each first."""
import html

STYLE = """
:root{color-scheme:light dark}
body{font:16px/1.5 sans-serif;margin:0 auto;padding:1rem;max-width:100rem}
h1{font-size:1.5rem}h2{font-size:1.2rem;margin-top:2.5rem;border-bottom:1px solid #8888}
.pair{display:grid;gap:1rem;grid-template-columns:repeat(auto-fit,minmax(min(100%,10rem),1fr))}
.pair>*{min-width:0;margin:0;overflow-x:auto}
img{max-width:100%;height:auto;background:#fff}
pre{font-size:.75rem;line-height:1.35;overflow-x:auto;padding:.5rem;border:1px solid #8888}
figcaption,.machine{font-weight:bold;margin-bottom:.5rem}
ul{padding-left:1.2rem}li,p,figcaption{overflow-wrap:anywhere}
"""


def words(text):
    return html.escape(text)


def verdict(machine):
    """What the run found, as compare's last lines say it."""
    root = machine.main
    made = {kind: sum(counts[kind]["made"] for counts in root.get("comparisons", {}).values() if kind in counts)
            for kind in ("sets", "states")}
    lines = [f"verdict: {root.get('verdict', 'not recorded')}"]
    if any(made.values()):
        lines.append(f"{made['sets']} sets and {made['states']} states compared with the reference")
    lines += [root["apis"]] if "apis" in root else []
    lines += [f"{backend['name']}: " + (backend["device"] + (" (software)" if backend.get("software") else "")
                                        if backend.get("open", True) else f"missing, {backend['reason']}")
              for backend in root.get("backends", [])]
    lines += root.get("warnings", [])
    return lines


def items(lines):
    return f"<ul>{''.join(f'<li>{words(line)}</li>' for line in lines)}</ul>"


def shown(folder, machine, name, kind):
    """The figure or table of one machine; empty if it was not made."""
    file = folder / machine.name / f"{name}.{kind}"
    if not file.exists():
        return ""
    source = f"{words(machine.name)}/{name}.png"
    body = (f'<a href="{source}"><img loading="lazy" src="{source}" alt="{name}, {words(machine.title)}"></a>'
            if kind == "png" else f"<pre tabindex=0>{words(file.read_text())}</pre>")
    return f"<figure><figcaption>{words(machine.title)}</figcaption>{body}</figure>"


def section(folder, machines, name, kind, caption):
    made = [text for text in (shown(folder, machine, name, kind) for machine in machines) if text]
    if not made:
        return ""
    heading, _, rest = caption.partition(". ")
    return (f'<section id="{name}"><h2>{words(heading.rstrip("."))}</h2>' + (f"<p>{words(rest)}</p>" if rest else "") +
            f'<div class=pair>{"".join(made)}</div></section>')


def write(folder, machines, figures, tables, reasons, captions):
    """reasons: (machine, name) -> why it is left out; captions: name -> the heading of its section."""
    names = {machine.name: machine.title for machine in machines}
    sections = [section(folder, machines, name, kind, captions.get(name, name))
                for kind, all_names in (("png", figures), ("txt", tables)) for name in all_names]
    left_out = [f"{name}, {names[machine]}: {reason}" for (machine, name), reason in sorted(reasons.items())]
    heads = "".join(f"<div><div class=machine>{words(machine.title)}</div>{items(verdict(machine))}</div>"
                    for machine in machines)
    rest = f"<section id=left-out><h2>Left out</h2>{items(left_out)}</section>" if left_out else ""
    title = "spherepair: recorded runs side by side"
    page = folder / "index.html"
    page.write_text(f'<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content="width=device-width">'
                    f"<title>{title}</title><style>{STYLE}</style><h1>{title}</h1>"
                    f"<section id=verdict><div class=pair>{heads}</div></section>{''.join(sections)}{rest}</html>")
    return page
