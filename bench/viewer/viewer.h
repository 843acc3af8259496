// SPDX-License-Identifier: MIT
// The state of `spherepair view`: a run that can continue on another backend, and its camera.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "bench/formats/start.h"
#include "bench/measure/session.h"
#include "bench/viewer/orbit.h"
#include "bench/viewer/window.h"
#include "common/image/antialiased_image.h"
#include "common/image/image_samples.h"
#include "common/scene/camera.h"

namespace spherepair {

constexpr uint still_samples = 16;  // samples of an image that stands still

class Viewer {
 public:
  static constexpr double slowest = 0x1p-20, fastest = 0x1p20;  // speeds by the clock

  struct Options {
    std::string backend, method;        // at the start; the session's backends can be chosen
    bool shared;                        // the backends draw in the window's context
    double speed = 0;                   // seconds of the scene in a second of the clock; 0: one step a frame
    std::filesystem::path folder = {};  // of saved images; none: the current one
  };
  Viewer(const Session& session, const Start& start, const Options& options);

  // One frame: user input, steps unless paused, and the image; false if the user closes the window. key: an additional
  // key press; 0: none.
  bool frame(Window& window, char key);
  bool hurries() const { return !paused_ && speed_ == 0; }  // wants frames faster than the display shows them
  std::string summary() const;

 private:
  struct Choice {
    std::vector<std::string> names;
    size_t chosen = 0;
    const std::string& name() const { return names[chosen]; }
    void next() { chosen = (chosen + 1) % names.size(); }
    void pick(const std::string& name);  // picks the first if none has this name
  };

  struct Search {
    Method method;
    bool lit;  // the search built the dense cells that lighting needs
    bool operator==(const Search&) const = default;
  };
  struct Shown {  // everything that decides the image
    View view;
    uint64_t step;
    size_t backend, draw;
    bool operator==(const Shown& other) const;
  };
  struct Seconds {  // seconds of the timed frames
    double move = 0, collide = 0, draw = 0, show = 0;
  };

  Backend& backend() const { return *session_.backends()[running_]; }
  Drawing& drawing() const { return drawing_of(backend()); }
  void change_backend(size_t next);
  void restart();
  void hold();  // no time passes until the next frame
  uint64_t due(double now);
  void scale_speed(double factor);
  void list_choices();
  bool take_keys(Window& window, char key);
  void show_panel(Window& window);
  void choose_colours();
  void advance(const Window& window);
  void move_steps(const Window& window, uint64_t due);
  void collide();
  ImageOptions still_image(const Window& window) const;
  void draw(Window& window);
  void refine(Window& window, const ImageOptions& image);
  void save_image(const Window& window);
  bool shown_without_host(uint texture);
  template <typename Work>
  void timed(double& seconds, Work work);

  const Session& session_;
  const Start& start_;
  const Options options_;
  Bounds bounds_;
  Choice backends_, methods_, draws_, colours_{{"contacts", "speed", "radius"}};
  Look palette_ = contact_look();  // the chosen colours
  size_t coloured_by_ = 0;
  size_t running_ = 0;  // the backend that holds the spheres
  bool paused_ = false, single_step_ = false, saving_ = false, light_ = true, panel_ = true;
  Orbit orbit_;
  double speed_;                // see Options
  std::optional<double> last_;  // the clock at the last frame, seconds
  double owed_ = 0;             // steps that the clock is ahead
  uint64_t step_ = 0;
  std::optional<Search> search_;  // the search of the current spheres
  Collisions totals_;             // of the last search
  std::string error_;             // of the last change of backend
  std::string saved_;             // the name of the last saved image, or the reason why saving failed
  std::optional<Shown> shown_;    // the last image
  ImageSamples samples_;          // samples of the last image, while it stands still
  Seconds seconds_;
  uint64_t frames_ = 0;
  std::chrono::steady_clock::time_point first_frame_;  // its end
};

}  // namespace spherepair
