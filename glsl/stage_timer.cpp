// SPDX-License-Identifier: MIT
#include "glsl/stage_timer.h"

namespace spherepair {

std::vector<StageTime> StageTimer::take() {
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

void StageTimer::forget() {
  for (const Stage& stage : stages_) glDeleteQueries(2, stage.queries.data());
  stages_.clear();
}

}  // namespace spherepair
