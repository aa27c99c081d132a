// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "core/preprocess.hpp"

namespace surefoot {

/// The axis about which a scan's beams turned as time went by, right-handed, LiDAR frame. Its
/// length is how steadily they did: 1 for a spinning sensor; about 0 where there are no times, or
/// where beams go to and fro.
[[nodiscard]] Eigen::Vector3f sweep_axis(const PreparedScan& scan);

/// Which way the beams of a map's scans turn. A spinning sensor never changes it: a scan that turns
/// the other way is mirrored, or its times run backwards. One that pans to and fro changes it at
/// every scan; of such a sensor it tells nothing.
class SweepDirection {
 public:
  /// Of a map's first scan.
  void begin(const Eigen::Vector3f& axis) { first_ = axis; }
  /// Whether the next scan turns the other way than the first one.
  [[nodiscard]] bool is_reversed(const Eigen::Vector3f& axis);

 private:
  Eigen::Vector3f first_ = Eigen::Vector3f::Zero();
  Eigen::Vector3f last_ = Eigen::Vector3f::Zero();
  int changes_ = 0;  // in a row
  bool to_and_fro_ = false;
};

}  // namespace surefoot
