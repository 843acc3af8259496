// SPDX-License-Identifier: MIT
// Lists of arrays in CUDA's memory: the same as those of the host's arrays, in the caller's memory and stream.
#include <limits>

#include "api/open.h"
#include "tests/lists/on_device.h"
#include "tests/oracle/list_oracle.h"
#include "tests/support/backends.h"

namespace spherepair {
namespace {

template <typename Element>
std::vector<Element> read(const sp_array& array) {
  std::vector<Element> values(size_t(array.rows * array.columns));
  EXPECT_EQ(cudaMemcpy(values.data(), array.data, values.size() * sizeof(Element), cudaMemcpyDefault), cudaSuccess);
  return values;
}

// The numbers of a list, wherever they lie.
struct ColumnValues {
  explicit ColumnValues(const sp_pairs& list)
      : first(read<int32_t>(list.first)),
        second(read<int32_t>(list.second)),
        shifts(read<int32_t>(list.shifts)),
        offsets(read<int64_t>(list.offsets)),
        vectors(read<double>(list.vectors)),
        distances(read<double>(list.distances)) {}
  std::vector<int32_t> first, second, shifts;
  std::vector<int64_t> offsets;
  std::vector<double> vectors, distances;
  bool operator==(const ColumnValues&) const = default;
};

class DeviceArraysOfCuda : public WithCuda {
 protected:
  ColumnValues list(const sp_problem& problem) {
    sp_pairs* made = nullptr;
    EXPECT_EQ(sp_list(context_, &problem, SP_SHIFTS | SP_VECTORS | SP_DISTANCES | SP_OFFSETS, &made), SP_OK)
        << sp_message(context_);
    if (!made) return ColumnValues({});
    ColumnValues columns(*made);
    sp_free(made);
    return columns;
  }
  std::string refusal(const sp_problem& problem, sp_status status) {
    int64_t count = 0;
    EXPECT_EQ(sp_count(context_, &problem, &count), status);
    return sp_message(context_);
  }
};

TEST_F(DeviceArraysOfCuda, HaveTheListsOfTheHosts) {
  sp_context* cpu = nullptr;
  ASSERT_EQ(sp_open("cpu", nullptr, 0, &cpu), SP_OK);
  std::swap(cpu, context_);
  Random random(71);
  size_t pairs = 0;
  for (int k = 0; k < 200; ++k) {
    const Both both(random_problem(random), k % 2 == 1);
    const ColumnValues wanted = list(both.host);
    std::swap(cpu, context_);
    EXPECT_TRUE(list(both.device) == wanted) << "case " << k;
    int64_t count = 0;
    EXPECT_EQ(sp_count(context_, &both.device, &count), SP_OK);
    EXPECT_EQ(size_t(count), wanted.first.size());
    std::swap(cpu, context_);
    pairs += wanted.first.size();
  }
  EXPECT_GT(pairs, 1000u);
  std::swap(cpu, context_);
  sp_close(cpu);
}

TEST_F(DeviceArraysOfCuda, FillWritesIntoTheCallersMemory) {
  const std::vector<float> points = {0, 0, 0, 1, 0, 0, 2, 0, 0};
  OnDevice<float> positions(points);
  OnDevice<int32_t> first(6), second(6);
  OnDevice<int64_t> wide(6), offsets(4);
  sp_problem problem = of_array(positions, 1.25);
  sp_pairs pairs = into(first, second);
  pairs.offsets = offsets.array();
  ASSERT_EQ(sp_fill(context_, &problem, &pairs), SP_OK) << sp_message(context_);
  EXPECT_EQ(pairs.count, 4);
  const int32_t untouched = 0x55555555;
  EXPECT_EQ(first.read(), (std::vector<int32_t>{0, 1, 1, 2, untouched, untouched}));
  EXPECT_EQ(second.read(), (std::vector<int32_t>{1, 0, 2, 1, untouched, untouched}));
  EXPECT_EQ(offsets.read(), (std::vector<int64_t>{0, 1, 3, 4}));
  pairs.second = wide.array();
  ASSERT_EQ(sp_fill(context_, &problem, &pairs), SP_OK) << sp_message(context_);
  EXPECT_EQ(wide.read()[2], 2);
  OnDevice<int64_t> found(1), few(3);  // offsets need 4 rows, also where the call does not wait
  pairs.found = found.array();
  for (int k = 0; k < 2; ++k) EXPECT_EQ(sp_fill(context_, &problem, &pairs), SP_OK);
  pairs.offsets = few.array();
  EXPECT_EQ(sp_fill(context_, &problem, &pairs), SP_E_CAPACITY);
  EXPECT_STREQ(sp_message(context_), "offsets has 3 rows, but needs 4");
  pairs.offsets = offsets.array(), pairs.found = {};
  sp_problem none = problem;  // no points to ask
  none.positions.rows = 0, none.queries = problem.positions;
  EXPECT_EQ(sp_fill(context_, &none, &pairs), SP_OK) << sp_message(context_);
  EXPECT_EQ(offsets.read(), (std::vector<int64_t>{0, 0, 0, 0}));
  problem.cutoff = 3;  // six pairs
  OnDevice<int32_t> narrow(5);
  pairs.second = narrow.array();
  EXPECT_EQ(sp_fill(context_, &problem, &pairs), SP_E_CAPACITY);
  EXPECT_EQ(pairs.count, 6);
  EXPECT_STREQ(sp_message(context_), "second has 5 rows, but the list has 6 pairs");
  EXPECT_EQ(narrow.read(), std::vector<int32_t>(5, untouched));
}

// A graph of the third call; it is replayed with other positions, which are given in the same memory.
TEST_F(DeviceArraysOfCuda, FillCanBeCapturedAndFollowsItsStream) {
  cudaStream_t stream = nullptr;
  ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
  OnDevice<double> positions(std::vector<double>{0, 0, 0, 1, 0, 0, 2, 0, 0});
  OnDevice<int32_t> first(4), second(4);
  OnDevice<int64_t> found(1);
  sp_problem problem = of_array(positions, 1.25);
  problem.stream = stream;
  sp_pairs pairs = into(first, second);
  pairs.found = found.array();
  ASSERT_EQ(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), cudaSuccess);
  EXPECT_EQ(sp_fill(context_, &problem, &pairs), SP_E_ARGUMENT);
  EXPECT_TRUE(std::string(sp_message(context_)).starts_with("this call cannot be captured"));
  cudaGraph_t graph = nullptr;
  cudaStreamEndCapture(stream, &graph);
  if (graph) cudaGraphDestroy(graph);
  for (int k = 0; k < 2; ++k) {
    ASSERT_EQ(sp_fill(context_, &problem, &pairs), SP_OK) << sp_message(context_);
    EXPECT_EQ(pairs.count, k == 0 ? 4 : -1);
    cudaStreamSynchronize(stream);
    EXPECT_EQ(found.read(), std::vector<int64_t>{4});
  }
  ASSERT_EQ(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), cudaSuccess);
  EXPECT_EQ(sp_fill(context_, &problem, &pairs), SP_OK) << sp_message(context_);
  ASSERT_EQ(cudaStreamEndCapture(stream, &graph), cudaSuccess);
  cudaGraphExec_t made = nullptr;
  ASSERT_EQ(cudaGraphInstantiate(&made, graph, 0), cudaSuccess);
  const auto replayed = [&](const std::vector<double>& points) {
    positions.write(points);
    EXPECT_EQ(cudaGraphLaunch(made, stream), cudaSuccess);
    EXPECT_EQ(cudaStreamSynchronize(stream), cudaSuccess);
    return found.read()[0];
  };
  EXPECT_EQ(replayed({0, 0, 0, 5, 0, 0, 6, 0, 0}), 2);
  EXPECT_EQ(first.read()[0], 1);
  EXPECT_EQ(second.read()[0], 2);
  const std::vector<int32_t> kept = first.read();
  EXPECT_EQ(replayed({0, 0, 0, 0.5, 0, 0, 1, 0, 0}), 6) << "more than there is room for";
  EXPECT_EQ(first.read(), kept) << "so no pair is written";
  EXPECT_EQ(replayed({0, 0, 0, 0, std::numeric_limits<double>::quiet_NaN(), 0, 1, 0, 0}), -2);
  EXPECT_EQ(replayed({0, 0, 0, 1, 0, 0, 2, 0, 0}), 4);
  cudaGraphExecDestroy(made);
  cudaGraphDestroy(graph);
  cudaStreamDestroy(stream);
}

