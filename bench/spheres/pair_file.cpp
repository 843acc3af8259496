// SPDX-License-Identifier: MIT
#include "bench/spheres/pair_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/spheres/rows_file.h"

namespace spherepair {
namespace {

// As the structured array's rows lie in the file.
struct [[gnu::packed]] ContactRow {
  uint32_t i, j;
  Contact contact;
};
static_assert(sizeof(ContactRow) == 64);

// A sum without rounding, as numbers none of whose bits overlap, ascending.
class ExactSum {
 public:
  void add(double term) {
    size_t kept = 0;
    for (size_t k = 0; k < count_; ++k) {
      const double other = parts_[k], sum = term + other, from_other = sum - term;
      const double rest = (term - (sum - from_other)) + (other - from_other);
      if (rest != 0) parts_[kept++] = rest;
      term = sum;
    }
    parts_[kept] = term;
    count_ = kept + 1;
  }
  void add_product(double a, double b) {
    const double product = a * b, rest = std::fma(a, b, -product);
    if (rest != 0) add(rest);
    if (product != 0) add(product);
  }
  double rounded() const {
    double sum = 0;
    for (size_t k = 0; k < count_; ++k) sum += parts_[k];
    return sum;
  }

 private:
  std::array<double, 32> parts_ = {};  // at most one a term, of which squared_gap has 24
  size_t count_ = 0;
};

// Adds sign * (a + b)^2. No product under- or overflows: float32 squared is far within float64.
void add_square(ExactSum& sum, double sign, float a, float b) {
  const double high = double(a) + b, from_b = high - a, low = (a - (high - from_b)) + (b - from_b);
  sum.add_product(sign * high, high);
  if (low == 0) return;
  sum.add_product(2 * sign * high, low);
  sum.add_product(sign * low, low);
}

// The squared sum of the radii less the squared distance of the centres, to one unit in the last place and with its
// sign: the overlap is this over their sum, without the cancellation of a difference of lengths.
double squared_gap(const vec4& a, const vec4& b) {
  ExactSum sum;
  add_square(sum, 1, a.w, b.w);
  add_square(sum, -1, a.x, -b.x);
  add_square(sum, -1, a.y, -b.y);
  add_square(sum, -1, a.z, -b.z);
  return sum.rounded();
}

}  // namespace

void check_pair_file(const std::string& option, const std::string& file) {
  check_rows_file(option, file, {".npy", ".txt"}, ".npy (NPY), .txt (text) and - (text to standard output)");
}

void write_pairs(const std::string& file, std::span<const Pair> pairs) {
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const Pair& pair : pairs.subspan(first, last - first)) {
      text.append(fmt::format_int(pair.first));
      text.push_back(' ');
      text.append(fmt::format_int(pair.second));
      text.push_back('\n');
    }
  };
  write_rows(file, pairs.size(), rows, [&](const Sink& sink) {
    sink(npy_head("'@u4'", fmt::format("({}, 2)", pairs.size())));
    sink(bytes_of(pairs));
  });
}

Contact contact_of(const Pair& pair, std::span<const vec4> spheres, const std::array<double, 3>& shift) {
  const vec4 &a = spheres[pair.first], &b = spheres[pair.second];
  const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, dz = double(b.z) - a.z;
  const double distance = std::hypot(dx, dy, dz), radii = double(a.w) + b.w;
  Contact contact{.overlap = 0, .normal = {}, .point = {}};
  if (radii + distance > 0) contact.overlap = squared_gap(a, b) / (radii + distance);
  if (distance > 0) contact.normal = {dx / distance, dy / distance, dz / distance};
  const double along = (distance + (double(a.w) - b.w)) / 2;
  contact.point = {a.x + along * contact.normal[0] + shift[0], a.y + along * contact.normal[1] + shift[1],
                   a.z + along * contact.normal[2] + shift[2]};
  return contact;
}

void write_contacts(const std::string& file, std::span<const Pair> pairs, std::span<const vec4> spheres,
                    const std::array<double, 3>& shift) {
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const Pair& pair : pairs.subspan(first, last - first)) {
      const Contact c = contact_of(pair, spheres, shift);
      fmt::format_to(std::back_inserter(text), "{} {} {} {} {}\n", pair.first, pair.second, c.overlap,
                     fmt::join(c.normal, " "), fmt::join(c.point, " "));
    }
  };
  write_rows(file, pairs.size(), rows, [&](const Sink& sink) {
    sink(npy_head("[('i', '@u4'), ('j', '@u4'), ('overlap', '@f8'), ('normal', '@f8', (3,)), ('point', '@f8', (3,))]",
                  fmt::format("({},)", pairs.size())));
    std::vector<ContactRow> packed;
    for (size_t start = 0; start < pairs.size(); start += rows_at_a_time) {
      packed.clear();
      for (const Pair& pair : pairs.subspan(start, std::min(rows_at_a_time, pairs.size() - start)))
        packed.push_back({pair.first, pair.second, contact_of(pair, spheres, shift)});
      sink(bytes_of(std::span<const ContactRow>(packed)));
    }
  });
}

void write_contact_numbers(const std::string& file, std::span<const uint> counts) {
  const Rows rows = [&](fmt::memory_buffer& text, size_t first, size_t last) {
    for (const uint count : counts.subspan(first, last - first)) {
      text.append(fmt::format_int(count));
      text.push_back('\n');
    }
  };
  write_rows(file, counts.size(), rows, [&](const Sink& sink) {
    sink(npy_head("'@u4'", fmt::format("({},)", counts.size())));
    sink(bytes_of(counts));
  });
}

}  // namespace spherepair
