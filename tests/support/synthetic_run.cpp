// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "support/synthetic_run.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

namespace surefoot::test {

namespace {

constexpr double kRadian = std::numbers::pi / 180.0;
constexpr double kLidarHeight = 0.45;  // [m] above the ground

/// Height of ramp_yard's ground along its middle line, without the smoothing.
double ground_height(double x, double slope_deg) {
  const double run = 10.0 * std::cos(slope_deg * kRadian);
  return std::clamp(x, 0.0, run) * std::tan(slope_deg * kRadian);
}

/// Mean of the ground under a body of 0.6 m, so that the slope changes over that length.
double smooth_height(double x, double slope_deg) {
  constexpr int kSamples = 13;
  double sum = 0.0;
  for (int i = 0; i < kSamples; ++i) sum += ground_height(x + 0.05 * (i - 6), slope_deg);
  return sum / kSamples;
}

bool same(const StageReport& a, const StageReport& b) {
  return a.name == b.name && a.iterations == b.iterations && a.matches == b.matches &&
         a.residual == b.residual && a.observability == b.observability;
}

bool same(const StageReports& a, const StageReports& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const StageReport& c, const StageReport& d) { return same(c, d); });
}

bool same(const Pose& a, const Pose& b) {
  return a.rotation.coeffs() == b.rotation.coeffs() && a.translation == b.translation;
}

}  // namespace

MotionFunction standing(const Pose& T_world_lidar) {
  return [=](double) { return T_world_lidar; };
}

MotionFunction constant_velocity(const Pose& T_start, const Twist& velocity) {
  return [=](double t) { return T_start * se3_exp(t * velocity); };
}

MotionFunction trotting(const Pose& T_start, double speed, double hertz) {
  return [=](double t) {
    const double phase = 2.0 * std::numbers::pi * hertz * t;
    const Eigen::Vector3d angles(2.0 * kRadian * std::sin(phase),
                                 1.5 * kRadian * std::sin(2.0 * phase),
                                 1.0 * kRadian * std::sin(phase + 1.0));
    const Eigen::Vector3d place(speed * t, 0.01 * std::sin(phase), 0.02 * std::sin(2.0 * phase));
    return T_start * Pose{from_roll_pitch_yaw(angles), place};
  };
}

MotionFunction climbing(double start_x, double speed, double slope_deg) {
  return [=](double t) {
    const double x = start_x + speed * t;
    const double ahead = smooth_height(x + 0.3, slope_deg);
    const double behind = smooth_height(x - 0.3, slope_deg);
    const double pitch = -std::atan2(ahead - behind, 0.6);
    return Pose{from_roll_pitch_yaw({0.0, pitch, 0.0}),
                {x, 0.0, 0.5 * (ahead + behind) + kLidarHeight}};
  };
}

MotionFunction mounted(const MotionFunction& motion, const Pose& T_lidar_mounted) {
  return [=](double t) { return motion(t) * T_lidar_mounted; };
}

std::vector<Scan> take_scans(const Scene& scene, const MotionFunction& motion, int count,
                             const Scanner& scanner, int first) {
  std::vector<Scan> scans;
  for (int i = first; i < first + count; ++i) {
    scans.push_back(take_scan(scene, motion, i * scanner.period, scanner));
  }
  return scans;
}

std::vector<Estimate> add_scans(Odometry& odometry, const std::vector<Scan>& scans) {
  std::vector<Estimate> estimates;
  for (const Scan& scan : scans) estimates.push_back(odometry.add_scan(scan));
  return estimates;
}

Error error_against(const std::vector<Estimate>& estimates, const MotionFunction& motion,
                    const Scanner& scanner) {
  const auto truth = [&](const Estimate& estimate) {
    return motion(1e-9 * static_cast<double>(estimate.stamp_ns - scanner.epoch_ns));
  };
  Error error;
  if (estimates.empty()) return error;
  const Pose T_map_world = estimates.front().T_world_lidar * truth(estimates.front()).inverse();
  for (const Estimate& estimate : estimates) {
    const Pose expected = T_map_world * truth(estimate);
    const Eigen::Vector3d miss = estimate.T_world_lidar.translation - expected.translation;
    error.final_translation = miss.norm();
    error.translation = std::max(error.translation, miss.norm());
    error.vertical = std::max(error.vertical, std::abs(miss.z()));
    error.rotation_deg = std::max(
        error.rotation_deg, angle_between_deg(estimate.T_world_lidar.rotation, expected.rotation));
  }
  return error;
}

std::string statuses(const std::vector<Estimate>& estimates) {
  std::string text;
  for (const Estimate& estimate : estimates) text += std::string(to_string(estimate.status)) + ' ';
  return text;
}

bool same_bits(const Estimate& a, const Estimate& b) {
  bool trajectories = a.trajectory.segments() == b.trajectory.segments();
  for (std::size_t k = 0; trajectories && k <= a.trajectory.segments(); ++k) {
    trajectories = same(a.trajectory.boundary(k), b.trajectory.boundary(k));
  }
  return trajectories && a.status == b.status && a.message == b.message &&
         a.stamp_ns == b.stamp_ns && same(a.T_world_lidar, b.T_world_lidar) && a.twist == b.twist &&
         a.covariance == b.covariance && a.converged == b.converged && same(a.stages, b.stages) &&
         a.points == b.points && a.registered_points == b.registered_points &&
         a.degenerate.size() == b.degenerate.size();
}

bool same_bits(const std::vector<Estimate>& a, const std::vector<Estimate>& b) {
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i) same = same_bits(a[i], b[i]);
  return same;
}

double angle_between_deg(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return so3_log(a.conjugate() * b).norm() / kRadian;
}

}  // namespace surefoot::test
