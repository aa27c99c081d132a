// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recordings/recording_maker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "io/file_writer.hpp"
#include "recordings/recording_folder.hpp"
#include "simulation/body_motion.hpp"
#include "simulation/companions.hpp"
#include "simulation/mesh_scene.hpp"

namespace surefoot::recordings {
namespace {

/// @throws std::invalid_argument for a sensor that the robot cannot carry so.
void require_place_for_sensor(const RecordingRequest& request, const simulation::GaitModel& gait) {
  const double height = gait.body_height + request.mount_offset.z();
  if (height <= 0.0) {
    throw std::invalid_argument(fmt::format(
        "--mount: the sensor would be {:.2f} m under the ground; the robot's body is {:.2f} m high",
        -height, gait.body_height));
  }
  if (request.robot_body && gait.name == "handheld") {
    throw std::invalid_argument("--body: a sensor in somebody's hand stands on no robot");
  }
}

}  // namespace

simulation::GaitModel gait_of(const RecordingRequest& request, const simulation::Scene& scene) {
  simulation::GaitModel gait =
      simulation::gait_model(request.robot.empty() ? scene.robot : request.robot);
  if (request.speed > 0.0 && gait.speed == 0.0) {
    throw std::invalid_argument("--speed: the robot '" + gait.name + "' does not walk");
  }
  if (request.speed > 0.0) gait.speed = request.speed;
  return scaled(std::move(gait), request.gait_scale);
}

Pose mount_of(const RecordingRequest& request) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  return {from_roll_pitch_yaw(kDegree * request.mount_tilt_deg), request.mount_offset};
}

std::uint64_t scans_in(double duration, const RecordingRequest& request) {
  const double turn = 1e-9 * simulation::lidar_model(request.lidar).turn_ns;
  return static_cast<std::uint64_t>(std::ceil(duration / turn - 1e-9));
}

simulation::ScannerOptions scanner_options_of(const RecordingRequest& request) {
  simulation::ScannerOptions options;
  options.seed = request.seed;
  options.footprint = request.footprint;
  options.dual_return = request.dual_return;
  options.robot_body = request.robot_body;
  options.air = request.air;
  return options;
}

simulation::Scene scene_of(const RecordingRequest& request) {
  if (simulation::is_mesh_file(request.scene)) {
    if (request.layout) {
      throw std::invalid_argument("--layout: " + request.scene +
                                  " is as it is; only scenes of --list have layouts");
    }
    return simulation::mesh_scene(request.scene, request.route_file);
  }
  simulation::Scene scene =
      simulation::build_scene(request.scene, {request.layout.value_or(request.seed), request.seed});
  if (!request.route_file.empty()) scene.route = simulation::read_route(request.route_file);
  return scene;
}

std::uint64_t make_recording(const RecordingRequest& request, const std::filesystem::path& folder,
                             const std::function<bool(std::uint64_t done)>& on_scan) {
  const simulation::LidarModel lidar = simulation::lidar_model(request.lidar);
  if (request.format.pcap && request.lidar != "vlp16") {
    throw std::invalid_argument("pcap holds VLP-16 packets; for '" + request.lidar +
                                "' use --format pcd");
  }
  const simulation::Scene scene = scene_of(request);
  const simulation::GaitModel gait = gait_of(request, scene);
  require_place_for_sensor(request, gait);
  simulation::RayCaster rays(scene);
  // One turn more than is scanned: the last scan's last firing lies beyond its nominal end.
  const double duration = 1e-9 * lidar.turn_ns * static_cast<double>(request.scans + 1);
  const simulation::Motion motion =
      simulation::make_motion(scene, rays, gait, duration, request.seed, mount_of(request));
  for (const simulation::MovingObject& person :
       simulation::make_companions(request.people, scene, rays, gait, duration, request.seed)) {
    rays.add(person);
  }
  simulation::Scanner scanner(rays, lidar, motion, scanner_options_of(request));

  const RecordingFolder place(folder, request.overwrite);
  const auto write_scene = [&](std::uint64_t scans) {
    io::write_whole_file(folder / kSceneFile,
                         scene_json(request, scene, gait, lidar, scanner.options(), scans));
  };
  write_scene(0);  // first: whatever ends the simulation, the folder is known for one of it
  RecordingWriter writer(folder, request.format, scanner.options());
  std::uint64_t done = 0;
  while (done < request.scans) {
    writer.write(scanner.scan(done));
    ++done;
    if (!on_scan(done)) break;
  }
  writer.finish(true_trajectory(scanner, done));
  write_scene(done);
  return done;
}

}  // namespace surefoot::recordings
