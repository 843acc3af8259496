// SPDX-License-Identifier: MIT
//
// Moves spheres in C++20: simulation.h with spans, an owner and exceptions. That header has the laws and the units.
//
//   spherepair::Simulation simulation({.positions = positions, .radii = radii, .contact = "spring"});
//   simulation.move(1000);
//   const auto [positions, velocities] = simulation.state();
#pragma once

#include <spherepair/simulation.h>

#include <algorithm>
#include <cstddef>
#include <spherepair/spherepair.hpp>
#include <vector>

namespace spherepair {

using Row = std::array<float, 3>;

// A box: its corners, and the axes along which it repeats. The others have walls; the floor is the plane.
struct Walls {
  std::array<double, 3> low, high;
  std::array<bool, 3> periodic = {};
};

// Where spheres start; sp_scene explains each field.
struct Scene {
  Points positions = {};                        // N x 3, m
  Points velocities = {};                       // N x 3, m/s; not given: at rest
  Numbers radii = {};                           // N, m
  double plane = 0, gravity = 9.81;             // m; m/s^2, downwards
  double restitution = 1, dt = 0;               // 0 to 1; s, 0: chosen
  std::string contact = "none";                 // or spring, hertz, quartic
  double stiffness = 0, density = 0, drag = 0;  // 0: chosen; kg/m^3, 0: water; 1/s
  std::optional<Walls> walls = {};
};

// What an image shows; sp_drawing explains each field.
struct Drawing {
  std::optional<std::array<double, 3>> eye = {}, target = {}, up = {};  // m; not given: all spheres in view, y upwards
  std::optional<double> azimuth = {}, elevation = {};                   // degrees, without eye; not given: 30 and 15
  double field = 30, nearest = 0;                                       // degrees; m, 0: chosen
  std::string color = "contacts";                                       // or radius, speed
  std::optional<std::array<double, 2>> color_range = {};                // m or m/s
  int32_t samples = 16;                                                 // of each pixel
  bool light = true, ground = true;                                     // occlusion and shadows; the plane, with light

  // The C struct; it points into this one.
  sp_drawing in_c() const {
    const auto angle = [&](const std::optional<double>& given, double usual) {
      return given.value_or(eye ? 0 : usual);
    };
    return {.size = sizeof(sp_drawing),
            .eye = eye ? eye->data() : nullptr,
            .target = target ? target->data() : nullptr,
            .up = up ? up->data() : nullptr,
            .azimuth = angle(azimuth, 30),
            .elevation = angle(elevation, 15),
            .field = field,
            .nearest = nearest,
            .color = color.c_str(),
            .color_range = color_range ? color_range->data() : nullptr,
            .samples = samples,
            .plain = !light,
            .no_ground = !ground};
  }
};

// Moves a scene on a backend of its own. One thread at a time may use it. All members throw Error.
class Simulation {
 public:
  struct State {
    std::vector<Row> positions, velocities;
  };

  explicit Simulation(const Scene& scene, const std::string& backend = "auto", const std::string& device = "",
                      int32_t threads = 0) {
    const Walls walls = scene.walls.value_or(Walls{});
    const sp_scene start = {.size = sizeof(sp_scene),
                            .positions = scene.positions.array(),
                            .velocities = scene.velocities.array(),
                            .radii = scene.radii.array(),
                            .plane = scene.plane,
                            .gravity = scene.gravity,
                            .restitution = scene.restitution,
                            .dt = scene.dt,
                            .contact = scene.contact.c_str(),
                            .stiffness = scene.stiffness,
                            .density = scene.density,
                            .drag = scene.drag,
                            .walls = scene.walls ? detail::host_array(&walls.low, SP_F64, 2, 3, 3) : sp_array{},
                            .periodic = {walls.periodic[0], walls.periodic[1], walls.periodic[2]}};
    open([&](const char* named,
             sp_simulation** out) { return sp_simulation_open(backend.c_str(), named, threads, &start, out); },
         device);
  }

