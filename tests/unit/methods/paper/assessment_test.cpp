// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a registration knows: degenerate directions by name, and the covariance against repeated
// registrations.
#include "methods/paper/assessment.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <tuple>

#include "core/information.hpp"
#include "geometry/decompositions.hpp"
#include "methods/paper/registration.hpp"
#include "unit/methods/paper/registration_fixture.hpp"

namespace surefoot {
namespace {

using test::Random;

Config::Health information_health() {
  Config::Health health = Config().health;
  health.min_information = 0.02;
  health.max_correction = 3.0;
  health.max_correction_deg = 45.0;
  return health;
}

std::vector<Eigen::Vector3d> floor_points(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Eigen::Vector3d> points;
  test::add_face(points, random, count, {-10, -10, -0.5}, {20, 0, 0}, {0, 20, 0});
  return points;
}

/// Along x, 3 m wide, floor and ceiling.
std::vector<Eigen::Vector3d> corridor_points(std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Eigen::Vector3d> points;
  test::add_face(points, random, count, {-10, -1.5, -0.5}, {20, 0, 0}, {0, 3, 0});
  test::add_face(points, random, count, {-10, -1.5, 2.5}, {20, 0, 0}, {0, 3, 0});
  test::add_face(points, random, count, {-10, -1.5, -0.5}, {20, 0, 0}, {0, 0, 3});
  test::add_face(points, random, count, {-10, 1.5, -0.5}, {20, 0, 0}, {0, 0, 3});
  return points;
}

/// Registers a scan of one set of points to a map of another, and assesses it.
Estimate assess_scene(const std::vector<Eigen::Vector3d>& map_points,
                      const std::vector<Eigen::Vector3d>& scan_points, const Pose& T) {
  const PaperParameters config = test::step_config();
  const LocalMap map = test::make_map(map_points, config);
  Source source = test::make_source(scan_points, T);
  const Registration registration =
      register_scan(source, map, T, config, test::kMinMatches, Workers(1), [](Step) {});
  Estimate estimate;
  estimate.status = Status::ok;
  assess(source, map, registration.T_map_lidar, config.vertical, information_health(), Workers(1),
         estimate);
  return estimate;
}

std::vector<std::string> weak_names(const Estimate& estimate) {
  std::vector<std::string> names;
  for (const DegenerateDirection& weak : estimate.degenerate) names.push_back(weak.name);
  std::sort(names.begin(), names.end());
  return names;
}

Pose heading(double yaw_deg) {
  return {so3_exp({0.0, 0.0, yaw_deg * std::numbers::pi / 180.0}), Eigen::Vector3d::Zero()};
}

TEST(Assessment, ARoomConstrainsEverything) {
  const Estimate estimate =
      assess_scene(test::room_points(1, 4000), test::room_points(2, 300), Pose{});
  EXPECT_EQ(estimate.status, Status::ok);
  EXPECT_TRUE(estimate.degenerate.empty());
  EXPECT_EQ(estimate.message, "");
}

TEST(Assessment, ACorridorLeavesTheWayAlongItOpen) {
  const auto map = corridor_points(1, 6000), scan = corridor_points(2, 400);
  for (const auto& [yaw, name, others] : {std::tuple{0.0, "forward", "lateral"},
                                          {180.0, "forward", "lateral"},
                                          {90.0, "lateral", "forward"}}) {
    const Estimate estimate = assess_scene(map, scan, heading(yaw));
    EXPECT_EQ(estimate.status, Status::degenerate);
    ASSERT_FALSE(estimate.degenerate.empty());
    EXPECT_EQ(estimate.degenerate[0].name, name) << "yaw " << yaw;  // the weakest comes first
    EXPECT_NE(estimate.message.find(name), std::string::npos) << estimate.message;
    // In the map's axes it is x, whatever the heading.
    EXPECT_GT(std::abs(estimate.degenerate[0].direction[0]), 0.99);
    EXPECT_NEAR(estimate.degenerate[0].direction.norm(), 1.0, 1e-9);
    // The other translations are known. (Turning about a long corridor's middle moves its faces
    // little against its length, and may be named as well.)
    for (const std::string& weak : weak_names(estimate)) {
      EXPECT_NE(weak, others);
      EXPECT_NE(weak, "up");
    }
  }
}

TEST(Assessment, AnOpenPlaneLeavesXYAndYawOpen) {
  const Estimate estimate = assess_scene(floor_points(1, 20'000), floor_points(2, 1500), Pose{});
  EXPECT_EQ(estimate.status, Status::degenerate);
  EXPECT_EQ(weak_names(estimate), (std::vector<std::string>{"forward", "lateral", "yaw"}));
}

TEST(Assessment, CovarianceIsSymmetricPositiveDefiniteEvenWhereNothingIsKnown) {
  for (const auto& points : {test::room_points(1, 3000), floor_points(1, 9000)}) {
    const Estimate estimate = assess_scene(points, points, Pose{});
    EXPECT_LT((estimate.covariance - estimate.covariance.transpose()).norm(),
              1e-12 * estimate.covariance.norm());
    const SymmetricEigen<6> eigen = symmetric_eigen<6>(estimate.covariance);
    EXPECT_GT(eigen.values[0], 0.0);
    // Never less certain than a prediction.
    const Matrix6 bound = unregistered_covariance(information_health());
    EXPECT_LT(eigen.values[5], bound.diagonal().maxCoeff() * (1.0 + 1e-9));
  }
}

TEST(Assessment, OpenDirectionsHaveThePredictionsVarianceAndTheOthersLess) {
  const Estimate estimate = assess_scene(floor_points(1, 20'000), floor_points(2, 1500), Pose{});
  EXPECT_GT(estimate.covariance(0, 0), 100.0 * estimate.covariance(2, 2));
  EXPECT_GT(estimate.covariance(5, 5), 100.0 * estimate.covariance(3, 3));
}

TEST(Assessment, CovarianceAgreesWithRepeatedRegistrationsToAnOrderOfMagnitude) {
  // 60 scans of one room, every point anew and with 2 cm of noise. The covariance is that of
  // point-to-plane residuals taken as independent; the estimator's horizontal stage is
  // point-to-point against a map of discrete points, which adds scatter along the faces. So the
  // standard deviations agree to a factor of some units, not to percents: a factor of 5 holds.
  constexpr int kScans = 60;
  const PaperParameters config = test::step_config();
  const LocalMap map = test::make_map(test::room_points(1, 6000), config);
  Matrix6 sample = Matrix6::Zero(), reported = Matrix6::Zero();
  Twist mean = Twist::Zero();
  std::vector<Twist> errors;
  for (std::uint64_t scan = 0; scan < kScans; ++scan) {
    Random random(100 + scan);
    Source source = test::make_source(test::room_points(1000 + scan, 200), Pose{});
    for (Eigen::Vector3f& p : source.points) {
      for (int axis = 0; axis < 3; ++axis) p[axis] += static_cast<float>(random.normal(0.02));
    }
    const Registration result =
        register_scan(source, map, Pose{}, config, test::kMinMatches, Workers(1), [](Step) {});
    Estimate estimate;
    assess(source, map, result.T_map_lidar, config.vertical, information_health(), Workers(1),
           estimate);
    reported += estimate.covariance / kScans;
    errors.push_back(se3_log(result.T_map_lidar));
    mean += errors.back() / kScans;
  }
  for (const Twist& e : errors) sample += (e - mean) * (e - mean).transpose() / (kScans - 1);
  for (int i = 0; i < 6; ++i) {
    const double ratio = std::sqrt(sample(i, i) / reported(i, i));
    EXPECT_GT(ratio, 1.0 / 5.0) << "direction " << i;
    EXPECT_LT(ratio, 5.0) << "direction " << i;
    RecordProperty("ratio_" + std::to_string(i), std::to_string(ratio));
  }
}

}  // namespace
}  // namespace surefoot
