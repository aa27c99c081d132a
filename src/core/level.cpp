// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/level.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/downsample.hpp"
#include "core/upright.hpp"
#include "core/voxel_key.hpp"
#include "geometry/decompositions.hpp"
#include "geometry/float_sums.hpp"
#include "geometry/so3.hpp"

namespace surefoot {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

constexpr double kThinning = 0.3;      // [m] so that the dense rings at the feet do not outvote
constexpr double kReach = 20.0;        // [m] ground farther away need not be in the same plane
constexpr double kThickness = 0.1;     // [m] points of the plane lie within this
constexpr double kClearlyBelow = 0.3;  // [m] points lower than this contradict it
constexpr double kMinHeight = 0.1;     // [m] of the sensor above the ground
constexpr double kMaxHeight = 5.0;     // [m]
constexpr double kMinSupport = 0.1;    // share of the points that must lie in it
constexpr int kMinPoints = 50;
constexpr int kHypotheses = 500;
constexpr int kRefinements = 5;

// A ground that far [deg] off a given mount is worth a word; robots seldom start on a steeper ramp.
constexpr double kMountContradicted = 10.0;
constexpr double kSteepest = 80.0;  // [deg] of a ground that is looked for to contradict a mount

/// Points p with normal . p + offset near 0; the sensor is `offset` above it.
struct Plane {
  Eigen::Vector3d normal;
  double offset;
  [[nodiscard]] double height_of(const Eigen::Vector3d& p) const { return normal.dot(p) + offset; }
};

std::vector<Eigen::Vector3d> thin_nearby(const std::vector<Eigen::Vector3f>& points) {
  std::vector<Eigen::Vector3d> nearby;
  for (const Eigen::Vector3f& point : downsample(points, kThinning)) {
    if (static_cast<double>(norm(point)) < kReach) nearby.push_back(point.cast<double>());
  }
  return nearby;
}

bool plausible(const Plane& plane, double min_cosine) {
  return plane.normal.z() >= min_cosine && plane.offset >= kMinHeight && plane.offset <= kMaxHeight;
}

/// Points in the plane; negative if too many lie below it for a ground.
int support(const Plane& plane, const std::vector<Eigen::Vector3d>& points) {
  int in = 0;
  int below = 0;
  for (const Eigen::Vector3d& p : points) {
    const double height = plane.height_of(p);
    in += std::abs(height) < kThickness ? 1 : 0;
    below += height < -kClearlyBelow ? 1 : 0;
  }
  return 5 * below > in ? -1 : in;
}

Plane through(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
  if (normal.z() < 0.0) normal = -normal;
  return {normal, -normal.dot(a)};
}

/// Least-squares plane of the points that lie in `plane`.
Plane refit(const Plane& plane, const std::vector<Eigen::Vector3d>& points) {
  double count = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) {
    if (std::abs(plane.height_of(p)) >= kThickness) continue;
    count += 1.0;
    sum += p;
    products += p * p.transpose();
  }
  const Eigen::Vector3d mean = sum / count;
  Eigen::Vector3d normal =
      symmetric_eigen<3>(products / count - mean * mean.transpose()).vectors.col(0);
  if (normal.z() < 0.0) normal = -normal;
  return {normal, -normal.dot(mean)};
}

std::string format(const char* text, double first, double second) {
  char buffer[200];
  std::snprintf(buffer, sizeof buffer, text, first, second);
  return buffer;
}

double tilt_deg(const Eigen::Vector3d& up) {
  return std::acos(std::clamp(up.z(), -1.0, 1.0)) / kDegree;
}

std::vector<Eigen::Vector3f> turned(const std::vector<Eigen::Vector3f>& points,
                                    const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3f R = rotation.toRotationMatrix().cast<float>();
  std::vector<Eigen::Vector3f> result;
  result.reserve(points.size());
  for (const Eigen::Vector3f& point : points) result.push_back(product(R, point));
  return result;
}

Eigen::Quaterniond upside_down() {
  return Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
}

Pose level_by_mount(const std::vector<Eigen::Vector3f>& points, const Config::Level& config,
                    LevelReport& report) {
  const Pose T_base_lidar = mount_pose(config);
  report.tilt_deg = tilt_deg(T_base_lidar.rotation * Eigen::Vector3d::UnitZ());
  report.message = "level: the map is the base's frame at the first scan, from the mount given";
  const auto ground = find_ground(turned(points, T_base_lidar.rotation), kSteepest);
  if (ground && tilt_deg(ground->normal) > kMountContradicted) {
    report.message += format(
        "; but the ground in the first scan is %.0f deg off it: is the mount T_base_lidar, metres "
        "and degrees?",
        tilt_deg(ground->normal), 0.0);
  } else if (!ground && find_ground(turned(points, upside_down() * T_base_lidar.rotation),
                                    config.max_tilt_deg)) {
    report.message += "; but there is a floor above it: is the mount upside down?";
  }
  return T_base_lidar;
}

