// SPDX-License-Identifier: MIT
// What a backend refuses before it begins: options that exclude each other, or that it lacks.
#pragma once

#include "common/backend/backend.h"

namespace spherepair {

// Throws std::invalid_argument for options that exclude each other.
void check_collide(const CollideOptions& options);

// Throws std::invalid_argument naming the API option that is wanted and not offered; `thrust`: the sort of a
// library is.
void refuse_missing(const std::string& backend, const CollideOptions& options, const ApiOptions& offered, bool thrust);

// Throws std::invalid_argument for a method that needs tensor cores, which the backend does not offer.
void refuse_tensor(const std::string& backend, const CollideOptions& options, bool offered);

// Throws std::invalid_argument unless each of n spheres has an entry of the palette.
void check_classes(const std::string& backend, std::span<const uint> classes, uint64_t n);

// Throws BackendError when `anchored` has done as many steps as it can count.
void check_steps(const std::string& backend, uint steps);

}  // namespace spherepair
