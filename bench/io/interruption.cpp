// SPDX-License-Identifier: MIT
#include "bench/io/interruption.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>
#include <mutex>
#include <vector>

#include "common/files/replaced_file.h"

namespace spherepair {
namespace {

namespace fs = std::filesystem;

// A name that a signal handler can read: the handler may neither lock nor allocate.
struct Name {
  std::atomic<bool> taken = false, ready = false;
  std::array<char, PATH_MAX> text;

  void set(const std::string& value) {
    ready = false;
    std::ranges::copy(value.substr(0, text.size() - 1) + '\0', text.begin());
    ready = true;
  }
};
std::array<Name, 64> temporaries;
std::array<Name, 16> new_folders;  // each before those within it
Name command, results;             // results: the last folder made
std::mutex writing;
std::atomic<bool> on_terminal = false;  // a line of progress may be on the terminal

// Holds the last name, and the one before it while the last is being set.
struct LastName {
  std::array<Name, 2> names;
  std::atomic<size_t> last = 0;

  const Name& name() const { return names[last]; }
  void set(const std::string& value) {
    const std::lock_guard lock(writing);
    const size_t next = 1 - last;
    names[next].set(value);
    last = next;
  }
} written, resumable;

template <size_t most>
void keep(std::array<Name, most>& names, const std::string& text) {
  for (Name& each : names) {
    if (text.size() >= each.text.size() || each.taken.exchange(true)) continue;
    return each.set(text);
  }
}

void say(const char* text) {
  if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;  // the message cannot be shown anywhere
}

void say_what_is_kept() {
  say(on_terminal ? "\nspherepair: " : "spherepair: ");
  say(command.text.data());
  const Name &file = written.name(), &from = resumable.name();
  if (from.ready) {
    say(" interrupted: ");
    say(from.text.data());
    return say("\n");
  }
  if (!file.ready) return say(" interrupted: nothing was written\n");
  say(results.ready ? " interrupted: what was finished is in " : " interrupted: the last file written is ");
  say((results.ready ? results : file).text.data());
  say("\n");
}

// A second signal changes nothing: it waits in this thread, and returns at once in another thread.
void interrupted(int signal) {
  static std::atomic_flag entered;
  if (entered.test_and_set()) return;
  for (const Name& temporary : temporaries)
    if (temporary.ready) ::unlink(temporary.text.data());
  remove_empty_folders();
  if (command.ready) say_what_is_kept();
  ::signal(signal, SIG_DFL);
  ::raise(signal);  // raises the signal again, which ends the process on return
}

constexpr int endings[] = {SIGINT, SIGTERM, SIGHUP};

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = interrupted;
  for (const int signal : endings) sigaddset(&action.sa_mask, signal);
  for (const int signal : endings) {
    struct sigaction old {};
    if (::sigaction(signal, nullptr, &old) == 0 && old.sa_handler == SIG_DFL) ::sigaction(signal, &action, nullptr);
  }
}

// A signal removes this file.
void keep_temporary(const std::string& file) {
  catch_signals();
  keep(temporaries, file);
}

void forget_temporary(const std::string& file) {
  for (Name& each : temporaries) {
    if (!each.ready || file != each.text.data()) continue;
    each.ready = false;
    each.taken = false;
  }
}

void note_written(const fs::path& file) { written.set(file.string()); }

// In every program that links this file.
[[maybe_unused]] const bool listens = (tell_of_files({keep_temporary, forget_temporary, note_written}), true);

}  // namespace

void handle_interruption(const std::string& name) {
  command.set(name);
  on_terminal = ::isatty(STDERR_FILENO) != 0;
  catch_signals();
}

void make_folder(const fs::path& folder) {
  std::vector<fs::path> missing;
  for (fs::path each = fs::absolute(folder); !fs::exists(each); each = each.parent_path()) missing.push_back(each);
  fs::create_directories(folder);
  for (const fs::path& each : std::vector(missing.rbegin(), missing.rend())) keep(new_folders, each.string());
  results.set(folder.string());
}

void remove_empty_folders() {
  for (size_t k = new_folders.size(); k-- > 0;)
    if (new_folders[k].ready) ::rmdir(new_folders[k].text.data());
}

void note_resumable(const std::string& sentence) { resumable.set(sentence); }

}  // namespace spherepair
