// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/localization_run.hpp"

#include <fmt/format.h>

#include <utility>

#include "io/decimal_time.hpp"
#include "io/file_writer.hpp"
#include "io/trajectory_files.hpp"
#include "runs/run_files.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::runs {

LocalizationRun::LocalizationRun(mapping::SavedMap map, const Pose& T_lidar_written)
    : localizer_(std::move(map), {}),
      T_lidar_written_(T_lidar_written),
      csv_("stamp,found,x_m,y_m,z_m,message\n") {}

void LocalizationRun::begin_anew(mapping::SavedMap map) {
  localizer_ = mapping::MapLocalizer(std::move(map), {});
  poses_.clear();
}

void LocalizationRun::add(const Estimate& estimate, const DeskewedScan& scan) {
  if (outcome_.scans++ == 0) first_stamp_ns_ = estimate.stamp_ns;
  const std::string stamp = io::format_seconds(estimate.stamp_ns);
  if (!estimate.trusted()) {
    csv_ += fmt::format("{},0,,,,{}\n", stamp, to_string(estimate.status));
    return;
  }
  localizer_.add(placed_.next(estimate), scan);
  outcome_.message = localizer_.message();
  if (!localizer_.T_map_world()) {
    csv_ += fmt::format("{},0,,,,{}\n", stamp, outcome_.message);
    return;
  }
  const Pose pose = *localizer_.T_map_world() * estimate.T_world_lidar;
  ++outcome_.found;
  if (!outcome_.first_found) outcome_.first_found = seconds(estimate.stamp_ns - first_stamp_ns_);
  poses_.push_back({estimate.stamp_ns, pose * T_lidar_written_});
  csv_ += fmt::format("{},1,{:.4f},{:.4f},{:.4f},{}\n", stamp, pose.translation.x(),
                      pose.translation.y(), pose.translation.z(), outcome_.message);
}

LocalizationOutcome LocalizationRun::finish(const std::filesystem::path& folder) {
  io::write_tum(folder / kMapFrameTrajectoryFile, poses_);
  io::write_whole_file(folder / kLocalizationFile, csv_);
  return outcome_;
}

}  // namespace surefoot::runs
