// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/datasets.hpp"

#include <numbers>

namespace surefoot::io {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr const char* kUntried =
    "not tried on its real files: none were at hand; its formats were, made after its description";

Pose at(double x, double y, double z) { return {Eigen::Quaterniond::Identity(), {x, y, z}}; }
Pose turned(Pose pose, double roll_deg, double pitch_deg, double yaw_deg) {
  pose.rotation = from_roll_pitch_yaw(Eigen::Vector3d(roll_deg, pitch_deg, yaw_deg) * kDegree);
  return pose;
}
Pose rotated(Pose pose, double qx, double qy, double qz, double qw) {
  pose.rotation = Eigen::Quaterniond(qw, qx, qy, qz).normalized();
  return pose;
}

Dataset kitti() {
  Dataset set;
  set.name = "kitti";
  set.what = "car, HDL-64E: a sequence's velodyne/*.bin, times.txt";
  set.truth = TruthOf::kitti_camera;
  set.truth_file = "poses/NN.txt, with the sequence's calib.txt";
  set.remark = "scans are deskewed already; --kitti-correction turns them up by 0.205 deg";
  set.tried =
      "poses, times and calibration of sequence 00 were, and scans of KITTI's object benchmark, "
      "which are of the same format; no sequence's scans were at hand";
  return set;
}

Dataset kitti_raw() {
  Dataset set;
  set.name = "kitti-raw";
  set.what = "car, HDL-64E: a drive's velodyne_points/data/*.bin, timestamps.txt";
  set.truth = TruthOf::oxts;
  set.truth_file = "the drive's folder: oxts/data/*.txt, calib_imu_to_velo.txt in or above it";
  set.derive_times = DeriveTimes::azimuth;
  set.cut_azimuth_deg = 180.0;
  set.stamps_name = "timestamps_start.txt";
  set.remark = "scans are not deskewed and have no times: they get them by azimuth, from behind";
  set.tried =
      "scans of two drives (21 files) were, as PCD; its truth was made after its description";
  return set;
}

Dataset newer_college() {
  Dataset set;
  set.name = "newer-college";
  set.what = "handheld, OS1-64 (2020)";
  set.topics = {"/os1_cloud_node/points"};
  const Pose T_imu_lidar =
      rotated(at(0.006252999883145094, -0.011775000020861626, 0.007644999772310257), 0, 0, 1, 0);
  const Pose T_imu_truth = rotated(at(0.035643, 0.089026, -0.021653), 0, 0, 0.38268, 0.92388);
  set.T_lidar_truth = T_imu_lidar.inverse() * T_imu_truth;
  set.truth_file = "registered_poses.csv; parkland_mound's has other columns, both are read";
  set.tried = "two of its scans were, without truth; its truth was made after its description";
  return set;
}

Dataset newer_college_2021() {
  Dataset set;
  set.name = "newer-college-2021";
  set.what = "handheld, OS0-128";
  set.topics = {"/os_cloud_node/points"};
  set.truth_file = "csv of sec, nsec, position, quaternion";
  set.remark = "its truth is of the base frame: how that lies to the LiDAR is in its own files";
  set.tried = kUntried;
  return set;
}

Dataset hilti_2022() {
  Dataset set;
  set.name = "hilti-2022";
  set.what = "handheld, PandarXT-32";
  set.topics = {"/hesai/pandar"};
  const Pose T_imu_lidar = rotated(at(-0.001, -0.00855, 0.055), 0.7071068, -0.7071068, 0, 0);
  set.T_lidar_truth = T_imu_lidar.inverse();
  set.truth_file = "..._imu.txt: TUM's columns, sparse";
  set.tried = kUntried;
  return set;
}

Dataset mulran() {
  Dataset set;
  set.name = "mulran";
  set.what = "car, OS1-64: Ouster/<ns>.bin, float32 x y z intensity";
  set.rows = 64;
  set.columns = 1024;
  set.T_base_lidar = turned(at(1.7042, -0.021, 1.8047), 0.0001, 0.0003, 179.6654);
  set.T_lidar_truth = set.T_base_lidar->inverse();
  set.truth_file = "global_pose.csv: ns and a 3x4 matrix";
  set.remark = "point times come of the columns, where a scan has all 65,536 points";
  set.tried = kUntried;
  return set;
}

Dataset s3e() {
  Dataset set;
  set.name = "s3e";
  set.what = "three wheeled robots in one bag, VLP-16 each";
  set.topics = {"/Alpha/velodyne_points"};
  set.truth_file = "a file for each robot";
  set.remark = "--topic /Bob/velodyne_points, /Carol/velodyne_points for the others";
  set.tried = kUntried;
  return set;
}

Dataset leg_kilo() {
  Dataset set;
  set.name = "leg-kilo";
  set.what = "Go1, VLP-16";
  set.topics = {"/points_raw"};
  set.stamp_at = StampAt::end;
  set.T_base_lidar = at(0, 0, 0.20);  // the IMU's frame
  set.truth_file = "TUM's columns";
  set.tried = kUntried;
  return set;
}

Dataset quadruped_slam() {
  Dataset set;
  set.name = "quadruped-slam";
  set.what = "Go2, PandarXT-16";
  set.truth = TruthOf::positions;
  set.truth_file = "positions of a prism; where it sits is in its own files";
  set.remark =
      "its data were not public when this was written: the topic is the only one of the bag";
  set.tried = kUntried;
  return set;
}

Dataset grandtour() {
  Dataset set;
  set.name = "grandtour";
  set.what = "ANYmal, PandarXT-32, Livox Mid-360 and VLP-16, a bag for each topic";
  set.topics = {"/gt_box/hesai/points", "/gt_box/livox/lidar", "/anymal/velodyne/points"};
  set.truth_file = "topics of other bags; extrinsics are in the one of /tf";
  set.remark = "its clouds on Hugging Face are deskewed already";
  set.tried = kUntried;
  return set;
}

Dataset diter() {
  Dataset set;
  set.name = "diter";
  set.what = "Go2 and Spot, Ouster (DiTer++)";
  set.topics = {"/agent1/ouster/points"};
  set.stamp_at = StampAt::end;
  set.T_base_lidar = at(0.005, 0.00056, 0.299);  // the IMU's frame
  set.truth_file = "TUM's columns; it is another odometry's, not a measurement";
  set.remark = "--topic /agent2/ouster/points for the other robot";
  set.tried = kUntried;
  return set;
}

Dataset fusionportable_legged() {
  Dataset set;
  set.name = "fusionportable-legged";
  set.what = "Unitree A1, OS1-128 (FusionPortable V2)";
  set.topics = {"/os_cloud_node/points"};
  set.truth = TruthOf::positions;
  set.truth_file = "TUM's columns, of a total station: positions, and 0 0 0 1 for rotations";
  set.tried = "the truth of its six legged sequences was; none of its bags were at hand";
  return set;
}

Dataset m2dgr() {
  Dataset set;
  set.name = "m2dgr";
  set.what = "wheeled robot, VLP-32C";
  set.topics = {"/velodyne_points"};
  set.truth_file = "TUM's columns; quaternions 0 0 0 0 where only positions are known";
  set.tried = "the truth of hall_03 was; none of its bags were at hand";
  return set;
}

Dataset ntu_viral() {
  Dataset set;
  set.name = "ntu-viral";
  set.what = "multicopter, two OS1-16";
  set.topics = {"/os1_cloud_node1/points"};
  set.truth = TruthOf::positions;
  const Pose T_body_lidar = at(-0.050, 0.0, 0.055);
  set.T_base_lidar = T_body_lidar;
  set.T_lidar_truth = T_body_lidar.inverse() * at(-0.293656, -0.012288, -0.273095);
  set.truth_topic = "/leica/pose/relative";
  set.truth_file = "the bag itself: /leica/pose/relative, positions of a prism";
  set.tried = kUntried;
  return set;
}

Dataset botanic_garden() {
  Dataset set;
  set.name = "botanic-garden";
  set.what = "wheeled robot, VLP-16";
  set.topics = {"/velodyne_points"};
  set.stamp_at = StampAt::end;
  set.truth_file = "..._GT_output.txt: TUM's columns, of the LiDAR";
  set.tried = kUntried;
  return set;
}

}  // namespace

