// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/health.hpp"

#include <numbers>

#include "geometry/se3.hpp"

namespace surefoot {

namespace {

Judgement too_few(const RegistrationEnd& end, const std::string& expected) {
  return {Status::too_few_matches,
          std::to_string(end.matches) + " of " + std::to_string(end.points) +
              " points have a match in the map; expected at least " + expected};
}

}  // namespace

Judgement judge_registration(const RegistrationEnd& end, const Config::Health& config) {
  if (end.matches < config.min_matches) return too_few(end, std::to_string(config.min_matches));
  const Pose correction = end.T_0.inverse() * end.T_map_lidar;
  if (!correction.translation.allFinite() || !correction.rotation.coeffs().allFinite()) {
    return {Status::diverged, "the registration's normal equations gave no finite pose"};
  }
  const double distance = correction.translation.norm();
  const double angle_deg = turn_angle(correction) * 180.0 / std::numbers::pi;
  if (distance > config.max_correction || angle_deg > config.max_correction_deg) {
    return {Status::diverged, "the registration moved the prediction by " +
                                  std::to_string(distance) + " m and " + std::to_string(angle_deg) +
                                  " deg; expected at most " +
                                  std::to_string(config.max_correction) + " m and " +
                                  std::to_string(config.max_correction_deg) + " deg"};
  }
  return {};
}

Judgement judge_with_share(const RegistrationEnd& end, const Config::Health& config) {
  const double expected = config.min_match_ratio * static_cast<double>(end.points);
  if (end.points == 0 || end.matches < expected) {
    return too_few(end, "a share of " + std::to_string(config.min_match_ratio));
  }
  return judge_registration(end, config);
}

}  // namespace surefoot
