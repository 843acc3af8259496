// SPDX-License-Identifier: MIT
// Columns of the caller's in CUDA's memory: what a fill allocates, writes and copies.
#include "tests/lists/on_device.h"

namespace spherepair {
namespace {

using DeviceColumnsOfCuda = WithCuda;

TEST_F(DeviceColumnsOfCuda, ColumnsOfTheCallersAreNotAllocatedAgain) {
  constexpr size_t room = 1 << 26;
  OnDevice<float> positions(std::vector<float>{0, 0, 0, 1, 0, 0, 2, 0, 0});
  OnDevice<int32_t> first(room), second(room), shifts(3 * room);
  OnDevice<int64_t> wide(room), found(1);
  sp_problem problem = of_array(positions, 1.25);
  int64_t count = 0;
  ASSERT_EQ(sp_count(context_, &problem, &count), SP_OK) << sp_message(context_);
  sp_pairs pairs = into(first, second);
  pairs.shifts = shifts.array(3), pairs.found = found.array();
  const auto allocated_by_fill = [&] {
    size_t before = 0, after = 0, total = 0;
    cudaMemGetInfo(&before, &total);
    EXPECT_EQ(sp_fill(context_, &problem, &pairs), SP_OK) << sp_message(context_);
    cudaDeviceSynchronize();
    cudaMemGetInfo(&after, &total);
    return before - after;
  };
  const size_t column = room * sizeof(int32_t), slack = column / 4;  // other processes may allocate, too
  EXPECT_LT(allocated_by_fill(), 5 * column / 2 + slack)
      << "keys alone: 1.5 times the room at their rows' places, and the room";
  EXPECT_LT(allocated_by_fill(), slack);
  EXPECT_EQ(pairs.count, -1) << "it has not waited";
  pairs.second = wide.array();  // is no place for int32, so the list needs its own
  EXPECT_GT(allocated_by_fill(), column - slack);
  EXPECT_LT(allocated_by_fill(), slack);
  EXPECT_EQ(wide.read()[3], 1);
}

TEST_F(DeviceColumnsOfCuda, FoundIsWrittenWhereThereIsTooLittleRoom) {
  OnDevice<float> positions(std::vector<float>{0, 0, 0, 1, 0, 0, 2, 0, 0});
  OnDevice<int32_t> first(3), second(3);
  OnDevice<int64_t> found(1);
  sp_problem problem = of_array(positions, 1.25);
  sp_pairs pairs = into(first, second);
  for (const sp_status status : {SP_E_CAPACITY, SP_OK}) {  // the first call knows the count, the second does not wait
    found.write({-7});
    pairs.found = found.array();
    EXPECT_EQ(sp_fill(context_, &problem, &pairs), status);
    EXPECT_EQ(pairs.count, status == SP_OK ? -1 : 4);
    EXPECT_EQ(found.read(), std::vector<int64_t>{4});
    EXPECT_EQ(first.read(), std::vector<int32_t>(3, 0x55555555));
  }
}

TEST_F(DeviceColumnsOfCuda, ACaptureNamesArraysThatWouldBeCopied) {
  cudaStream_t stream = nullptr;
  ASSERT_EQ(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking), cudaSuccess);
  OnDevice<double> positions(std::vector<double>{0, 0, 0, 1, 0, 0}),
      box(std::vector<double>{5, 0, 0, 0, 5, 0, 0, 0, 5});
  std::vector<uint8_t> flags = {1, 1, 1};
  OnDevice<int32_t> first(4), second(4);
  OnDevice<int64_t> found(1);
  sp_problem problem = of_array(positions, 1.25);
  problem.stream = stream, problem.boxes = box.array(9);
  problem.periodic = {flags.data(), 1, 3, 3, 1, SP_U8, 1, 0};
  sp_pairs pairs = into(first, second);
  pairs.found = found.array();
  ASSERT_EQ(sp_fill(context_, &problem, &pairs), SP_OK) << sp_message(context_);
  ASSERT_EQ(cudaStreamBeginCapture(stream, cudaStreamCaptureModeThreadLocal), cudaSuccess);
  EXPECT_EQ(sp_fill(context_, &problem, &pairs), SP_E_ARGUMENT);
  EXPECT_STREQ(sp_message(context_),
               "this call cannot be captured, since it copies boxes to the host: give boxes in the host's memory");
  cudaGraph_t graph = nullptr;
  EXPECT_EQ(cudaStreamEndCapture(stream, &graph), cudaSuccess) << "the capture goes on";
  if (graph) cudaGraphDestroy(graph);
  cudaStreamDestroy(stream);
}

}  // namespace
}  // namespace spherepair
