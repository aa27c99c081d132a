// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The three panels of an animation: the scene with the scan, the robot near by, its motion in time.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "report/canvas.hpp"
#include "simulation/leg_sketch.hpp"
#include "simulation/scanner.hpp"
#include "simulation/scene_picture.hpp"

namespace surefoot::recordings {

/// What the panels show, from `begin` to `end` [s].
struct WalkShown {
  const simulation::Motion& motion;
  simulation::LegSketch legs;
  double begin;
  double end;
  double turn;  ///< of the LiDAR [s]

  /// The body's pose at an instant without what the gait does to it.
  [[nodiscard]] simulation::PoseAngles resting(double time) const;
};

/// One measured point.
struct SeenPoint {
  double time = 0.0;      ///< [s]
  Eigen::Vector3d place;  ///< map frame
};
/// Appends the points of a scan, ordered in time.
void append_points(const simulation::SimulatedScan& scan, const simulation::ScannerOptions& options,
                   std::vector<SeenPoint>& points);

/// The scene from above; what one turn of the LiDAR met, and the beams of the moment.
class ScenePanel {
 public:
  /// @param points ordered in time.
  ScenePanel(const simulation::Scene& scene, const simulation::RayCaster& rays,
             const WalkShown& walk, std::vector<SeenPoint> points, const report::Rect& rect);
  void draw(report::Canvas& canvas, double time, const std::string& title) const;

 private:
  struct Dot {
    double time = 0.0;
    report::Pixel at;
    std::uint32_t argb = 0;
  };

  const WalkShown* walk_;
  report::Rect rect_;
  simulation::SceneView view_;
  report::Raster background_;
  std::vector<Dot> dots_;  ///< those in view, ordered in time
};

/// The robot near by, its gait exaggerated.
class RobotPanel {
 public:
  RobotPanel(const simulation::RayCaster& rays, const WalkShown& walk, const report::Rect& rect);
  void draw(report::Canvas& canvas, double time) const;

 private:
  void draw_ground(report::Canvas& canvas, const Eigen::Vector3d& below) const;
  [[nodiscard]] report::Pixel pixel(const Eigen::Vector3d& point,
                                    const Eigen::Vector3d& center) const;

  const simulation::RayCaster* rays_;
  const WalkShown* walk_;
  report::Rect rect_;
  Eigen::Vector3d right_;
  Eigen::Vector3d up_;
  Eigen::Vector3d ahead_;
  Eigen::Vector3d origin_;
};

/// Height, roll and pitch against the resting pose.
class GaitPanel {
 public:
  GaitPanel(const WalkShown& walk, const report::Rect& rect);
  void draw(report::Canvas& canvas, double time) const;

 private:
  const WalkShown* walk_;
  report::Rect rect_;
  std::vector<std::array<double, 3>> values_;  ///< bounce [cm], roll, pitch [deg], evenly in time
};

}  // namespace surefoot::recordings
