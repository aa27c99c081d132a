// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot simulate: one recording of a robot walking through a scene, with exact truth.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>

#include "recording_writer.hpp"
#include "report/canvas.hpp"
#include "simulation/body_motion.hpp"
#include "simulation/lidar_model.hpp"
#include "simulation/scanner.hpp"
#include "simulation/scene_picture.hpp"

namespace surefoot::app {

namespace {

struct SimulateArguments {
  std::string scene;
  std::string robot;
  std::string lidar = "vlp16";
  std::string output;
  std::string picture;
  std::uint64_t seed = 1;
  std::uint64_t scans = 600;
  double gait_scale = 1.0;
  bool list = false;
  bool no_footprint = false;
  bool true_points = false;
  bool body = false;
  bool dual = false;
};

void list_scenes() {
  for (const simulation::SceneEntry& entry : simulation::scene_catalogue()) {
    fmt::print("{:<12} {}\n", entry.name, entry.description);
  }
}

void draw_picture(const SimulateArguments& arguments) {
  constexpr int kWidth = 720;
  const simulation::Scene scene = simulation::build_scene(arguments.scene, arguments.seed);
  const simulation::RayCaster rays(scene);
  simulation::SceneImage image = simulation::render_scene(scene, rays, kWidth);
  report::Canvas canvas(image.width, image.height, report::PageFormat::kPng);
  const report::Rect page{0.0, 0.0, static_cast<double>(image.width),
                          static_cast<double>(image.height)};
  canvas.image({image.width, image.height, std::move(image.argb)}, page);
  canvas.save(arguments.picture);
}

void run(const SimulateArguments& arguments) {
  using namespace simulation;
  const Scene scene = build_scene(arguments.scene, arguments.seed);
  RayCaster rays(scene);
  const LidarModel lidar = lidar_model(arguments.lidar);
  const GaitModel gait = scaled(gait_model(arguments.robot.empty() ? scene.robot : arguments.robot),
                                arguments.gait_scale);
  const Pose mount{Eigen::Quaterniond::Identity(), {0.1, 0.0, 0.16}};
  const double duration = 1e-9 * lidar.turn_ns * static_cast<double>(arguments.scans + 1);
  const Motion motion = make_motion(scene, rays, gait, duration, arguments.seed, mount);
  ScannerOptions options;
  options.seed = arguments.seed;
  options.footprint = !arguments.no_footprint;
  options.robot_body = arguments.body;
  options.dual_return = arguments.dual;
  Scanner scanner(rays, lidar, motion, options);

  RecordingWriter writer(arguments.output);
  const auto begin = std::chrono::steady_clock::now();
  const bool terminal = isatty(STDERR_FILENO) != 0;
  for (std::uint64_t index = 0; index < arguments.scans; ++index) {
    const SimulatedScan scan = scanner.scan(index);
    writer.write_scan(scan);
    if (arguments.true_points) writer.write_true_points(scan);
    if (terminal && index % 10 == 0) {
      fmt::print(stderr, "\r{}: scan {} of {}", scene.name, index, arguments.scans);
    }
  }
  writer.finish(true_trajectory(scanner, arguments.scans));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  fmt::print(stderr, "{}{}: {} scans in {:.1f} s ({:.1f} scans/s) to {}\n", terminal ? "\r" : "",
             scene.name, arguments.scans, seconds, static_cast<double>(arguments.scans) / seconds,
             arguments.output);
}

}  // namespace

void add_simulate_command(CLI::App& app, int& exit_code) {
  (void)exit_code;
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command = app.add_subcommand("simulate", "Make a recording with exact truth");
  command->add_option("scene", arguments->scene, "Scene; --list shows them");
  command->add_flag("--list", arguments->list, "Show the scenes and stop");
  command->add_option("--robot", arguments->robot, "How it moves; absent: what suits the scene")
      ->check(CLI::IsMember(simulation::gait_names()));
  command->add_option("--lidar", arguments->lidar, "Sensor")
      ->check(CLI::IsMember(simulation::lidar_names()));
  command->add_option("--scans", arguments->scans, "Number of scans")->check(CLI::Range(1, 100000));
  command->add_option("--seed", arguments->seed, "Same seed, same bytes");
  command->add_option("--gait-scale", arguments->gait_scale, "All gait amplitudes times this")
      ->check(CLI::Range(0.0, 10.0));
  command->add_flag("--no-footprint", arguments->no_footprint, "One ray a beam: faster");
  command->add_flag("--true-points", arguments->true_points,
                    "Write every point's exact position in the map, too");
  command->add_flag("--body", arguments->body, "The robot's own body is in view");
  command->add_flag("--dual", arguments->dual, "Strongest and last return");
  command->add_option("--picture", arguments->picture, "Draw the scene to this PNG file and stop");
  command->add_option("-o,--output", arguments->output, "Folder to write to");
  command->callback([arguments] {
    if (arguments->list) return list_scenes();
    if (arguments->scene.empty()) throw CLI::RequiredError("SCENE (or --list)");
    if (!arguments->picture.empty()) return draw_picture(*arguments);
    if (arguments->output.empty()) throw CLI::RequiredError("-o OUT");
    run(*arguments);
  });
}

}  // namespace surefoot::app
