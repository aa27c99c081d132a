// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "methods/floam/floam_parameters.hpp"
#include "methods/floam/floam_solver.hpp"
#include "methods/shared/baseline_front_end.hpp"
#include "methods/shared/kd_tree.hpp"

namespace surefoot {

/// F-LOAM (Wang et al., IROS 2021) as its code has it: add() is its feature extraction and its
/// updatePointsToMap. A scan counts as taken at its middle, unless floam.distortion_compensation
/// brings its points there.
class FloamFrontEnd : public BaselineFrontEnd {
 public:
  explicit FloamFrontEnd(const Session& session);

  Estimate add(const PreparedScan& scan) override;
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override;

 private:
  struct Clouds {
    std::vector<Eigen::Vector3d> edges, surfaces;  // LiDAR frame
  };
  struct Trees {
    KdTree edges, surfaces;
  };

  [[nodiscard]] std::vector<FloamResidual> match(const Clouds& clouds, const Trees& trees,
                                                 const Pose& T_map_lidar) const;
  [[nodiscard]] Alignment register_clouds(const Clouds& clouds, const Pose& prediction);
  [[nodiscard]] Clouds thinned(const Clouds& clouds) const;
  void add_to_map(const Clouds& clouds, const Pose& T_map_lidar);

  const FloamParameters& floam_;
  Clouds map_;  // in the map's frame
  int optimization_count_;
  Pose last_pose_;
  Pose last_delta_;
};

}  // namespace surefoot
