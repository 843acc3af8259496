// SPDX-License-Identifier: MIT
// Checkpoints: refused, or gone on with on the CPU backend, saved and read again. Each input is read as it stands and
// with its checksums made right, so that mutations get behind them.
#include "common/files/checkpoint.h"

#include "tests/fuzz/fuzz.h"
#include "tests/support/sphere_files.h"

using namespace spherepair;

namespace {

// Puts the right checksum behind the `size` bytes from `at` on, and returns where the next part begins.
size_t mend(std::string& file, size_t at, uint64_t size) {
  if (at > file.size() || size > file.size() - at || file.size() - at - size < 8) return file.size();
  const uint64_t sum = checksum(std::string_view(file).substr(at, size));
  std::memcpy(file.data() + at + size, &sum, 8);
  return at + size + 8;
}

std::string with_right_checksums(std::string file) {
  constexpr size_t header = 64, name_length_at = 28;
  if (file.size() < header) return file;
  uint32_t name_length;
  std::memcpy(&name_length, file.data() + name_length_at, 4);
  uint64_t length;
  for (size_t at = mend(file, 0, header + uint64_t(name_length)); at + 8 <= file.size();
       at = mend(file, at + 8, length))
    std::memcpy(&length, file.data() + at, 8);
  return file;
}

void go_on(Checkpoint checkpoint) {
  Backend& backend = fuzzed_backend();
  backend.resume(checkpoint.scene, checkpoint.motion);
  require_one_set();
  for (int step = 0; step < 3; ++step) backend.move();
  const Motion::State state = current_state(backend);
  checkpoint.scene.positions = state.positions, checkpoint.scene.velocities = state.velocities;
  checkpoint.motion = backend.save();
  const std::string file = input_file("saved", "");
  write_checkpoint(file, checkpoint);
  const std::string written = read_bytes(file);
  write_checkpoint(file, read_checkpoint(file));
  require(read_bytes(file) == written, "what is saved is read again to the same bytes");
}

}  // namespace

FUZZ(checkpoint) {
  const std::string given(text_of(data, size));
  for (const std::string& bytes : {given, with_right_checksums(given)}) {
    const std::string file = input_file("run.checkpoint", bytes);
    const auto checkpoint = unless_refused([&] { return read_checkpoint(file); });
    if (checkpoint && checkpoint->scene.size() <= 200) unless_refused([&] { return go_on(*checkpoint), true; });
  }
}
