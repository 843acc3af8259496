// SPDX-License-Identifier: MIT
#include "run_action.h"

#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "answers.h"
#include "commands.h"

namespace spherepair {
namespace {

int fail(ExitCode code, const std::string& message) {
  fmt::print(stderr, "spherepair: {}\n", message);
  return code;
}

}  // namespace

int run_action(const std::function<int()>& action) {
  try {
    return action();
  } catch (const DifferenceFound& difference) {
    return fail(kDifference, std::string("DIFFERENCE FOUND: ") + difference.what());
  } catch (const std::invalid_argument& error) {
    return fail(kUsage, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kDeviceTrouble, "out of memory on the host; use fewer spheres");
  } catch (const std::exception& error) {
    return fail(kDeviceTrouble, error.what());
  }
}

}  // namespace spherepair
