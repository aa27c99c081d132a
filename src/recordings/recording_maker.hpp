// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What 'surefoot simulate' and 'surefoot suite' have in common: from a request to a recording.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "io/option_ranges.hpp"
#include "recordings/recording_writer.hpp"
#include "simulation/gait.hpp"
#include "simulation/lidar_model.hpp"
#include "simulation/scene.hpp"

namespace surefoot::recordings {

// What numbers of a request may be, wherever they are given.
inline constexpr int kMostScans = 100'000;  ///< nearly three hours; the motion is held in memory
inline constexpr int kMostPeople = 20;
inline constexpr io::NumberRange kSpeeds{0.3, 5.0};  ///< [m/s]
inline constexpr io::NumberRange kGaitScales{0.0, 10.0};
inline constexpr io::NumberRange kAirShares{0.0, 0.5};  ///< rain, dust

struct RecordingRequest {
  std::string scene;  ///< a name of the catalogue, or a mesh file: .ply .obj .asc
  std::filesystem::path
      route_file;     ///< instead of the scene's own way: corners "x y z", one a line
  std::string robot;  ///< empty: what suits the scene
  std::string lidar = "vlp16";
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> layout;  ///< of a scene of the catalogue; absent: the seed's
  std::uint64_t scans = 600;
  double gait_scale = 1.0;
  double speed = 0.0;                             ///< [m/s]; 0: the robot's own
  Eigen::Vector3d mount_offset{0.10, 0.0, 0.16};  ///< LiDAR in the body's frame [m]
  Eigen::Vector3d mount_tilt_deg{0.0, 0.0, 0.0};  ///< its roll, pitch, yaw
  bool footprint = true;
  bool dual_return = false;
  bool robot_body = false;
  simulation::AirOptions air;  ///< rain and dust
  int people = 0;              ///< who go with the robot
  bool overwrite = false;      ///< also files that no simulation has left
  RecordingFormat format;
};

/// The scene of a request. @throws std::invalid_argument, std::runtime_error with the reason.
[[nodiscard]] simulation::Scene scene_of(const RecordingRequest& request);

/// What the request says of the robot's gait. @throws std::invalid_argument for an unknown robot.
[[nodiscard]] simulation::GaitModel gait_of(const RecordingRequest& request,
                                            const simulation::Scene& scene);
/// T_body_lidar.
[[nodiscard]] Pose mount_of(const RecordingRequest& request);
/// So many of the request's LiDAR cover the duration [s].
[[nodiscard]] std::uint64_t scans_in(double duration, const RecordingRequest& request);
[[nodiscard]] simulation::ScannerOptions scanner_options_of(const RecordingRequest& request);

/// Makes the recording in `folder`; on_scan is told after each scan and stops it with false.
/// @returns the number of scans that were made.
/// @throws std::invalid_argument for a request that cannot be met, std::runtime_error for files.
std::uint64_t make_recording(const RecordingRequest& request, const std::filesystem::path& folder,
                             const std::function<bool(std::uint64_t done)>& on_scan);

/// Every parameter of a recording, as JSON.
[[nodiscard]] std::string scene_json(const RecordingRequest& request,
                                     const simulation::Scene& scene,
                                     const simulation::GaitModel& gait,
                                     const simulation::LidarModel& lidar,
                                     const simulation::ScannerOptions& options,
                                     std::uint64_t scans);

}  // namespace surefoot::recordings
