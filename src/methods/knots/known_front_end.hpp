// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/front_end.hpp"
#include "methods/knots/knot_points.hpp"
#include "methods/knots/surfel_map.hpp"

namespace surefoot {

/// What is to be answered, scan after scan, and how the map's frame was found.
struct KnownAnswers {
  std::vector<Estimate> estimates;  ///< in the map's frame
  LevelReport level;
};

/// Answers scans of which everything is known already; the local map follows them.
class KnownFrontEnd : public FrontEnd {
 public:
  KnownFrontEnd(const Session& session, std::shared_ptr<const KnownAnswers> known);

  /// A scan that is none of those, the next one being asked for first, is `rejected`.
  Estimate add(const PreparedScan& scan) override;

  [[nodiscard]] std::optional<StampedPose> last_pose() const override { return last_pose_; }
  [[nodiscard]] Twist velocity() const override { return velocity_; }
  [[nodiscard]] const LevelReport& level() const override { return known_->level; }
  [[nodiscard]] const DeskewedScan& deskewed_scan() const override { return last_scan_; }
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override { return map_.points(); }
  [[nodiscard]] Cubes emptied_cubes() const override { return emptied_; }

 private:
  void map(const PreparedScan& scan, const Pose& middle);

  const Session& session_;
  std::shared_ptr<const KnownAnswers> known_;
  std::size_t next_ = 0;
  int segment_ = 0;
  SurfelMap map_;
  PointChoice choice_;
  std::optional<StampedPose> last_pose_;
  Twist velocity_ = Twist::Zero();
  DeskewedScan last_scan_;
  Cubes emptied_;
};

}  // namespace surefoot
