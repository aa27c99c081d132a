// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Which of the places that a search named a robot is at: the one that fits, if no other does nearly
// as well.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "mapping/loop_verifier.hpp"

namespace surefoot::mapping {

/// Where a place would have the robot's world lie, and what was found when it was asked.
struct AskedPlace {
  Pose T_map_world;
  LoopCheck check;
  std::size_t frame = 0;  ///< which of the map's, of those that nothing joins
};

struct ChoiceLimits {
  double fit = 0.4;      ///< of the place chosen,
  double clearly = 0.1;  ///< and by so much it fits better than any other
  bool alone = false;    ///< and no other one passes every question and fits so well
  double alike = 0.1;    ///< places look alike that fit well and differ by less
  double agree_metres = 0.3;
  double agree_degrees = 2.0;
};

/// Share of what stands that lies on the place, less what speaks against it: what contradicts,
/// walls that are missing, walls that stand beside, how far off what lies on it is. No limit: what
/// was moved since speaks a little against where the robot is, and there the more has to lie on the
/// place. 0 to 1.
[[nodiscard]] double fit_of(const LoopCheck& check);

/// Whether two poses have the robot at one place. At the robot: far from the origins a turn moves
/// everything.
[[nodiscard]] bool agree(const Pose& one, const Pose& other, const Eigen::Vector3d& robot_in_world,
                         const ChoiceLimits& limits);

struct PlaceChoice {
  std::optional<std::size_t> chosen;  ///< index
  double fit = 0.0;                   ///< of it
  bool several = false;               ///< one fits, and another nearly as well
  bool alike = false;                 ///< two fit well, and nearly as well
};
[[nodiscard]] PlaceChoice choose_place(const std::vector<AskedPlace>& asked,
                                       const Eigen::Vector3d& robot_in_world,
                                       const ChoiceLimits& limits);

}  // namespace surefoot::mapping
