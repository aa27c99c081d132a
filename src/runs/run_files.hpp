// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The files of a run's folder.
#pragma once

#include <array>

namespace surefoot::runs {

inline constexpr const char* kTrajectoryFile = "trajectory.tum";
inline constexpr const char* kDenseTrajectoryFile = "trajectory_dense.tum";
inline constexpr const char* kKittiTrajectoryFile = "trajectory_kitti.txt";
/// Then the segment's number and ".tum"; where a run has several.
inline constexpr const char* kSegmentFiles = "trajectory_segment_";
inline constexpr const char* kScansFile = "scans.csv";
inline constexpr const char* kMapFile = "map.ply";
inline constexpr const char* kDeskewingFile = "deskewing.ply";
inline constexpr const char* kPictureFile = "picture.png";
inline constexpr const char* kReportFile = "report.html";
inline constexpr const char* kDescriptionFile = "run.yaml";

/// In the order in which an earlier run's are removed: those that tell a run's folder from another
/// go last.
inline constexpr std::array kRunFiles = {
    kReportFile,          kPictureFile,    kDeskewingFile,   kMapFile,  kDenseTrajectoryFile,
    kKittiTrajectoryFile, kTrajectoryFile, kDescriptionFile, kScansFile};

}  // namespace surefoot::runs
