// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recordings/animation.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "io/file_writer.hpp"
#include "recordings/animation_panels.hpp"
#include "report/animated_png.hpp"

namespace surefoot::recordings {

namespace {

constexpr double kBegin = 12.0;      // [s], when every robot walks
constexpr std::uint64_t kTurns = 4;  // a stride of the trot, so that the end meets the beginning
constexpr int kFramesPerTurn = 12;
constexpr double kSlowMotion = 10.0;
constexpr int kWidth = 800;
constexpr int kHeight = 450;

constexpr report::Rect kScenePanel{0.0, 0.0, 540.0, 450.0};
constexpr report::Rect kRobotPanel{540.0, 0.0, 260.0, 250.0};
constexpr report::Rect kGaitPanel{540.0, 250.0, 260.0, 200.0};

}  // namespace

void draw_animation(const RecordingRequest& request, const std::filesystem::path& file) {
  if (!io::has_ending(file, {".png"})) {
    throw std::invalid_argument("--animation: '" + file.string() +
                                "' is to be a PNG file: .png (PNG holds animations, too)");
  }
  const simulation::LidarModel lidar = simulation::lidar_model(request.lidar);
  const simulation::Scene scene = scene_of(request);
  const simulation::GaitModel gait = gait_of(request, scene);
  simulation::RayCaster rays(scene);
  const double turn = 1e-9 * lidar.turn_ns;
  const auto first = static_cast<std::uint64_t>(kBegin / turn);
  const double duration = turn * static_cast<double>(first + kTurns + 4);
  const simulation::Motion motion =
      make_motion(scene, rays, gait, duration, request.seed, mount_of(request));
  simulation::Scanner scanner(rays, lidar, motion, scanner_options_of(request));

  // The turn before the first one shown is on the picture from the start.
  const double begin = turn * static_cast<double>(first);
  const double end = begin + turn * static_cast<double>(kTurns);
  std::vector<SeenPoint> points;
  for (std::uint64_t index = first - 1; index < first + kTurns; ++index) {
    append_points(scanner.scan(index), scanner.options(), points);
  }
  rays.set_interval(begin, begin + turn);
  const WalkShown walk{motion, simulation::LegSketch(gait, motion, rays, request.seed), begin, end,
                       turn};
  const ScenePanel scene_panel(scene, rays, walk, std::move(points), kScenePanel);
  const RobotPanel robot_panel(rays, walk, kRobotPanel);
  const GaitPanel gait_panel(walk, kGaitPanel);

  const std::string title = fmt::format("{}, {}, {}", scene.name, gait.name, lidar.name);
  report::AnimatedPng animation(kWidth, kHeight);
  const int frames = static_cast<int>(kTurns) * kFramesPerTurn;
  const double step = turn / kFramesPerTurn;
  for (int frame = 1; frame <= frames; ++frame) {
    const double time = begin + step * frame;
    report::Canvas canvas(kWidth, kHeight, report::PageFormat::png);
    scene_panel.draw(canvas, time, title);
    robot_panel.draw(canvas, time);
    gait_panel.draw(canvas, time);
    animation.add(canvas.raster(), static_cast<std::uint16_t>(1000.0 * kSlowMotion * step));
  }
  animation.save(file);
}

}  // namespace surefoot::recordings
