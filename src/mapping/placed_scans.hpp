// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "mapping/piece.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot::mapping {

/// A run's trusted estimates, as maps take them: one after the other, and where a world of its
/// own begins.
class PlacedScans {
 public:
  [[nodiscard]] PlacedScan next(const Estimate& estimate) {
    PlacedScan placed;
    placed.stamp_ns = estimate.stamp_ns;
    placed.T_world_lidar = estimate.T_world_lidar;
    placed.covariance = estimate.covariance;
    placed.restarted =
        begun_ && (estimate.status == Status::first_scan || estimate.segment != segment_);
    segment_ = estimate.segment;
    begun_ = true;
    return placed;
  }

 private:
  bool begun_ = false;
  int segment_ = 0;
};

}  // namespace surefoot::mapping
