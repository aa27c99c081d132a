// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "support/scene.hpp"
#include "support/synthetic_run.hpp"

namespace surefoot::test {

/// What a standing scanner sees; only its returns.
inline std::vector<Eigen::Vector3f> look(const Scene& scene, const Pose& T_world_lidar) {
  std::vector<Eigen::Vector3f> returns;
  for (const auto& p : take_scan(scene, standing(T_world_lidar), 0.0, {}).points) {
    if (!p.isZero()) returns.push_back(p);
  }
  return returns;
}

}  // namespace surefoot::test
