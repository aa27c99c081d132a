// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_agreement.hpp"

#include <algorithm>

namespace surefoot::mapping {

/// While the robot stands it sees the same, and what looks alike by chance stays alike: then it has
/// to fit well.
bool PlaceAgreement::add(const Pose& T_map_world, double fit, double way,
                         const Eigen::Vector3d& robot_in_world, const ChoiceLimits& same) {
  if (walls_were_missing(T_map_world, way, robot_in_world, same)) {
    add_silence();
    return false;
  }
  if (!agreed_ || !agree(agreed_->T_map_world, T_map_world, robot_in_world, same)) {
    agreed_ = Agreed{.T_map_world = T_map_world, .since = way};
  }
  agreed_->T_map_world = T_map_world;
  agreed_->evidence += fit - limits_.no_evidence;
  agreed_->silent = 0;
  ++agreed_->searches;
  if (alike_at_ && way - *alike_at_ < limits_.alike_way) return false;
  const double mean_fit = limits_.no_evidence + agreed_->evidence / agreed_->searches;
  return agreed_->searches >= limits_.searches && agreed_->evidence >= limits_.evidence &&
         (way - agreed_->since >= limits_.way || mean_fit >= limits_.fit_standing);
}

void PlaceAgreement::add_missing(const Pose& T_map_world, double share, double way) {
  constexpr std::size_t kMost = 1000;  // who stands asks the same places, over and over
  if (share > limits_.missing) missing_.push_back({T_map_world, way});
  if (missing_.size() > kMost) missing_.erase(missing_.begin());
  std::erase_if(missing_, [&](const Missing& was) { return way - was.at > limits_.missing_way; });
}

bool PlaceAgreement::walls_were_missing(const Pose& T_map_world, double way,
                                        const Eigen::Vector3d& robot_in_world,
                                        const ChoiceLimits& same) const {
  return std::any_of(missing_.begin(), missing_.end(), [&](const Missing& was) {
    return way - was.at <= limits_.missing_way &&
           agree(was.T_map_world, T_map_world, robot_in_world, same);
  });
}

void PlaceAgreement::add_silence() {
  if (agreed_ && ++agreed_->silent > limits_.silent) forget();
}

}  // namespace surefoot::mapping
