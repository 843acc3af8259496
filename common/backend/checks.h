// SPDX-License-Identifier: MIT
// Checks that refuse options which exclude each other or which a backend lacks.
#pragma once

#include "common/backend/collide_options.h"

namespace spherepair {

// Throws std::invalid_argument for options that exclude each other.
void check_collide(const CollideOptions& options);

// Throws std::invalid_argument for searches that a periodic box does not have.
void check_images(const CollideOptions& options);

// Throws std::invalid_argument that names an API option which `options` asks for and `offered` lacks. thrust: whether
// the backend has the radix sort of Thrust.
void refuse_missing(const std::string& backend, const CollideOptions& options, const ApiOptions& offered, bool thrust);

// Throws std::invalid_argument if the method needs tensor cores and the backend does not offer them.
void refuse_tensor(const std::string& backend, const CollideOptions& options, bool offered);

// Throws std::invalid_argument unless `classes` has n entries, each an index into the palette.
void check_classes(const std::string& backend, std::span<const uint> classes, uint64_t n);

// Throws BackendError when `anchored` has done as many steps as it can count.
void check_steps(const std::string& backend, uint steps);

}  // namespace spherepair
