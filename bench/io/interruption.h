// SPDX-License-Identifier: MIT
// Cleans up when a signal ends the program. SIGINT, SIGTERM and SIGHUP remove its temporary files and the still empty
// folders that it made. They print on standard error what was interrupted and which file was written last, or
// the last folder made, and then end the program as usual. replaced_file.h tells of these files. A signal that is
// ignored stays ignored.
#pragma once

#include <filesystem>
#include <string>

namespace spherepair {

// Catches the signals; the message names this command.
void handle_interruption(const std::string& command);

// Creates the folder and those above it. Throws std::filesystem::filesystem_error.
void make_folder(const std::filesystem::path& folder);
void remove_empty_folders();  // removes the empty folders that make_folder made

// A sentence that says how to continue a run that is interrupted from now on; the message has it in place of the last
// file.
void note_resumable(const std::string& sentence);

}  // namespace spherepair
