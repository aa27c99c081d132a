// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/front_end.hpp"
#include "methods/paper/local_map.hpp"
#include "methods/paper/prediction.hpp"
#include "methods/paper/prediction_error.hpp"
#include "methods/paper/registration.hpp"

namespace surefoot {

/// The paper's front-end: add() is Algorithm 1 from top to bottom. What the paper leaves open has a
/// function each: how a map begins, what is done with scans that cannot be registered, and what an
/// estimate is worth.
class PaperFrontEnd : public FrontEnd {
 public:
  explicit PaperFrontEnd(const Session& session);

  Estimate add(const PreparedScan& scan) override;

  [[nodiscard]] std::optional<StampedPose> last_pose() const override;
  [[nodiscard]] Twist velocity() const override { return motion_.velocity; }
  [[nodiscard]] const LevelReport& level() const override { return level_; }
  [[nodiscard]] const DeskewedScan& deskewed_scan() const override { return last_scan_; }
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override { return map_.points(); }

 private:
  [[nodiscard]] ScanTrajectory predict(const PreparedScan& scan) const;
  [[nodiscard]] std::vector<Eigen::Vector3f> at_mid_scan(const PreparedScan& scan,
                                                         const ScanTrajectory& predicted) const;
  [[nodiscard]] Estimate conclude(const Registration& registration, const Pose& T_0,
                                  Source& source) const;
  Estimate begin_map(const std::vector<Eigen::Vector3f>& points, const ScanTrajectory& predicted);
  Estimate lose(const std::vector<Eigen::Vector3f>& points, const ScanTrajectory& predicted,
                Estimate estimate);
  void integrate(const std::vector<Eigen::Vector3f>& points, const Pose& T_map_lidar);
  [[nodiscard]] Estimate publish(const ScanTrajectory& trajectory, Estimate estimate) const;

  const Session& session_;
  const Config& config_;
  const PaperParameters& paper_;
  const Workers& workers_;

  // Everything that outlives a scan.
  LocalMap map_;
  LastMotion motion_;
  PredictionError prediction_error_;
  LevelReport level_;
  DeskewedScan last_scan_;
  bool started_ = false;
  int segment_ = 0;
  int lost_in_a_row_ = 0;
};

}  // namespace surefoot
