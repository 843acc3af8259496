// SPDX-License-Identifier: MIT
// Writes the stress catalogue as a table: the rows that ran, their backend, figure and bound, and whether they passed.
// A test of a row is named RowNN_WhatItShows, whatever its suite.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace spherepair {

// Notes a measurement of a row for the table; several of one test are joined.
void note_figure(const std::string& figure, const std::string& bound = {});

// Counts one more comparison of a test: "answers" (collision sets) or "states".
void count_figure(const std::string& what);

// Collects rows as tests end; writes stress.txt and stress.json, with machine and commit, into the folder that
// SPHEREPAIR_RECORD names, if any.
class CatalogueListener : public testing::EmptyTestEventListener {
 public:
  explicit CatalogueListener(std::vector<std::string> command_line) : command_line_(std::move(command_line)) {}
  void OnTestEnd(const testing::TestInfo& info) override;
  void OnTestProgramEnd(const testing::UnitTest& program) override;

 private:
  struct Row {
    int number;
    std::string name, scene, backend, figure, bound, verdict;
    double seconds;
  };
  std::vector<std::string> command_line_;
  std::vector<Row> rows_;
};

}  // namespace spherepair
