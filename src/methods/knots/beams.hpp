// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "methods/knots/surfel.hpp"

namespace surefoot {

/// A scan's beams by where they point, for the question what they went through.
class Beams {
 public:
  /// `rays`: unit vectors from the sensor [map frame], and how far each went [m].
  Beams(const Eigen::Vector3d& sensor, const std::vector<Eigen::Vector3d>& rays,
        const std::vector<double>& ranges);

  /// A quick answer for a place [m, map frame]: false only where no beam that points about there
  /// ends well behind it.
  [[nodiscard]] bool may_pass(const Eigen::Vector3f& place) const;
  /// Whether a beam went through the middle of a surfel, and ended well behind it.
  [[nodiscard]] bool pass(const Surfel& surfel) const;

  /// What the beams that point about a place [m, map frame] tell of it.
  enum class Answer {
    none,  ///< none points there, or they ended before
    open,  ///< one ended about there
    free   ///< all ended well behind it
  };
  [[nodiscard]] Answer at(const Eigen::Vector3d& place) const;
  /// The share of the beams that went far enough to tell of any place: a covered sensor's do not.
  [[nodiscard]] double telling() const;

 private:
  struct Beam {
    Eigen::Vector3d ray;
    double clear = 0.0;  // [m] up to where it went through
  };

  void find_clear();

  Eigen::Vector3d sensor_;
  std::vector<std::uint32_t> begins_;  // of each cell's beams
  std::vector<Beam> beams_;            // cell by cell
  std::vector<float> clear2_;          // [m^2] farthest of the beams in each cell and around it
  std::vector<float> free2_;           // [m^2] nearest of them; 0: none
};

}  // namespace surefoot
