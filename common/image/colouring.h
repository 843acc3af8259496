// SPDX-License-Identifier: MIT
// Chooses the colours of spheres from the range of the data, and the labels of the legend.
#pragma once

#include <string>
#include <vector>

#include "common/backend/motion.h"
#include "common/backend/search.h"
#include "common/scene/camera.h"

namespace spherepair {

struct LegendKey {
  uint colour;  // 0xRRGGBB
  std::string label;
};
struct Legend {
  std::string title;  // with its unit
  std::vector<LegendKey> keys;
  std::vector<std::string> facts;
};

enum class ColourBy { contacts, radius, speed, species };
ColourBy colour_by_name(const std::string& name);  // throws std::invalid_argument with the known names
const char* name_of(ColourBy by);

// Throws std::invalid_argument unless colours by this quantity can have the range, which ascends from 0 or more.
void check_colour_range(ColourBy by, double low, double high);

// A value for each sphere: contacts of the last collide(), radius in metres, or speed in m/s.
std::vector<double> values_of(ColourBy by, Search& search, const Motion::State& state);

class Colouring {
 public:
  // values: of the first image's spheres, or of all images'. unit: of radius or speed, or empty. clipped: values are
  // both ends of a range; numbers beyond them get the first and the last colour.
  Colouring(ColourBy by, const std::vector<double>& values, const std::string& unit, bool clipped = false);
  // By species: values are indices into the names. If there are more species than colours, the rarest share one.
  Colouring(const std::vector<std::string>& names, const std::vector<double>& values);

  std::vector<uint> classes(const std::vector<double>& values) const;  // for Drawing::set_classes
  Look look() const;
  Legend legend() const;                                     // without facts
  double highest() const { return highest_; }                // the largest value that it was made from
  const std::string& grouping() const { return grouping_; }  // the values that share a colour; empty: none

 private:
  void choose_contacts(std::vector<double> values);
  void choose_range(const std::vector<double>& values, bool clipped);

  std::string title_, grouping_;
  std::array<uint, COLOURS> palette_{};
  std::vector<double> limits_;       // ascending: a sphere's class is the number of limits that its value reaches
  std::vector<uint> class_of_name_;  // of species
  std::vector<std::string> labels_;
  double highest_ = 0;
};

}  // namespace spherepair
