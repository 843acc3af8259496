// SPDX-License-Identifier: MIT
#include "bench/image/image_record.h"

#include <fmt/format.h>

#include "bench/check/step_result.h"
#include "bench/io/motion_choice.h"
#include "bench/measure/choice.h"

namespace spherepair {
namespace {

json to_json(vec4 v) { return {v.x, v.y, v.z, v.w}; }
json to_json(uvec4 v) {
  json list = json::array();
  for (const uint colour : {v.x, v.y, v.z, v.w}) list.push_back(fmt::format("{:06X}", colour));
  return list;
}

json to_json(const Camera& camera) {
  return {{"eye", camera.eye},
          {"target", camera.target},
          {"up", camera.up},
          {"field_degrees", camera.field},
          {"near", camera.near}};
}

json to_json(const View& view) {
  return {{"eye_and_near", to_json(view.eye)},
          {"right", to_json(view.right)},
          {"up", to_json(view.up)},
          {"forward", to_json(view.forward)},
          {"light_and_ambient", to_json(view.light)},
          {"focal", view.focal},
          {"centre", {view.centre_x, view.centre_y}},
          {"palette", {to_json(view.palette_0), to_json(view.palette_4)}},
          {"background", fmt::format("{:06X}", view.background)},
          {"lighting", view.lighting},
          {"ground", to_json(view.ground)}};
}

// How the spheres reached OpenGL; null if there was no transfer.
json transfer_taken(Backend& backend) {
  const auto taken = drawing_of(backend).transfer_taken();
  return taken ? json(transfer_name(*taken)) : json();
}

}  // namespace

json image_record(const Start& start, Backend& backend, Method method, const ImageOptions& image,
                  const Legend& legend) {
  json views = json::array(), keys = json::array();
  for (uint sample = 0; sample < image.samples; ++sample)
    views.push_back(
        to_json(make_view(image.camera, image.look, image.width, image.height, jitter(sample, image.samples))));
  for (const LegendKey& key : legend.keys) keys.push_back({fmt::format("{:06X}", key.colour), key.label});
  const MethodChoice choice = backend.choice({.method = method});
  const Collisions totals = backend.collisions();
  json record = {{"scene", start.record},
                 {"motion", motion_label(start.scene.motion)},
                 {"dt", start.scene.dt},
                 {"restitution", start.scene.restitution},
                 {"method", method_name(choice.method)},
                 {"choice", to_json(choice)},
                 {"drawn_by", draw_method_name(image.method)},
                 {"transfer", transfer_taken(backend)},
                 {"pairs", totals.pairs},
                 {"colliding_spheres", totals.colliding_spheres},
                 {"fingerprint", hex64(totals.fingerprint.a) + hex64(totals.fingerprint.b)},
                 {"height_above_legend", image.height},
                 {"colours", {{"by", legend.title}, {"keys", keys}}},
                 {"box", image.box ? json{{"low", image.box->low}, {"high", image.box->high}} : json()},
                 {"camera", to_json(image.camera)},
                 {"samples", views}};
  if (start.length_exponent) record["lengths_times_2_to"] = start.length_exponent;
  return record;
}

}  // namespace spherepair
