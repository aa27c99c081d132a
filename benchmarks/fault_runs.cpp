// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "fault_runs.hpp"

#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "simulation/body_motion.hpp"
#include "simulation/gait.hpp"
#include "simulation/lidar_model.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::benchmarks {

namespace {

const Pose kMount{Eigen::Quaterniond::Identity(), {0.10, 0.0, 0.16}};  // T_body_lidar

/// A pose with what it should be.
struct Pair {
  Pose estimate, truth;
  int place = 0;
  int segment = 0;
};

MotionError error_between(const Pair& from, const Pair& to) {
  if (from.place != to.place) return {1e3, 180.0};
  return motion_error(from.estimate.inverse() * to.estimate, from.truth.inverse() * to.truth);
}

/// A pose that was called ok, and whether it was wrong.
struct Claimed {
  Pair pair;
  bool wrong = false;
};

/// What a pose is off by, against the one of ten scans before, or where that one was wrong itself,
/// against the newest right one before it if that is less: who comes back from where a pose went
/// wrong is right. `claimed`: one a scan, of those before.
std::optional<MotionError> error_of(const std::vector<std::optional<Claimed>>& claimed,
                                    const Pair& pair) {
  const Claimed* first = nullptr;  // of the segment
  const Claimed* last = nullptr;   // at least ten scans old
  const Claimed* right = nullptr;  // likewise, of those that were right
  for (std::size_t n = 0; n < claimed.size(); ++n) {
    if (!claimed[n] || claimed[n]->pair.segment != pair.segment) continue;
    if (first == nullptr) first = &*claimed[n];
    if (n + kWrongScans > claimed.size()) continue;
    last = &*claimed[n];
    if (!last->wrong) right = last;
  }
  if (first == nullptr) return std::nullopt;
  const MotionError error = error_between((last != nullptr ? last : first)->pair, pair);
  if (last == nullptr || !last->wrong || right == nullptr || !error.wrong()) return error;
  const MotionError since = error_between(right->pair, pair);
  return since.wrong() ? error : since;
}

}  // namespace

WalkSpec WalkSpec::parse(const std::string& text) {
  const std::size_t seed = text.find(':');
  const std::size_t robot = seed == std::string::npos ? seed : text.find(':', seed + 1);
  try {
    return {text.substr(0, seed), std::stoull(text.substr(seed + 1)),
            robot == std::string::npos ? "" : text.substr(robot + 1)};
  } catch (const std::exception&) {
    throw std::invalid_argument("'" + text + "': expected SCENE:SEED or SCENE:SEED:ROBOT");
  }
}

std::string WalkSpec::name() const {
  return scene + (robot.empty() ? "" : "-" + robot) + "-" + std::to_string(seed);
}

FaultWalk::FaultWalk(const WalkSpec& spec)
    : spec_(spec), scene_(simulation::build_scene(spec.scene, spec.seed)), rays_(scene_) {
  const simulation::LidarModel lidar = simulation::lidar_model("vlp16");
  const simulation::GaitModel gait =
      simulation::gait_model(spec.robot.empty() ? scene_.robot : spec.robot);
  const double duration = 1e-9 * lidar.turn_ns * static_cast<double>(simulation::kFaultReach + 2);
  simulation::ScannerOptions options;
  options.seed = spec.seed;
  options.footprint = false;  // faster
  scanner_ = std::make_unique<simulation::Scanner>(
      rays_, lidar, simulation::make_motion(scene_, rays_, gait, duration, spec.seed, kMount),
      options);
  source_.scan = [this](std::uint64_t index) {
    const auto found = made_.find(index);
    if (found != made_.end()) return found->second;
    return made_.emplace(index, scanner_->scan(index).scan).first->second;
  };
  source_.T_map_lidar = [this](std::int64_t instant_ns) {
    const std::int64_t since_start_ns = instant_ns - scanner_->options().start_ns;
    return scanner_->motion().T_map_lidar(seconds(since_start_ns));
  };
}

simulation::Scanner FaultWalk::on_the_way(const simulation::Motion& motion,
                                          std::uint64_t seed) const {
  simulation::ScannerOptions options = scanner_->options();
  options.seed = seed;
  return {rays_, scanner_->model(), motion, options};
}

MotionError motion_error(const Pose& estimated, const Pose& truth) {
  const Pose off = truth.inverse() * estimated;
  return {off.translation.norm(), so3_log(off.rotation).norm() * 180.0 / std::numbers::pi};
}

Pose mount() { return kMount; }

std::vector<JudgedScan> run_fault(const FaultWalk& walk, const FaultWalk& elsewhere,
                                  const simulation::Fault& fault, std::uint64_t scans,
                                  const Config& config) {
  Odometry odometry(config);
  std::vector<JudgedScan> judged;
  std::vector<std::optional<Claimed>> ok;  // one a scan
  std::optional<Pair> before;              // the fault
  for (std::uint64_t n = 0; n < scans; ++n) {
    const simulation::FaultyScan shown = fault.scan(n, walk.source(), elsewhere.source());
    JudgedScan scan{odometry.add_scan(shown.scan), {}, {}};
    const Estimate& estimate = scan.estimate;
    const Pair pair{estimate.T_world_lidar, shown.T_map_lidar, shown.place, estimate.segment};
    const bool claimed = estimate.status == Status::ok || estimate.status == Status::first_scan;
    if (claimed && n < simulation::kFaultBegins) before = pair;
    if (claimed) scan.over_ten = error_of(ok, pair);
    const bool wrong = scan.over_ten && scan.over_ten->wrong();
    ok.push_back(claimed ? std::optional(Claimed{pair, wrong}) : std::nullopt);
    if (before && before->segment == pair.segment) scan.since_fault = error_between(*before, pair);
    judged.push_back(std::move(scan));
  }
  return judged;
}

}  // namespace surefoot::benchmarks
