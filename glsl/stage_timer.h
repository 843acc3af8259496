// SPDX-License-Identifier: MIT
// The device's own clock around stages, in the current context; nothing at all while it is off.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <vector>

#include "common/backend/backend.h"

namespace spherepair {

class StageTimer {
 public:
  void turn(bool on) { on_ = on; }

  // Runs the work, whose time is then that of a stage of this name.
  template <typename Work>
  void time(const char* name, Work work) {
    if (!on_) return work();
    Stage stage{name, {}};
    glCreateQueries(GL_TIMESTAMP, 2, stage.queries.data());
    glQueryCounter(stage.queries[0], GL_TIMESTAMP);
    work();
    glQueryCounter(stage.queries[1], GL_TIMESTAMP);
    stages_.push_back(stage);
  }

  std::vector<StageTime> take();  // since the last call, in order; waits for the work
  void forget();                  // deletes the queries

 private:
  struct Stage {
    const char* name;
    std::array<GLuint, 2> queries;
  };
  bool on_ = false;
  std::vector<Stage> stages_;
};

}  // namespace spherepair
