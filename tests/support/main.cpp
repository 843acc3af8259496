// SPDX-License-Identifier: MIT
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "bench/io/context.h"
#include "bench/options/program_threads.h"
#include "tests/support/backends.h"
#include "tests/support/catalogue.h"

// Properties are tried on the same cases in every run, unless RC_PARAMS says otherwise.
int main(int argc, char** argv) {
  spherepair::wait_passively(argv);
  const std::vector<std::string> command_line(argv, argv + argc);  // before GoogleTest takes its own words out
  testing::InitGoogleTest(&argc, argv);
  setenv("SPHEREPAIR_CACHE", SPHEREPAIR_SCRATCH "/cache", 0);
  setenv("RC_PARAMS", "seed=20251121 max_success=1500", 0);
  if (!testing::GTEST_FLAG(list_tests)) {
    std::cout << "commit: " << spherepair::build_info.commit << "\ndate: " << spherepair::utc_date() << '\n';
    std::cout << (spherepair::full_stress() ? "full form" : "short form; STRESS=full asks for the full one") << '\n';
    for (const auto& entry : spherepair::all_backends())
      std::cout << entry.name << ": " << (entry.backend ? entry.backend->info().device : entry.reason) << '\n';
  }
  testing::UnitTest::GetInstance()->listeners().Append(new spherepair::CatalogueListener(command_line));
  return RUN_ALL_TESTS();
}
