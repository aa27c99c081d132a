// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "methods/icp/icp_parameters.hpp"
#include "methods/shared/baseline_front_end.hpp"
#include "methods/shared/kd_tree.hpp"
#include "methods/shared/voxel_map.hpp"

namespace surefoot {

/// Classical ICP on raw points, one scan against the one before or against a map. A scan counts as
/// taken at its middle: nothing is deskewed.
class IcpFrontEnd : public BaselineFrontEnd {
 public:
  explicit IcpFrontEnd(const Session& session);

  Estimate add(const PreparedScan& scan) override;
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override;

 private:
  void set_target(const std::vector<Eigen::Vector3d>& points, const Pose& T_map_lidar);

  const IcpParameters& icp_;
  KdTree last_scan_;  // in the map's frame; for IcpTarget::scan
  VoxelMap map_;      // for IcpTarget::map
  Pose last_pose_;
  Pose last_delta_;
};

}  // namespace surefoot
