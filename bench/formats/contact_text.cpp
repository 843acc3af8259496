// SPDX-License-Identifier: MIT
// The summary of a scene's contacts: law, stiffness, density, drag, time step, walls.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/formats/start.h"
#include "common/scene/contact_scene.h"

namespace spherepair {
namespace {

constexpr double coarse_steps = 10;

std::string text_of_drag(const Scene& scene) {
  return scene.contact.drag > 0 ? fmt::format(", drag {:.4g} 1/s", scene.contact.drag) : "";
}

std::string text_of_density(const Scene& scene) {
  return scene.contact.density == water ? "" : fmt::format(", density {:.4g} kg/m^3", scene.contact.density);
}

std::string text_of_walls(const Scene& scene) {
  const auto box = box_of(scene);
  if (!box) return "";
  const std::string open =
      scene.contact.walls || box->periodic == 7 ? "" : fmt::format(", open along {}", axes_text(7 - box->periodic));
  return fmt::format("{}{}: box from {} to {}\n",
                     box->periodic ? "periodic along " + axes_text(box->periodic) : "walls", open,
                     fmt::join(box->low, ", "), fmt::join(box->high, ", "));
}

}  // namespace

std::string describe_contacts(const Scene& scene) {
  if (scene.contact.law == ContactLaw::none) return "";
  const double time = contact_time(scene), steps = time / double(scene.dt);
  std::string text = fmt::format("contacts: {}, stiffness {:.4g}{}; dt = {:.4g} s, a contact lasts {:.3g} steps\n",
                                 contact_name(scene.contact.law), double(scene.contact.stiffness) * times_water(scene),
                                 text_of_density(scene) + text_of_drag(scene), scene.dt, steps);
  text += text_of_walls(scene);
  if (steps < coarse_steps)
    text += fmt::format("* dt is coarse: give --dt {:.3g} or less for {} steps a contact\n", time / coarse_steps,
                        coarse_steps);
  return text;
}

}  // namespace spherepair
