// SPDX-License-Identifier: MIT
// Writes spheres as VTK's XML PolyData (.vtp; docs.vtk.org, "XML file formats"), with its arrays as raw bytes.
#include <fmt/format.h>

#include <bit>
#include <vector>

#include "bench/output/sphere_output.h"

namespace spherepair {
namespace {

struct Array {
  const char *name, *type;
  uint64_t components, bytes_each;
};
constexpr Array points = {"Points", "Float32", 3, 4}, radius = {"radius", "Float32", 1, 4},
                velocity = {"velocity", "Float32", 3, 4}, connectivity = {"connectivity", "Int64", 1, 8},
                offsets = {"offsets", "Int64", 1, 8};

class VtpWriter {
 public:
  VtpWriter(const Sink& sink, uint64_t count) : sink_(sink), count_(count) {}

  // Describes arrays, which must be written in the order of their descriptions.
  std::string described(std::initializer_list<Array> arrays) {
    std::string text;
    for (const Array& array : arrays) {
      text += fmt::format(
          "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
          array.type, array.name, array.components, next_);
      next_ += sizeof(uint64_t) + bytes_of_array(array);
    }
    return text;
  }

  // Writes number_of(sphere, component) for all spheres.
  template <typename Number>
  void write(const Array& array, auto number_of) {
    const uint64_t bytes = bytes_of_array(array);
    sink_(bytes_of(std::span<const uint64_t>(&bytes, 1)));
    std::vector<Number> numbers;
    for (size_t start = 0; start < count_; start += rows_at_a_time) {
      numbers.clear();
      for (size_t i = start; i < std::min<size_t>(start + rows_at_a_time, count_); ++i)
        for (uint64_t k = 0; k < array.components; ++k) numbers.push_back(Number(number_of(i, k)));
      sink_(bytes_of(std::span<const Number>(numbers)));
    }
  }

 private:
  uint64_t bytes_of_array(const Array& array) const { return count_ * array.components * array.bytes_each; }

  const Sink& sink_;
  uint64_t count_, next_ = 0;
};

}  // namespace

void write_vtp(const Sink& sink, std::span<const vec4> positions, std::span<const vec4> velocities) {
  VtpWriter writer(sink, positions.size());
  const char* order = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
  std::string head = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"{}\" header_type=\"UInt64\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      order, positions.size(), positions.size());
  head +=
      "<Points>\n" + writer.described({points}) + "</Points>\n<PointData Scalars=\"radius\" Vectors=\"velocity\">\n";
  head += writer.described({radius, velocity}) + "</PointData>\n<Verts>\n";
  head += writer.described({connectivity, offsets});
  sink(head + "</Verts>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_");
  const auto component = [](const vec4& v, uint64_t k) { return k == 0 ? v.x : k == 1 ? v.y : v.z; };
  writer.write<float>(points, [&](size_t i, uint64_t k) { return component(positions[i], k); });
  writer.write<float>(radius, [&](size_t i, uint64_t) { return positions[i].w; });
  writer.write<float>(velocity, [&](size_t i, uint64_t k) { return component(velocities[i], k); });
  writer.write<int64_t>(connectivity, [](size_t i, uint64_t) { return i; });
  writer.write<int64_t>(offsets, [](size_t i, uint64_t) { return i + 1; });
  sink("\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace spherepair
