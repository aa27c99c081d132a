// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/localization_run.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "io/decimal_time.hpp"
#include "io/file_writer.hpp"
#include "io/trajectory_files.hpp"
#include "runs/csv_table.hpp"
#include "runs/run_files.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::runs {

LocalizationRun::LocalizationRun(mapping::SavedMap map, const Pose& T_lidar_written)
    : localizer_(std::move(map), {}), T_lidar_written_(T_lidar_written) {}

void LocalizationRun::open(const std::filesystem::path& folder) {
  folder_ = folder;
  poses_.open(folder / kMapFrameTrajectoryFile);
  csv_.open(folder / kLocalizationFile);
  write("stamp,found,x_m,y_m,z_m,message\n");
}

void LocalizationRun::write(const std::string& row) {
  if (csv_ << row << std::flush && poses_.flush()) return;
  throw io::WriteError(folder_.string() + ": cannot be written any more: " + std::strerror(errno));
}

void LocalizationRun::begin_anew(mapping::SavedMap map, bool is_another) {
  localizer_ = mapping::MapLocalizer(std::move(map), {});
  if (is_another && poses_.is_open()) keep_poses();
}

void LocalizationRun::keep_poses() {
  namespace fs = std::filesystem;
  const fs::path file = folder_ / kMapFrameTrajectoryFile;
  const auto kept = [&](int i) { return folder_ / fmt::format("{}{}.tum", kMapFrameFiles, i); };
  poses_.close();
  if (fs::file_size(file) > 0) {
    int number = 1;
    while (fs::exists(kept(number))) ++number;
    fs::rename(file, kept(number));
  }
  poses_.open(file);
}

void LocalizationRun::add(const Estimate& estimate, const mapping::ScanPoints& points) {
  // A scan that is refused for its stamp says nothing of the time.
  const bool counts = outcome_.scans++ == 0 || estimate.trusted();
  const std::int64_t now_ns = counts ? clock_.next(estimate.stamp_ns) : 0;
  const std::string stamp = io::format_seconds(estimate.stamp_ns);
  if (!estimate.trusted()) {
    return write(fmt::format("{},0,,,,{}\n", stamp, to_string(estimate.status)));
  }
  localizer_.add(placed_.next(estimate), points);
  outcome_.message = localizer_.message();
  if (!localizer_.T_map_world()) {
    return write(fmt::format("{},0,,,,{}\n", stamp, csv_quoted(outcome_.message)));
  }
  const Pose pose = *localizer_.T_map_world() * estimate.T_world_lidar;
  ++outcome_.found;
  if (!outcome_.first_found) outcome_.first_found = seconds(now_ns - clock_.begin_ns());
  poses_ << io::format_tum({{estimate.stamp_ns, pose * T_lidar_written_}});
  write(fmt::format("{},1,{:.4f},{:.4f},{:.4f},{}\n", stamp, pose.translation.x(),
                    pose.translation.y(), pose.translation.z(), csv_quoted(outcome_.message)));
}

}  // namespace surefoot::runs
