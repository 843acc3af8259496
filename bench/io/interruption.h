// SPDX-License-Identifier: MIT
// What a program that ends early leaves behind and says. SIGINT, SIGTERM and SIGHUP remove its temporary files and the
// folders that it made and that are still empty, say on standard error what was interrupted and what is kept, and then
// end the program as if they had not been caught. A signal that is ignored stays ignored.
#pragma once

#include <filesystem>
#include <string>

namespace spherepair {

// Catches the signals, which then name this command.
void handle_interruption(const std::string& command);

// Files that a signal removes.
void keep_temporary(const std::string& file);
void forget_temporary(const std::string& file);

// Creates the folder and those above it. Throws std::filesystem::filesystem_error.
void make_folder(const std::filesystem::path& folder);
void remove_empty_folders();  // of those that make_folder made

// A file that is complete and stays. In the last folder made, it is the folder that is named.
void note_written(const std::filesystem::path& file);

// What a run that is interrupted from now on can be continued from, in a sentence: said in place of the last file.
void note_resumable(const std::string& sentence);

}  // namespace spherepair
