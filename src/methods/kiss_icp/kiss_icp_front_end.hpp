// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "methods/kiss_icp/kiss_icp_parameters.hpp"
#include "methods/shared/adaptive_threshold.hpp"
#include "methods/shared/baseline_front_end.hpp"
#include "methods/shared/voxel_map.hpp"

namespace surefoot {

/// KISS-ICP (Vizzo et al., RA-L 2023) as its code has it: add() is its RegisterFrame. Its poses
/// hold at a scan's last instant, to which it deskews.
class KissIcpFrontEnd : public BaselineFrontEnd {
 public:
  explicit KissIcpFrontEnd(const Session& session);

  Estimate add(const PreparedScan& scan) override;
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override { return map_.points(); }

 private:
  void update_map(const std::vector<Eigen::Vector3d>& points, const Pose& T_map_end);

  const KissIcpParameters& kiss_;
  VoxelMap map_;
  AdaptiveThreshold adaptive_threshold_;
  Pose last_pose_;   // T_map_lidar at the end of the last scan
  Pose last_delta_;  // between the last two
};

}  // namespace surefoot
