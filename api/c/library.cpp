// SPDX-License-Identifier: MIT
// The calls of include/spherepair/spherepair.h that open backends and make lists.
#include <fmt/format.h>

#include <optional>

#include "api/c/columns.h"
#include "api/c/device_calls.h"
#include "api/c/guarded.h"
#include "api/c/problem_of.h"
#include "api/open.h"
#include "common/lists/device_lists.h"
#include "common/lists/host_lists.h"
#include "common/lists/pair_list.h"

using namespace spherepair;

struct sp_context {
  ~sp_context() {
    if (backend) end_lists();
    close_for_calls(backend);
  }
  DeviceCalls& on_device() {
    if (!device_calls) device_calls.emplace(*backend);
    return *device_calls;
  }
  void end_lists() noexcept;

  std::unique_ptr<Backend> backend;
  std::optional<DeviceCalls> device_calls;
  std::optional<DeviceLists> lists;  // lists of the host's arrays, made on a device
  std::optional<HostLists> host_lists;
  // Of the last call, for their memory: the system takes milliseconds to give millions of points new pages.
  ListProblem problem;
  PairRows rows;
  std::string message;
};

namespace {

// Makes the list of context.problem in context.rows.
const PairRows& list_in_thread(sp_context& context, bool with_shifts) {
  const InThread in_thread(*context.backend);
  const ListProblem& problem = context.problem;
  PairRows& rows = context.rows;
  check_problem(problem);
  Device* const device = context.backend->device();
  const bool makes_lists = device && device->capabilities().makes_lists;
  if (makes_lists && !context.lists) context.lists.emplace(*device);
  if (makes_lists)
    if (auto list = context.lists->list(problem)) return rows = std::move(*list);
  const int threads = list_threads(*context.backend);
  if (threads && !context.host_lists) context.host_lists.emplace(threads);
  if (threads && context.host_lists->list(problem, with_shifts, rows)) return rows;
  return rows = list_by_search(*context.backend, problem);
}

}  // namespace

// Frees the lists' buffers while the backend's device is the thread's.
void sp_context::end_lists() noexcept {
  try {
    const InThread in_thread(*backend);
    device_calls.reset();
    lists.reset();
  } catch (const std::exception&) {  // the device has failed, and an earlier call said so
  }
}

uint32_t sp_abi_version(void) { return SP_ABI_VERSION; }
const char* sp_version(void) { return SPHEREPAIR_VERSION; }

const char* sp_backend_name(int32_t index) {
  static const std::vector<std::string> names = backend_names();
  return index >= 0 && size_t(index) < names.size() ? names[size_t(index)].c_str() : nullptr;
}

sp_status sp_open(const char* backend, const char* device, int32_t threads, sp_context** out) {
  return guarded(open_message(), [&] {
    if (!out) refuse("out is NULL");
    *out = nullptr;
    auto context = std::make_unique<sp_context>();
    context->backend = open_for_calls(backend, device, threads);
    *out = context.release();
    return SP_OK;
  });
}

void sp_close(sp_context* context) { delete context; }

const char* sp_backend(const sp_context* context) { return context ? context->backend->info().name.c_str() : ""; }
const char* sp_device(const sp_context* context) { return context ? context->backend->info().device.c_str() : ""; }
const char* sp_message(const sp_context* context) { return (context ? context->message : open_message()).c_str(); }

sp_status sp_count(sp_context* context, const sp_problem* problem, int64_t* count) {
  if (!context) return SP_E_ARGUMENT;
  return guarded(context->message, [&] {
    if (!problem || !count) refuse("problem or count is NULL");
    if (is_on_device(*problem)) {
      *count = context->on_device().count(*problem);
      return SP_OK;
    }
    context->problem = problem_of(*problem, {}, std::move(context->problem));
    *count = list_in_thread(*context, false).count();
    return SP_OK;
  });
}

sp_status sp_list(sp_context* context, const sp_problem* problem, uint32_t wanted, sp_pairs** out) {
  if (out) *out = nullptr;
  if (!context) return SP_E_ARGUMENT;
  return guarded(context->message, [&] {
    if (!problem || !out) refuse("problem or out is NULL");
    if (wanted > (SP_SHIFTS | SP_VECTORS | SP_DISTANCES | SP_OFFSETS))
      refuse(fmt::format("wanted is {}, but must be a sum of SP_SHIFTS, SP_VECTORS, SP_DISTANCES, SP_OFFSETS", wanted));
    if (is_on_device(*problem)) {
      *out = context->on_device().list(*problem, wanted).release();
      return SP_OK;
    }
    context->problem = problem_of(*problem, {}, std::move(context->problem));
    const PairRows& list = list_in_thread(*context, wanted & (SP_SHIFTS | SP_VECTORS | SP_DISTANCES));
    auto owned = std::make_unique<OwnedPairs>(list.count(), list.rows(), wanted);
    write_list(context->problem, list, *owned);
    *out = owned.release();
    return SP_OK;
  });
}

void sp_free(sp_pairs* list) { delete static_cast<OwnedPairs*>(list); }

sp_status sp_fill(sp_context* context, const sp_problem* problem, sp_pairs* pairs) {
  if (!context) return SP_E_ARGUMENT;
  return guarded(context->message, [&] {
    if (!problem || !pairs) refuse("problem or pairs is NULL");
    check_columns(*pairs, is_on_device(*problem));
    if (is_on_device(*problem))
      return context->on_device().fill(*problem, *pairs, context->message) ? SP_OK : SP_E_CAPACITY;
    context->problem = problem_of(*problem, {}, std::move(context->problem));
    const bool with_shifts = pairs->shifts.data || pairs->vectors.data || pairs->distances.data;
    const PairRows& list = list_in_thread(*context, with_shifts);
    pairs->count = list.count();
    check_room(*pairs, list.rows(), context->message);
    if (!context->message.empty()) return SP_E_CAPACITY;
    write_list(context->problem, list, *pairs);
    return SP_OK;
  });
}
