// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One scan of a swaying sensor, in a hall, and a map made with the true motion.
#pragma once

#include <functional>
#include <numbers>

#include "methods/knots/knot_attempts.hpp"

namespace surefoot::test {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kScanStart = 0.7;  // [s]
constexpr int kSegments = 8;
constexpr double kStep = 0.1 / kSegments;  // [s]
inline const Pose kStart{Eigen::Quaterniond::Identity(), {-3.0, 0.5, 0.45}};
inline const StepObserver kNobody = [](Step) {};

/// Rolls and pitches by up to 3.5 deg at 2.5 Hz while it walks: 0.5 rad/s.
[[nodiscard]] Pose swaying(double t);

/// Six scans of the same walk, every point where it was seen.
[[nodiscard]] SurfelMap map_of_walk(const Config::Knots& config);
/// By the default config.
[[nodiscard]] const SurfelMap& true_map();

/// Every third point of the scan that begins at kScanStart.
[[nodiscard]] const KnotPoints& scan_points();

[[nodiscard]] KnotWindow window_along(const std::function<Pose(double)>& motion);

/// The first two knots, known to `sigma` [m, rad].
[[nodiscard]] KnotPrior prior_at(const KnotWindow& window, double sigma);

[[nodiscard]] KnotRegistration register_from(const KnotWindow& start, const KnotPrior& prior,
                                             const Config::Knots& config = Config().knots,
                                             int threads = 1);

struct KnotError {
  double translation = 0.0, rotation_deg = 0.0;  ///< largest of the scan's knots
};
[[nodiscard]] KnotError error_of(const KnotWindow& window);

}  // namespace surefoot::test
