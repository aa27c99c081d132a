// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The files of a run's folder.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace surefoot::runs {

inline constexpr const char* kTrajectoryFile = "trajectory.tum";
inline constexpr const char* kDenseTrajectoryFile = "trajectory_dense.tum";
inline constexpr const char* kKittiTrajectoryFile = "trajectory_kitti.txt";
/// Then the segment's number and ".tum"; where a run has several.
inline constexpr const char* kSegmentFiles = "trajectory_segment_";
/// Stands in a run's trajectories where a segment's poses begin; then its number.
inline constexpr std::string_view kSegmentBegins = "# segment ";
/// That line.
template <typename Number>
[[nodiscard]] std::string segment_mark(Number number) {
  return std::string(kSegmentBegins) + std::to_string(number) + ": in a frame of its own\n";
}
inline constexpr const char* kScansFile = "scans.csv";
inline constexpr const char* kMapFile = "map.ply";
inline constexpr const char* kDeskewingFile = "deskewing.ply";
// Beside these where loops were closed:
inline constexpr const char* kOptimizedTrajectoryFile = "trajectory_optimized.tum";
inline constexpr const char* kOptimizedMapFile = "map_optimized.ply";
inline constexpr const char* kLoopsFile = "loops.csv";
inline constexpr const char* kPiecesFile = "pieces.csv";      // of joined maps
inline constexpr const char* kRevisitsFile = "revisits.csv";  // where the truth is known
inline constexpr const char* kPoseGraphFile = "pose_graph.g2o";
inline constexpr const char* kSavedMapFile = "map.surefoot";  // to come back to
// Where a map was to be continued:
inline constexpr const char* kMapLoopsFile = "map_loops.csv";
inline constexpr const char* kApartMapFile = "map_apart.surefoot";  // the run's own, if it was not
// And in a saved map:
inline constexpr const char* kMapFrameTrajectoryFile = "trajectory_map.tum";
/// Then a number from 1 on and ".tum": of maps that were asked for before.
inline constexpr const char* kMapFrameFiles = "trajectory_map_";
inline constexpr const char* kLocalizationFile = "localization.csv";
/// Of a live run: what became of every scan.
inline constexpr const char* kLiveLogFile = "live.log";
inline constexpr const char* kPictureFile = "picture.png";
inline constexpr const char* kReportFile = "report.html";
inline constexpr const char* kDescriptionFile = "run.yaml";

/// In the order in which an earlier run's are removed: those that tell a run's folder from another
/// go last.
inline constexpr std::array kRunFiles = {kLiveLogFile,
                                         kRevisitsFile,
                                         kMapFrameTrajectoryFile,
                                         kLocalizationFile,
                                         kMapLoopsFile,
                                         kApartMapFile,
                                         kSavedMapFile,
                                         kPoseGraphFile,
                                         kLoopsFile,
                                         kOptimizedMapFile,
                                         kOptimizedTrajectoryFile,
                                         kReportFile,
                                         kPictureFile,
                                         kDeskewingFile,
                                         kMapFile,
                                         kDenseTrajectoryFile,
                                         kKittiTrajectoryFile,
                                         kTrajectoryFile,
                                         kDescriptionFile,
                                         kScansFile};

}  // namespace surefoot::runs
