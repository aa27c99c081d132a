// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "recordings/animation_panels.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "recordings/robot_drawing.hpp"
#include "report/color_map.hpp"
#include "report/plot.hpp"

namespace surefoot::recordings {

namespace {

using report::Canvas;
using report::Color;
using report::Pixel;
using report::Rect;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr Color kPaper{0.055, 0.070, 0.100};
constexpr Color kFrame{0.20, 0.24, 0.31};
constexpr Color kText{0.88, 0.91, 0.95};
constexpr Color kFaint{0.52, 0.58, 0.67};
constexpr Color kBright{1.00, 0.42, 0.36};
constexpr Color kBeam{1.00, 0.55, 0.40};

constexpr double kSceneMetres = 19.0;   // across the scene's panel
constexpr double kRobotMetres = 1.15;   // across the robot's panel
constexpr double kExaggeration = 4.0;   // of the gait in the robot's panel
constexpr double kBeamsShown = 0.0012;  // firings of the last while are drawn as beams [s]

std::uint32_t argb_of(const Color& color) {
  const auto channel = [](double value) {
    return static_cast<std::uint32_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
  };
  return 0xff000000U | (channel(color.red) << 16) | (channel(color.green) << 8) |
         channel(color.blue);
}

/// The scene at night, so that points shine: dim and nearly grey.
std::uint32_t dimmed(std::uint32_t argb) {
  if (argb == simulation::kSky) return argb_of(kPaper);
  const double red = (argb >> 16) & 0xffU, green = (argb >> 8) & 0xffU, blue = argb & 0xffU;
  const double grey = 0.3 * red + 0.6 * green + 0.1 * blue;
  const auto dim = [&](double channel) { return (0.6 * grey + 0.4 * channel) / 255.0 * 0.34; };
  return argb_of({dim(red) + 0.01, dim(green) + 0.02, dim(blue) + 0.05});
}

Pose T_body_lidar_of(const simulation::Motion& motion, double time) {
  return motion.T_map_body(time).inverse() * motion.T_map_lidar(time);
}

Pose pose_of(const simulation::PoseAngles& angles) {
  return {from_roll_pitch_yaw(angles.tail<3>()), angles.head<3>()};
}

}  // namespace

simulation::PoseAngles WalkShown::resting(double time) const {
  constexpr double kSpan = 0.4;  // about a stride [s]
  constexpr int kSamples = 41;
  simulation::PoseAngles sum = simulation::PoseAngles::Zero();
  for (int i = 0; i < kSamples; ++i) {
    sum += motion.body_angles(time + kSpan * (static_cast<double>(i) / (kSamples - 1) - 0.5));
  }
  return sum / kSamples;
}

void append_points(const simulation::SimulatedScan& scan, const simulation::ScannerOptions& options,
                   std::vector<SeenPoint>& points) {
  for (std::size_t i = 0; i < scan.true_points.size(); ++i) {
    const auto stamp = static_cast<double>(scan.scan.stamp_ns - options.start_ns);
    points.push_back({1e-9 * (stamp + scan.scan.times_ns[i]), scan.true_points[i]});
  }
}

ScenePanel::ScenePanel(const simulation::Scene& scene, const simulation::RayCaster& rays,
                       const WalkShown& walk, std::vector<SeenPoint> points, const Rect& rect)
    : walk_(&walk),
      rect_(rect),
      view_(scene, walk.resting(0.5 * (walk.begin + walk.end)).head<3>(), kSceneMetres,
            static_cast<int>(rect.width), static_cast<int>(rect.height)) {
  simulation::SceneImage image = simulation::render_view(view_, rays);
  std::transform(image.argb.begin(), image.argb.end(), image.argb.begin(), dimmed);
  background_ = {image.width, image.height, std::move(image.argb)};

  std::vector<Eigen::Vector3d> places;
  for (const SeenPoint& point : points) places.push_back(point.place);
  const std::vector<bool> visible = view_.visible(places, rays);
  const double ground = walk.resting(walk.begin)(2) - 0.4;
  constexpr double kHeights = 4.0;  // over which the colour changes [m]
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Pixel at = view_.pixel(places[i]);
    const bool inside =
        at.x() >= 0.0 && at.y() >= 0.0 && at.x() < rect.width - 1.0 && at.y() < rect.height - 1.0;
    if (!visible[i] || !inside) continue;
    const double height = std::clamp((places[i].z() - ground) / kHeights, 0.0, 1.0);
    dots_.push_back({points[i].time, at, argb_of(report::viridis(0.42 + 0.58 * height))});
  }
}