TEST_F(DeviceArraysOfCuda, WrongArraysAreNamed) {
  std::vector<double> points = {0, 0, 0, 1, 0, 0};
  OnDevice<double> positions(points), bad(std::vector<double>{0, 0, 0, 1, INFINITY, 0}),
      radii(std::vector<double>{1, -1});
  sp_problem problem = of_array(positions, 1);
  EXPECT_EQ(refusal(problem, SP_OK), "");
  problem.positions = bad.array(3);
  EXPECT_EQ(refusal(problem, SP_E_NONFINITE), "positions[1].y is inf");
  problem.positions = positions.array(3), problem.cutoff = 0, problem.radii = radii.array();
  EXPECT_EQ(refusal(problem, SP_E_ARGUMENT), "radii[1] is -1, but must not be negative");
  problem.radii.device_type = 1;
  EXPECT_EQ(refusal(problem, SP_E_ARGUMENT),
            "radii lies in the host's memory, but positions in CUDA's: both must lie in one");
  problem.radii = {}, problem.cutoff = 1, problem.positions.data = points.data();
  EXPECT_TRUE(refusal(problem, SP_E_ARGUMENT).starts_with("positions is not memory of the context's device"));
  problem.positions = positions.array(3), problem.positions.device_id = 7;
  EXPECT_TRUE(refusal(problem, SP_E_ARGUMENT).starts_with("positions is not memory of the context's device"));
}

}  // namespace
}  // namespace spherepair
