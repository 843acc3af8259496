// SPDX-License-Identifier: MIT
// GLSL only: the view as plain uniforms, which are sent with the commands; a uniform block that changes with every
// frame and phase would be fetched from the host's memory. CUDA passes a kernel argument.
#include "common/shared/view.h"

layout(location = VIEW_LOCATION) uniform uvec4 view_words[VIEW_FOURS];

vec4 view_reals(uint k) { return uintBitsToFloat(view_words[k]); }

View v =
    View(view_reals(0u), view_reals(1u), view_reals(2u), view_reals(3u), view_reals(4u), view_reals(5u),
         view_reals(6u).x, view_reals(6u).y, view_reals(6u).z, view_reals(6u).w, view_reals(7u).x, view_reals(7u).y,
         view_reals(7u).z, view_reals(7u).w, view_words[8], view_words[9], view_words[10].x, view_words[10].y,
         view_words[10].z, view_words[10].w, view_words[11].x, view_words[11].y, view_words[11].z, view_words[11].w,
         view_words[12].x, view_words[12].y, view_words[12].z, view_words[12].w, view_reals(13u), view_reals(14u).x,
         view_reals(14u).y, view_reals(14u).z, view_words[14].w, view_reals(15u));