void ScenePanel::draw(Canvas& canvas, double time, const std::string& title) const {
  const auto after = [](double value, const Dot& dot) { return value < dot.time; };
  const auto first = std::upper_bound(dots_.begin(), dots_.end(), time - walk_->turn, after);
  const auto last = std::upper_bound(dots_.begin(), dots_.end(), time, after);
  report::Raster picture = background_;
  const auto width = static_cast<std::size_t>(picture.width);
  for (auto dot = first; dot != last; ++dot) {
    const auto corner =
        static_cast<std::size_t>(dot->at.y()) * width + static_cast<std::size_t>(dot->at.x());
    for (const std::size_t pixel : {corner, corner + 1, corner + width, corner + width + 1}) {
      picture.argb[pixel] = dot->argb;
    }
  }
  canvas.clip(rect_);
  canvas.image(picture, rect_);
  const Pixel corner(rect_.x, rect_.y);
  const Pose T_map_lidar = walk_->motion.T_map_lidar(time);
  const Pixel sensor = view_.pixel(T_map_lidar.translation) + corner;
  const auto beams = std::upper_bound(dots_.begin(), dots_.end(), time - kBeamsShown, after);
  for (auto dot = beams; dot != last; ++dot) {
    const std::array<Pixel, 2> beam = {sensor, dot->at + corner};
    canvas.line(beam, {kBeam.with_alpha(0.10), 1.0});
  }
  const Pose T_map_body = walk_->motion.T_map_body(time);
  draw_robot(
      canvas, [&](const Eigen::Vector3d& point) -> Pixel { return view_.pixel(point) + corner; },
      T_map_body, T_body_lidar_of(walk_->motion, time), walk_->legs.at(time, T_map_body),
      rect_.width / kSceneMetres);
  canvas.text(title, {rect_.x + 14.0, rect_.y + 26.0}, {16.0, kText, {}, true});
  canvas.text(fmt::format("{:.2f} s, ten times slower", time), {rect_.x + 14.0, rect_.y + 46.0},
              {12.0, kText});
  canvas.unclip();
}

RobotPanel::RobotPanel(const simulation::RayCaster& rays, const WalkShown& walk, const Rect& rect)
    : rays_(&rays), walk_(&walk), rect_(rect) {
  constexpr double kElevation = 14.0 * kDegree;
  const simulation::PoseAngles start = walk.resting(walk.begin);
  const double heading = start(simulation::kYaw);
  // Seen from the right, somewhat from ahead.
  const double viewer = heading - 65.0 * kDegree;
  const Eigen::Vector3d forward(-std::cos(kElevation) * std::cos(viewer),
                                -std::cos(kElevation) * std::sin(viewer), -std::sin(kElevation));
  right_ = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  up_ = right_.cross(forward);
  ahead_ = {std::cos(heading), std::sin(heading), 0.0};
  origin_ = start.head<3>();
}

Pixel RobotPanel::pixel(const Eigen::Vector3d& point, const Eigen::Vector3d& center) const {
  const double metre = rect_.width / kRobotMetres;
  const Eigen::Vector3d from = point - center;
  return rect_.center() + Pixel(metre * right_.dot(from), -metre * up_.dot(from));
}

void RobotPanel::draw_ground(Canvas& canvas, const Eigen::Vector3d& center) const {
  constexpr double kMarkStep = 0.25;
  constexpr double kHalfTrack = 0.32;
  constexpr double kDepth = 1.5;
  const Eigen::Vector3d aside(-ahead_.y(), ahead_.x(), 0.0);
  const double walked = ahead_.dot(center - origin_);
  std::array<std::vector<Pixel>, 2> borders;
  for (int i = -4; i <= 4; ++i) {
    const double along = kMarkStep * (std::floor(walked / kMarkStep) + i);
    std::vector<Pixel> mark;
    for (std::size_t side = 0; side < borders.size(); ++side) {
      Eigen::Vector3d place =
          center + (along - walked) * ahead_ + (side == 0 ? kHalfTrack : -kHalfTrack) * aside;
      place.z() = rays_->ground_below(place, kDepth).value_or(center.z() - 0.3);
      mark.push_back(pixel(place, center));
      borders[side].push_back(mark.back());
    }
    canvas.line(mark, {kFrame, 1.0});
  }
  for (const std::vector<Pixel>& border : borders) canvas.line(border, {kFrame, 1.0});
}

