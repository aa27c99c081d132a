// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/run_bag.hpp"

#include <fmt/format.h>

#include <utility>

#include "geometry/so3.hpp"
#include "io/messages/point_cloud2_writer.hpp"
#include "io/messages/pose_messages.hpp"
#include "report/joined_names.hpp"

namespace surefoot::runs {

namespace {

constexpr const char* kMap = "map";
constexpr const char* kWorld = "odom";
constexpr const char* kLidar = "lidar";
constexpr const char* kBase = "base_link";
constexpr std::int64_t kMapPeriodNs = 1'000'000'000;
// Of the path: for listeners 0.3 MB a message, for files 2.5.
constexpr std::size_t kListenersPoses = 1 << 12, kFilePoses = 1 << 15;

/// The pose's covariance for a frame that sits at T_lidar_written: a rotation of the LiDAR moves it
/// by the lever between the two.
Matrix6 moved_covariance(const Estimate& estimate, const Pose& T_lidar_written) {
  const Eigen::Vector3d lever = estimate.T_world_lidar.rotation * T_lidar_written.translation;
  Matrix6 change = Matrix6::Identity();
  change.block<3, 3>(0, 3) = -hat(lever);
  return change * estimate.covariance * change.transpose();
}

/// The LiDAR's velocity as that of a frame fixed to it, in that frame.
Twist moved_twist(const Twist& twist, const Pose& T_lidar_written) {
  const Eigen::Vector3d linear = twist.head<3>();
  const Eigen::Vector3d angular = twist.tail<3>();
  const Eigen::Quaterniond R_written_lidar = T_lidar_written.rotation.conjugate();
  Twist moved;
  moved.head<3>() = R_written_lidar * (linear + angular.cross(T_lidar_written.translation));
  moved.tail<3>() = R_written_lidar * angular;
  return moved;
}

io::Diagnostic::Level level_of(const Estimate& estimate) {
  if (!estimate.trusted()) return io::Diagnostic::Level::error;
  return estimate.status == Status::degenerate ? io::Diagnostic::Level::warn
                                               : io::Diagnostic::Level::ok;
}

}  // namespace

RunTopics add_run_topics(io::BagWriter& bag) {
  RunTopics topics = {};
  topics.scan = bag.add_topic("/surefoot/scan", io::point_cloud2_definition());
  topics.map = bag.add_topic("/surefoot/local_map", io::point_cloud2_definition());
  topics.odometry = bag.add_topic("/surefoot/odometry", io::odometry_definition());
  topics.path = bag.add_topic("/surefoot/path", io::path_definition());
  topics.transforms = bag.add_topic("/tf", io::transforms_definition());
  topics.diagnostics = bag.add_topic("/diagnostics", io::diagnostics_definition());
  return topics;
}

RunBag::RunBag(std::shared_ptr<io::BagWriter> bag, const std::optional<Pose>& T_lidar_base)
    : bag_(std::move(bag)),
      T_lidar_written_(T_lidar_base.value_or(Pose{})),
      of_base_(T_lidar_base.has_value()),
      frame_(of_base_ ? kBase : kLidar),
      topics_(add_run_topics(*bag_)),
      path_(bag_->is_latched() ? kListenersPoses : kFilePoses) {}

void RunBag::add(const std::string& name, const Estimate& estimate, const Odometry& odometry) {
  write_diagnosis(name, estimate);
  if (!estimate.trusted()) return;
  write_pose(estimate);
  write_clouds(estimate, odometry);
  if (path_.added() >= next_path_) write_path();
}

void RunBag::place(const std::optional<Pose>& T_map_world) {
  const bool moved =
      T_map_world && (!T_map_world_ || !(T_map_world_->matrix() == T_map_world->matrix()));
  is_placed_ = true;
  T_map_world_ = T_map_world;
  if (moved) fixed_written_ = false;
}

void RunBag::write_fixed_transforms(std::int64_t stamp_ns) {
  fixed_written_ = true;
  std::vector<io::Transform> transforms;
  if (T_map_world_ || !is_placed_) {
    transforms.push_back({stamp_ns, kMap, kWorld, T_map_world_.value_or(Pose{})});
  }
  if (of_base_) transforms.push_back({stamp_ns, kBase, kLidar, T_lidar_written_.inverse()});
  if (transforms.empty()) return;
  const std::size_t topic = bag_->add_topic("/tf_static", io::transforms_definition());
  bag_->write(topic, stamp_ns, io::format_transforms(transforms, bag_->flavour()));
}

void RunBag::write_pose(const Estimate& estimate) {
  const std::int64_t stamp = estimate.stamp_ns;
  if (bag_->is_latched() && !fixed_written_) write_fixed_transforms(stamp);
  io::OdometryMessage message{stamp, kWorld, frame_, estimate.T_world_lidar * T_lidar_written_};
  message.covariance = moved_covariance(estimate, T_lidar_written_);
  message.twist = moved_twist(estimate.twist, T_lidar_written_);
  bag_->write(topics_.odometry, stamp, io::format_odometry(message, bag_->flavour()));
  std::vector<io::Transform> transforms = {{stamp, kWorld, frame_, message.T_frame_child}};
  if (of_base_ && !fixed_written_) {
    transforms.push_back({stamp, kBase, kLidar, T_lidar_written_.inverse()});
  }
  bag_->write(topics_.transforms, stamp, io::format_transforms(transforms, bag_->flavour()));
  if (std::exchange(segment_, estimate.segment) != estimate.segment) {  // in another frame
    path_.clear();
    path_written_ = 0;
    next_path_ = 1;
  }
  path_.add({stamp, message.T_frame_child});
}

void RunBag::write_clouds(const Estimate& estimate, const Odometry& odometry) {
  Scan cloud;
  cloud.stamp_ns = estimate.stamp_ns;
  cloud.points = odometry.deskewed_scan().points;
  cloud.intensities = odometry.deskewed_scan().intensities;
  bag_->write(topics_.scan, cloud.stamp_ns,
              io::format_point_cloud2(cloud, kLidar, bag_->flavour()));
  // A stamp before the last one's is of a clock that was set back.
  const bool soon = estimate.stamp_ns >= next_map_ns_ - kMapPeriodNs;
  if (any_map_ && soon && estimate.stamp_ns < next_map_ns_) return;
  any_map_ = true;
  next_map_ns_ = estimate.stamp_ns + kMapPeriodNs;
  cloud.points.clear();
  cloud.intensities.clear();
  for (const Eigen::Vector3d& point : odometry.local_map()) {
    cloud.points.push_back(point.cast<float>());
  }
  bag_->write(topics_.map, cloud.stamp_ns, io::format_point_cloud2(cloud, kWorld, bag_->flavour()));
}

/// So that all of its messages together are a few times the path, not its square; nor more than 50
/// poses a scan for listeners and 4 in files, once it has all the poses that it may have.
void RunBag::write_path() {
  const Trajectory& poses = path_.poses();
  bag_->write(topics_.path, poses.back().stamp_ns, io::format_path(poses, kWorld, bag_->flavour()));
  path_written_ = path_.added();
  next_path_ = path_written_ + poses.size() / (bag_->is_latched() ? 50 : 4) + 1;
}

void RunBag::write_diagnosis(const std::string& name, const Estimate& estimate) {
  io::Diagnostic diagnostic;
  diagnostic.stamp_ns = estimate.stamp_ns;
  diagnostic.level = level_of(estimate);
  diagnostic.name = "surefoot: odometry";
  diagnostic.message = std::string(to_string(estimate.status));
  if (!estimate.message.empty()) diagnostic.message += ": " + estimate.message;
  const auto add = [&](std::string key, const auto& value) {
    diagnostic.values.emplace_back(std::move(key), fmt::format("{}", value));
  };
  add("scan", name);
  add("points", estimate.points);
  add("registered points", estimate.registered_points);
  for (const StageReport& stage : estimate.stages) {
    add(fmt::format("{} matches", stage.name), stage.matches);
    add(fmt::format("{} iterations", stage.name), stage.iterations);
    add(fmt::format("{} residual [m]", stage.name), stage.residual);
  }
  add("weak directions", report::joined_names(estimate.degenerate));
  bag_->write(topics_.diagnostics, estimate.stamp_ns,
              io::format_diagnostic(diagnostic, bag_->flavour()));
}

void RunBag::finish(const std::string& run_yaml) {
  if (path_.added() > path_written_) write_path();
  bag_->attach("run.yaml", "application/yaml", run_yaml);
  bag_->finish();
}

}  // namespace surefoot::runs
