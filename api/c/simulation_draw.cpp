// SPDX-License-Identifier: MIT
// The call that draws a simulation into the caller's memory.
#include <fmt/format.h>

#include "api/c/simulation.h"
#include "common/image/antialiased_image.h"
#include "common/image/colouring.h"

using namespace spherepair;

namespace {

std::vector<double> numbers_at(const double* given, size_t count, const std::string& name) {
  if (!given) return {};
  for (size_t k = 0; k < count; ++k) require_finite(given[k], fmt::format("{}[{}]", name, k));
  return {given, given + count};
}

double angle(double value, double most, const std::string& name, bool eye) {
  require_finite(value, name);
  if (eye && value != 0) refuse(fmt::format("{} is given, but with an eye it has no meaning: leave it out", name));
  if (value < -most || value > most)
    refuse(fmt::format("{} is {}, but must be {} to {} degrees", name, value, -most, most));
  return value;
}

CameraOptions camera_options(const sp_drawing& given) {
  CameraOptions camera;
  camera.eye = numbers_at(given.eye, 3, "eye");
  camera.target = numbers_at(given.target, 3, "target");
  if (given.up) camera.up = numbers_at(given.up, 3, "up");
  camera.azimuth = angle(given.azimuth, 360, "azimuth", given.eye);
  camera.elevation = angle(given.elevation, 90, "elevation", given.eye);
  require_finite(given.field, "field");
  require_finite(given.nearest, "nearest");
  if (given.nearest < 0) refuse(fmt::format("nearest is {}, but must not be negative", given.nearest));
  if (given.field != 0) camera.field = given.field;
  camera.near = given.nearest;
  return camera;
}

ColourBy colour_of(const sp_drawing& given) {
  const ColourBy by = given.color ? colour_by_name(given.color) : ColourBy::contacts;
  if (by == ColourBy::species) refuse("color is species, which a simulation has not: name contacts, radius or speed");
  return by;
}

// Finds the contacts if colours or light need them, and gives the spheres their colours.
Look coloured(Backend& backend, const Motion::State& state, const sp_drawing& given) {
  const ColourBy by = colour_of(given);
  const std::vector<double> range = numbers_at(given.color_range, 2, "color_range");
  if (!range.empty()) check_colour_range(by, range[0], range[1]);
  if (by == ColourBy::contacts || !given.plain)
    backend.collide({.method = Method::collide_grid});  // light uses its cells
  const std::vector<double> values = values_of(by, backend, state);
  if (values.empty()) return contact_look();
  const Colouring colouring(by, range.empty() ? values : range, "", !range.empty());
  drawing_of(backend).set_classes(colouring.classes(values));
  return colouring.look();
}

ImageOptions image_size(const sp_array& pixels) {
  if (pixels.columns % 4 != 0) refuse(fmt::format("pixels has {} columns, but each pixel has 4", pixels.columns));
  const int64_t width = pixels.columns / 4, height = pixels.rows;
  if (width < 1 || width > widest_image || height < 1 || height > widest_image)
    refuse(fmt::format("pixels has {} rows of {} pixels, but each must be 1 to {}", height, width, widest_image));
  check_array(pixels, "pixels", pixels.columns, {SP_U8});
  return {.camera = {}, .look = {}, .width = uint(width), .height = uint(height), .samples = 16};
}

void draw(const sp_simulation& simulation, const sp_drawing& given, const sp_array& pixels) {
  if (given.size != sizeof(sp_drawing))
    refuse(fmt::format("drawing.size is {}, but sizeof(sp_drawing) is {}: the program was compiled with another header",
                       given.size, sizeof(sp_drawing)));
  ImageOptions image = image_size(pixels);
  if (given.samples < 0 || given.samples > 1024)
    refuse(fmt::format("samples is {}, but must be 1 to 1024, or 0 for 16", given.samples));
  if (given.samples != 0) image.samples = uint(given.samples);
  const CameraOptions camera = camera_options(given);
  Backend& backend = *simulation.backend;
  const Motion::State state = current_state(backend);
  image.camera = camera_of(camera, bounds_of(state.positions), double(image.width) / image.height);
  image.look = coloured(backend, state, given);
  if (!given.plain) image.look.lighting = LIGHT_OCCLUSION | LIGHT_SHADOW;
  if (!given.plain && !given.no_ground) put_ground(image.look, {0, 1, 0}, double(simulation.scene.plane));
  const std::vector<uint> drawn = draw_image(drawing_of(backend), image).pixels;
  write_array(pixels, pixels.rows, pixels.columns, [&](int64_t row, int64_t column) {
    return drawn[size_t(row) * image.width + size_t(column) / 4] >> column % 4 * 8 & 255;
  });
}

}  // namespace

sp_status sp_simulation_draw(sp_simulation* simulation, const sp_drawing* drawing, const sp_array* pixels) {
  return on(simulation, [&](Backend&) {
    if (!drawing) refuse("drawing is NULL");
    if (!pixels) refuse("pixels is NULL");
    with_fields([&] { draw(*simulation, *drawing, *pixels); });
  });
}