void RobotPanel::draw(Canvas& canvas, double time) const {
  canvas.fill(rect_, kPaper);
  canvas.clip(rect_);
  const simulation::PoseAngles resting = walk_->resting(time);
  const simulation::PoseAngles now = walk_->motion.body_angles(time);
  const Pose shown = pose_of(resting + kExaggeration * (now - resting));
  const Eigen::Vector3d center = resting.head<3>() - 0.08 * Eigen::Vector3d::UnitZ();
  draw_ground(canvas, center);
  draw_robot(
      canvas, [&](const Eigen::Vector3d& point) { return pixel(point, center); }, shown,
      T_body_lidar_of(walk_->motion, time), walk_->legs.at(time, shown),
      rect_.width / kRobotMetres);
  canvas.text(fmt::format("motion of the gait x {:.0f}", kExaggeration),
              {rect_.x + 12.0, rect_.y + 20.0}, {11.0, kFaint});
  canvas.unclip();
}

GaitPanel::GaitPanel(const WalkShown& walk, const Rect& rect) : walk_(&walk), rect_(rect) {
  constexpr int kSamples = 220;
  for (int i = 0; i <= kSamples; ++i) {
    const double time = walk.begin + (walk.end - walk.begin) * i / kSamples;
    const simulation::PoseAngles off = walk.motion.body_angles(time) - walk.resting(time);
    values_.push_back({100.0 * off(simulation::kBounce), off(simulation::kRoll) / kDegree,
                       off(simulation::kPitch) / kDegree});
  }
}

void GaitPanel::draw(Canvas& canvas, double time) const {
  constexpr std::array<const char*, 3> kNames = {"height [cm]", "roll [deg]", "pitch [deg]"};
  constexpr double kLabel = 16.0;
  canvas.fill(rect_, kPaper);
  const double row_height = (rect_.height - 8.0) / kNames.size();
  const double done = (time - walk_->begin) / (walk_->end - walk_->begin);
  const auto count = static_cast<double>(values_.size() - 1);
  for (std::size_t row = 0; row < kNames.size(); ++row) {
    double largest = 0.5;
    for (const auto& value : values_) largest = std::max(largest, std::abs(value[row]));
    const Rect area{rect_.x + 12.0, rect_.y + row_height * static_cast<double>(row) + kLabel,
                    rect_.width - 26.0, row_height - kLabel - 4.0};
    const report::PlotArea plot{area, {0.0, 1.0}, {-largest, largest}};
    std::vector<Pixel> curve;
    for (std::size_t i = 0; i < values_.size(); ++i) {
      curve.push_back(plot.at(static_cast<double>(i) / count, values_[i][row]));
    }
    const std::array<Pixel, 2> zero = {plot.at(0.0, 0.0), plot.at(1.0, 0.0)};
    canvas.line(zero, {kFrame, 1.0});
    canvas.line(curve, {kFaint.with_alpha(0.55), 1.2});
    const auto now = static_cast<std::size_t>(std::lround(std::clamp(done, 0.0, 1.0) * count));
    canvas.line({curve.data(), now + 1}, {kBright, 1.8});
    canvas.circle(curve[now], 3.2, kBright, {kPaper, 1.0});
    canvas.text(kNames[row], {area.x, area.y - 3.0}, {11.0, kText});
    canvas.text(fmt::format("{:+.1f}", values_[now][row]), {area.right(), area.y - 3.0},
                {11.0, kText, report::Anchor::right});
  }
  const std::array<Pixel, 2> border = {Pixel(rect_.x, rect_.y), Pixel(rect_.right(), rect_.y)};
  canvas.line(border, {kFrame, 1.0});
}

}  // namespace surefoot::recordings
