// SPDX-License-Identifier: MIT
#include "common/files/checkpoint.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstring>

#include "common/files/checkpoint_check.h"
#include "common/files/replaced_file.h"
#include "common/scene/contact_scene.h"
#include "common/scene/counted.h"
#include "common/shared/hash.h"

namespace spherepair {
namespace {

static_assert(std::endian::native == std::endian::little, "checkpoints are little-endian");
constexpr char magic[] = "SPHCHECK";
constexpr uint format_version = 1, version_with_contacts = 5;  // earlier versions lack fields of ContactHeader

struct Header {
  char magic[8];
  uint version, method, precision, anchored_steps, equal_radii, name_length;
  float dt, gravity, plane, restitution;
  uint64_t n, step;
};
static_assert(sizeof(Header) == 64);

struct ContactHeader {
  uint law, walls;  // bit 0 of walls: they close; bits 1 to 3: the box is periodic along x, y, z
  int unit_exponent, momentum_exponent;
  float stiffness, low[3], high[3];
  float drag;     // from version 3 on
  float skin;     // from version 4 on
  float density;  // from version 5 on
};
static_assert(sizeof(ContactHeader) == 56);
constexpr size_t contact_bytes[] = {0, 0, 44, 48, 52, 56};  // by version

template <typename T>
std::string_view bytes_of(const T* values, size_t count = 1) {
  return {reinterpret_cast<const char*>(values), count * sizeof(T)};
}

// Visits the parts in the order of the file, for writing and for reading.
template <typename Any, typename Visit>
void visit_all(Any& checkpoint, Visit visit) {
  visit("positions", checkpoint.scene.positions);
  visit("velocities", checkpoint.scene.velocities);
  visit_parts(checkpoint.motion, [&](uint, const char* name, auto& part) { visit(name, part); });
}

class Reader {
 public:
  explicit Reader(const FileBytes& file) : file_(file) {}

  std::string_view take(uint64_t bytes, const std::string& what) {
    item_ = at_;
    if (bytes > file_.bytes().size() - at_)
      fail(fmt::format("{} of {}", counted(bytes, "byte"), what),
           fmt::format("{}: cut off", file_.bytes().size() - at_));
    at_ += bytes;
    return file_.bytes().substr(at_ - bytes, bytes);
  }
  template <typename T>
  T number(const std::string& what) {
    T value;
    std::memcpy(&value, take(sizeof(T), what).data(), sizeof(T));
    return value;
  }
  // Throws unless the bytes read have the checksum that was written.
  void verify(std::string_view bytes, const std::string& what) {
    const uint64_t given = number<uint64_t>("the checksum of the " + what), wanted = checksum(bytes);
    if (given != wanted)
      fail(fmt::format("the checksum {:016x} of the {}", wanted, what), fmt::format("{:016x}: damaged", given));
  }
  void finish() {
    item_ = at_;
    if (at_ != file_.bytes().size()) fail("the end", counted(file_.bytes().size() - at_, "byte") + " more");
  }
  // Throws with the position of the item taken last.
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    file_.fail_at_byte(item_, expected, found);
  }

 private:
  const FileBytes& file_;
  uint64_t at_ = 0, item_ = 0;
};

Header read_header(Reader& reader) {
  const std::string_view start = reader.take(8, "a checkpoint's mark");
  if (start != std::string_view(magic, 8)) reader.fail(magic, in_quotes(start) + ": no checkpoint");
  Header header;
  std::memcpy(header.magic, start.data(), 8);
  header.version = reader.number<uint>("the version");
  if (header.version < format_version || header.version > version_with_contacts)
    reader.fail(fmt::format("version {} to {}", format_version, version_with_contacts),
                fmt::format("version {}", header.version));
  const std::string_view rest = reader.take(sizeof(Header) - 12, "the header");
  std::memcpy(reinterpret_cast<char*>(&header) + 12, rest.data(), rest.size());
  return header;
}

ContactHeader header_of(const ContactOptions& c) {
  return {uint(c.law),
          uint(c.walls) | c.periodic << 1,
          c.unit_exponent,
          c.momentum_exponent,
          c.stiffness,
          {c.low.x, c.low.y, c.low.z},
          {c.high.x, c.high.y, c.high.z},
          c.drag,
          c.skin,
          c.density};
}

ContactOptions contacts_of(Reader& reader, const Header& header, const ContactHeader& c) {
  const bool leaps = header.method == MOTION_LEAPFROG && header.precision == PRECISION_FIXED;
  const bool known = c.law != CONTACT_NONE && c.law <= CONTACT_HERTZ && c.walls <= 15;
  if (!leaps || !known || std::abs(c.unit_exponent) > 100 || std::abs(c.momentum_exponent) > 200)
    reader.fail("the leapfrog in fixed precision, a known law of contacts, and its units",
                fmt::format("method {}, precision {}, law {}, units 2^-{} and 2^-{}", header.method, header.precision,
                            c.law, c.unit_exponent, c.momentum_exponent));
  return {.law = ContactLaw(c.law),
          .stiffness = c.stiffness,
          .density = c.density,
          .drag = c.drag,
          .walls = (c.walls & 1) != 0,
          .low = {c.low[0], c.low[1], c.low[2], 0},
          .high = {c.high[0], c.high[1], c.high[2], 0},
          .periodic = c.walls >> 1,
          .unit_exponent = c.unit_exponent,
          .momentum_exponent = c.momentum_exponent,
          .skin = c.skin};
}

// The number of elements that a part of this checkpoint must have.
uint64_t wanted_size(const Checkpoint& c, const void* part) {
  const MotionOptions& motion = c.scene.motion;
  const uint64_t n = c.scene.size(), anchored = motion.method == MotionMethod::anchored;
  if (part == &c.motion.wide) return motion.precision == Precision::float32 ? 0 : 12 * n;
  if (part == &c.motion.flights) return anchored * 2 * n * real_words(motion.precision);
  if (part == &c.motion.anchors || part == &c.motion.since || part == &c.motion.next_event) return anchored * n;
  return n;
}

template <typename T>
void read_part(Reader& reader, const std::string& name, std::vector<T>& part, uint64_t size) {
  const uint64_t bytes = reader.number<uint64_t>("the length of the " + name);
  if (bytes != size * sizeof(T))
    reader.fail(fmt::format("{} of {}", counted(size * sizeof(T), "byte"), name), fmt::format("a length of {}", bytes));
  const std::string_view data = reader.take(bytes, name);
  reader.verify(data, name);
  part.resize(size);
  if (size) std::memcpy(part.data(), data.data(), bytes);
}

}  // namespace

