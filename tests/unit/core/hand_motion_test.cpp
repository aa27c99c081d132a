// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Two single scans under hard hand motion (Newer College, an OS1-64 that turns by 3.2 and 3.5 deg
// within the sweep), against the same points deskewed by a LiDAR-inertial system. One scan has no
// scan before it to be registered to: every other point of the reference is the map, and the points
// between them, as measured, are registered from standstill.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "core/downsample.hpp"
#include "core/preprocess.hpp"
#include "io/recording.hpp"
#include "methods/knots/knot_registration.hpp"

namespace surefoot {
namespace {

using std::filesystem::path;

Scan read_one(const path& file) {
  const auto recording = io::open_recording(file);
  return recording->next()->scan.value();
}

struct Halves {
  std::vector<Eigen::Vector3d> map;        // every other point, where the reference has it
  PreparedScan scan;                       // the points between, as measured
  std::vector<Eigen::Vector3d> reference;  // and where the reference has them
};

Halves read_halves(const std::string& name) {
  const path folder = path(SUREFOOT_SHARED_DATA) / "newer_college";
  const Scan raw = read_one(folder / (name + ".pcd"));
  const Scan reference = read_one(folder / ("deskewed_reference_" + name + ".ply"));
  EXPECT_EQ(raw.points.size(), reference.points.size());
  EXPECT_EQ(raw.points.size(), raw.times_ns.size());
  if (::testing::Test::HasFailure()) return {};
  const auto [first, last] = std::minmax_element(raw.times_ns.begin(), raw.times_ns.end());
  Halves halves;
  halves.scan.start_ns = *first;
  halves.scan.end_ns = *last;
  for (std::size_t i = 0; i < raw.points.size(); ++i) {
    const Eigen::Vector3d place = reference.points[i].cast<double>();
    if (i % 2 == 0) {
      halves.map.push_back(place);
      continue;
    }
    halves.scan.points.push_back(raw.points[i]);
    halves.scan.taus.push_back(static_cast<float>(raw.times_ns[i] - *first) /
                               static_cast<float>(*last - *first));
    halves.reference.push_back(place);
  }
  return halves;
}

/// RMS distance [m] of the scan's points from the reference's, deskewed to its first instant by a
/// motion.
double deskew_error(const Halves& halves, const ScanTrajectory& motion) {
  double squares = 0.0;
  for (std::size_t i = 0; i < halves.reference.size(); ++i) {
    const Pose T = motion.at(static_cast<double>(halves.scan.taus[i]));
    squares += (T * halves.scan.points[i].cast<double>() - halves.reference[i]).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(halves.reference.size()));
}

KnotRegistration find_motion(const Halves& halves) {
  const Config::Knots config = Config().knots;
  SurfelMap map(config, 100.0);
  map.insert({Eigen::Vector3d::Zero(), halves.map});
  const double step = 1e-9 * static_cast<double>(halves.scan.end_ns - halves.scan.start_ns) /
                      static_cast<double>(config.segments);
  const KnotWindow still{std::vector<Pose>(static_cast<std::size_t>(config.segments) + 2), step,
                         step, halves.scan.start_ns, halves.scan.end_ns};
  KnotPoints points =
      sort_points(halves.scan, downsample_indices(halves.scan.points, config.map_voxel), still);
  const KnotPrior prior = at_rest(Pose(), step);
  const VelocityModel model(config);
  const Workers workers(1);
  const StepObserver nobody = [](Step) {};
  return register_knots(points, {map, prior, model, config, workers, nobody}, still,
                        patient_annealing(config));
}

TEST(HandMotion, AScansKnotsDeskewItAsTheReferenceDoes) {
  for (const char* const name : {"000000", "000001"}) {
    if (!std::filesystem::exists(path(SUREFOOT_SHARED_DATA) / "newer_college")) {
      GTEST_SKIP() << "newer_college is not on this machine";
    }
    const Halves halves = read_halves(name);
    ASSERT_FALSE(HasFailure());
    const Pose still;
    const double raw = deskew_error(
        halves, ScanTrajectory({still, still}, halves.scan.start_ns, halves.scan.end_ns));
    const KnotRegistration found = find_motion(halves);
    ASSERT_TRUE(found.solved);
    EXPECT_TRUE(found.converged);
    const double deskewed = deskew_error(halves, found.window.trajectory());
    std::printf("newer_college %s: raw %.3f m, deskewed %.4f m from the reference, misfit %.3f\n",
                name, raw, deskewed, found.misfit);
    EXPECT_LT(deskewed, 0.1 * raw);
  }
}

}  // namespace
}  // namespace surefoot
