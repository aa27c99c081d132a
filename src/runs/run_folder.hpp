// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A run's results, read back from the folder that it left.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/report.hpp"
#include "surefoot/trajectory.hpp"

namespace surefoot::runs {

struct RunFolder {
  std::filesystem::path input;  ///< the recording; empty if not known
  std::string method;           ///< "" if not known
  bool poses_of_lidar = true;
  std::vector<report::Fact> facts;
  std::vector<std::string> notes;  ///< the run's own, and which of its files are missing
  std::vector<report::ReportParameter> parameters;
  report::ScanTable scans;
  std::vector<std::optional<Pose>> poses;       ///< one a scan; none if rejected
  Trajectory measured;                          ///< trajectory.tum
  report::MapCloud map;                         ///< in the map frame
  std::vector<report::DeskewSample> deskewing;  ///< likewise
  std::vector<report::ReportLoop> loops;
  std::vector<std::optional<Pose>> corrected;  ///< by the loops, as `poses`; empty: not known
};

/// Throws io::ReadError if scans.csv, trajectory_kitti.txt or trajectory.tum is missing or
/// broken, or any other of the run's files is broken.
[[nodiscard]] RunFolder read_run_folder(const std::filesystem::path& folder);

/// Why a run's trajectory is not all of it, in a few words: it was killed or interrupted.
/// `estimate`: its folder, or a trajectory in it; empty for what is no run's, or is whole.
[[nodiscard]] std::string unfinished_text(const std::filesystem::path& estimate);

}  // namespace surefoot::runs