uint64_t checksum(std::string_view bytes) {
  uint64_t sum = splitmix64(bytes.size());
  for (size_t at = 0; at < bytes.size(); at += 8) {
    uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<size_t>(8, bytes.size() - at));
    sum = splitmix64(sum ^ word);
  }
  return sum;
}

uint64_t checkpoint_bytes(const Checkpoint& checkpoint) {
  const bool contacts = checkpoint.scene.contact.law != ContactLaw::none;
  uint64_t bytes = sizeof(Header) + (contacts ? sizeof(ContactHeader) : 0) + checkpoint.scene.name.size() + 8;
  visit_all(checkpoint, [&](const std::string&, const auto& part) { bytes += part.size() * sizeof part[0] + 16; });
  return bytes;
}

void write_checkpoint(const Checkpoint& checkpoint, const std::function<void(std::string_view)>& write) {
  const Scene& scene = checkpoint.scene;
  const bool contacts = scene.contact.law != ContactLaw::none;
  Header header{{},
                contacts ? version_with_contacts : format_version,
                uint(scene.motion.method),
                uint(scene.motion.precision),
                checkpoint.motion.steps,
                scene.equal_radii,
                uint(scene.name.size()),
                scene.dt,
                scene.gravity,
                scene.plane,
                scene.restitution,
                scene.size(),
                checkpoint.step};
  std::memcpy(header.magic, magic, 8);
  const ContactHeader contact = header_of(scene.contact);
  const std::string start =
      std::string(bytes_of(&header)) + std::string(contacts ? bytes_of(&contact) : "") + scene.name;
  const auto write_number = [&](uint64_t number) { write(bytes_of(&number)); };
  write(start);
  write_number(checksum(start));
  visit_all(checkpoint, [&](const std::string&, const auto& part) {
    const std::string_view bytes = bytes_of(part.data(), part.size());
    write_number(bytes.size());
    write(bytes);
    write_number(checksum(bytes));
  });
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
  ReplacedFile file(path);
  write_checkpoint(checkpoint, [&](std::string_view bytes) { file.write(bytes); });
  file.commit();
}

Checkpoint read_checkpoint(const FileBytes& file) {
  Reader reader(file);
  const Header header = read_header(reader);
  Checkpoint checkpoint;
  Scene& scene = checkpoint.scene;
  const bool contacts = header.version != format_version;
  const size_t bytes = contact_bytes[header.version];
  const std::string contact(contacts ? reader.take(bytes, "the contacts") : "");
  scene.name = reader.take(header.name_length, "the scene's name");
  reader.verify(std::string(bytes_of(&header)) + contact + scene.name, "header");
  const bool known = contacts || (header.method <= MOTION_ANCHORED && header.precision <= PRECISION_FLOAT64);
  if (!known || header.n > 0x7FFFFFFF)
    reader.fail("a known motion method and precision and at most 2147483647 spheres",
                fmt::format("method {}, precision {}, n = {}", header.method, header.precision, header.n));
  scene.motion = {MotionMethod(header.method), Precision(header.precision)};
  if (contacts) {
    ContactHeader read{};
    read.density = water;
    std::memcpy(&read, contact.data(), bytes);
    scene.contact = contacts_of(reader, header, read);
  }
  scene.dt = header.dt, scene.gravity = header.gravity, scene.plane = header.plane;
  scene.restitution = header.restitution, scene.equal_radii = header.equal_radii != 0;
  checkpoint.motion.steps = header.anchored_steps, checkpoint.step = header.step;
  if (contacts) checkpoint.motion.contact_steps = header.step;
  visit_all(checkpoint, [&](const std::string& name, auto& part) {
    read_part(reader, name, part, name == "positions" ? header.n : wanted_size(checkpoint, &part));
  });
  reader.finish();
  if (contacts && bytes < offsetof(ContactHeader, density)) scene.contact.skin = skin_of(scene);
  check_contents(checkpoint, file.name());
  return checkpoint;
}

}  // namespace spherepair
