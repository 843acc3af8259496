// SPDX-License-Identifier: MIT
// The calls of include/spherepair/spherepair.h. No exception leaves them: each becomes a status and a message.
#include <fmt/format.h>

#include <memory>
#include <new>

#include "api/c/arrays.h"
#include "api/c/columns.h"
#include "api/c/problem_of.h"
#include "api/open.h"
#include "common/lists/pair_list.h"

using namespace spherepair;

struct sp_context {
  std::unique_ptr<Backend> backend;
  std::string message;
};

namespace {

thread_local std::string open_message;

sp_status status_of(ListFault fault) {
  return fault == ListFault::argument ? SP_E_ARGUMENT : fault == ListFault::not_finite ? SP_E_NONFINITE : SP_E_RANGE;
}

// Runs work(); what it throws becomes a status, and the message says why.
template <typename Work>
sp_status guarded(std::string& message, Work work) noexcept {
  try {
    try {
      message.clear();
      return work();
    } catch (const ListError& error) {
      message = error.what();
      return status_of(error.fault);
    } catch (const std::invalid_argument& error) {
      message = error.what();
      return SP_E_ARGUMENT;
    } catch (const std::bad_alloc&) {
      message = "out of memory";
      return SP_E_MEMORY;
    } catch (const std::exception& error) {
      message = error.what();
      return SP_E_BACKEND;
    }
  } catch (...) {  // no memory for the message
    return SP_E_MEMORY;
  }
}

// The backend's own device and context within, the caller's before and behind.
class InThread {
 public:
  explicit InThread(Backend& backend) : backend_(backend) { backend_.enter_thread(); }
  ~InThread() { backend_.leave_thread(); }
  InThread(const InThread&) = delete;
  InThread& operator=(const InThread&) = delete;

 private:
  Backend& backend_;
};

std::vector<ListedPair> list_in_thread(Backend& backend, const ListProblem& problem) {
  const InThread in_thread(backend);
  return list_pairs(backend, problem);
}

// The fastest that opens, as `spherepair run` chooses: software is slower than the CPU's own backend.
std::unique_ptr<Backend> open_fastest(OpenOptions options) {
  options.require_hardware = true;
  for (const char* name : {"cuda", "vulkan", "opengl"}) try {
      return open_backend(name, options);
    } catch (const BackendError&) {
    }
  return open_backend("cpu", options);
}

std::unique_ptr<Backend> open(const std::string& name, const char* device, int32_t threads) {
  if (threads < 0) refuse(fmt::format("threads is {}, but must not be negative", threads));
  OpenOptions options;
  options.threads = threads;
  if (device && *device) {
    if (name != "cuda" && name != "vulkan" && name != "opengl" && name != "opengl-core")
      refuse(fmt::format("a device is given for the backend {}: name cuda, opengl or vulkan", name));
    (name == "cuda" ? options.cuda_device : name == "vulkan" ? options.vulkan_device : options.gl_device) = device;
  }
  return name == "auto" ? open_fastest(options) : open_backend(name, options);
}

// A list with the memory of its columns.
class OwnedPairs : public sp_pairs {
 public:
  OwnedPairs(int64_t pairs, int64_t firsts, uint32_t wanted) : sp_pairs{} {
    size = sizeof(sp_pairs);
    count = pairs;
    allocate(first, SP_I32, sizeof(int32_t), pairs, 1);
    allocate(second, SP_I32, sizeof(int32_t), pairs, 1);
    if (wanted & SP_SHIFTS) allocate(shifts, SP_I32, sizeof(int32_t), pairs, 3);
    if (wanted & SP_VECTORS) allocate(vectors, SP_F64, sizeof(double), pairs, 3);
    if (wanted & SP_DISTANCES) allocate(distances, SP_F64, sizeof(double), pairs, 1);
    if (wanted & SP_OFFSETS) allocate(offsets, SP_I64, sizeof(int64_t), firsts + 1, 1);
  }

 private:
  void allocate(sp_array& array, sp_type type, size_t bytes, int64_t rows, int64_t columns) {
    // One element more, so that an empty column has an address as well.
    memory_.push_back(std::make_unique_for_overwrite<std::byte[]>((size_t(rows * columns) + 1) * bytes));
    array = {memory_.back().get(), rows, columns, columns, 1, type, 1, 0};
  }

  std::vector<std::unique_ptr<std::byte[]>> memory_;
};

}  // namespace

uint32_t sp_abi_version(void) { return SP_ABI_VERSION; }
const char* sp_version(void) { return SPHEREPAIR_VERSION; }

const char* sp_backend_name(int32_t index) {
  static const std::vector<std::string> names = backend_names();
  return index >= 0 && size_t(index) < names.size() ? names[size_t(index)].c_str() : nullptr;
}

sp_status sp_open(const char* backend, const char* device, int32_t threads, sp_context** out) {
  return guarded(open_message, [&] {
    if (!out) refuse("out is NULL");
    *out = nullptr;
    if (!backend) refuse("backend is NULL: name cpu, opengl, cuda, vulkan or auto");
    auto context = std::make_unique<sp_context>();
    context->backend = open(backend, device, threads);
    context->backend->leave_thread();
    *out = context.release();
    return SP_OK;
  });
}

void sp_close(sp_context* context) {
  if (!context) return;
  guarded(context->message, [&] {
    context->backend->enter_thread();
    context->backend.reset();  // an OpenGL context leaves the thread as it ends
    return SP_OK;
  });
  delete context;
}
const char* sp_backend(const sp_context* context) { return context ? context->backend->info().name.c_str() : ""; }
const char* sp_device(const sp_context* context) { return context ? context->backend->info().device.c_str() : ""; }
const char* sp_message(const sp_context* context) { return (context ? context->message : open_message).c_str(); }

sp_status sp_count(sp_context* context, const sp_problem* problem, int64_t* count) {
  if (!context) return SP_E_ARGUMENT;
  return guarded(context->message, [&] {
    if (!problem || !count) refuse("problem or count is NULL");
    *count = int64_t(list_in_thread(*context->backend, problem_of(*problem)).size());
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
    const ListProblem asked = problem_of(*problem);
    const std::vector<ListedPair> list = list_in_thread(*context->backend, asked);
    auto owned = std::make_unique<OwnedPairs>(int64_t(list.size()), int64_t(asked.firsts().size()), wanted);
    write_list(asked, list, *owned);
    *out = owned.release();
    return SP_OK;
  });
}

void sp_free(sp_pairs* list) { delete static_cast<OwnedPairs*>(list); }

sp_status sp_fill(sp_context* context, const sp_problem* problem, sp_pairs* pairs) {
  if (!context) return SP_E_ARGUMENT;
  return guarded(context->message, [&] {
    if (!problem || !pairs) refuse("problem or pairs is NULL");
    check_columns(*pairs);
    const ListProblem asked = problem_of(*problem);
    const std::vector<ListedPair> list = list_in_thread(*context->backend, asked);
    pairs->count = int64_t(list.size());
    check_room(*pairs, int64_t(asked.firsts().size()), context->message);
    if (!context->message.empty()) return SP_E_CAPACITY;
    write_list(asked, list, *pairs);
    return SP_OK;
  });
}
