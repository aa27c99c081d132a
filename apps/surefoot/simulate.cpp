// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot simulate: one recording of a robot walking through a scene, with exact truth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "io/counted.hpp"
#include "io/file_writer.hpp"
#include "process/exit_codes.hpp"
#include "process/interrupt.hpp"
#include "process/progress.hpp"
#include "recordings/recording_maker.hpp"
#ifdef SUREFOOT_HAS_PICTURES
#include "recordings/animation.hpp"
#include "recordings/scene_drawing.hpp"
#include "report/picture_mark.hpp"
#endif

namespace surefoot::app {

namespace {

using recordings::kMostScans;

CLI::Validator within(const io::NumberRange& range) {
  return command_line::number_within(range.low, range.high);
}

struct SimulateArguments {
  recordings::RecordingRequest request;
  double duration = 0.0;
  std::string output;
  std::string picture;
  std::string animation;
  bool list = false;
  bool quiet = false;
};

void list_scenes() {
  for (const simulation::SceneEntry& entry : simulation::scene_catalogue()) {
    fmt::print("{:<12} {}\n", entry.name, entry.description);
  }
  fmt::print("{:<12} {}\n", "FILE", "your own mesh or heightfield: .ply, .obj, .asc");
}

/// What is drawn instead of a recording made; false where nothing is asked for.
bool draw([[maybe_unused]] const SimulateArguments& arguments) {
  if (arguments.picture.empty() && arguments.animation.empty()) return false;
#ifdef SUREFOOT_HAS_PICTURES
  io::require_ending(arguments.picture, {".png"});
  io::require_ending(arguments.animation, {".png"});
  for (const std::string& file : {arguments.picture, arguments.animation}) {
    if (file.empty()) continue;
    report::require_picture_or_nothing(file, report::PictureKind::scene,
                                       arguments.request.overwrite);
  }
  if (!arguments.picture.empty()) recordings::draw_scene(arguments.request, arguments.picture);
  if (!arguments.animation.empty()) {
    recordings::draw_animation(arguments.request, arguments.animation);
  }
  return true;
#else
  throw std::runtime_error("--picture, --animation: this program was built without pictures");
#endif
}

void simulate(const SimulateArguments& arguments, int& exit_code) {
  const recordings::RecordingRequest& request = arguments.request;
  const auto begin = std::chrono::steady_clock::now();
  const process::InterruptGuard guard;
  process::Progress progress("scans", arguments.quiet);
  const std::uint64_t done =
      recordings::make_recording(request, arguments.output, [&](std::uint64_t scans) {
        progress.update(scans, static_cast<double>(scans) / static_cast<double>(request.scans));
        return !guard.interrupted();
      });
  progress.finish();
  const bool is_whole = done == request.scans;
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!arguments.quiet) {
    fmt::print(stderr, "{}: {}{} in {:.1f} s to {}\n", request.scene,
               is_whole ? "" : "interrupted, ", io::counted(done, "scan"), seconds,
               arguments.output);
  }
  if (!is_whole) exit_code = process::kInterrupted;
}

void add_motion_options(CLI::App& command, SimulateArguments& arguments) {
  recordings::RecordingRequest& request = arguments.request;
  command.add_option("--robot", request.robot, "How it moves; absent: what suits the scene")
      ->check(CLI::IsMember(simulation::gait_names()));
  command.add_option("--speed", request.speed, "Walking speed [m/s]; absent: the robot's own")
      ->check(within(recordings::kSpeeds));
  command.add_option("--gait-scale", request.gait_scale, "All gait amplitudes times this")
      ->check(within(recordings::kGaitScales))
      ->capture_default_str();
  command.add_option("--route", request.route_file,
                     "Instead of the scene's own way: corners of a closed one, 'x y z' a line [m]");
}

void add_sensor_options(CLI::App& command, SimulateArguments& arguments) {
  recordings::RecordingRequest& request = arguments.request;
  command.add_option("--lidar", request.lidar, "Sensor")
      ->check(CLI::IsMember(simulation::lidar_names()))
      ->capture_default_str();
  const auto vector = [&](const char* flag, Eigen::Vector3d& value, double most, const char* help) {
    command
        .add_option_function<std::vector<double>>(
            flag,
            [&value](const std::vector<double>& xyz) { value = Eigen::Vector3d::Map(xyz.data()); },
            help)
        ->expected(3)
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(command_line::number_within(-most, most));
  };
  vector("--mount", request.mount_offset, 5.0, "LiDAR in the body's frame: x y z [m]");
  vector("--tilt", request.mount_tilt_deg, 180.0, "LiDAR's roll pitch yaw on the body [deg]");
  command.add_flag("--dual", request.dual_return, "Two returns: the strongest and the last");
  command.add_flag("--body", request.robot_body, "The robot's own body is in view");
  const auto share = [&](const char* flag, double& value, const char* help) {
    command.add_option(flag, value, help)
        ->check(within(recordings::kAirShares))
        ->capture_default_str();
  };
  share("--rain", request.air.rain, "Share of the beams that end in a drop");
  share("--dust", request.air.dust, "Share of the beams that end in a cloud of dust");
  command.add_option("--people", request.people, "Who go with the robot and stop in front of it")
      ->check(CLI::Range(0, recordings::kMostPeople))
      ->capture_default_str();
  command.add_flag_callback(
      "--no-footprint", [&request] { request.footprint = false; },
      "One ray a beam: faster, no mixed pixels");
}

void add_output_options(CLI::App& command, SimulateArguments& arguments) {
  recordings::RecordingRequest& request = arguments.request;
  auto* scans = command.add_option("--scans", request.scans, "Number of scans")
                    ->check(CLI::Range(1, kMostScans))
                    ->capture_default_str();
  command.add_option("--duration", arguments.duration, "Length of the recording [s]")
      ->check(command_line::number_within(0.1, 0.1 * kMostScans))
      ->excludes(scans);
  command.add_option("--seed", request.seed, "Same seed, same bytes")
      ->check(command_line::whole_number(0))
      ->capture_default_str();
  command
      .add_option(
          "--layout", request.layout,
          "Buildings, ground, ramps, stairs, route; absent: the seed. 1: as without layouts")
      ->check(command_line::whole_number(0));
  command
      .add_option_function<std::vector<std::string>>(
          "--format",
          [&request](const std::vector<std::string>& names) { request.format.choose(names); },
          "pcd, pcap (VLP-16 packets), mcap, rosbag2 (both ROS 2), or several with commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember({"pcd", "pcap", "mcap", "rosbag2"}));
  command.add_flag("--true-points", request.format.true_points,
                   "Every point's exact position in the map, too");
  command.add_flag("-q,--quiet", arguments.quiet, "Say nothing");
  command.add_option("-o,--output", arguments.output, "Folder to write to");
  command.add_flag("--overwrite", request.overwrite,
                   "Write also where scans or pictures lie that no simulation has left");
}

}  // namespace

void add_simulate_command(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command = app.add_subcommand("simulate", "Make a recording with exact truth");
  command->add_option("scene", arguments->request.scene,
                      "Scene (--list shows them) or a file: .ply, .obj, .asc");
  command->add_flag("--list", arguments->list, "Show the scenes and stop");
  command->add_option("--picture", arguments->picture, "Draw the scene to this PNG file and stop");
  command->add_option("--animation", arguments->animation,
                      "Draw scan and gait to this animated PNG file and stop");
  add_motion_options(*command, *arguments);
  add_sensor_options(*command, *arguments);
  add_output_options(*command, *arguments);
  command->callback([arguments, &exit_code] {
    if (arguments->list) return list_scenes();
    if (arguments->request.scene.empty()) throw CLI::RequiredError("SCENE (or --list)");
    recordings::RecordingRequest& request = arguments->request;
    if (arguments->duration > 0.0) {
      request.scans = recordings::scans_in(arguments->duration, request);
    }
    if (draw(*arguments)) return;
    if (arguments->output.empty()) throw CLI::RequiredError("-o OUT");
    simulate(*arguments, exit_code);
  });
}

}  // namespace surefoot::app
