// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/front_end.hpp"
#include "methods/knots/knot_front_end.hpp"

namespace surefoot {

/// Surefoot's own method over several maps. Where one is left after a search in vain another one
/// begins, a segment of its own; and who comes back to where he was before goes on in that map and
/// that segment. docs/method.md, "Coming home".
class KnotSegments : public FrontEnd {
 public:
  explicit KnotSegments(const Session& session);

  Estimate add(const PreparedScan& scan) override;

  [[nodiscard]] std::optional<StampedPose> last_pose() const override { return now_->last_pose(); }
  [[nodiscard]] Twist velocity() const override { return now_->velocity(); }
  [[nodiscard]] const LevelReport& level() const override { return now_->level(); }
  [[nodiscard]] const DeskewedScan& deskewed_scan() const override { return now_->deskewed_scan(); }
  [[nodiscard]] std::vector<Eigen::Vector3d> local_map() const override {
    return now_->local_map();
  }
  [[nodiscard]] Cubes emptied_cubes() const override { return now_->emptied_cubes(); }

 private:
  [[nodiscard]] bool is_time_to_look();
  Estimate begin_anew(const PreparedScan& scan);

  std::unique_ptr<KnotFrontEnd> now_;
  std::unique_ptr<KnotFrontEnd> home_;  // of the maps that were left, the one of most scans
  int segments_ = 1;
  bool lost_ = false;  // in the map it is in now
  int waited_ = 0;     // scans since home was last looked for
  int pause_ = 0;      // scans that are waited for until it is again
};

}  // namespace surefoot
