# SPDX-License-Identifier: MIT
"""Numbers and words as the tables and the prose show them."""
import re


APIS = {"cpu": "CPU", "opengl": "OpenGL", "opengl-core": "OpenGL without extensions", "opengl-spirv": "OpenGL from SPIR-V", "vulkan": "Vulkan", "cuda": "CUDA"}  # of backends


def ms(value):
    """Three significant digits, never an exponent."""
    if value is None:
        return "-"
    digits = max(0, 2 - int(f"{value:e}".split("e")[1]))
    return f"{value:.{digits}f}" if value else "0"


def interval(record, scale=1):
    """Median and the interval of the median, in milliseconds times `scale`."""
    return f"{ms(scale * record.median)} [{ms(scale * record.low)}, {ms(scale * record.high)}]"


def cached(text, records):
    """With a mark if the working sets of all these fit in the L2 cache, which some records do not tell."""
    return text + "†" if records and all(record.parameters.get("fits_l2") for record in records) else text


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
