// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

#include "support/random.hpp"

namespace surefoot::test {

/// Points spread evenly over a cube about the origin, `half` its half side [m].
inline std::vector<Eigen::Vector3f> random_cloud(std::uint64_t seed, int count, double half = 4.0) {
  Random random(seed);
  std::vector<Eigen::Vector3f> cloud;
  for (int i = 0; i < count; ++i) cloud.emplace_back(random.vector(half).cast<float>());
  return cloud;
}

inline void shuffle(std::vector<Eigen::Vector3f>& cloud, Random& random) {
  for (std::size_t i = cloud.size(); i > 1; --i) std::swap(cloud[i - 1], cloud[random.below(i)]);
}

}  // namespace surefoot::test
