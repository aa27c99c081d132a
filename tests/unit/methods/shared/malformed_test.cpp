// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans that should not be: no baseline crashes, and all go on afterwards.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <utility>

#include "support/synthetic_run.hpp"

namespace surefoot {
namespace {

using namespace test;  // NOLINT: the scenes and motions of the test support

const Pose kScanStart{Eigen::Quaterniond::Identity(), {-3.0, 0.5, 0.45}};

void keep(Scan& scan, std::size_t count) {
  scan.points.resize(count);
  if (!scan.times_ns.empty()) scan.times_ns.resize(count);
  if (!scan.intensities.empty()) scan.intensities.resize(count);
  if (!scan.rings.empty()) scan.rings.resize(count);
}

using Spoil = std::function<void(Scan&)>;
const std::pair<const char*, Spoil> kSpoilers[] = {
    {"empty", [](Scan& s) { keep(s, 0); }},
    {"one point", [](Scan& s) { keep(s, 1); }},
    {"all NaN",
     [](Scan& s) {
       for (auto& p : s.points) p.setConstant(std::numeric_limits<float>::quiet_NaN());
     }},
    {"all infinite",
     [](Scan& s) {
       for (auto& p : s.points) p.setConstant(std::numeric_limits<float>::infinity());
     }},
    {"too many times", [](Scan& s) { s.times_ns.push_back(0); }},
    {"too few rings", [](Scan& s) { s.rings.assign(3, 1); }},
    {"hundred points", [](Scan& s) { keep(s, 120); }},
    {"all far",
     [](Scan& s) {
       for (auto& p : s.points) p *= 50.0F;
     }},
    {"all near",
     [](Scan& s) {
       for (auto& p : s.points) p *= 0.02F;
     }},
    {"on one line",
     [](Scan& s) {
       for (auto& p : s.points) p = {p.x(), 0.0F, 0.0F};
     }},
    {"on one plane",
     [](Scan& s) {
       for (auto& p : s.points) p.z() = -0.4F;
     }},
    {"all twice the same few",
     [](Scan& s) {
       for (std::size_t i = 0; i < s.points.size(); ++i) s.points[i] = s.points[i % 7];
     }},
    {"wild rings",
     [](Scan& s) {
       s.rings.resize(s.points.size());
       for (std::size_t i = 0; i < s.rings.size(); ++i) {
         s.rings[i] = static_cast<std::uint16_t>(i * 7919);
       }
     }},
    {"times all equal", [](Scan& s) { s.times_ns.assign(s.points.size(), 50'000'000); }},
};

class Malformed : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Baselines, Malformed,
                         testing::Values("kiss-icp", "icp", "genz-icp", "floam", "ct-icp",
                                         "ct-icp-robust-driving", "ct-icp-nclt"));

std::vector<Scan> short_walk() {
  const Twist velocity = (Twist() << 0.5, 0, 0, 0, 0, 0).finished();
  Scanner scanner;
  scanner.columns = 180;
  return take_scans(furnished_hall(), constant_velocity(kScanStart, velocity), 4, scanner);
}

void expect_numbers(const Estimate& estimate, const char* name) {
  EXPECT_TRUE(estimate.T_world_lidar.translation.allFinite()) << name;
  EXPECT_TRUE(estimate.T_world_lidar.rotation.coeffs().allFinite()) << name;
  EXPECT_TRUE(estimate.covariance.allFinite()) << name;
  if (!estimate.trusted()) {
    EXPECT_FALSE(estimate.message.empty()) << name;
  }
}

TEST_P(Malformed, AnywhereInARunLeaveNumbersAndWords) {
  Config config = method_config(GetParam());
  set_parameter(config, "icp.max_iteration", "5");
  set_parameter(config, "floam.use_rings", "true");
  for (const auto& [name, spoil] : kSpoilers) {
    for (const std::size_t place : {0U, 2U}) {
      std::vector<Scan> scans = short_walk();
      spoil(scans[place]);
      Odometry odometry(config);
      for (const Scan& scan : scans) expect_numbers(odometry.add_scan(scan), name);
    }
  }
}

TEST_P(Malformed, ReturningToThePastIsRejected) {
  Odometry odometry(method_config(GetParam()));
  const std::vector<Scan> scans = short_walk();
  odometry.add_scan(scans[1]);
  EXPECT_EQ(odometry.add_scan(scans[0]).status, Status::rejected);
}

}  // namespace
}  // namespace surefoot
