// SPDX-License-Identifier: MIT
// Puts arrays of tests into CUDA's memory.
#pragma once

#include <cuda_runtime_api.h>
#include <gtest/gtest.h>

#include "common/lists/list_problem.h"
#include "include/spherepair/spherepair.h"
#include "tests/support/backends.h"

namespace spherepair {

// A copy of a host vector in CUDA's memory.
template <typename Element>
class OnDevice {
 public:
  explicit OnDevice(size_t count) : count_(count) {
    EXPECT_EQ(cudaMalloc(&data_, std::max<size_t>(count, 1) * sizeof(Element)), cudaSuccess);
    EXPECT_EQ(cudaMemset(data_, 0x55, count * sizeof(Element)), cudaSuccess);
  }
  explicit OnDevice(const std::vector<Element>& values) : OnDevice(values.size()) { write(values); }
  ~OnDevice() { cudaFree(data_); }
  OnDevice(const OnDevice&) = delete;
  OnDevice& operator=(const OnDevice&) = delete;

  void write(const std::vector<Element>& values) {
    cudaMemcpy(data_, values.data(), values.size() * sizeof(Element), cudaMemcpyHostToDevice);
    cudaDeviceSynchronize();  // other streams do not wait for the copy
  }
  std::vector<Element> read() const {
    std::vector<Element> values(count_);
    EXPECT_EQ(cudaMemcpy(values.data(), data_, count_ * sizeof(Element), cudaMemcpyDeviceToHost), cudaSuccess);
    return values;
  }
  sp_array array(int64_t columns = 1) {
    constexpr sp_type type = std::is_same_v<Element, float>     ? SP_F32
                             : std::is_same_v<Element, double>  ? SP_F64
                             : std::is_same_v<Element, int32_t> ? SP_I32
                             : std::is_same_v<Element, int64_t> ? SP_I64
                                                                : SP_U8;
    return {data_, int64_t(count_) / columns, columns, columns, 1, type, 2, 0};
  }

 private:
  size_t count_;
  void* data_ = nullptr;
};

// A problem in the host's memory, and the same in CUDA's memory.
struct Both {
  explicit Both(const ListProblem& problem, bool wide_rows)
      : points(numbers(problem.set)),
        queries(numbers(problem.queries)),
        radii(problem.set.radii),
        query_radii(problem.queries.radii),
        offsets(problem.set.offsets.begin(), problem.set.offsets.end()),
        query_offsets(problem.queries.offsets.begin(), problem.queries.offsets.end()) {
    for (const ListBox& box : problem.boxes)
      for (size_t k = 0; k < 3; ++k) {
        rows.insert(rows.end(), box.rows[k].begin(), box.rows[k].end());
        flags.push_back(box.periodic[k]);
      }
    for (const auto& [i, j] : problem.exclusions) exclusions.push_back(i), exclusions.push_back(j);
    const auto on_host = [](auto& values, int64_t columns, sp_type type) {
      static double none = 0;
      void* const data = values.empty() ? static_cast<void*>(&none) : values.data();
      return sp_array{data, int64_t(values.size()) / columns, columns, columns, 1, type, 1, 0};
    };
    const bool sized = !radii.empty() || !query_radii.empty();
    host.size = sizeof(sp_problem);
    host.positions = on_host(points, 3, SP_F64);
    if (sized) host.radii = on_host(radii, 1, SP_F64);
    host.cutoff = problem.cutoff, host.skin = problem.skin;
    host.boxes = on_host(rows, 9, SP_F64), host.periodic = on_host(flags, 3, SP_U8);
    host.offsets = on_host(offsets, 1, SP_I64);
    if (!exclusions.empty()) host.exclusions = on_host(exclusions, 2, SP_I32);
    host.half = problem.half, host.inclusive = problem.inclusive, host.self_pairs = problem.self_pairs;
    if (problem.asks) {
      host.queries = on_host(queries, 3, SP_F64), host.query_offsets = on_host(query_offsets, 1, SP_I64);
      if (sized) host.query_radii = on_host(query_radii, 1, SP_F64);
    }
    device = host;
    // Points as the first three of five numbers.
    std::vector<double> spread(points.size() / 3 * 5, -1);
    for (size_t k = 0; k < points.size(); ++k) spread[k / 3 * 5 + k % 3] = points[k];
    on_device_.push_back(std::make_unique<OnDevice<double>>(wide_rows ? spread : points));
    device.positions = on_device_.back()->array(wide_rows ? 5 : 3);
    device.positions.columns = 3;
    const auto move = [&](sp_array& array, const std::vector<double>& values, int64_t columns) {
      if (!array.data) return;
      on_device_.push_back(std::make_unique<OnDevice<double>>(values));
      array = on_device_.back()->array(columns);
    };
    move(device.queries, queries, 3), move(device.radii, radii, 1), move(device.query_radii, query_radii, 1);
    move(device.boxes, rows, 9);  // flags, offsets and exclusions stay on the host
  }
  static std::vector<double> numbers(const PointSet& set) {
    std::vector<double> all;
    for (const Point3& point : set.points) all.insert(all.end(), point.begin(), point.end());
    return all;
  }

  std::vector<double> points, queries, radii, query_radii, rows;
  std::vector<int64_t> offsets, query_offsets;
  std::vector<int32_t> exclusions;
  std::vector<uint8_t> flags;
  sp_problem host = {}, device = {};

 private:
  std::vector<std::unique_ptr<OnDevice<double>>> on_device_;
};

template <typename Number>
sp_problem of_array(OnDevice<Number>& positions, double cutoff) {
  sp_problem problem = {};
  problem.size = sizeof problem, problem.positions = positions.array(3), problem.cutoff = cutoff;
  return problem;
}

inline sp_pairs into(OnDevice<int32_t>& first, OnDevice<int32_t>& second) {
  sp_pairs pairs = {};
  pairs.size = sizeof pairs, pairs.first = first.array(), pairs.second = second.array();
  return pairs;
}

// A context of cuda, without which the test is skipped.
class WithCuda : public testing::Test {
 protected:
  void SetUp() override {
    if (sp_open("cuda", nullptr, 0, &context_) == SP_OK) return;
    if (backend_required("cuda")) FAIL() << sp_message(nullptr);
    GTEST_SKIP() << sp_message(nullptr);
  }
  void TearDown() override { sp_close(context_); }

  sp_context* context_ = nullptr;
};

}  // namespace spherepair
