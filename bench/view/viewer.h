// SPDX-License-Identifier: MIT
// The state of `spherepair view`: a run that can continue on another backend, and its camera.
#pragma once

#include <chrono>

#include "bench/formats/start.h"
#include "bench/measure/session.h"
#include "bench/view/history.h"
#include "bench/view/window.h"
#include "common/scene/camera.h"

namespace spherepair {

class Viewer {
 public:
  // The session's backends can be chosen. shared: they draw in the window's context.
  Viewer(const Session& session, const Start& start, const std::string& backend, const std::string& method,
         bool shared);

  // One frame: user input, a step unless paused, and the image. key: an additional key press; 0: none.
  void frame(Window& window, char key);
  std::string summary() const;

 private:
  struct Choice {
    std::vector<std::string> names;
    size_t chosen = 0;
    const std::string& name() const { return names[chosen]; }
    void next() { chosen = (chosen + 1) % names.size(); }
    void pick(const std::string& name);  // the first if there is none of this name
  };

  // Of the camera: degrees, and the distance relative to that with all spheres in view.
  struct Orbit {
    double azimuth = 30, elevation = 20, distance = 1;
  };
  struct Search {
    Method method;
    bool lit;  // it built the dense cells that lighting needs
    bool operator==(const Search&) const = default;
  };
  struct Seconds {  // of the frames that are timed
    double move = 0, collide = 0, draw = 0, show = 0;
  };

  Backend& backend() const { return *session_.backends()[running_]; }
  void change_backend(size_t next);
  void go_to(uint64_t step);
  void pick(std::array<uint, 2> pixel);
  void list_choices();
  void take_keys(Window& window, char key);
  void fill_panel(Window& window);
  void turn_camera(const Window& window);
  void choose_colours();
  void advance();
  void collide();
  void draw(Window& window);
  bool shown_without_host(uint texture);
  template <typename Work>
  void timed(double& seconds, Work work);

  const Session& session_;
  const Start& start_;
  bool shared_;
  Bounds bounds_;
  Choice backends_, methods_, draws_, colours_{{"contacts", "speed", "radius"}};
  Look palette_ = contact_look();  // of the chosen colours
  size_t coloured_by_ = 0;
  size_t running_ = 0;  // the backend that holds the spheres
  bool paused_ = false, single_step_ = false, light_ = true, panel_ = true;
  Orbit orbit_;
  uint64_t step_ = 0;
  std::optional<Search> search_;  // of the spheres as they stand
  Collisions totals_;             // of the last search
  std::string error_;             // of the last change of backend
  View view_{};                   // of the last image
  std::string picked_;            // the sphere that was clicked
  History history_;
  Seconds seconds_;
  uint64_t frames_ = 0;
  std::chrono::steady_clock::time_point first_frame_;  // its end
};

}  // namespace spherepair
