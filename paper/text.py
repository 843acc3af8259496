# SPDX-License-Identifier: MIT
"""Numbers and words as the tables and the prose show them."""
import re


def ms(value):
    """Three significant digits, never an exponent."""
    if value is None:
        return "-"
    digits = max(0, 2 - int(f"{value:e}".split("e")[1]))
    return f"{value:.{digits}f}" if value else "0"


def interval(record, scale=1):
    """Median and the interval of the median, in milliseconds times `scale`."""
    return f"{ms(scale * record.median)} [{ms(scale * record.low)}, {ms(scale * record.high)}]"


def escape(text):
    """For LaTeX, except what is LaTeX already: a thin space and a percent sign."""
    for plain, safe in (("\\,", "\0"), ("\\%", "\1"), ("\\", ""), ("%", "\\%"), ("_", "\\_"), ("&", "\\&"),
                        ("#", "\\#"), ("^", "\\textasciicircum{}")):
        text = text.replace(plain, safe)
    return text.replace("\0", "\\,").replace("\1", "\\%")


def plain(text):
    """The same without LaTeX's marks."""
    bare = re.sub(r"\$|\\[a-z]+\{([^}]*)\}", r"\1", text.replace("\\,", " ").replace("\\%", "%"))
    return bare.replace("~", " ")
