// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/leg_sketch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace surefoot::simulation {

namespace {

constexpr double kLink = 0.213;  // thigh and shank of a Go2 [m]
constexpr double kLift = 0.08;   // of a swinging foot [m]
constexpr std::array<std::array<double, 3>, 4> kHips = {
    {{0.19, 0.13, 0.0}, {0.19, -0.13, 0.0}, {-0.19, -0.13, 0.0}, {-0.19, 0.13, 0.0}}};

Eigen::Vector3d hip_of(std::size_t leg, const Pose& T_map_body) {
  return T_map_body * Eigen::Vector3d(kHips[leg][0], kHips[leg][1], kHips[leg][2]);
}

/// The knee of two equal links, bent backwards.
Eigen::Vector3d knee_between(const Eigen::Vector3d& hip, const Eigen::Vector3d& foot,
                             const Eigen::Vector3d& backward) {
  const Eigen::Vector3d along = foot - hip;
  const double half = std::min(0.5 * along.norm(), kLink);
  const Eigen::Vector3d axis = along.normalized();
  const Eigen::Vector3d across = (backward - backward.dot(axis) * axis).normalized();
  return hip + 0.5 * along + std::sqrt(kLink * kLink - half * half) * across;
}

}  // namespace

LegSketch::LegSketch(const GaitModel& gait, const Motion& motion, const RayCaster& rays,
                     std::uint64_t seed)
    : gait_(gait), motion_(&motion), rays_(&rays) {
  if (gait.footfalls.empty()) return;
  phases_ = stride_phases(gait, plan_walk(gait, motion.duration(), seed), seed);
  // Diagonal pairs take turns, single feet leave three on the ground.
  stance_ = gait.footfalls.size() > 2 ? 0.75 : 0.5;
}

double LegSketch::touchdown(std::size_t leg) const {
  return gait_.footfalls[leg % gait_.footfalls.size()];
}

double LegSketch::phase_at(double time) const {
  const double place =
      std::clamp(time / kMotionStep + 1.0, 0.0, static_cast<double>(phases_.size()) - 1.001);
  const auto k = static_cast<std::size_t>(place);
  return phases_[k] + (place - static_cast<double>(k)) * (phases_[k + 1] - phases_[k]);
}

double LegSketch::time_of(double phase) const {
  const auto found = std::lower_bound(phases_.begin(), phases_.end(), phase);
  const double time = kMotionStep * (static_cast<double>(found - phases_.begin()) - 1.0);
  return std::clamp(time, 0.0, motion_->duration() - kMotionStep);
}

Eigen::Vector3d LegSketch::foothold(std::size_t leg, double step) const {
  constexpr double kDepth = 1.5;
  const double middle = time_of(step + touchdown(leg) + 0.5 * stance_);
  Eigen::Vector3d foot = hip_of(leg, motion_->T_map_body(middle));
  foot.z() = rays_->ground_below(foot, kDepth).value_or(foot.z() - gait_.body_height);
  return foot;
}

Eigen::Vector3d LegSketch::foot_at(std::size_t leg, double time) const {
  const double phase = phase_at(time) - touchdown(leg);
  const double step = std::floor(phase);
  const double swing = (phase - step - stance_) / (1.0 - stance_);
  const Eigen::Vector3d stood = foothold(leg, step);
  if (swing <= 0.0) return stood;
  const double part = swing * swing * (3.0 - 2.0 * swing);
  Eigen::Vector3d foot = stood + part * (foothold(leg, step + 1.0) - stood);
  foot.z() += kLift * std::sin(std::numbers::pi * swing);
  return foot;
}

std::vector<Leg> LegSketch::at(double time, const Pose& T_map_body) const {
  std::vector<Leg> legs;
  if (phases_.empty()) return legs;
  const Eigen::Vector3d backward = T_map_body.rotation * -Eigen::Vector3d::UnitX();
  for (std::size_t leg = 0; leg < kHips.size(); ++leg) {
    const Eigen::Vector3d hip = hip_of(leg, T_map_body);
    const Eigen::Vector3d foot = foot_at(leg, time);
    legs.push_back({hip, knee_between(hip, foot, backward), foot});
  }
  return legs;
}

}  // namespace surefoot::simulation
