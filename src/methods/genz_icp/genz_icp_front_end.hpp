// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "methods/genz_icp/genz_icp.hpp"
#include "methods/shared/baseline_front_end.hpp"

namespace surefoot {

/// GenZ-ICP (Lee et al., RA-L 2024) as its code has it: add() is its RegisterFrame. Its poses hold
/// at mid-scan, to which it deskews if it does.
class GenzIcpFrontEnd : public BaselineFrontEnd {
 public:
  explicit GenzIcpFrontEnd(const Session& session);

  Estimate add(const PreparedScan& scan) override;
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override { return map_.points(); }

 private:
  [[nodiscard]] bool has_moved() const;
  void update_map(const std::vector<Eigen::Vector3d>& points, const Pose& T_map_lidar);

  const GenzIcpParameters& genz_;
  VoxelMap map_;
  GenzThreshold threshold_;
  double voxel_size_;  // of the last scan's thinning
  int poses_ = 0;
  Pose first_pose_;
  Pose last_pose_;
  Pose last_delta_;
};

}  // namespace surefoot
