// SPDX-License-Identifier: MIT
#include "bench/options/run_action.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>

#include "bench/check/step_result.h"
#include "bench/io/interruption.h"
#include "bench/options/command.h"

namespace spherepair {
namespace {

// Prints by std::fputs, which does not throw: standard error may be full, too.
int fail(ExitCode code, const std::string& message) {
  std::fputs(fmt::format("spherepair: {}\n", message).c_str(), stderr);
  return code;
}

// run_action reports a failed write to standard output, so it is not reported twice.
int fail_unless_told(ExitCode code, const std::string& message) {
  return std::ferror(stdout) ? kUsage : fail(code, message);
}

int code_of(const std::function<int()>& action) {
  try {
    return action();
  } catch (const DifferenceFound& difference) {
    return fail(kDifference, std::string("DIFFERENCE FOUND: ") + difference.what());
  } catch (const std::invalid_argument& error) {
    return fail_unless_told(kUsage, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kDeviceFailure, "out of memory on the host; use fewer spheres");
  } catch (const std::exception& error) {
    return fail_unless_told(kDeviceFailure, error.what());
  }
}

}  // namespace

int run_action(const std::function<int()>& action) {
  const int code = code_of(action);
  remove_empty_folders();  // if the command failed before its first result
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return code;
  fail(kUsage, fmt::format("cannot write to standard output: {}", std::strerror(errno)));
  return code == kDifference ? kDifference : kUsage;
}

}  // namespace spherepair
