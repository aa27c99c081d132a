// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Poses of walks through synthetic scenes, as every bit of them: what two machines are compared by.
#include <cstdio>
#include <string>

#include "support/synthetic_run.hpp"

int main() {
  using namespace surefoot;
  Pose T_start;
  T_start.translation = {-3.0, 0.0, 0.5};
  const std::vector<Scan> scans =
      test::take_scans(test::furnished_hall(), test::trotting(T_start, 0.8, 2.0), 30);
  for (const std::string& method : methods()) {
    Odometry odometry(method_config(method));
    for (const Estimate& estimate : test::add_scans(odometry, scans)) {
      const Eigen::Vector3d& t = estimate.T_world_lidar.translation;
      const Eigen::Quaterniond& q = estimate.T_world_lidar.rotation;
      std::printf("%s %s %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", method.c_str(),
                  std::string(to_string(estimate.status)).c_str(), t.x(), t.y(), t.z(), q.x(),
                  q.y(), q.z(), q.w());
    }
  }
  return 0;
}
