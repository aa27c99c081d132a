// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// scan_context RECORDING: Scan Context as Kim and Kim describe it ("Scan Context: Egocentric
// Spatial Descriptor for Place Recognition within 3D Point Cloud Map", IROS 2018), written from the
// paper, for a comparison: 20 rings, 60 sectors, 80 m, the highest point of each bin; candidates by
// ring keys; the mean cosine distance of columns, turned as suits best. Single scans, as they were
// measured, are keyframes, one a metre of the true way. A line of CSV a keyframe: the place that is
// most alike among those passed 25 m or more before, whatever the distance. RECORDING has a gt.tum
// beside it. Exit codes: 0, 2 for bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <exception>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "io/recording.hpp"
#include "io/trajectory_files.hpp"

namespace surefoot::benchmarks {

namespace {

constexpr int kRings = 20;
constexpr int kSectors = 60;
constexpr double kRange = 80.0;          // [m]
constexpr std::size_t kCandidates = 10;  // of the ring keys
constexpr double kMountHeight = 0.47;  // [m] of the simulated robot's LiDAR: bins are above ground
constexpr double kStep = 1.0;          // [m] between keyframes
constexpr double kWayBetween = 25.0;   // [m] as loops are looked for
constexpr std::int64_t kTruthStep = 10'000'000;  // [ns]

struct Keyframe {
  std::int64_t stamp_ns = 0;
  double way = 0.0;                             // [m]
  Eigen::Matrix<float, kRings, kSectors> bins;  // the highest point [m]; nothing: 0
  Eigen::Matrix<float, kRings, 1> key;          // share of the sectors that hold something
};

void describe(const Scan& scan, Keyframe& frame) {
  frame.bins.setZero();
  for (const Eigen::Vector3f& point : scan.points) {
    const double range = std::hypot(point.x(), point.y());
    if (!(range < kRange)) continue;
    const double turns = std::atan2(point.y(), point.x()) / (2.0 * std::numbers::pi) + 0.5;
    const int ring = static_cast<int>(range / kRange * kRings);
    const int sector = std::min(static_cast<int>(turns * kSectors), kSectors - 1);
    float& bin = frame.bins(ring, sector);
    bin = std::max(bin, point.z() + static_cast<float>(kMountHeight));
  }
  frame.key = (frame.bins.array() > 0.0F).cast<float>().rowwise().mean();
}

struct Distance {
  double distance = 1.0;
  int shift = 0;  // sectors
};

/// Columns with nothing in them have no cosine and are left out.
Distance distance_between(const Keyframe& one, const Keyframe& other) {
  const Eigen::Matrix<float, 1, kSectors> norms1 = one.bins.colwise().norm();
  const Eigen::Matrix<float, 1, kSectors> norms2 = other.bins.colwise().norm();
  Distance best;
  for (int shift = 0; shift < kSectors; ++shift) {
    double likeness = 0.0;
    int compared = 0;
    for (int column = 0; column < kSectors; ++column) {
      const int turned = (column + kSectors - shift) % kSectors;
      const float norms = norms1[column] * norms2[turned];
      if (norms == 0.0F) continue;
      likeness += one.bins.col(column).dot(other.bins.col(turned)) / norms;
      ++compared;
    }
    const double distance = compared > 0 ? 1.0 - likeness / compared : 1.0;
    if (distance < best.distance) best = {distance, shift};
  }
  return best;
}

/// Of the first `allowed` keyframes, the one that is most alike; there is one at least. The nearest
/// keys are those that a tree would find.
std::pair<std::size_t, Distance> search(const std::vector<Keyframe>& frames, std::size_t allowed,
                                        const Keyframe& query) {
  std::vector<std::pair<float, std::size_t>> keys;
  for (std::size_t i = 0; i < allowed; ++i) {
    keys.emplace_back((frames[i].key - query.key).squaredNorm(), i);
  }
  const std::size_t kept = std::min(kCandidates, keys.size());
  std::partial_sort(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(kept), keys.end());
  std::pair<std::size_t, Distance> best{keys.front().second, {}};
  for (std::size_t i = 0; i < kept; ++i) {
    const Distance distance = distance_between(frames[keys[i].second], query);
    if (distance.distance < best.second.distance) best = {keys[i].second, distance};
  }
  return best;
}

/// Where the sensor truly was [m].
Eigen::Vector3d position_at(const Trajectory& truth, std::int64_t stamp_ns) {
  const auto after = std::lower_bound(
      truth.begin(), truth.end(), stamp_ns,
      [](const StampedPose& pose, std::int64_t stamp) { return pose.stamp_ns < stamp; });
  return (after == truth.end() ? truth.back() : *after).pose.translation;
}

void measure(const std::filesystem::path& path) {
  const Trajectory truth = io::read_tum_thinned(path / "gt.tum", kTruthStep);
  if (truth.empty()) throw std::runtime_error(path.string() + ": gt.tum holds no pose");
  const auto recording = io::open_recording(path, {});
  std::vector<Keyframe> frames;
  Eigen::Vector3d last = truth.front().pose.translation;
  double way = 0.0;
  while (const auto item = recording->next()) {
    if (!item->scan) continue;
    const Eigen::Vector3d here = position_at(truth, item->scan->stamp_ns);
    if (!frames.empty() && (here - last).norm() < kStep) continue;
    way += frames.empty() ? 0.0 : (here - last).norm();
    last = here;
    const std::clock_t begin = std::clock();
    Keyframe frame{item->scan->stamp_ns, way, {}, {}};
    describe(*item->scan, frame);
    const auto allowed = static_cast<std::size_t>(
        std::count_if(frames.begin(), frames.end(),
                      [&](const Keyframe& each) { return way - each.way >= kWayBetween; }));
    if (allowed > 0) {
      const auto [place, found] = search(frames, allowed, frame);
      const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      fmt::print("{:.9f},{:.9f},{:.4f},{:.1f},{:.3f}\n", 1e-9 * static_cast<double>(frame.stamp_ns),
                 1e-9 * static_cast<double>(frames[place].stamp_ns), found.distance,
                 std::remainder(found.shift * 360.0 / kSectors, 360.0), 1e3 * seconds);
    }
    frames.push_back(frame);
  }
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  std::string recording;
  CLI::App app{"Scan Context on a recording"};
  app.add_option("recording", recording, "a simulated recording's folder")->required();
  try {
    app.parse(argc, argv);
    fmt::print("stamp,place_stamp,distance,yaw_deg,search_ms\n");
    surefoot::benchmarks::measure(recording);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "scan_context: {}\n", error.what());
    return 2;
  }
}
