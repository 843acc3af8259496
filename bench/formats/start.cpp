// SPDX-License-Identifier: MIT
#include "bench/formats/start.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/io/scene_text.h"
#include "bench/spheres/sphere_file.h"
#include "common/files/checkpoint.h"
#include "common/scene/counted.h"

namespace spherepair {

namespace {

bool is_changed(const MotionChoice& motion) {
  return motion.dt || motion.restitution || motion.gravity || motion.drag || motion.contact.stiffness;
}

// Continues the checkpoint's run or, with other parameters, begins a new run from its spheres.
Start start_from_checkpoint(const std::string& file, const MotionChoice& motion) {
  Checkpoint saved = read_checkpoint(file);
  const json record = {{"file", file}, {"n", saved.scene.size()}, {"step", saved.step}};
  const std::string label = fmt::format("{} from step {}", saved.scene.name, saved.step);
  if (!is_changed(motion)) return {std::move(saved.scene), label, "", record, std::move(saved.motion), saved.step};
  Scene& scene = saved.scene;
  const bool contacts = scene.contact.law != ContactLaw::none;
  if (!contacts && (motion.drag || motion.contact.stiffness))
    throw std::invalid_argument(
        fmt::format("{} is of a run without contacts: omit {}", file, motion.drag ? "--drag" : "--stiffness"));
  choose_time(scene, motion);
  choose_contacts(scene, changed_contacts(scene, motion));
  const std::string note =
      fmt::format("A new run with other parameters, from step {} of {}: it counts its steps and its time from 0\n",
                  saved.step, file);
  return {std::move(scene), label, note, record};
}

// Lowers the plane below all spheres: motion would lift spheres that begin below it.
void lower_plane(Scene& scene) {
  float lowest = 0;
  for (const vec4& sphere : scene.positions) lowest = std::min(lowest, sphere.y - sphere.w);
  if (lowest < scene.plane) scene.plane = std::max(std::floor(lowest) - 1, -std::numeric_limits<float>::max());
}

// Raises a plane that is too far below very small spheres with contacts. Units of length must reach from the plane to
// the farthest sphere: with a plane metres below spheres of a micrometre they are too coarse for overlaps. The plane
// then lies below the spheres by their own extent.
void raise_plane(Scene& scene, const ContactChoice& contact) {
  if (contact.law == ContactLaw::none || scene.positions.empty() || units_are_fine(scene)) return;
  vec4 low = {INFINITY, INFINITY, INFINITY, 0}, high = {-INFINITY, -INFINITY, -INFINITY, 0};
  for (const vec4& s : scene.positions) {
    low = {std::min(low.x, s.x - s.w), std::min(low.y, s.y - s.w), std::min(low.z, s.z - s.w), 0};
    high = {std::max(high.x, s.x + s.w), std::max(high.y, s.y + s.w), std::max(high.z, s.z + s.w), 0};
  }
  scene.plane = low.y - std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

// Refuses spheres that reach below the plane. With contacts they may press into it, but their centres must be above.
void take_plane(Scene& scene, float plane, bool contacts) {
  scene.plane = plane;
  if (scene.positions.empty()) return;
  const auto bottom = [&](uint64_t i) { return double(scene.positions[i].y) - double(scene.positions[i].w); };
  const uint64_t i = sphere_with_most(scene, [&](uint64_t k) { return -bottom(k); });
  if (bottom(i) >= double(plane) || (contacts && scene.positions[i].y > plane)) return;
  float lower = float(bottom(i));
  if (double(lower) > bottom(i)) lower = std::nextafter(lower, -INFINITY);
  throw std::invalid_argument(
      fmt::format("sphere {} reaches down to y = {}, below the plane: give --plane {} or less", i, bottom(i), lower));
}

// Takes the file's box if it is periodic, or if --walls closes it.
ContactChoice contacts_of(const SphereFile& input, const MotionChoice& motion) {
  ContactChoice contact = contact_choice(motion);
  if (contact.law == ContactLaw::none || !input.box) return contact;
  if (contact.box && input.box->periodic)
    throw std::invalid_argument(fmt::format(
        "{} has a periodic box: omit --box, or read the file as if it had none with --ignore-periodic", input.file));
  if (contact.box) return contact;
  if (!contact.walls && !contact.periodic && !input.box->periodic) return contact;
  if (motion.plane && (contact.walls || (contact.periodic | input.box->periodic) & 2))
    throw std::invalid_argument(fmt::format("{} has a box, whose floor is at y = {}: omit --plane{}", input.file,
                                            input.box->low[1], contact.walls ? ", or --walls" : ""));
  contact.box = input.box;
  return contact;
}

Start start_from(SphereFile input, const MotionChoice& motion) {
  const ContactChoice contact = contacts_of(input, motion);
  choose_motion(input.scene, motion);
  uint64_t outside = 0;
  if (contact.box) {
    WallBox box = *contact.box;
    box.periodic |= contact.periodic;
    outside = wrap_centres(input.scene, box);
  }
  if (motion.plane) {
    take_plane(input.scene, *motion.plane, contact.law != ContactLaw::none);
  } else {
    lower_plane(input.scene);
    raise_plane(input.scene, contact);
  }
  choose_contacts(input.scene, contact);
  Start start;
  start.label = input.scene.name;
  start.notes = describe(input);
  if (outside) start.notes += fmt::format("{} outside the periodic box: wrapped into it\n", counted(outside, "centre"));
  if (input.box && contact.law != ContactLaw::none && !contact.walls && input.scene.contact.periodic != 7)
    start.notes += fmt::format("{} has a box whose open faces spheres can leave: --walls closes them\n", input.file);
  if (!input.units.empty() && input.units != "m")
    start.notes += fmt::format("WARNING: motion takes lengths for metres: 1 {} moves as 1 m does\n", input.units);
  start.record = to_json(input);
  start.at_rest = input.at_rest;
  start.file = input.file;
  start.unread_species = input.unread_species;
  start.scene = std::move(input.scene);
  start.species = std::move(input.species);
  start.species_index = std::move(input.species_index);
  return start;
}

SphereFileOptions file_options(const StartOptions& options, int threads) {
  return {.radius = options.radius,
          .frame = options.frame,
          .columns = options.columns,
          .decimal_comma = options.decimal_comma,
          .species = options.species,
          .ignore_periodic = options.ignore_periodic,
          .moves_in_box = options.motion.contact.law != ContactLaw::none,
          .threads = threads};
}

}  // namespace

std::vector<Start> start_of_frames(const StartOptions& options, int threads) {
  std::vector<Start> starts;
  for (SphereFile& frame : read_sphere_frames(options.input_file, file_options(options, threads)))
    starts.push_back(start_from(std::move(frame), options.motion));
  return starts;
}

Start start_of(const StartOptions& options, int threads) {
  if (!options.resume_file.empty()) return start_from_checkpoint(options.resume_file, options.motion);
  if (!options.input_file.empty())
    return start_from(read_sphere_file(options.input_file, file_options(options, threads)), options.motion);
  SceneOptions scene = options.scene;
  choose_motion(scene, options.motion);
  Scene made = make_scene(scene);
  if (options.motion.gravity) made.gravity = 0 - *options.motion.gravity;
  choose_contacts(made, contact_choice(options.motion));
  return {std::move(made), scene_label(scene), "", scene_json(scene)};
}

std::string plane_text(const Scene& scene) { return fmt::format("plane at y = {}\n", scene.plane); }

std::string species_warning(const Start& start) {
  if (!start.unread_species) return "";
  return fmt::format("* --spheres writes no species: those of {} are left out (XYZ: X instead)\n", start.file);
}

void add_inputs(OutputFiles& files, const StartOptions& options) {
  files.read("--input", options.input_file);
  files.read("--resume", options.resume_file);
}

void upload_start(const Start& start, Motion& motion) {
  start.motion ? motion.resume(start.scene, *start.motion) : motion.upload(start.scene);
}

}  // namespace spherepair
