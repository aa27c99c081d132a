// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/whole_way.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/deskew.hpp"
#include "methods/knots/knot_points.hpp"
#include "methods/knots/knot_prediction.hpp"
#include "methods/knots/segment_sum.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// Solutions on one map; each moves the knots by a tenth of the one before, or less.
constexpr int kSteps = 3;

// Of a voxel: of more, sums in single precision lose what another one adds.
constexpr int kMostPoints = 1'000'000;

/// What is frozen and holds all of the way need not be mistrusted as what one scan is added to:
/// voxels are hardly ever full, and residuals count in full, or the knots would be held back.
Config::Knots config_of_all(Config::Knots config) {
  config.points_per_voxel = kMostPoints;
  config.independence = 1.0;
  return config;
}

/// The knots of a scan that goes on where the last one ended, or begins a chain of its own.
KnotWindow window_of(const PreparedScan& scan, const ScanTrajectory& trajectory,
                     const KnotWindow* last, int usual) {
  KnotWindow window;
  window.begin_ns = last ? last->end_ns : std::min(scan.start_ns, scan.end_ns - kInstantNs);
  window.end_ns = scan.end_ns;
  const double span = seconds(window.end_ns - window.begin_ns);
  const int segments = segments_over(span, scan, usual);
  window.step = window.first_step = span / segments;
  const auto at = [&](int k) {
    return trajectory.at_time(window.begin_ns + std::llround(1e9 * window.step * k));
  };
  if (last) {
    const std::size_t end = last->knots.size() - 1;
    window.first_step = last->duration(end - 1);
    window.knots = {last->knots[end - 1], last->knots[end]};
  } else {
    window.knots = {at(-1), at(0)};
  }
  for (int k = 1; k <= segments; ++k) window.knots.push_back(at(k));
  return window;
}

}  // namespace

WholeWay::WholeWay(const Session& session)
    : session_(session),
      config_(config_of_all(session.config.knots)),
      map_(config_, std::numeric_limits<double>::max()) {}

bool WholeWay::add(PreparedScan scan, const Estimate& estimate) {
  const WayScan* const last = scans_.empty() ? nullptr : &scans_.back();
  const double longest = session_.config.motion_prior.max_extrapolation;
  const bool goes_on = last && seconds(scan.start_ns - last->window.end_ns) <= longest;
  if (last && seconds(scan.end_ns - last->window.end_ns) < usual_step(scan, config_.segments)) {
    return false;
  }
  KnotWindow window =
      window_of(scan, estimate.trajectory, goes_on ? &last->window : nullptr, config_.segments);
  const std::size_t first = knots() - (goes_on ? 2 : 0);
  scans_.push_back(
      {std::move(scan), std::move(window), first, VelocityModel(config_), estimate.covariance});
  return true;
}

std::size_t WholeWay::knots() const {
  return scans_.empty() ? 0 : scans_.back().first + scans_.back().window.knots.size();
}

ScanTrajectory WholeWay::trajectory(std::size_t scan) const {
  const WayScan& way = scans_[scan];
  return way.window.trajectory(way.scan.start_ns, way.scan.end_ns);
}

bool WholeWay::refine() {
  if (scans_.empty()) return false;
  const Pose T_map_first = trajectory(0).at(0.5);
  std::vector<std::vector<Pose>> before;
  for (const WayScan& way : scans_) before.push_back(way.window.knots);
  map_all();
  for (int t = 1; t <= kSteps; ++t) {
    const std::vector<Equations> equations = all_equations();
    BandedSystem system(knots());
    for (std::size_t s = 0; s < scans_.size(); ++s) {
      system.add_at(scans_[s].first, equations[s].system);
    }
    if (!system.factorise() || !move(system.solve())) {
      for (std::size_t s = 0; s < scans_.size(); ++s) scans_[s].window.knots = before[s];
      return false;
    }
    if (t == kSteps) learn(equations, system.covariance());
  }
  anchor(T_map_first);
  return true;
}

/// In the order in which they were seen: what later beams went through is not in it.
void WholeWay::map_all() {
  map_.clear();
  for (std::size_t s = 0; s < scans_.size(); ++s) {
    const ScanTrajectory motion = trajectory(s);
    const Pose middle = motion.at(0.5);
    std::vector<Eigen::Vector3d> points;
    points.reserve(scans_[s].scan.points.size());
    for (const Eigen::Vector3f& point : deskew(scans_[s].scan, motion, session_.workers)) {
      points.push_back(middle * point.cast<double>());
    }
    map_.insert({middle.translation, std::move(points)}, session_.workers);
  }
}

WholeWay::Equations WholeWay::equations_of(const WayScan& way) const {
  const Look look{1.0, 0, 1, false};
  std::vector<std::uint32_t> all(way.scan.points.size());
  std::iota(all.begin(), all.end(), 0U);
  KnotPoints points = sort_points(way.scan, all, way.window);
  const KnotWindow& window = way.window;
  Equations equations{BandedSystem(window.knots.size())};
  BandedSystem& system = equations.system;
  for (std::size_t k = 0; k < window.segments(); ++k) {
    const SegmentSums sums = sum_segment(points, k, map_, window, look, config_).surfels;
    system.add(k + 1, k + 1, sums.first);
    system.add(k + 2, k + 1, sums.between);
    system.add(k + 2, k + 2, sums.last);
    system.add(k + 1, sums.first_gradient);
    system.add(k + 2, sums.last_gradient);
    equations.squares += sums.weighted_squares;
    equations.count += sums.count;
  }
  way.model.add_to(system, window, window.knots[1].rotation);
  return equations;
}

std::vector<WholeWay::Equations> WholeWay::all_equations() const {
  std::vector<Equations> equations(scans_.size(), Equations{BandedSystem(0)});
  session_.workers.for_each(scans_.size(),
                            [&](std::size_t s) { equations[s] = equations_of(scans_[s]); });
  return equations;
}

/// Returns whether a robot can have moved so; else nothing is moved.
bool WholeWay::move(const std::vector<Twist>& steps) {
  constexpr double kImpossible = 1.0;  // [m, rad] within one step of what is nearly there
  for (const Twist& step : steps) {
    if (!step.allFinite() || step.cwiseAbs().maxCoeff() > kImpossible) return false;
  }
  for (WayScan& way : scans_) {
    for (std::size_t k = 0; k < way.window.knots.size(); ++k) {
      way.window.knots[k] = displaced(way.window.knots[k], steps[way.first + k]);
    }
  }
  return true;
}

void WholeWay::anchor(const Pose& T_map_first) {
  const Pose T_new_old = T_map_first * trajectory(0).at(0.5).inverse();
  for (WayScan& way : scans_) {
    for (Pose& knot : way.window.knots) knot = T_new_old * knot;
  }
}

/// The velocity's fluctuation, scan after scan, and how well each middle is known.
void WholeWay::learn(const std::vector<Equations>& equations,
                     const BandedSystem::Covariance& of_all) {
  VelocityModel model = scans_.front().model;
  for (std::size_t s = 0; s < scans_.size(); ++s) {
    WayScan& way = scans_[s];
    const BandedSystem::Covariance covariance = of_all.part(way.first, way.window.knots.size());
    model.learn(way.window, covariance, way.window.knots[1].rotation);
    way.model = model;
    const std::int64_t mid_ns = way.scan.mid_ns();
    const double variance = equations[s].squares / std::max(equations[s].count, 1);
    way.covariance = variance * covariance.at(way.window.place_of(mid_ns));
  }
}

}  // namespace surefoot
