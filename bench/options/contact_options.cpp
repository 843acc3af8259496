// SPDX-License-Identifier: MIT
// The options of contacts that push.
#include "bench/options/options.h"

namespace spherepair {

void add_contact_options(CLI::App& command, MotionChoice& motion) {
  ContactChoice& contact = motion.contact;
  const auto take = [&contact](const std::string& name) { contact.law = contact_from_name(name); };
  auto* law = command.add_option_function<std::string>(
      "--contact", take,
      "Spheres that touch push each other: spring, quartic or hertz; none: they pass through each other. Motion is "
      "then the leapfrog's in 64-bit integers, and --dt by default chosen from the shortest contact");
  law->default_str(contact_name(contact.law));
  for (const char* other : {"--motion", "--precision"}) law->excludes(command.get_option(other));
  command
      .add_option("--stiffness", contact.stiffness,
                  "Of contacts, in N/m (spring), N/m^3 (quartic) or N/m^1.5 (hertz); default: such that the fastest "
                  "sphere enters another by 1 % of a radius. Spheres are of 1000 kg/m^3")
      ->check(real_number(1e-30, 1e30));
  command
      .add_option(
          "--drag", motion.drag,
          "Of a fluid at rest, in 1/s: alone, a speed falls to 1/e in 1/drag seconds. With some 0.1 % a step, and "
          "more in the end, beds come to rest to the bit")
      ->default_str("0")
      ->check(real_number(0, 1e30));
  const auto keep_awake = [&contact](int64_t) { contact.sleeping = false; };
  command.add_flag("--no-sleeping", keep_awake, "Do not pass over spheres at rest: slower, the same bits")
      ->needs("--drag");
  auto* walls = command.add_flag(
      "--walls", contact.walls, "Close a box: that of an .extxyz file with one, else around the spheres, on the plane");
  const auto take_box = [&contact](const std::vector<float>& corners) {
    contact.box = {{corners[0], corners[1], corners[2]}, {corners[3], corners[4], corners[5]}};
  };
  command
      .add_option_function<std::vector<float>>("--box", take_box,
                                               "Close this box: its lower corner x,y,z and its upper one, in metres")
      ->delimiter(',')
      ->expected(6)
      ->check(real_number(-0x1p60, 0x1p60))
      ->needs(law)
      ->excludes(walls);
}

}  // namespace spherepair
