// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// within_scans RECORDING... [--method M] [--hole S] [--start N] [--count N]: what a trajectory file
// does not show. How well the motion within each scan is known (attitude and deskewing, relative to
// mid-scan), and whether the covariances tell the truth. Needs gt.tum in each folder. Exit codes:
// 0, 2 for bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/association.hpp"
#include "geometry/se3.hpp"
#include "geometry/so3.hpp"
#include "io/recording.hpp"
#include "io/trajectory_files.hpp"
#include "surefoot/odometry.hpp"

namespace surefoot::benchmarks {

namespace {

constexpr int kInstants = 9;       // of a scan, its ends included
constexpr double kRange = 8.0;     // [m] of the points whose deskewing is judged
constexpr double kMotion = 1.0;    // [m] of the motions whose covariance is judged
constexpr std::size_t kLearn = 4;  // scans at first that do not count
// With holes: one every so often; motions across it from and to so many scans.
constexpr double kBetweenHoles = 8.0;  // [s]
constexpr std::size_t kAround = 5;
constexpr std::int64_t kHole = 500'000'000;  // [ns] what is longer between two scans is one
// 2.5, 50 and 97.5 % of chi squared with six degrees of freedom.
constexpr double kLower = 1.237, kMiddle = 5.348, kUpper = 14.449;

struct Options {
  std::string method = "surefoot";
  double hole = 0.0;      ///< [s]
  std::size_t start = 0;  ///< scans left out at first
  std::size_t count = 1'000'000;
};

/// One scan, estimated and true.
struct Pair {
  Estimate estimate;
  std::array<Pose, kInstants> truth;

