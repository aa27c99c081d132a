// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "methods/ct_icp/ct_icp_attempts.hpp"
#include "methods/shared/baseline_front_end.hpp"

namespace surefoot {

/// CT-ICP (Dellenbach et al., ICRA 2022) as its code has it: add() is its RegisterFrame, with
/// motion_compensation CONTINUOUS and the CERES solver. A scan has two poses, at its first and its
/// last instant; every estimate is half-way between.
class CtIcpFrontEnd : public BaselineFrontEnd {
 public:
  explicit CtIcpFrontEnd(const Session& session);

  Estimate add(const PreparedScan& scan) override;
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override { return map_.points(); }

 private:
  struct Registered {
    CtIcpResult result;
    CtIcpChange change;
    int attempts = 0;
    bool plausible = false;
  };

  [[nodiscard]] bool starting() const { return scans_ < ct_.init_num_frames; }
  [[nodiscard]] CtIcpFrame predict() const;
  [[nodiscard]] Registered register_scan(const std::vector<CtIcpPoint>& points,
                                         const CtIcpFrame& prediction);
  [[nodiscard]] bool admit(const Registered& registered);
  void update_map(const std::vector<CtIcpPoint>& points, const CtIcpFrame& frame, bool admitted);
  ScanTrajectory finish(const PreparedScan& scan, const CtIcpFrame& frame);

  const CtIcpParameters& ct_;
  CtIcpSampler sampler_;
  VoxelMap map_;
  VoxelNeighbours neighbours_;
  CtIcpCaution caution_;
  int scans_ = 0;
  int skipped_ = 0;    // scans since the last that entered the map
  CtIcpFrame last_;    // of the scan before,
  CtIcpFrame second_;  // and of the one before that
};

}  // namespace surefoot
