// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "mapping/piece.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot::mapping {

/// A run's trusted estimates, as maps take them: one after the other, and where another frame
/// begins, or one that was left is entered again.
class PlacedScans {
 public:
  [[nodiscard]] PlacedScan next(const Estimate& estimate) {
    PlacedScan placed;
    placed.stamp_ns = estimate.stamp_ns;
    placed.T_world_lidar = estimate.T_world_lidar;
    placed.covariance = estimate.covariance;
    placed.restarted =
        begun_ && (estimate.status == Status::first_scan || estimate.segment != segment_);
    // A map that begins is a frame of its own, whatever its number.
    if (estimate.status == Status::first_scan) frames_.erase(estimate.segment);
    const auto [frame, fresh] = frames_.try_emplace(estimate.segment, count_);
    if (fresh) ++count_;
    placed.frame = frame->second;
    segment_ = estimate.segment;
    begun_ = true;
    return placed;
  }

 private:
  bool begun_ = false;
  int segment_ = 0;
  std::map<int, int> frames_;  // by the segments' numbers
  int count_ = 0;
};

}  // namespace surefoot::mapping
