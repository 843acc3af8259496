# SPDX-License-Identifier: MIT
"""A table of the paper as HTML."""
import html
import re

from paper.text import plain


def rich(text):
    """With powers as such: 10^6, 2^{-6}."""
    return re.sub(r"(?<![\w.])(\d+)\^\{?(-?\d+)\}?", r"<span>\1<sup>\2</sup></span>", html.escape(text))


def cell(text):
    return rich(plain(text))


def as_html(table):
    kinds = ["" if k < table.left else " class=n" for k in range(len(table.heads[1]))]
    groups = "".join(f"<th colspan={width}{' class=g' if text else ''}>{cell(text)}</th>" for text, width in table.heads[0])
    lines = [f"<tr>{groups}</tr>"] if any(text for text, _ in table.heads[0]) else []
    lines.append("<tr>" + "".join(f"<th{kind} scope=col>{cell(name)}</th>" for kind, name in zip(kinds, table.heads[1])) + "</tr>")
    rows = ("<tr>" + "".join(f"<td{kind}>{cell(text)}</td>" for kind, text in zip(kinds, row)) + "</tr>" for row in table.rows)
    return f"<table><thead>{''.join(lines)}</thead><tbody>{''.join(rows)}</tbody></table>"
