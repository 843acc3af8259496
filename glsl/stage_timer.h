// SPDX-License-Identifier: MIT
// Times stages by the device's clock, in the current context. Takes no times while it is off.
#pragma once

#include <epoxy/gl.h>

#include <array>
#include <vector>

#include "common/backend/backend.h"

namespace spherepair {

class StageTimer {
 public:
  void turn(bool on) { on_ = on; }

  // Runs the work and times it as a stage of this name.
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

  // The times since the last call, in order. Waits for the work.
  std::vector<StageTime> take() {
    std::vector<StageTime> times;
    for (const Stage& stage : stages_) {
      GLuint64 start = 0, stop = 0;
      glGetQueryObjectui64v(stage.queries[0], GL_QUERY_RESULT, &start);
      glGetQueryObjectui64v(stage.queries[1], GL_QUERY_RESULT, &stop);
      times.push_back({stage.name, double(stop - start) * 1e-9});
    }
    forget();
    return times;
  }

  void forget() {  // deletes the queries
    for (const Stage& stage : stages_) glDeleteQueries(2, stage.queries.data());
    stages_.clear();
  }

 private:
  struct Stage {
    const char* name;
    std::array<GLuint, 2> queries;
  };
  bool on_ = false;
  std::vector<Stage> stages_;
};

}  // namespace spherepair
