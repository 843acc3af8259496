// SPDX-License-Identifier: MIT
// The letters of images: DejaVu Sans as font.py has drawn it, embedded in the program.
#pragma once

#include <string>

#include "bench/legend/canvas.h"

namespace spherepair {

// Pixels from the left of the first letter to where another would follow; size: of an em.
double text_width(const std::string& utf8, double size);

// From the left end of the baseline. A letter that the font lacks is a question mark.
void draw_text(Canvas& canvas, const std::string& utf8, Point baseline, double size, uint colour);

}  // namespace spherepair
