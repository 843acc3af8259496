// SPDX-License-Identifier: MIT
// Draws the letters of images: DejaVu Sans as font.py has drawn it, embedded in the program.
#pragma once

#include <string>

#include "common/image/canvas.h"

namespace spherepair {

// Pixels from the left of the first letter to the start of a next one. size: pixels of an em.
double text_width(const std::string& utf8, double size);

// Draws from the left end of the baseline. A letter that the font lacks becomes a question mark.
void draw_text(Canvas& canvas, const std::string& utf8, Point baseline, double size, uint colour);

}  // namespace spherepair
