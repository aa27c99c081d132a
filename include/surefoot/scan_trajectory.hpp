// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot {

/// The sensor's motion within one scan: piecewise-constant velocity between K + 1 boundary poses,
/// eqs. (8)-(11). Poses are T_a_lidar, in whichever frame a the boundary poses are given: those of
/// an `Estimate` in the world.
class ScanTrajectory {
 public:
  ScanTrajectory() : ScanTrajectory(Pose{}, 0) {}
  /// A sensor that stands still at one instant.
  ScanTrajectory(const Pose& pose, std::int64_t stamp_ns);
  /// Boundary poses T_0..T_K, spread evenly over [start_ns, end_ns]. Throws std::invalid_argument
  /// if there are less than two.
  ScanTrajectory(std::vector<Pose> boundaries, std::int64_t start_ns, std::int64_t end_ns);

  /// T(tau), eqs. (10)-(11). Outside [0, 1] the first or last segment's velocity goes on.
  [[nodiscard]] Pose at(double tau) const;
  /// The pose at an instant [ns, sensor's epoch]; outside the scan as at(tau).
  [[nodiscard]] Pose at_time(std::int64_t stamp_ns) const;
  /// Normalised time of an instant: 0 at the start, 1 at the end; 0.5 where they coincide.
  [[nodiscard]] double tau(std::int64_t stamp_ns) const;

  [[nodiscard]] std::int64_t start_ns() const { return start_ns_; }
  [[nodiscard]] std::int64_t end_ns() const { return end_ns_; }
  [[nodiscard]] std::int64_t mid_ns() const { return start_ns_ + (end_ns_ - start_ns_) / 2; }
  [[nodiscard]] std::size_t segments() const { return twists_.size(); }
  [[nodiscard]] const Pose& boundary(std::size_t k) const { return boundaries_[k]; }
  /// Motion over segment k [m, rad], in the LiDAR's axes at its begin, eq. (9).
  [[nodiscard]] const Twist& segment_twist(std::size_t k) const { return twists_[k]; }

  /// The same motion seen from another frame: every pose becomes T_new_old * pose.
  [[nodiscard]] ScanTrajectory moved(const Pose& T_new_old) const;
  /// The same motion so much later [ns].
  [[nodiscard]] ScanTrajectory delayed(std::int64_t by_ns) const;

 private:
  std::vector<Pose> boundaries_;
  std::vector<Twist> twists_;
  std::int64_t start_ns_ = 0;
  std::int64_t end_ns_ = 0;
};

}  // namespace surefoot
