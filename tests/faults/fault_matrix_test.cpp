// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "fault_runs.hpp"
#include "simulation/faults.hpp"

namespace surefoot::benchmarks {
namespace {

const simulation::Fault& fault_named(const std::vector<simulation::Fault>& all,
                                     const std::string& name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& fault) { return fault.name == name; });
  if (found == all.end()) throw std::invalid_argument("no fault is named " + name);
  return *found;
}

// Something a hand before the sensor hides nine tenths of the foyer. What is left fits in more than
// one place of a map: no such scan may say where it is.
TEST(FaultMatrix, ACoveredSensorIsNotFoundAtAWrongPlace) {
  const FaultWalk walk(WalkSpec::parse("foyer:62"));
  const FaultWalk elsewhere({"playground", 99, ""});
  const std::vector<simulation::Fault> all = simulation::fault_catalogue();
  const std::vector<JudgedScan> scans =
      run_fault(walk, elsewhere, fault_named(all, "covered near"), simulation::kFaultyScans);
  ASSERT_EQ(scans.size(), simulation::kFaultyScans);
  EXPECT_EQ(std::count_if(scans.begin(), scans.end(),
                          [](const JudgedScan& scan) { return scan.false_ok(); }),
            0);
  EXPECT_EQ(scans.back().estimate.status, Status::ok);  // found again after it
  ASSERT_TRUE(scans.back().since_fault);
  EXPECT_FALSE(scans.back().since_fault->wrong());
}

}  // namespace
}  // namespace surefoot::benchmarks
