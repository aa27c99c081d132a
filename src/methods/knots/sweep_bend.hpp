// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "methods/knots/knot_window.hpp"
#include "methods/knots/usual_size.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot {

/// What the map is bent by, told from what all scans' motion has in common.
///
/// What is seen ahead can lie in the map with another attitude than what is seen behind: bent by
/// a first scan whose motion was not known, or little by little. Each sweep then turns from the one
/// to the other and back, and maps what it sees bent alike. All fits, and no residual tells. But
/// nobody swings in time with the sensor's turns: over some scans, each segment's velocity is in
/// the mean the one at which the sensor gets from scan to scan. What is left of it is the map's,
/// and is taken out of the motion before that is published, learnt from and mapped.
class SweepBend {
 public:
  /// Takes a scan's knots as they were registered, and learns from the scan before it: only the
  /// scans about that tell how fast the sensor was.
  void learn(const KnotWindow& registered);
  /// The scan's motion without what bends the map; its mean pose stays. The same knots as long as
  /// nothing is known, or of a scan of other than the usual size.
  [[nodiscard]] KnotWindow straightened(const KnotWindow& registered) const;
  void clear() { *this = {}; }

 private:
  void begin(std::size_t segments);
  void learn_from(const KnotWindow& registered, const StampedPose& before,
                  const StampedPose& after);
  void compare_means();
  [[nodiscard]] double rate() const;
  [[nodiscard]] Twist chance() const;
  [[nodiscard]] Twist doubt() const;
  [[nodiscard]] Twist counted_of(const std::vector<Twist>& own) const;
  [[nodiscard]] Twist certainty() const;

  UsualSize usual_size_;
  std::vector<Twist> mean_;          // of each segment's velocity less the one from scan to scan,
  std::vector<Twist> variance_;      // and of that in one scan; LiDAR frame, [m/s, rad/s]
  std::vector<Twist> straightened_;  // of the mean, since the map began
  std::deque<std::vector<Twist>> means_;  // of the last scans, with what was straightened
  Twist wander_ = Twist::Zero();          // of means far apart, as a multiple of chance
  int compared_ = 0;
  std::optional<KnotWindow> last_;
  std::optional<StampedPose> before_;  // the middle of the scan before the last
  int learnt_ = 0;
};

}  // namespace surefoot
