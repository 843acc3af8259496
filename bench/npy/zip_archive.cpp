// SPDX-License-Identifier: MIT
#include "bench/npy/zip_archive.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>

#include "common/backend/backend.h"
#include "common/backend/growing_list.h"
#include "common/scene/counted.h"

namespace spherepair {
namespace {

constexpr uint64_t in_zip64 = 0xffffffff;  // a size or an offset with this value is in the extra field
constexpr uint64_t end_bytes = 22, entry_bytes = 46, local_bytes = 30;

// A record that begins with a signature, and its little-endian numbers.
class Record {
 public:
  Record(const FileBytes& file, uint64_t at, std::string_view signature, uint64_t bytes, std::string_view what)
      : file_(file), at_(at) {
    const std::string_view all = file.bytes();
    if (at > all.size() || all.size() - at < bytes || !all.substr(at).starts_with(signature))
      file.fail_at_byte(std::min<uint64_t>(at, all.size()), what,
                        at >= all.size() ? "the end of the file" : in_quotes(all.substr(at, 4)));
  }
  uint64_t number(uint64_t offset, uint64_t bytes) const {
    return little_endian(file_.bytes().substr(at_ + offset, bytes));
  }
  std::string_view text(uint64_t offset, uint64_t bytes, std::string_view what) const {
    const uint64_t left = file_.bytes().size() - at_ - offset;
    if (bytes > left)
      file_.fail_at_byte(at_ + offset, fmt::format("{} of {}", counted(bytes, "byte"), what),
                         fmt::format("the end of the file after {}", left));
    return file_.bytes().substr(at_ + offset, bytes);
  }

 private:
  const FileBytes& file_;
  uint64_t at_;
};

// Reads the sizes and the offset that need 64 bits. The extra field has only those, in this order.
void read_zip64(std::string_view extra, ZipMember& member) {
  while (extra.size() >= 4) {
    const uint64_t id = little_endian(extra.substr(0, 2));
    const uint64_t size = std::min<uint64_t>(little_endian(extra.substr(2, 2)), extra.size() - 4);
    std::string_view field = extra.substr(4, size);
    for (uint64_t* number : {&member.bytes, &member.packed_bytes, &member.header_at})
      if (id == 1 && *number == in_zip64 && field.size() >= 8) {
        *number = little_endian(field.substr(0, 8));
        field.remove_prefix(8);
      }
    extra.remove_prefix(4 + size);
  }
}

struct Directory {
  uint64_t at, members;
};

Directory find_directory(const FileBytes& file) {
  const size_t at = file.bytes().rfind("PK\5\6");
  if (at == std::string_view::npos)
    file.fail_at_byte(file.bytes().size(), "the directory at the end of a zip archive",
                      "the end of the file: it is truncated");
  const Record end(file, at, "PK\5\6", end_bytes, "the 22 bytes that end a zip archive");
  const Directory directory{end.number(16, 4), end.number(10, 2)};
  if ((directory.at != in_zip64 && directory.members != 0xffff) || at < 20) return directory;
  const Record locator(file, at - 20, "PK\6\7", 20, "the zip64 locator of an archive");
  const Record large(file, locator.number(8, 8), "PK\6\6", 56, "the zip64 end of an archive");
  return {large.number(48, 8), large.number(32, 8)};
}

std::string inflated(const FileBytes& file, const ZipMember& member, std::string_view packed) {
  std::string bytes(member.bytes, 0);
  z_stream stream{};
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw BackendError("zlib cannot start: out of memory");
  constexpr uint64_t most = std::numeric_limits<uInt>::max();
  int status = Z_OK;
  uint64_t read = 0, written = 0;
  while (status == Z_OK) {
    const auto in = uInt(std::min(most, packed.size() - read)), out = uInt(std::min(most, bytes.size() - written));
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data() + read));
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + written);
    stream.avail_in = in, stream.avail_out = out;
    status = inflate(&stream, Z_NO_FLUSH);
    read += in - stream.avail_in, written += out - stream.avail_out;
  }
  inflateEnd(&stream);
  if (status != Z_STREAM_END || written != bytes.size() || read != packed.size())
    file.fail_at_byte(member.header_at, fmt::format("deflated data of {}", counted(member.bytes, "byte")),
                      "damaged data");
  return bytes;
}

}  // namespace

std::vector<ZipMember> zip_members(const FileBytes& file) {
  auto [at, count] = find_directory(file);
  std::vector<ZipMember> members;
  for (uint64_t k = 0; k < count; ++k) {
    const Record entry(file, at, "PK\1\2", entry_bytes,
                       fmt::format("entry {} of {} in the zip directory", k + 1, count));
    ZipMember member{.name = {},
                     .header_at = entry.number(42, 4),
                     .flags = entry.number(8, 2),
                     .method = entry.number(10, 2),
                     .crc = entry.number(16, 4),
                     .packed_bytes = entry.number(20, 4),
                     .bytes = entry.number(24, 4)};
    const uint64_t name = entry.number(28, 2), extra = entry.number(30, 2), comment = entry.number(32, 2);
    member.name = entry.text(entry_bytes, name, "a member's name");
    read_zip64(entry.text(entry_bytes + name, extra, "a member's extra field"), member);
    members.push_back(member);
    at += entry_bytes + name + extra + comment;
  }
  return members;
}

FileBytes unpacked(const FileBytes& file, const ZipMember& member) {
  const auto fail = [&](std::string_view expected, const std::string& found) {
    file.fail_at_byte(member.header_at, fmt::format("{} for {}", expected, in_quotes(member.name)), found);
  };
  const Record local(file, member.header_at, "PK\3\4", local_bytes, "the header of a zip member");
  const uint64_t data_at = local_bytes + local.number(26, 2) + local.number(28, 2);
  local.text(local_bytes, data_at - local_bytes, "the header of a zip member");
  const std::string_view packed = local.text(data_at, member.packed_bytes, in_quotes(member.name));
  if (member.flags & 1) fail("no encryption", "an encrypted member");
  if (member.method != 0 && member.method != 8)
    fail("method 0 (stored) or 8 (deflated)", fmt::format("method {}", member.method));
  if (member.method == 0 ? member.bytes != packed.size() : member.bytes / 1032 > packed.size())
    fail("a size that its data may have", fmt::format("{} in {}", counted(member.bytes, "byte"), packed.size()));
  if (!fits_in_memory(member.bytes))
    throw BackendError(fmt::format("{} in {} has {} bytes, which do not fit in memory: use a machine with more",
                                   in_quotes(member.name), file.name(), member.bytes));
  std::string bytes = member.method == 0 ? std::string(packed) : inflated(file, member, packed);
  const uint64_t crc = crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  if (crc != member.crc)
    fail(fmt::format("the checksum {:08x}", member.crc), fmt::format("{:08x}: the file is damaged", crc));
  return FileBytes(fmt::format("{}, {}", file.name(), in_quotes(member.name)), std::move(bytes));
}

}  // namespace spherepair
