// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_agreement.hpp"

#include <algorithm>

namespace surefoot::mapping {

/// While the robot stands it sees the same, and what looks alike by chance stays alike: then it has
/// to fit well.
bool PlaceAgreement::add(const Pose& T_map_world, double fit, double way,
                         const Eigen::Vector3d& robot_in_world, const ChoiceLimits& same) {
  if (!agreed_ || !agree(agreed_->T_map_world, T_map_world, robot_in_world, same)) {
    agreed_ = Agreed{.T_map_world = T_map_world, .since = way};
  }
  agreed_->T_map_world = T_map_world;
  agreed_->fit = std::min(agreed_->fit, fit);
  agreed_->evidence += fit - limits_.no_evidence;
  agreed_->silent = 0;
  ++agreed_->searches;
  if (alike_at_ && way - *alike_at_ < limits_.alike_way) return false;
  return agreed_->searches >= limits_.searches && agreed_->evidence >= limits_.evidence &&
         (way - agreed_->since >= limits_.way || agreed_->fit >= limits_.fit_standing);
}

void PlaceAgreement::add_silence() {
  if (agreed_ && ++agreed_->silent > limits_.silent) forget();
}

}  // namespace surefoot::mapping
