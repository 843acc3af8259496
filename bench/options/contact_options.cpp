// SPDX-License-Identifier: MIT
// The options of contacts that push.
#include <set>

#include "bench/options/options.h"

namespace spherepair {
namespace {

CLI::Validator axes_of_a_box() {
  const auto check = [](const std::string& text) {
    const bool known = !text.empty() && text.find_first_not_of("xyz") == text.npos;
    const bool once = std::set(text.begin(), text.end()).size() == text.size();
    return known && once ? std::string() : text + " is not one or more of the axes x, y and z, such as xz";
  };
  return {check, "AXES"};
}

}  // namespace

void add_contact_options(CLI::App& command, MotionChoice& motion) {
  ContactChoice& contact = motion.contact;
  const auto take = [&contact](const std::string& name) { contact.law = contact_from_name(name); };
  auto* law = command.add_option_function<std::string>(
      "--contact", take, "Spheres that touch push each other: spring, quartic, hertz or none");
  law->default_str(contact_name(contact.law));
  for (const char* other : {"--motion", "--precision"}) law->excludes(command.get_option(other));
  command
      .add_option("--stiffness", contact.stiffness,
                  "In N/m (spring), N/m^3 (quartic) or N/m^1.5 (hertz); default: the fastest sphere enters another by "
                  "1 % of a radius")
      ->check(real_number(1e-30, 1e30));
  command.add_option("--density", contact.density, "Of spheres, in kg/m^3")
      ->capture_default_str()
      ->check(real_number(1e-6, 1e9));
  command.add_option("--drag", motion.drag, "Of a fluid at rest, in 1/s: alone, speeds fall to 1/e in 1/drag s")
      ->default_str("0")
      ->check(real_number(0, 1e30));
  const auto keep_awake = [&contact](int64_t) { contact.sleeping = false; };
  command.add_flag("--no-sleeping", keep_awake, "Compute spheres at rest, too: slower, the same bits")->needs("--drag");
  auto* walls =
      command.add_flag("--walls", contact.walls, "Close a box: that of the file, else one around the spheres");
  const auto take_box = [&contact](const std::vector<float>& corners) {
    contact.walls = true;
    contact.box = WallBox{{corners[0], corners[1], corners[2]}, {corners[3], corners[4], corners[5]}};
  };
  command
      .add_option_function<std::vector<float>>("--box", take_box,
                                               "Close this one: x,y,z of its lower corner, then of its upper one")
      ->delimiter(',')
      ->expected(6)
      ->check(real_number(-0x1p60, 0x1p60))
      ->needs(law)
      ->excludes(walls);
  const auto take_axes = [&contact](const std::string& axes) {
    for (const char axis : axes) contact.periodic |= 1u << (axis - 'x');
  };
  command
      .add_option_function<std::string>("--periodic", take_axes,
                                        "The box repeats along these axes, in place of walls: x, xz, xyz, ...")
      ->needs(law)
      ->check(axes_of_a_box());
}

}  // namespace spherepair
