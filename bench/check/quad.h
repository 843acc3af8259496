// SPDX-License-Identifier: MIT
// Quadruple precision for references; separate, because this header takes long to compile.
#pragma once

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "common/scene/scene.h"

namespace spherepair {

using Quad = boost::multiprecision::cpp_bin_float_quad;

// A centre or a displacement: x, y, z in metres.
using QuadPoint = std::array<Quad, 3>;

// Centre of sphere i in the closed form (closed_form.h) after so many steps of scene.dt.
QuadPoint closed_form_position(const Scene& scene, uint64_t i, uint64_t steps);

}  // namespace spherepair
