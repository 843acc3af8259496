// SPDX-License-Identifier: MIT
// Calls that move, save, resume and draw, with any arguments. Each must give a result or a message, and must not write
// outside its arrays.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "include/spherepair/simulation.h"
#include "tests/fuzz/fuzz.h"

using namespace spherepair;

namespace {

constexpr int64_t spheres = 4, room = 4096;  // bytes of pixels

double number(Values& values) {
  const auto kind = values.next<uint8_t>();
  return kind < 240 ? double(int8_t(kind)) / 16 : kind < 243 ? values.next<double>() : 0;
}

const double* place(Values& values, double* memory) {
  for (int k = 0; k < 3; ++k) memory[k] = number(values);
  return values.next<uint8_t>() % 2 ? memory : nullptr;
}

// A simulation that the bytes describe; null if they describe none.
sp_simulation* opened(Values& values) {
  std::vector<double> positions, radii;
  for (int64_t i = 0; i < spheres; ++i) {
    for (const double base : {0.0, 3.0, 0.0}) positions.push_back(base + number(values) / 4);
    radii.push_back(0.25 + values.next<uint8_t>() / 512.0);
  }
  sp_scene scene = {};
  scene.size = sizeof scene;
  scene.positions = {positions.data(), spheres, 3, 3, 1, SP_F64, 1, 0};
  scene.radii = {radii.data(), spheres, 1, 1, 1, SP_F64, 1, 0};
  scene.gravity = std::abs(number(values)), scene.restitution = 1;
  const char* const laws[] = {nullptr, "spring", "hertz", "quartic"};
  scene.contact = laws[values.next<uint8_t>() % 4];
  sp_simulation* simulation = nullptr;
  sp_simulation_open("cpu", nullptr, 1, &scene, &simulation);
  return simulation;
}

void draw(sp_simulation* simulation, Values& values) {
  double places[4][3];
  sp_drawing drawing = {};
  drawing.size = values.next<uint8_t>() % 32 ? sizeof drawing : 8;
  drawing.eye = place(values, places[0]), drawing.target = place(values, places[1]);
  drawing.up = place(values, places[2]), drawing.color_range = place(values, places[3]);
  if (!drawing.eye) drawing.azimuth = number(values) * 8, drawing.elevation = number(values) * 8;
  drawing.field = values.next<uint8_t>() % 4 ? 0 : number(values) * 16, drawing.nearest = std::abs(number(values));
  const char* const colours[] = {nullptr, "contacts", "speed", "radius", "species", "none"};
  drawing.color = colours[values.next<uint8_t>() % 6];
  drawing.samples = values.next<uint8_t>() % 4 - values.next<uint8_t>() / 240;
  drawing.plain = values.next<uint8_t>() % 2, drawing.no_ground = values.next<uint8_t>() % 2;
  std::vector<uint8_t> bytes(size_t(room), 7);
  sp_array pixels = {bytes.data(), values.next<uint8_t>() % 17, values.next<uint8_t>() % 17 * 4, 0, 1, SP_U8, 1, 0};
  if (values.next<uint8_t>() % 16 == 0) ++pixels.columns;
  pixels.row_stride = values.next<uint8_t>() % 2 ? pixels.columns : 200;
  pixels.type = values.next<uint8_t>() % 16 ? SP_U8 : values.next<uint8_t>() % 7;
  if (values.next<uint8_t>() % 16 == 0) pixels.data = nullptr;
  const sp_status status = sp_simulation_draw(simulation, &drawing, &pixels);
  require((status == SP_OK) == (*sp_simulation_message(simulation) == 0), "what fails says why");
  for (int64_t k = 0; k < room; ++k) {
    const bool inside =
        status == SP_OK && k / pixels.row_stride < pixels.rows && k % pixels.row_stride < pixels.columns;
    require(inside || bytes[size_t(k)] == 7, "pixels stay in their array");
  }
}

// Saves, changes the bytes and resumes.
void resume(sp_simulation* simulation, Values& values) {
  size_t size = 0;
  require(sp_simulation_save_bytes(simulation, nullptr, 0, &size) == SP_E_CAPACITY, "the size is told");
  std::string saved(size, '\0');
  require(sp_simulation_save_bytes(simulation, saved.data(), size, &size) == SP_OK, "what moves is saved");
  const bool changed = values.next<uint8_t>() % 2;
  std::string given = saved;
  if (changed) {
    given.resize(std::min<size_t>(size, values.next<uint16_t>()));
    if (!given.empty()) given[values.next<uint16_t>() % given.size()] ^= char(1 + values.next<uint8_t>() % 255);
  }
  sp_simulation* resumed = nullptr;
  const sp_status status = sp_simulation_resume_bytes("cpu", nullptr, 1, given.data(), given.size(), &resumed);
  require((status == SP_OK) == (resumed != nullptr), "a simulation or a message");
  require((status == SP_OK) == !changed, "whole checkpoints resume, others do not");
  require(!resumed || sp_simulation_steps(resumed) == sp_simulation_steps(simulation), "steps are counted on");
  sp_simulation_close(resumed);
}

}  // namespace

FUZZ(simulations) {
  Values values(data, size);
  sp_simulation* const simulation = opened(values);
  if (!simulation) return;
  if (sp_simulation_move(simulation, values.next<uint8_t>() % 8) == SP_OK) {
    resume(simulation, values);
    for (int k = 0; k < 3; ++k) draw(simulation, values);
  }
  sp_simulation_close(simulation);
}
