// SPDX-License-Identifier: MIT
// The calls of include/spherepair/spherepair.h: wrong use gets a status and a message, right use the caller's arrays.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "include/spherepair/spherepair.h"

namespace {

template <typename Element>
constexpr sp_type type_of = std::is_same_v<Element, float>     ? SP_F32
                            : std::is_same_v<Element, double>  ? SP_F64
                            : std::is_same_v<Element, int32_t> ? SP_I32
                            : std::is_same_v<Element, int64_t> ? SP_I64
                                                               : SP_U8;

template <typename Element>
sp_array array(std::vector<Element>& values, int64_t columns = 1) {
  return {values.data(), int64_t(values.size()) / columns, columns, columns, 1, type_of<Element>, 1, 0};
}

class CCalls : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(sp_open("cpu", nullptr, 1, &context_), SP_OK) << sp_message(nullptr); }
  void TearDown() override { sp_close(context_); }

  sp_problem problem() {
    sp_problem all = {};
    all.size = sizeof all;
    all.positions = array(positions_, 3);
    all.cutoff = 1.25;
    return all;
  }
  std::string message(const sp_problem& problem, sp_status status = SP_E_ARGUMENT) {
    int64_t count = 0;
    EXPECT_EQ(sp_count(context_, &problem, &count), status);
    return sp_message(context_);
  }

  sp_context* context_ = nullptr;
  std::vector<double> positions_ = {0, 0, 0, 1, 0, 0, 2, 0, 0};  // two neighbours at a distance of 1
};

TEST_F(CCalls, ListHasWhatIsWanted) {
  const sp_problem asked = problem();
  sp_pairs* list = nullptr;
  ASSERT_EQ(sp_list(context_, &asked, SP_OFFSETS | SP_DISTANCES, &list), SP_OK) << sp_message(context_);
  ASSERT_EQ(list->count, 4);
  const auto first = static_cast<const int32_t*>(list->first.data),
             second = static_cast<const int32_t*>(list->second.data);
  EXPECT_EQ(std::vector<int32_t>(first, first + 4), (std::vector<int32_t>{0, 1, 1, 2}));
  EXPECT_EQ(std::vector<int32_t>(second, second + 4), (std::vector<int32_t>{1, 0, 2, 1}));
  const auto offsets = static_cast<const int64_t*>(list->offsets.data);
  EXPECT_EQ(std::vector<int64_t>(offsets, offsets + 4), (std::vector<int64_t>{0, 1, 3, 4}));
  EXPECT_EQ(static_cast<const double*>(list->distances.data)[3], 1.0);
  EXPECT_EQ(list->shifts.data, nullptr);
  EXPECT_EQ(list->vectors.data, nullptr);
  sp_free(list);
  sp_free(nullptr);
}

TEST_F(CCalls, FillWritesOnlyWhatFitsWhole) {
  const sp_problem asked = problem();
  std::vector<int64_t> first(5, -1), second(3, -1);
  sp_pairs pairs = {};
  pairs.size = sizeof pairs;
  EXPECT_EQ(sp_fill(context_, &asked, &pairs), SP_OK) << "no column: counts";
  EXPECT_EQ(pairs.count, 4);
  pairs.first = array(first), pairs.second = array(second);
  EXPECT_EQ(sp_fill(context_, &asked, &pairs), SP_E_CAPACITY);
  EXPECT_EQ(std::string(sp_message(context_)), "second has 3 rows, but the list has 4 pairs");
  EXPECT_EQ(first, std::vector<int64_t>(5, -1));
  second.assign(4, -1), pairs.second = array(second);
  EXPECT_EQ(sp_fill(context_, &asked, &pairs), SP_OK);
  EXPECT_EQ(first, (std::vector<int64_t>{0, 1, 1, 2, -1}));
  EXPECT_EQ(second, (std::vector<int64_t>{1, 0, 2, 1}));
}

// Backwards, and as columns of a larger array.
TEST_F(CCalls, StridesAreObeyed) {
  std::vector<float> wide = {2, 5, 0, 9, 0, 9, 1, -7, 0, 9, 0, 9, 0, 30, 0, 9, 0, 9};
  sp_problem asked = problem();
  asked.positions = {wide.data() + 12, 3, 3, -6, 2, SP_F32, 1, 0};
  std::vector<int32_t> second(8, -1);
  sp_pairs pairs = {};
  pairs.size = sizeof pairs;
  pairs.second = {second.data() + 6, 4, 1, -2, 0, SP_I32, 1, 0};
  ASSERT_EQ(sp_fill(context_, &asked, &pairs), SP_OK) << sp_message(context_);
  EXPECT_EQ(second, (std::vector<int32_t>{1, -1, 2, -1, 0, -1, 1, -1}));
}

