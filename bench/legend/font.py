#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws font.png, the letters of images: DejaVu Sans, as matplotlib brings it. Run it after a change of `LETTERS`.

The letters are side by side, in the order of `LETTERS`. The first row of pixels is white where a letter's box begins;
the box is as wide as the letter's advance."""

import pathlib

import matplotlib
import numpy
from matplotlib.ft2font import FT2Font, FT2Image
from PIL import Image

LETTERS = "".join(map(chr, range(32, 127))) + "·×–≥²³µÅ"  # as in font.cpp
EM, ASCENT, DESCENT = 48, 47, 13  # pixels, as in font.cpp


def column(font, letter):
    font.set_size(EM, 72)
    glyph = font.load_char(ord(letter))
    width = round(glyph.linearHoriAdvance / 65536)
    image = FT2Image(2 * width + EM, 2 * EM)
    x, top = max(glyph.bbox[0] // 64, 0), -(-glyph.bbox[3] // 64)
    font.draw_glyph_to_bitmap(image, EM // 2 + x, ASCENT - top, glyph, antialiased=True)
    return numpy.asarray(image)[: ASCENT + DESCENT, EM // 2 : EM // 2 + width]


def main():
    folder = pathlib.Path(matplotlib.get_data_path()) / "fonts" / "ttf"
    font = FT2Font(str(folder / "DejaVuSans.ttf"))
    columns = [column(font, letter) for letter in LETTERS]
    marks = [numpy.eye(1, c.shape[1], dtype=numpy.uint8) * 255 for c in columns]
    pixels = numpy.vstack([numpy.hstack(marks), numpy.hstack(columns)])
    Image.fromarray(pixels.astype(numpy.uint8)).save(pathlib.Path(__file__).with_name("font.png"), optimize=True)


main()
