// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/submap_registration.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace surefoot::mapping {
namespace {

/// Two walls and ground with noise; every other metre of the walls is set back.
Submap corner(unsigned seed, double set_back) {
  constexpr double kNoise = 0.03;
  Submap submap;
  std::mt19937 draw(seed);
  std::normal_distribution<double> noise(0.0, kNoise);
  const auto see = [&](double x, double y, double z) {
    submap.points.push_back(Eigen::Vector3d(x, y, z).cast<float>());
    submap.eyes.emplace_back(0.0F, 0.0F, 0.5F);
  };
  for (double s = -8.95; s < 9.0; s += 0.1) {
    const double back = static_cast<int>(std::floor(s)) % 2 == 0 ? set_back : 0.0;
    for (double z = 0.05; z < 4.0; z += 0.1) {
      see(s, 9.25 + back + noise(draw), z);
      see(9.25 + back + noise(draw), s, z);
    }
    for (double t = -8.95; t < 9.0; t += 0.1) see(s, t, noise(draw));
  }
  return submap;
}

double misfit_of(const Submap& here, const Submap& there) {
  const SubmapAlignment found =
      align_submaps(RegistrationSubmap(here), RegistrationSubmap(there), Pose{});
  EXPECT_GT(found.matched, 0.95);
  EXPECT_LT(found.T_target_source.translation.norm(), 0.1);
  return found.misfit;
}

/// Noise makes points lie off their own surfaces as well: of a place seen twice it is no misfit.
TEST(SubmapRegistration, WhatLiesFartherOffThanAtHomeIsTheMisfit) {
  const Submap flat = corner(1, 0.0);
  EXPECT_NEAR(misfit_of(flat, flat), 0.0, 1e-3);
  EXPECT_NEAR(misfit_of(flat, corner(2, 0.0)), 0.0, 0.004);
  // The half that is set back lies half of 0.1 m off, and so does the other half.
  const double expected = std::hypot(0.05, 0.03) - 0.03;
  EXPECT_NEAR(misfit_of(flat, corner(2, 0.1)), expected, 0.01);
  EXPECT_NEAR(misfit_of(corner(1, 0.1), corner(2, 0.1)), 0.0, 0.004) << "built so";
}

/// Where few points lie at home it is not known how far off they lie.
TEST(SubmapRegistration, SparsePointsMatchButTellNoMisfit) {
  const Submap flat = corner(1, 0.0);
  const Submap all = corner(2, 0.1);
  Submap few;
  for (std::size_t i = 0; i < all.points.size(); i += 60) {
    few.points.push_back(all.points[i]);
    few.eyes.push_back(all.eyes[i]);
  }
  const SubmapAlignment found =
      align_submaps(RegistrationSubmap(flat), RegistrationSubmap(few), Pose{});
  EXPECT_GT(found.matched, 0.9);
  EXPECT_EQ(found.misfit, 0.0);
}

}  // namespace
}  // namespace surefoot::mapping
