// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/health.hpp"

#include <numbers>

namespace surefoot {

Judgement judge_registration(const RegistrationEnd& end, double min_match_ratio,
                             const Config::Health& config) {
  const double ratio =
      end.points > 0 ? static_cast<double>(end.matches) / static_cast<double>(end.points) : 0.0;
  const std::string share =
      min_match_ratio > 0.0 ? " and a share of " + std::to_string(min_match_ratio) : "";
  if (end.matches < config.min_matches || ratio < min_match_ratio) {
    return {Status::too_few_matches, std::to_string(end.matches) + " of " +
                                         std::to_string(end.points) +
                                         " points have a match in the map; expected at least " +
                                         std::to_string(config.min_matches) + share};
  }
  const Pose correction = end.T_0.inverse() * end.T_map_lidar;
  if (!correction.translation.allFinite() || !correction.rotation.coeffs().allFinite()) {
    return {Status::diverged, "the registration's normal equations gave no finite pose"};
  }
  const double distance = correction.translation.norm();
  const double angle_deg = so3_log(correction.rotation).norm() * 180.0 / std::numbers::pi;
  if (distance > config.max_correction || angle_deg > config.max_correction_deg) {
    return {Status::diverged, "the registration moved the prediction by " +
                                  std::to_string(distance) + " m and " + std::to_string(angle_deg) +
                                  " deg; expected at most " +
                                  std::to_string(config.max_correction) + " m and " +
                                  std::to_string(config.max_correction_deg) + " deg"};
  }
  return {};
}

}  // namespace surefoot