/// Where a floor above says that the LiDAR hangs upside down: the mount that would be.
std::string upside_down_mount(const GroundPlane& floor) {
  // Roll, then pitch, that turn the floor's normal to z.
  const Eigen::Vector3d up = upside_down() * floor.normal;
  double roll = std::atan2(up.y(), up.z());
  if (roll < 0.0) roll += 2.0 * std::numbers::pi;  // 180, not -180
  const double pitch = std::atan2(-up.x(), std::hypot(up.y(), up.z()));
  return format(
      "; there is a floor above it: if the LiDAR hangs upside down, its mount is 0,0,0,%.0f,%.0f "
      "and the yaw (--extrinsic)",
      roll / kDegree, pitch / kDegree);
}

/// The shortest turn that brings `up` to z, so that the heading stays.
Pose upward(const Eigen::Vector3d& up) {
  return {rotation_between(up, Eigen::Vector3d::UnitZ()), Eigen::Vector3d::Zero()};
}

/// For want of a ground beneath it: what stands upright and lies level tells, or the LiDAR's own z
/// axis is taken.
Pose level_without_ground(const std::vector<Eigen::Vector3f>& points, const Config::Level& config,
                          LevelReport& report) {
  report.message = "level: no ground found in the first scan; ";
  const auto up = find_up(points, config.max_tilt_deg);
  if (up) {
    report.tilt_deg = tilt_deg(*up);
    report.message +=
        format("up is along what stands upright in it, %.0f deg from the LiDAR's z axis",
               report.tilt_deg, 0.0);
  } else {
    report.message += "the LiDAR's own z axis is taken for up";
  }
  const auto floor = find_ground(turned(points, upside_down()), config.max_tilt_deg);
  if (floor) report.message += upside_down_mount(*floor);
  return up ? upward(*up) : Pose{};
}

}  // namespace

std::optional<GroundPlane> find_ground(const std::vector<Eigen::Vector3f>& cloud,
                                       double max_tilt_deg) {
  const std::vector<Eigen::Vector3d> points = thin_nearby(cloud);
  if (points.size() < kMinPoints) return std::nullopt;
  const double min_cosine = std::cos(max_tilt_deg * kDegree);
  // RANSAC with a fixed sequence of triples: the same cloud gives the same plane.
  std::uint64_t draw = 0;
  const auto pick = [&] { return points[hash_key(++draw) % points.size()]; };
  std::optional<Plane> best;
  int best_support = -1;
  for (int i = 0; i < kHypotheses; ++i) {
    const Eigen::Vector3d a = pick(), b = pick(), c = pick();
    const Plane plane = through(a, b, c);
    if (!plane.normal.allFinite() || !plausible(plane, min_cosine)) continue;
    const int supporting = support(plane, points);
    if (supporting > best_support) {
      best = plane;
      best_support = supporting;
    }
  }
  if (best_support < kMinPoints) return std::nullopt;
  for (int i = 0; i < kRefinements; ++i) best = refit(*best, points);
  const bool supported =
      support(*best, points) >=
      std::max(kMinSupport * static_cast<double>(points.size()), static_cast<double>(kMinPoints));
  if (!supported || !plausible(*best, min_cosine)) return std::nullopt;
  return GroundPlane{best->normal, best->offset};
}

Pose level_pose(const std::vector<Eigen::Vector3f>& points, const Config::Level& config,
                LevelReport& report) {
  report = {};
  report.mode = config.mode;
  if (config.mode == LevelMode::none) {
    report.message = "level: the LiDAR's own z axis is taken for up";
    return {};
  }
  if (config.mode == LevelMode::mount) return level_by_mount(points, config, report);
  const auto ground = find_ground(points, config.max_tilt_deg);
  if (!ground) return level_without_ground(points, config, report);
  report.from_ground = true;
  report.tilt_deg = tilt_deg(ground->normal);
  report.ground_height = ground->height;
  report.message = format(
      "level: from the ground in the first scan, %.2f deg from the LiDAR's z axis, %.2f m "
      "below it",
      report.tilt_deg, report.ground_height);
  return upward(ground->normal);
}

}  // namespace surefoot
