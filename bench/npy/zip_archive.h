// SPDX-License-Identifier: MIT
// Reads the members of a zip archive (PKWARE's APPNOTE.TXT), stored or deflated, as in NPZ files.
#pragma once

#include <vector>

#include "common/files/file_bytes.h"

namespace spherepair {

struct ZipMember {
  std::string name;
  uint64_t header_at = 0;  // byte offset of the local header
  uint64_t flags = 0, method = 0, crc = 0;
  uint64_t packed_bytes = 0, bytes = 0;
};

// The members in the order of the central directory, also in archives beyond 4 GiB (zip64).
std::vector<ZipMember> zip_members(const FileBytes& file);

// The bytes of a member, as a file named `FILE, 'NAME'`.
FileBytes unpacked(const FileBytes& file, const ZipMember& member);

}  // namespace spherepair