TEST_F(CCalls, WrongArgumentsAreNamed) {
  sp_problem wrong = problem();
  wrong.size = 8;
  EXPECT_TRUE(message(wrong).starts_with("problem.size is 8, but sizeof(sp_problem) is "));
  wrong = problem(), wrong.positions.columns = 2;
  EXPECT_EQ(message(wrong), "positions has 3 rows of 2, but each row has 3");
  wrong = problem(), wrong.positions.type = SP_I32;
  EXPECT_EQ(message(wrong), "positions is of type I32, but must be F32 or F64");
  wrong = problem(), wrong.positions.type = 77;
  EXPECT_EQ(message(wrong), "positions is of type 77, but must be F32 or F64");
  wrong = problem(), wrong.positions.data = nullptr;
  EXPECT_EQ(message(wrong), "positions has 3 rows but no data");
  wrong = problem(), wrong.positions.device_type = 2;
  EXPECT_EQ(
      message(wrong),
      "positions lies in CUDA's memory, but the context is of cpu: open a context of cuda, or copy the array to the "
      "host");
  int64_t found = 0;
  sp_pairs pairs = {};
  pairs.size = sizeof pairs, pairs.found = {&found, 1, 1, 1, 1, SP_I64, 1, 0};
  const sp_problem right = problem();
  EXPECT_EQ(sp_fill(context_, &right, &pairs), SP_E_ARGUMENT);
  EXPECT_STREQ(sp_message(context_), "found is given: it is for positions in CUDA's memory");
  wrong = problem(), wrong.positions.device_type = 10;
  EXPECT_TRUE(message(wrong).starts_with("positions lies on a device of type 10"));
  wrong = problem(), wrong.positions.rows = int64_t(1) << 60;
  EXPECT_EQ(message(wrong, SP_E_RANGE), "positions has 1152921504606846976 rows, but 2147483647 at most can be read");
  wrong = problem(), wrong.positions = {};
  EXPECT_EQ(message(wrong), "positions are missing");
  wrong = problem(), wrong.half = 2;
  EXPECT_EQ(message(wrong), "half is 2, but must be 0 or 1");
  positions_[4] = -INFINITY;
  EXPECT_EQ(message(problem(), SP_E_NONFINITE), "positions[1].y is -inf");
}

TEST_F(CCalls, ArraysThatDoNotFitTogetherAreNamed) {
  std::vector<double> radii = {1, 1}, box(9, 1.0);
  std::vector<int64_t> offsets = {0, 2, 1};
  std::vector<int32_t> excluded = {0, 3};
  sp_problem wrong = problem();
  wrong.radii = array(radii);
  EXPECT_EQ(message(wrong), "radii has 2 rows, but positions has 3");
  radii = {1, 1, 1}, wrong.radii = array(radii);
  EXPECT_EQ(message(wrong), "there are radii and a cutoff: give one of them (and a skin)");
  wrong = problem(), wrong.offsets = array(offsets);
  EXPECT_EQ(message(wrong), "offsets[2] is 1, below 2 before it");
  offsets[2] = 4;
  EXPECT_EQ(message(wrong), "offsets ends with 4, but there are 3 points");
  wrong = problem(), wrong.boxes = array(box, 9);
  EXPECT_EQ(message(wrong), "boxes and periodic go together: give both or neither");
  wrong = problem(), wrong.exclusions = array(excluded, 2);
  EXPECT_EQ(message(wrong), "exclusions[0] names point 3, but there are 3");
  wrong = problem(), wrong.queries = array(positions_, 3), wrong.half = 1;
  EXPECT_EQ(message(wrong), "half and self_pairs must be 0 where there are queries");
}

// OpenGL's context belongs to a call, not to the thread that opened it.
TEST_F(CCalls, AnyThreadMayUseAContextAfterAnother) {
  for (int32_t k = 0; const char* name = sp_backend_name(k); ++k) {
    sp_context* other = nullptr;
    if (sp_open(name, nullptr, 1, &other) != SP_OK) continue;
    const auto count = [&] {
      const sp_problem asked = problem();
      int64_t pairs = 0;
      EXPECT_EQ(sp_count(other, &asked, &pairs), SP_OK) << name << ": " << sp_message(other);
      EXPECT_EQ(pairs, 4) << name;
    };
    count();
    std::thread(count).join();
    count();
    std::thread([&] { sp_close(other); }).join();
  }
}

TEST_F(CCalls, MissingPointersAreNoCrash) {
  const sp_problem asked = problem();
  int64_t count = 0;
  sp_pairs* list = nullptr;
  EXPECT_EQ(sp_count(nullptr, &asked, &count), SP_E_ARGUMENT);
  EXPECT_EQ(sp_count(context_, nullptr, &count), SP_E_ARGUMENT);
  EXPECT_EQ(sp_count(context_, &asked, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(sp_list(context_, &asked, 0, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(sp_list(context_, &asked, 16, &list), SP_E_ARGUMENT);
  EXPECT_EQ(list, nullptr);
  EXPECT_EQ(sp_fill(context_, &asked, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(sp_open(nullptr, nullptr, 0, nullptr), SP_E_ARGUMENT);
  EXPECT_EQ(std::string(sp_backend(nullptr)), "");
  sp_close(nullptr);
}

TEST_F(CCalls, BackendsOpenByNameOrSayWhyNot) {
  sp_context* other = nullptr;
  EXPECT_EQ(sp_open("abacus", nullptr, 0, &other), SP_E_ARGUMENT);
  EXPECT_NE(std::string(sp_message(nullptr)).find("abacus"), std::string::npos);
  EXPECT_EQ(sp_open("cpu", "0", 0, &other), SP_E_ARGUMENT);
  EXPECT_EQ(sp_open("cpu", nullptr, -1, &other), SP_E_ARGUMENT);
  EXPECT_EQ(other, nullptr);
  ASSERT_EQ(sp_open("auto", nullptr, 1, &other), SP_OK) << sp_message(nullptr);
  EXPECT_NE(std::string(sp_backend(other)), "");
  const sp_problem asked = problem();
  sp_pairs* list = nullptr;
  ASSERT_EQ(sp_list(other, &asked, 0, &list), SP_OK);
  sp_close(other);
  EXPECT_EQ(list->count, 4) << "a list outlives its context";
  sp_free(list);
  std::vector<std::string> names;
  for (int32_t k = 0; sp_backend_name(k); ++k) names.push_back(sp_backend_name(k));
  EXPECT_EQ(names, (std::vector<std::string>{"cpu", "opengl", "cuda", "vulkan"}));
  EXPECT_EQ(sp_backend_name(-1), nullptr);
  EXPECT_EQ(sp_abi_version(), uint32_t(SP_ABI_VERSION));
}

}  // namespace
