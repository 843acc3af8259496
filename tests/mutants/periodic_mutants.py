# SPDX-License-Identifier: MIT
"""Deliberate faults in periodic boxes of contacts."""
from mutant import mutant

NEAREST = "common/shared/contact/periodic.h"
PERIODIC = [
    mutant("no image is nearest in integers", NEAREST, "twice < -period ? way + period : way", "way", "PeriodicContacts"),
    mutant("no image is nearest in float32", NEAREST, "way < -half_period ? 1 : 0", "0", "PeriodicContacts", "ContactFilter"),
    mutant("centres leave the box below", NEAREST, "at < low ? at + (high - low) : at", "at", "PeriodicContacts"),
    mutant("no image beyond a lower face", NEAREST, "return (low & axes) | ((high & axes) << 3);", "return low & axes;", "PeriodicContacts", "ContactFilter"),
    mutant("an image is needed only if all faces are near", NEAREST, "(needed & faces) == needed", "needed == faces", "PeriodicContacts", "ContactFilter"),
    mutant("images are made of both a direction and its opposite", NEAREST, "#define FIRST_IMAGE 14u", "#define FIRST_IMAGE 0u", "PeriodicContacts", "ContactFilter"),
    mutant("walls stand at periodic faces", "common/shared/contact/contact.h", "uint axes = 7u - periodic_axes(c);", "uint axes = 7u;", "PeriodicContacts"),
    mutant("rounding of images is left out", "common/scene/contact_scene.cpp", "return 5 * 0x1p-24 * sum;", "return 0 * sum;", "ContactFilter"),
    mutant("pairs across faces take the wrong corner", "common/shared/contact/image_pair.h", "uint add = float_bits(shift > 0 ? high : low);", "uint add = float_bits(high);", "PeriodicSearches"),
    mutant("cpu: pairs of two images push twice", "common/cpu/cpu_contacts.cpp", "return pair.first >= n; });", "return false && pair.first >= n; });", "PeriodicContacts"),
    mutant("glsl: an image is another sphere's", "shaders/contact/contact_images.comp", "image_of[1u + pair.y - p.n]", "image_of[pair.y - p.n]", "PeriodicContacts"),
    mutant("devices: images have no more room than at first", "common/simulation/contacts.cpp", "if (images <= capacity) return context_.n + images;", "if (images <= capacity || capacity) return context_.n + std::min(images, capacity);", "PeriodicContacts"),
    mutant("a box shorter than two reaches is taken", "common/scene/contact_check.cpp", "!(period > least)", "false", "PeriodicChecks"),
    mutant("a centre on the upper face stays there", "common/scene/contact_box.cpp", "at < box.high[axis])) return at;", "at <= box.high[axis])) return at;", "PeriodicChecks"),
    mutant("cpu: a search ends a run", "common/cpu/cpu_contacts.cpp", "  failed_.faults = faults;\n", "", "PeriodicChecks"),
    mutant("a resumed box does not repeat", "common/files/checkpoint.cpp", ".periodic = c.walls >> 1,", ".periodic = 0,", "PeriodicProgram"),
]
