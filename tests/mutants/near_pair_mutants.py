# SPDX-License-Identifier: MIT
"""Deliberate faults in what is done with near pairs: sums of impulses, their study, and contacts between steps."""
from mutant import mutant

NEAR_PAIRS = [
    mutant("glsl: rows of near pairs stay unsorted", "shaders/contact/contact_order.comp", "k < length", "k < min(length, 1u)",
           "SumsOfImpulses"),
    mutant("glsl: rows hold one sphere of a pair", "shaders/contact/contact_rows.comp", "join_row(near[k].y, near[k].x);", "",
           "SumsOfImpulses"),
    mutant("rows that are too short stay so", "common/simulation/contacts.cpp", "fill(longest);", "static_cast<void>(longest);",
           "SumsOfImpulses"),
    mutant("sums in order without rows", "common/simulation/contacts.cpp", "made_ = false;  // sums in order need rows", "",
           "SumsOfImpulses"),
    mutant("cpu: float sums are kept", "common/cpu/cpu_contacts.cpp", "std::exchange(float_sums_[k], 0.0f)", "float_sums_[k]",
           "SumsOfImpulses"),
    mutant("glsl: float sums are kept", "shaders/contact/contact_state.glsl", "if (sum != 0.0f) impulse[k].of[i] = 0.0f;", "",
           "SumsOfImpulses"),
    mutant("momentum is no change", "bench/studies/contact_errors.cpp", "word(wide, k) - word(start, k)", "word(wide, k)",
           "ContactStudy"),
    mutant("the way back goes on", "bench/studies/contact_errors.cpp", "-word(later, k)", "word(later, k)", "ContactStudy"),
    mutant("time steps of a study are all alike", "bench/studies/contact_errors.cpp", "* (steps_a_contact / coarsest)", "* 1",
           "ContactStudy"),
    mutant("one sphere alone pushes", "common/scene/contact/contact_law.cpp", "greatest_number(largest / b, width) * impulse", "impulse",
           "ContactBounds"),
    mutant("any sum of impulses is in range", "common/scene/contact_scene.cpp", "if (!(sum < most_units))", "if (false)", "ContactBounds"),
    mutant("paths are points", "common/backend/swept_paths.cpp", "std::sqrt(std::max(before, behind))", "0", "Swept"),
    mutant("spheres around paths lack their margin", "common/backend/swept_paths.cpp", "* (1 + 0x1p-17)", "* (1 - 0x1p-6)", "Swept"),
    mutant("a path beyond float32 is searched", "common/backend/swept_paths.cpp", "if (lost < n)", "if (false)", "Swept"),
    mutant("glsl: the last path is left out", "shaders/collide/collide_swept.comp", "k < p.search.near_pairs",
           "k + 1u < p.search.near_pairs", "Swept"),
    mutant("contacts keep a list of paths", "common/simulation/simulation.cpp", "contacts_.forget_list();", "", "Swept"),
]
