// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "unit/methods/knots/swaying_scan.hpp"

#include <algorithm>
#include <cmath>

#include "support/synthetic_run.hpp"

namespace surefoot::test {

Pose swaying(double t) {
  const double phase = 2.0 * std::numbers::pi * 2.5 * t;
  const Eigen::Vector3d angles(3.5 * kDegree * std::sin(phase), 2.5 * kDegree * std::cos(phase),
                               1.0 * kDegree * std::sin(phase + 1.0));
  return kStart * Pose{from_roll_pitch_yaw(angles), {0.8 * t, 0.0, 0.02 * std::sin(2.0 * phase)}};
}

namespace {

double seconds(const Scan& scan, std::size_t point) {
  return 1e-9 * static_cast<double>(scan.stamp_ns + scan.times_ns[point]);
}

}  // namespace

SurfelMap map_of_walk(const Config::Knots& config) {
  SurfelMap made(config, 100.0);
  for (const Scan& scan : take_scans(furnished_hall(), swaying, 6)) {
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      if (scan.points[i].isZero()) continue;
      points.emplace_back(swaying(seconds(scan, i)) * scan.points[i].cast<double>());
    }
    made.insert({swaying(seconds(scan, 0)).translation, points});
  }
  return made;
}

const SurfelMap& true_map() {
  static const SurfelMap map = map_of_walk(Config().knots);
  return map;
}

namespace {

KnotPoints take_points() {
  const Scan scan = take_scan(furnished_hall(), swaying, kScanStart, {});
  KnotPoints points;
  for (int segment = 0; segment < kSegments; ++segment) {
    points.begins.push_back(points.points.size());
    for (std::size_t i = 0; i < scan.points.size(); i += 3) {
      const double share = (seconds(scan, i) - kScanStart) / kStep;
      if (scan.points[i].isZero() || std::min(static_cast<int>(share), kSegments - 1) != segment) {
        continue;
      }
      points.points.push_back({scan.points[i].cast<double>(), share - segment, {}});
    }
  }
  points.begins.push_back(points.points.size());
  return points;
}

}  // namespace

const KnotPoints& scan_points() {
  static const KnotPoints points = take_points();
  return points;
}

namespace {

double knot_time(std::size_t k) { return kScanStart + (static_cast<double>(k) - 1.0) * kStep; }

}  // namespace

KnotWindow window_along(const std::function<Pose(double)>& motion) {
  KnotWindow window{{}, kStep, kStep, 700'000'000, 800'000'000};
  for (std::size_t k = 0; k < kSegments + 2; ++k) window.knots.push_back(motion(knot_time(k)));
  return window;
}

KnotPrior prior_at(const KnotWindow& window, double sigma) {
  return {{window.knots[0], window.knots[1]},
          Eigen::Matrix<double, 12, 12>::Identity() / (sigma * sigma)};
}

KnotRegistration register_from(const KnotWindow& start, const KnotPrior& prior,
                               const Config::Knots& config, int threads) {
  KnotPoints points = scan_points();
  const VelocityModel model(config);
  const Workers workers(threads);
  return register_knots(points, {true_map(), prior, model, config, workers, kNobody}, start,
                        usual_annealing(config));
}

KnotError error_of(const KnotWindow& window) {
  KnotError error;
  for (std::size_t k = 1; k < window.knots.size(); ++k) {
    const Twist miss = difference(window.knots[k], swaying(knot_time(k)));
    error.translation = std::max(error.translation, miss.head<3>().norm());
    error.rotation_deg = std::max(error.rotation_deg, miss.tail<3>().norm() / kDegree);
  }
  return error;
}

}  // namespace surefoot::test
