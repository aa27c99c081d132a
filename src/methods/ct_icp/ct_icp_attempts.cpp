// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/ct_icp/ct_icp_attempts.hpp"

#include <algorithm>

namespace surefoot {

namespace {

// What the original hides in its code.
constexpr int kStartingIterations = 15;  // at least, for a starting scan
constexpr int kMoreSteps = 30;           // of the solver, per level
constexpr int kMoreIterations = 20;      // per level,
constexpr int kMaxIterations = 50;       // up to these
constexpr int kMaxResiduals = 1000000;   // ours: more than any scan has
constexpr int kMoreResiduals = 2;        // factors per level
constexpr double kFinerThreshold = 0.1;
constexpr double kLooserLoss = 1.2;
constexpr double kWiderPlane = 1.5;
constexpr double kFinerSampling = 1.5;
constexpr double kLeastOrientationThreshold = 1e-5;  // [deg]
constexpr double kLeastTranslationThreshold = 1e-4;  // [m]
constexpr int kToleratedFailures = 5;  // after so many, scans enter the map all the same

}  // namespace

CtIcpChange change_of(const CtIcpFrame& previous, const CtIcpFrame& frame) {
  return {(frame.end.translation - frame.begin.translation).norm(),
          degrees_between(frame.begin, frame.end), degrees_between(previous.end, frame.end)};
}

bool turns_fast(const CtIcpChange& change, const CtIcpParameters& config) {
  return change.ego_orientation > config.robust_threshold_ego_orientation ||
         change.relative_orientation > config.robust_threshold_relative_orientation;
}

bool is_plausible(const CtIcpResult& result, const CtIcpChange& change, int robust_level,
                  const CtIcpParameters& config) {
  if (change.distance > config.distance_error_threshold) return false;
  if (change.relative_orientation > config.orientation_error_threshold) return false;
  if (change.ego_orientation > config.orientation_error_threshold) return false;
  if (config.robust_registration) {
    if (robust_level == 0 && turns_fast(change, config)) return false;
    if (change.distance > config.robust_relative_trans_threshold) return false;
  }
  return result.success;
}

CtIcpEffort first_effort(const CtIcpParameters& config, bool starting, int level) {
  CtIcpEffort effort{config, starting ? config.init_sample_voxel_size : config.sample_voxel_size};
  while (effort.level < level) effort.increase();
  if (starting) {
    effort.config.num_iters_icp = std::max(effort.config.num_iters_icp, kStartingIterations);
  }
  return effort;
}

void CtIcpEffort::increase() {
  const double finest = std::min(config.init_voxel_size, config.voxel_size);
  config.ls_max_num_iters += kMoreSteps;
  if (config.max_num_residuals > 0) {
    config.max_num_residuals = std::min(kMoreResiduals * config.max_num_residuals, kMaxResiduals);
  }
  config.num_iters_icp = std::min(config.num_iters_icp + kMoreIterations, kMaxIterations);
  config.threshold_orientation_norm =
      std::max(kFinerThreshold * config.threshold_orientation_norm, kLeastOrientationThreshold);
  // Metres from degrees: so does the original.
  config.threshold_translation_norm =
      std::max(kFinerThreshold * config.threshold_orientation_norm, kLeastTranslationThreshold);
  config.ls_sigma *= kLooserLoss;
  config.max_dist_to_plane_ct_icp *= kWiderPlane;
  sample_voxel_size = std::max(config.sample_voxel_size / kFinerSampling, finest);
  ++level;
}

bool CtIcpCaution::admit(const CtIcpResult& result, const CtIcpChange& change, int attempts) {
  const bool exhausted = attempts >= config_.robust_num_attempts;
  // The original asks for more attempts than there can be, and so never counts a failure.
  const bool failed = config_.robust_bookkeeping && exhausted;
  failures_ = failed ? failures_ + 1 : 0;
  const bool fast = turns_fast(change, config_);
  const bool admitted = !fast || (exhausted && failures_ > kToleratedFailures);
  level_ = fast || attempts > 1 ? 1 : 0;
  if (!result.success) level_ = 2;
  return admitted;
}

}  // namespace surefoot
