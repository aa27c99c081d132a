// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Public data sets by name: what their users had to find out once. The table is in datasets.cpp and
// nowhere else.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/recording.hpp"
#include "surefoot/pose.hpp"

namespace surefoot::io {

/// What a data set's truth is of.
enum class TruthOf {
  poses,         ///< poses, in whichever file
  positions,     ///< of a point, such as a prism
  kitti_camera,  ///< poses of KITTI's left camera; its calibration lies beside
  oxts,          ///< KITTI's OXTS records: latitude, longitude, height, angles
};

struct Dataset {
  std::string name;
  std::string what;                 ///< robot and LiDAR
  std::vector<std::string> topics;  ///< of a bag, the first that it has
  StampAt stamp_at = StampAt::automatic;
  std::size_t rows = 0;  ///< of a scan that is stored column by column, with no point times
  std::size_t columns = 0;
  DeriveTimes derive_times = DeriveTimes::no;
  double cut_azimuth_deg = 0.0;  ///< with it
  std::string stamps_name;       ///< file of stamps that goes before others
  std::optional<Pose> T_base_lidar;
  TruthOf truth = TruthOf::poses;
  /// Frame or point that the truth tells, in the LiDAR's frame; nothing: the LiDAR itself.
  std::optional<Pose> T_lidar_truth;
  std::string truth_topic;  ///< in the bag
  std::string truth_file;   ///< as it is usually called
  std::string remark;       ///< what a user should know
  /// What was tried, and on what: nothing here was seen on all of its real files.
  std::string tried;
};

[[nodiscard]] const std::vector<Dataset>& datasets();
[[nodiscard]] std::vector<std::string> dataset_names();
/// Throws ReadError that names those there are.
[[nodiscard]] const Dataset& dataset_named(std::string_view name);

/// Options with what the data set named in them says, where they leave it open. Throws ReadError.
[[nodiscard]] OpenOptions with_dataset(OpenOptions options);

}  // namespace surefoot::io
