// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "support/scene.hpp"

#include <cmath>
#include <numbers>

#include "support/random.hpp"

namespace surefoot::test {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kLasers = 16;
constexpr double kLaserPeriod = 2.304e-6;  // [s]

Box turned_box(double x, double y, double z, const Eigen::Vector3d& half, double yaw_deg,
               double pitch_deg = 0.0) {
  return {{from_roll_pitch_yaw({0.0, pitch_deg * kDegree, yaw_deg * kDegree}), {x, y, z}}, half};
}

/// Slab method; the exit counts where the ray starts inside.
double distance_to(const Box& box, const Eigen::Vector3d& origin,
                   const Eigen::Vector3d& direction) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  const Pose T_box_world = box.T_world_box.inverse();
  const Eigen::Vector3d o = T_box_world * origin;
  const Eigen::Vector3d d = T_box_world.rotation * direction;
  double enter = -kNone, leave = kNone;
  for (int axis = 0; axis < 3; ++axis) {
    if (d[axis] == 0.0) {
      if (std::abs(o[axis]) > box.half[axis]) return kNone;
      continue;
    }
    const double a = (-box.half[axis] - o[axis]) / d[axis];
    const double b = (box.half[axis] - o[axis]) / d[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  if (leave < enter || leave <= 0.0) return kNone;
  return enter > 0.0 ? enter : leave;
}

}  // namespace

Box box_between(const Eigen::Vector3d& low, const Eigen::Vector3d& high) {
  return {{Eigen::Quaterniond::Identity(), 0.5 * (low + high)}, 0.5 * (high - low)};
}

Scene& Scene::add(const Box& box) {
  boxes_.push_back(box);
  return *this;
}

double Scene::cast(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Box& box : boxes_) nearest = std::min(nearest, distance_to(box, origin, direction));
  return nearest;
}

Scene Scene::moved(const Pose& T_new_old) const {
  Scene result = *this;
  for (Box& box : result.boxes_) box.T_world_box = T_new_old * box.T_world_box;
  return result;
}

Scene bare_hall() {
  Scene scene;
  scene.add(box_between({-15.0, -10.0, 0.0}, {15.0, 10.0, 6.0}));
  scene.add(turned_box(6.0, 6.0, 1.0, {1.0, 0.6, 1.0}, 20.0));
  scene.add(turned_box(-4.0, 7.0, 0.5, {0.8, 0.8, 0.5}, 45.0));
  scene.add(turned_box(-9.0, -3.0, 1.5, {0.5, 2.0, 1.5}, -10.0));
  scene.add(turned_box(3.0, -7.0, 0.4, {1.5, 0.5, 0.4}, 70.0));
  scene.add(turned_box(11.0, -4.0, 2.0, {0.4, 0.4, 2.0}, 0.0));
  scene.add(turned_box(10.0, 3.0, 2.0, {0.4, 0.4, 2.0}, 30.0));
  scene.add(turned_box(-12.0, 6.0, 0.8, {1.0, 1.0, 0.8}, 15.0));
  scene.add(turned_box(0.0, 9.5, 2.5, {2.0, 0.5, 0.2}, 0.0));
  return scene;
}

Scene furnished_hall() {
  Scene scene = bare_hall();
  // Shelves and pillars along both sides, as a store room has them.
  for (int i = 0; i < 12; ++i) {
    const double x = -13.0 + 2.3 * i;
    scene.add(turned_box(x, 3.5 + 0.4 * (i % 3), 1.0, {0.25, 0.4, 1.0 + 0.2 * (i % 4)}, 17.0 * i));
    scene.add(turned_box(x + 1.1, -3.0 - 0.5 * (i % 4), 0.9, {0.3, 0.3, 2.0}, 29.0 * i));
  }
  return scene;
}

Scene ramp_yard(double slope_deg) {
  constexpr double kLength = 10.0;  // along the slope
  const double rise = kLength * std::sin(slope_deg * kDegree);
  const double run = kLength * std::cos(slope_deg * kDegree);
  Scene scene;
  scene.add(box_between({-25.0, -30.0, -1.0}, {30.0, 30.0, 0.0}));
  // The ramp's upper face passes through the origin; its centre lies 1 m below that face.
  const Eigen::Quaterniond tilt = from_roll_pitch_yaw({0.0, -slope_deg * kDegree, 0.0});
  const Eigen::Vector3d centre = tilt * Eigen::Vector3d(0.5 * kLength, 0.0, -1.0);
  scene.add({{tilt, centre}, {0.5 * kLength, 4.0, 1.0}});
  scene.add(box_between({run, -4.0, -1.0}, {30.0, 4.0, rise}));
  scene.add(box_between({-26.0, -31.0, -1.0}, {-25.0, 31.0, 12.0}));
  scene.add(box_between({30.0, -31.0, -1.0}, {31.0, 31.0, 12.0}));
  scene.add(box_between({-26.0, 8.0, -1.0}, {-2.0, 9.0, 10.0}));
  scene.add(box_between({4.0, 8.0, -1.0}, {18.0, 9.5, 10.0}));
  scene.add(box_between({-12.0, -9.0, -1.0}, {14.0, -8.0, 10.0}));
  for (const double x : {-18.0, -9.0, -3.0, 5.0, 12.0, 19.0, 24.0}) {
    scene.add(turned_box(x, -6.0, 2.0, {0.3, 0.3, 4.0}, 7.0 * x));
    scene.add(turned_box(x + 2.5, 6.0, 2.0, {0.4, 0.3, 4.0}, -5.0 * x));
  }
  return scene;
}

Scan take_scan(const Scene& scene, const MotionFunction& T_world_lidar, double start,
               const Scanner& scanner) {
  Scan scan;
  const auto start_ns = static_cast<std::int64_t>(std::llround(start * 1e9));
  scan.stamp_ns = scanner.epoch_ns + start_ns;
  Random random(static_cast<std::uint64_t>(start_ns) + 17);
  for (int column = 0; column < scanner.columns; ++column) {
    const double share = static_cast<double>(column) / scanner.columns;
    const double azimuth = -2.0 * std::numbers::pi * share;
    for (int laser = 0; laser < kLasers; ++laser) {
      const auto time_ns = static_cast<std::int32_t>(
          std::lround(1e9 * (share * scanner.period + laser * kLaserPeriod)));
      const double elevation = (2.0 * laser - 15.0) * kDegree;
      const Eigen::Vector3d ray(std::cos(elevation) * std::cos(azimuth),
                                std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
      const Pose pose = T_world_lidar(start + 1e-9 * time_ns);
      const double range = scene.cast(pose.translation, pose.rotation * ray);
      const double seen = range + random.normal(scanner.noise);
      const bool hit = range < scanner.max_range && seen > 0.0;
      scan.points.push_back(hit ? Eigen::Vector3f((seen * ray).cast<float>())
                                : Eigen::Vector3f::Zero());
      scan.intensities.push_back(static_cast<float>(laser));
      scan.rings.push_back(static_cast<std::uint16_t>(laser));
      if (scanner.point_times) scan.times_ns.push_back(time_ns);
    }
  }
  return scan;
}

}  // namespace surefoot::test
