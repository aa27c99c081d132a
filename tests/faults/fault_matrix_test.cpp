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

std::vector<JudgedScan> judged(const char* walk, const std::string& fault) {
  const FaultWalk elsewhere({"playground", 99, ""});
  const std::vector<simulation::Fault> all = simulation::fault_catalogue();
  return run_fault(FaultWalk(WalkSpec::parse(walk)), elsewhere, fault_named(all, fault),
                   simulation::kFaultyScans);
}

std::ptrdiff_t false_oks(const std::vector<JudgedScan>& scans) {
  return std::count_if(scans.begin(), scans.end(),
                       [](const JudgedScan& scan) { return scan.false_ok(); });
}

/// No pose of the run may be wrong and called ok, and the last is right again.
void expect_never_wrong_silently(const char* walk, const std::string& fault) {
  const std::vector<JudgedScan> scans = judged(walk, fault);
  ASSERT_EQ(scans.size(), simulation::kFaultyScans);
  EXPECT_EQ(false_oks(scans), 0);
  EXPECT_EQ(scans.back().estimate.status, Status::ok);
  ASSERT_TRUE(scans.back().since_fault);
  EXPECT_FALSE(scans.back().since_fault->wrong());
}

// Something a hand before the sensor hides nine tenths of the foyer. What is left fits in more than
// one place of a map: no such scan may say where it is.
TEST(FaultMatrix, ACoveredSensorIsNotFoundAtAWrongPlace) {
  expect_never_wrong_silently("foyer:62", "covered near");
}

// Along a corridor a metre hardly shows; but where it was put, the scan fits four times better.
TEST(FaultMatrix, AMetreAlongACorridorIsSeen) {
  expect_never_wrong_silently("corridor:73", "carried 1 m");
}

// Thinned to a point per cube, a tenth of strays would be most of what a corridor is registered by.
TEST(FaultMatrix, StraysDoNotOutnumberWalls) {
  expect_never_wrong_silently("corridor:73", "random tenth");
}

// Points that lose their times distort every scan of a trot, and on a bare plaza little else tells
// where it is: found by three scans each time, it was found wrongly five times more (of 47 ok).
TEST(FaultMatrix, WhoIsLostAgainSoonIsFoundByMoreScans) {
  EXPECT_LE(false_oks(judged("plaza:61", "no times")), 1);
}

}  // namespace
}  // namespace surefoot::benchmarks