const std::vector<Dataset>& datasets() {
  static const std::vector<Dataset> all = {
      kitti(),          kitti_raw(), newer_college(), newer_college_2021(),
      hilti_2022(),     mulran(),    s3e(),           leg_kilo(),
      quadruped_slam(), grandtour(), diter(),         fusionportable_legged(),
      m2dgr(),          ntu_viral(), botanic_garden()};
  return all;
}

std::vector<std::string> dataset_names() {
  std::vector<std::string> names;
  for (const Dataset& set : datasets()) names.push_back(set.name);
  return names;
}

const Dataset& dataset_named(std::string_view name) {
  std::string names;
  for (const Dataset& set : datasets()) {
    if (set.name == name) return set;
    names += (names.empty() ? "" : ", ") + set.name;
  }
  throw ReadError("no data set '" + std::string(name) + "'; there are " + names);
}

OpenOptions with_dataset(OpenOptions options) {
  if (options.dataset.empty()) return options;
  const Dataset& set = dataset_named(options.dataset);
  if (options.stamp_at == StampAt::automatic) options.stamp_at = set.stamp_at;
  if (options.topic.empty()) options.likely_topics = set.topics;
  if (options.stamps_name.empty()) options.stamps_name = set.stamps_name;
  const bool derives = set.derive_times != DeriveTimes::no &&
                       options.derive_times == DeriveTimes::no &&
                       options.time_direction != TimeDirection::none;
  if (derives) {
    options.derive_times = set.derive_times;
    options.cut_azimuth_deg = set.cut_azimuth_deg;
  }
  if (options.rows == 0) {
    options.rows = set.rows;
    options.columns = set.columns;
  }
  return options;
}

}  // namespace surefoot::io
