// SPDX-License-Identifier: MIT
// Shared by all calls of the C headers: turns exceptions into statuses, uses a backend in the caller's thread, and owns
// the columns of a list.
#pragma once

#include <functional>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "api/c/arrays.h"
#include "common/backend/backend.h"

namespace spherepair {

std::string& open_message();  // the reason why this thread's last sp_open or the like failed

sp_status status_of(ListFault fault);

// Runs work(). Turns an exception into a status and its text into the message.
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

// Makes the backend's device and context current, and the caller's again when it ends.
class InThread {
 public:
  explicit InThread(Backend& backend) : backend_(backend) { backend_.enter_thread(); }
  ~InThread() { backend_.leave_thread(); }
  InThread(const InThread&) = delete;
  InThread& operator=(const InThread&) = delete;

 private:
  Backend& backend_;
};

// Opens the backend that sp_open's arguments name. No thread has its context current afterwards.
std::unique_ptr<Backend> open_for_calls(const char* backend, const char* device, int32_t threads);
void close_for_calls(std::unique_ptr<Backend>& backend) noexcept;

// An sp_pairs that owns its columns, in the host's memory or in CUDA's.
class OwnedPairs : public sp_pairs {
 public:
  OwnedPairs(int64_t pairs, int64_t firsts, uint32_t wanted);
  OwnedPairs(int64_t pairs, int64_t firsts, uint32_t wanted, Device& device, int32_t device_id);

 private:
  using Allocate = std::function<void*(uint64_t)>;
  void make_columns(int64_t pairs, int64_t firsts, uint32_t wanted, int32_t device_type, int32_t device_id,
                    const Allocate& allocate);

  std::vector<std::shared_ptr<void>> memory_;
};

}  // namespace spherepair
