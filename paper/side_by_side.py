# SPDX-License-Identifier: MIT
"""One HTML page with the figures and tables of several machines side by side."""
import html

STYLE = ("body{font-family:sans-serif;margin:2em;max-width:110em}table{border-collapse:collapse}"
         "td{vertical-align:top;padding:0 2em 2em 0;max-width:54em}img{max-width:100%}"
         "pre{font-size:75%;overflow-x:auto}")


def cell(folder, machine, name, kind, reason):
    file = folder / machine.name / f"{name}.{kind}"
    if not file.exists():
        return f"<p>{name} is left out: {html.escape(reason)}</p>"
    if kind == "png":
        return f'<img src="{html.escape(machine.name)}/{name}.png" alt="{name}, {html.escape(machine.title)}">'
    return f"<pre>{html.escape(file.read_text())}</pre>"


def write(folder, machines, figures, tables, reasons):
    """reasons: (machine, name) -> why it is left out."""
    rows = ["<tr>" + "".join(f"<th>{html.escape(machine.title)}</th>" for machine in machines) + "</tr>"]
    for kind, names in (("png", figures), ("txt", tables)):
        for name in names:
            cells = (cell(folder, machine, name, kind, reasons.get((machine.name, name), "not recorded"))
                     for machine in machines)
            rows.append(f"<tr>{''.join(f'<td>{text}</td>' for text in cells)}</tr>")
    page = folder / "index.html"
    title = "spherepair: recorded runs side by side"
    page.write_text(f"<!doctype html><meta charset=utf-8><title>{title}</title><style>{STYLE}</style>"
                    f"<h1>{title}</h1><table>{''.join(rows)}</table>")
    return page