  // Continues from a checkpoint: a file, or the bytes of one.
  static Simulation resume(const std::string& file, const std::string& backend = "auto", const std::string& device = "",
                           int32_t threads = 0) {
    Simulation resumed;
    resumed.open(
        [&](const char* named, sp_simulation** out) {
          return sp_simulation_resume(backend.c_str(), named, threads, file.c_str(), out);
        },
        device);
    return resumed;
  }
  static Simulation resume(std::span<const std::byte> bytes, const std::string& backend = "auto",
                           const std::string& device = "", int32_t threads = 0) {
    Simulation resumed;
    resumed.open(
        [&](const char* named, sp_simulation** out) {
          return sp_simulation_resume_bytes(backend.c_str(), named, threads, bytes.data(), bytes.size(), out);
        },
        device);
    return resumed;
  }

  void move(uint64_t steps = 1) { check(sp_simulation_move(simulation_.get(), steps)); }
  double dt() const { return sp_simulation_dt(simulation_.get()); }          // seconds of a step
  uint64_t steps() const { return sp_simulation_steps(simulation_.get()); }  // made so far
  uint64_t spheres() const { return sp_simulation_spheres(simulation_.get()); }

  // Writes a checkpoint to a file, which is replaced once the new one is whole, or returns its bytes.
  void save(const std::string& file) { check(sp_simulation_save(simulation_.get(), file.c_str())); }
  std::vector<std::byte> save() {
    size_t size = 0;
    const sp_status status = sp_simulation_save_bytes(simulation_.get(), nullptr, 0, &size);
    if (status != SP_E_CAPACITY) check(status);
    std::vector<std::byte> bytes(size);
    check(sp_simulation_save_bytes(simulation_.get(), bytes.data(), size, &size));
    return bytes;
  }

  // Reads the state, rounded to float32.
  State state() {
    State found{std::vector<Row>(spheres()), std::vector<Row>(spheres())};
    const auto array = [&](std::vector<Row>& rows) {
      return detail::host_array(rows.data(), SP_F32, int64_t(rows.size()), 3, 3);
    };
    const sp_array positions = array(found.positions), velocities = array(found.velocities);
    check(sp_simulation_state(simulation_.get(), &positions, &velocities));
    return found;
  }

  // Lists the pairs i < j of spheres that overlap now.
  PairList pairs() {
    sp_pairs* list = nullptr;
    check(sp_simulation_pairs(simulation_.get(), &list));
    return PairList(list);
  }

  // Draws the spheres at their current positions: red, green, blue and alpha of each pixel, the upper row first.
  std::vector<uint8_t> draw(int32_t width, int32_t height, const Drawing& drawing = {}) {
    constexpr int32_t widest = 16384;
    std::vector<uint8_t> pixels(size_t(std::clamp(width, 0, widest)) * size_t(std::clamp(height, 0, widest)) * 4);
    draw(pixels.data(), width, height, int64_t(width) * 4, drawing);
    return pixels;
  }
  // The same into memory of yours, whose rows begin row_stride bytes apart.
  void draw(uint8_t* pixels, int32_t width, int32_t height, int64_t row_stride, const Drawing& drawing = {}) {
    const sp_array array = {pixels, height, int64_t(width) * 4, row_stride, 1, SP_U8, 1, 0};
    const sp_drawing wanted = drawing.in_c();
    check(sp_simulation_draw(simulation_.get(), &wanted, &array));
  }

 private:
  Simulation() = default;

  // Calls open_it with the device, or NULL if none is named.
  template <typename Open>
  void open(Open open_it, const std::string& device) {
    sp_simulation* opened = nullptr;
    const sp_status status = open_it(device.empty() ? nullptr : device.c_str(), &opened);
    simulation_.reset(opened);
    check(status);
  }
  struct Close {
    void operator()(sp_simulation* simulation) const { sp_simulation_close(simulation); }
  };
  void check(sp_status status) const {
    if (status != SP_OK) throw Error(status, sp_simulation_message(simulation_.get()));
  }

  std::unique_ptr<sp_simulation, Close> simulation_;
};

}  // namespace spherepair
