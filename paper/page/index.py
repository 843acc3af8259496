# SPDX-License-Identifier: MIT
"""The HTML of the page."""
import html
import shutil
from pathlib import Path

import matplotlib

from paper.page import contents
from paper.page.html_table import rich

STYLE = (Path(__file__).parent / "style.css").read_text()
FONTS = ("STIXGeneral.ttf", "STIXGeneralBol.ttf")  # of the figures
LONG = 20  # rows of a table that scrolls
KICKER = "spherepair: the same particle work through OpenGL compute shaders (GLSL) and through CUDA"


def words(text):
    return html.escape(text)


def paragraphs(lines, kind=""):
    return "".join(f"<p{f' class={kind}' if kind else ''}>{words(line)}</p>" for line in lines)


def who(report):
    return f"{'Recorded' if report.recorded else 'This machine'}: {report.device}"


def body_of(report, item):
    if item.table:
        kind = "scroll long" if item.table.count("<tr>") > LONG else "scroll"
        return f'<div class="{kind}" tabindex=0>{item.table}</div>'
    source, (width, height) = f"{words(report.name)}/{words(item.name)}.png", item.size
    return (f'<div class="scroll card" tabindex=0><a href="{source}"><img loading=lazy src="{source}" width={width} height={height} '
            f'style="--width:{width}px" alt="{words(contents.title_of(item.name))}, {words(who(report))}"></a></div>')


def shown(report, item, caption):
    """One machine's figure or table, with what is said of it below."""
    said = f"<figcaption>{rich(caption)}</figcaption>" if caption else ""
    made = "Rendered beforehand" if item.rendered else who(report)
    return (f"<figure><details><summary>{words(made)}</summary>{words(item.source)}</details>"
            f"{body_of(report, item)}{said}</figure>")


def section(reports, name):
    """A figure or table of every machine that has it; a caption that is the same for all is given once, below."""
    found = [(report, item) for report in reports if (item := report.item(name))]
    found = found[:1] if name in contents.OF_NO_MACHINE else found
    captions = list(dict.fromkeys(item.caption for _, item in found if item.caption))
    each = "".join(shown(report, item, item.caption if len(captions) > 1 else "") for report, item in found)
    below = f"<p class=caption>{rich(captions[0])}</p>" if len(captions) == 1 else ""
    return (f'<section id="{name}"><h3><a href="#{name}">{words(contents.title_of(name))}</a></h3>'
            f"<div class=machines>{each}</div>{below}</section>")


def groups_of(reports):
    """group -> its names that some machine has, without those of the head."""
    made = {item.name for report in reports for item in report.items}
    groups = {group: [name for name in titles if name in made] for group, titles in contents.GROUPS.items()}
    groups["Others"] = sorted(made.difference(*groups.values()))
    return {group: names for group, found in groups.items() if (names := [name for name in found if name not in contents.HEAD])}


def anchor(group):
    return group.lower().replace(" ", "-")


def contents_list(groups):
    def entry(group, names):
        links = "".join(f'<li><a href="#{name}">{words(contents.title_of(name))}</a></li>' for name in names)
        return f'<section><p><a href="#{anchor(group)}">{words(group)}</a></p><ul>{links}</ul></section>'

    return f"<nav aria-label=Contents>{''.join(entry(*group) for group in groups.items())}</nav>"


def verdict(reports):
    """Lines that end ./reproduce and head the page: (in words, with ratios, of this machine)."""
    here = [report for report in reports if not report.recorded]
    answering = next((report for report in (*here, *reports) if report.answer), None)
    in_words, ratios = answering.answer if answering else ("No run here compares OpenGL with CUDA on a GPU.", "")
    of_here = [line for report in here for line in (report.equal, *([] if report.answer else [report.why_not]))]
    return in_words, ratios, of_here or [f"{report.device}. {report.equal}" for report in reports]


def head(reports):
    in_words, ratios, of_here = verdict(reports)
    chosen = sorted(reports, key=lambda report: report.recorded)  # this machine's, if it has them
    first = [next(([report] for report in chosen if report.item(name)), []) for name in contents.HEAD]
    warnings = [line for report in reports if not report.recorded for line in report.warnings]
    return (f"<header><p class=kicker>{words(KICKER)}</p><h1>{words(in_words)}</h1>"
            f"<p class=lead>{words(ratios)}</p><div class=here>{paragraphs(of_here)}{paragraphs(warnings, 'warning')}</div></header>"
            + "".join(section(found, name) for name, found in zip(contents.HEAD, first) if found))


def foot(reports):
    """The devices of each run, and what is missing: a line a reason."""
    devices = "".join(f"<p><b>{words(who(report))}</b></p>{paragraphs([report.equal, *report.backends])}" for report in reports)
    lines = [line if len(reports) == 1 else f"{who(report)}. {line}" for report in reports
             for line in contents.left_out(report.left_out, report.compares_apis)]
    missing = f'<h2 id=left-out>Left out</h2><div class=small>{paragraphs(lines)}</div>' if lines else ""
    return f"{missing}<h2 id=devices>Devices</h2><div class=small>{devices}</div>"


def page_of(reports):
    groups = groups_of(reports)
    sections = "".join(f'<h2 id="{anchor(group)}">{words(group)}</h2>' + "".join(section(reports, name) for name in names)
                       for group, names in groups.items())
    return ("<!doctype html><html lang=en><meta charset=utf-8><meta name=viewport content='width=device-width,initial-scale=1'>"
            f"<title>OpenGL or CUDA: spherepair</title><style>{STYLE}</style>"
            f"<main>{head(reports)}<h2 id=contents>Contents</h2>{contents_list(groups)}{sections}{foot(reports)}</main></html>")


def write(folder, reports):
    """Writes the page, the figures' fonts, and the verdict as text."""
    (folder / "fonts").mkdir(parents=True, exist_ok=True)
    for font in FONTS:
        shutil.copy(Path(matplotlib.get_data_path(), "fonts/ttf", font), folder / "fonts")
    in_words, ratios, of_here = verdict(reports)
    (folder / "verdict.txt").write_text("\n".join([*of_here, f"OpenGL or CUDA: {in_words} {ratios}".strip()]) + "\n")
    page = folder / "index.html"
    page.write_text(page_of(reports))
    return page