  [[nodiscard]] const Pose& middle() const { return truth[kInstants / 2]; }
};

std::int64_t instant(const ScanTrajectory& scan, int i) {
  return scan.start_ns() + (scan.end_ns() - scan.start_ns()) * i / (kInstants - 1);
}

/// Whether a scan so long [s] after the first is left out.
bool in_hole(double since, double hole) {
  return std::fmod(since, kBetweenHoles) >= kBetweenHoles - hole;
}

std::vector<Pair> run(const std::string& recording, const Options& options) {
  const Trajectory truth = io::read_tum(std::filesystem::path(recording) / "gt.tum");
  const auto true_pose = [&truth](std::int64_t stamp) -> std::optional<Pose> {
    if (stamp < truth.front().stamp_ns || stamp > truth.back().stamp_ns) return std::nullopt;
    return evaluation::associate(truth, {{stamp, {}}},
                                 {.method = evaluation::AssociationMethod::interpolate})
        .reference.front()
        .pose;
  };
  Odometry odometry(method_config(options.method));
  std::vector<Pair> pairs;
  std::optional<std::int64_t> first_ns;
  const auto scans = io::open_recording(recording);
  std::size_t n = 0;
  while (const auto item = scans->next()) {
    if (!item->scan || !item->remark.empty() || n++ < options.start) continue;
    if (n > options.start + options.count) break;
    const std::int64_t since = item->scan->stamp_ns - first_ns.value_or(item->scan->stamp_ns);
    if (!first_ns) first_ns = item->scan->stamp_ns;
    if (in_hole(1e-9 * static_cast<double>(since), options.hole)) continue;
    Pair pair{odometry.add_scan(*item->scan), {}};
    bool known = pair.estimate.trusted();
    for (int i = 0; known && i < kInstants; ++i) {
      const auto pose = true_pose(instant(pair.estimate.trajectory, i));
      known = pose.has_value();
      if (known) pair.truth[static_cast<std::size_t>(i)] = *pose;
    }
    if (known) pairs.push_back(std::move(pair));
  }
  return pairs;
}

struct WithinScans {
  double attitude = 0.0;   ///< [rad] RMS
  double deskewing = 0.0;  ///< [m] RMS of points in the plane of the sensor
};

WithinScans within_scans(const std::vector<Pair>& pairs) {
  double rotation = 0.0, points = 0.0;
  int count = 0;
  for (std::size_t n = kLearn; n < pairs.size(); ++n) {
    const Estimate& estimate = pairs[n].estimate;
    for (int i = 0; i < kInstants; ++i) {
      const Pose found =
          estimate.T_world_lidar.inverse() * estimate.pose_at(instant(estimate.trajectory, i));
      const Pose real = pairs[n].middle().inverse() * pairs[n].truth[static_cast<std::size_t>(i)];
      rotation += so3_log(real.rotation.conjugate() * found.rotation).squaredNorm();
      for (const Eigen::Vector3d& side :
           {Eigen::Vector3d(kRange, 0, 0), Eigen::Vector3d(-kRange, 0, 0),
            Eigen::Vector3d(0, kRange, 0), Eigen::Vector3d(0, -kRange, 0)}) {
        points += 0.25 * (found * side - real * side).squaredNorm();
      }
      ++count;
    }
  }
  return {std::sqrt(rotation / std::max(count, 1)), std::sqrt(points / std::max(count, 1))};
}

/// The covariance of a pose in its own axes.
Matrix6 in_lidar_axes(const Estimate& estimate) {
  const Matrix6 turn = turned_axes(estimate.T_world_lidar.rotation.conjugate());
  return turn * estimate.covariance * turn.transpose();
}

/// Normalised error squared of the motion between two scans, both poses' errors taken as
/// independent.
double normalised_error(const Pair& a, const Pair& b) {
  const Pose found = a.estimate.T_world_lidar.inverse() * b.estimate.T_world_lidar;
  const Twist error = se3_log((a.middle().inverse() * b.middle()).inverse() * found);
  const Pose back = found.inverse();
  const Eigen::Matrix3d R = back.rotation.toRotationMatrix();
  Matrix6 adjoint = Matrix6::Zero();
  adjoint << R, hat(back.translation) * R, Eigen::Matrix3d::Zero(), R;
  const Matrix6 covariance =
      in_lidar_axes(b.estimate) + adjoint * in_lidar_axes(a.estimate) * adjoint.transpose();
  return error.dot(covariance.ldlt().solve(error));
}

/// Of every motion of kMotion, from every scan.
std::vector<double> normalised_errors(const std::vector<Pair>& pairs) {
  std::vector<double> errors;
  for (std::size_t a = kLearn, b = kLearn; a < pairs.size(); ++a) {
    const auto way = [&] {
      return (pairs[b].middle().translation - pairs[a].middle().translation).norm();
    };
    b = a;
    while (b + 1 < pairs.size() && way() < kMotion) ++b;
    if (way() < kMotion) break;
    errors.push_back(normalised_error(pairs[a], pairs[b]));
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

/// Of the motions across holes.
std::vector<double> errors_across_holes(const std::vector<Pair>& pairs) {
  std::vector<double> errors;
  for (std::size_t after = kLearn + kAround; after < pairs.size(); ++after) {
    const auto stamp = [&pairs](std::size_t n) { return pairs[n].estimate.stamp_ns; };
    if (stamp(after) - stamp(after - 1) < kHole) continue;
    for (std::size_t a = after - kAround; a < after; ++a) {
      for (std::size_t b = after; b < std::min(after + kAround, pairs.size()); ++b) {
        if (pairs[a].estimate.segment != pairs[b].estimate.segment) continue;
        errors.push_back(normalised_error(pairs[a], pairs[b]));
      }
    }
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

double share_below(const std::vector<double>& sorted, double bound) {
  const auto end = std::lower_bound(sorted.begin(), sorted.end(), bound);
  return static_cast<double>(end - sorted.begin()) / static_cast<double>(sorted.size());
}

void print_row(const std::string& recording, const std::vector<Pair>& pairs, double hole) {
  const WithinScans within = within_scans(pairs);
  const std::vector<double> errors =
      hole > 0.0 ? errors_across_holes(pairs) : normalised_errors(pairs);
  const std::filesystem::path folder(recording);
  const std::filesystem::path name = folder.has_filename() ? folder : folder.parent_path();
  fmt::print("| {} | {} | {:.1f} | {:.0f} |", name.filename().string(), pairs.size(),
             1e3 * within.attitude, 1e3 * within.deskewing);
  if (errors.empty()) {
    fmt::print(" – | – | – |\n");
  } else {
    const double below = share_below(errors, kUpper);
    fmt::print(" {:.2f} | {:.0f} | {:.0f} |\n", errors[errors.size() / 2] / kMiddle, 100.0 * below,
               100.0 * (below - share_below(errors, kLower)));
  }
  std::fflush(stdout);
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  std::vector<std::string> recordings;
  surefoot::benchmarks::Options options;
  CLI::App app{"Motion within the scans and covariances against the truth"};
  app.add_option("recordings", recordings, "Folders with gt.tum")->required();
  app.add_option("--method", options.method, "As surefoot run's")->capture_default_str();
  app.add_option("--hole", options.hole,
                 "[s] left out of every 8; the covariances are those across it")
      ->check(CLI::Range(0.0, 7.0));
  app.add_option("--start", options.start, "Scans left out at first")->capture_default_str();
  app.add_option("--count", options.count, "At most this many after them")->capture_default_str();
  try {
    app.parse(argc, argv);
    fmt::print(
        "| recording | scans | attitude within the scan [mrad] | deskewing at 8 m [mm] | "
        "normalised "
        "error of 1 m, median over expected | below its 97.5 % bound [%] | between both "
        "bounds [%] |\n|---|---|---|---|---|---|---|\n");
    for (const std::string& recording : recordings) {
      surefoot::benchmarks::print_row(recording, surefoot::benchmarks::run(recording, options),
                                      options.hole);
    }
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "within_scans: {}\n", error.what());
    return 2;
  }
}
