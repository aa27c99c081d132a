// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "core/front_end.hpp"
#include "core/last_motion.hpp"
#include "methods/shared/alignment.hpp"

namespace surefoot {

/// What the baselines share: how a registration is reported.
///
/// The originals judge nothing: whatever the registration gives is the pose, is published and goes
/// into the map. So it is here: such a pose is always trusted(), `degenerate` where it misses
/// health.min_matches or health.min_match_ratio. Not trusted is only what an original does not give
/// either: `diverged` where no finite pose was found, and what CT-ICP's own rules refuse; then the
/// prediction stands.
class BaselineFrontEnd : public FrontEnd {
 public:
  explicit BaselineFrontEnd(const Session& session) : session_(session) {}

  [[nodiscard]] std::optional<StampedPose> last_pose() const override;
  [[nodiscard]] Twist velocity() const override { return motion_.velocity; }
  [[nodiscard]] const LevelReport& level() const override { return level_; }
  [[nodiscard]] const DeskewedScan& deskewed_scan() const override { return last_scan_; }

 protected:
  [[nodiscard]] const Config& config() const { return session_.config; }
  [[nodiscard]] const Workers& workers() const { return session_.workers; }
  void begin_step(Step step) const { session_.begin_step(step); }

  [[nodiscard]] bool started() const { return started_; }
  /// T_map_lidar of the first scan, as level.mode asks for.
  [[nodiscard]] Pose first_pose(const std::vector<Eigen::Vector3f>& points);
  /// To be called once per scan, with its points at mid-scan.
  void keep_scan(std::vector<Eigen::Vector3f> points, const PreparedScan& scan);
  /// A scan that nothing was there to align with.
  [[nodiscard]] Estimate report_first(const ScanTrajectory& trajectory);
  [[nodiscard]] Estimate report(const Alignment& alignment, const ScanTrajectory& trajectory);

 private:
  void judge(const Alignment& alignment, Estimate& estimate) const;
  [[nodiscard]] Matrix6 covariance(const Alignment& alignment, const Pose& T_map_lidar) const;
  Estimate publish(const ScanTrajectory& trajectory, Estimate estimate);

  const Session& session_;
  LastMotion motion_;
  LevelReport level_;
  DeskewedScan last_scan_;
  bool started_ = false;
  int segment_ = 0;
};

}  // namespace surefoot
