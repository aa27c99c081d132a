// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <numbers>

#include "simulation/random.hpp"
#include "simulation/rotor.hpp"
#include "simulation/rounding.hpp"
#include "support.hpp"

namespace surefoot::simulation::test {
namespace {

constexpr double kScannerDegree = std::numbers::pi / 180.0;

struct Studio {
  explicit Studio(Scene of, const char* robot = "trot", const ScannerOptions& options = {},
                  const char* lidar = "vlp16")
      : scene(std::move(of)),
        rays(scene),
        scanner(rays, lidar_model(lidar),
                make_motion(scene, rays, gait_model(robot), 6.0, 7, kMount), options) {}
  Scene scene;
  RayCaster rays;
  Scanner scanner;
};

Eigen::Vector3d in_map(const Studio& studio, const SimulatedScan& scan, std::size_t i) {
  return studio.scanner.motion().T_map_lidar(instant(scan, i, studio.scanner.options())) *
         scan.scan.points[i].cast<double>();
}

bool same_bytes(const SimulatedScan& a, const SimulatedScan& b) {
  return a.scan.points == b.scan.points && a.scan.times_ns == b.scan.times_ns &&
         a.scan.intensities == b.scan.intensities && a.scan.rings == b.scan.rings &&
         a.scan.stamp_ns == b.scan.stamp_ns && a.labels == b.labels;
}

TEST(LidarModelTest, Vlp16FiresAsItsManualSays) {
  const LidarModel model = lidar_model("vlp16");
  const std::array<double, 16> elevation = {-15, 1, -13, 3,  -11, 5,  -9, 7,
                                            -7,  9, -5,  11, -3,  13, -1, 15};
  ASSERT_EQ(model.lasers.size(), 16U);
  for (std::size_t laser = 0; laser < 16; ++laser) {
    EXPECT_DOUBLE_EQ(model.lasers[laser].offset_ns, 2304.0 * static_cast<double>(laser));
    EXPECT_NEAR(model.lasers[laser].elevation / kScannerDegree, elevation[laser], 1e-12);
    EXPECT_NEAR(model.lasers[laser].vertical_origin,
                -0.04191 * std::tan(elevation[laser] * kScannerDegree), 6e-5);
    EXPECT_EQ(model.lasers[laser].ring, (elevation[laser] + 15.0) / 2.0);
  }
  EXPECT_DOUBLE_EQ(model.sequence_ns, 55296.0);
}

/// Digits as the maker publishes them, each with the laser that it belongs to.
struct PublishedLaser {
  const char* lidar;
  std::size_t laser;
  double elevation_deg;
  double azimuth_deg;
  double offset_us;
};

TEST(LidarModelTest, LasersAreTheMakersToTheDigit) {
  // VeloView-VLP-32C.yaml (azimuth: rot_correction with the other sign); ouster-sdk, design values
  // of the first generation; "PandarXT-16_Firetime Correction File.csv" and pandarXT.h;
  // the OS1-128's elevations are even.
  const std::array<PublishedLaser, 23> published = {
      {{"os1-128", 0, 21.2, 4.2, 0.0},       {"os1-128", 63, 0.1669291338582, -4.2, 0.0},
       {"os1-128", 127, -21.2, -4.2, 0.0},   {"vlp32", 0, -25.0, 1.4, 0.0},
       {"vlp32", 1, -1.0, -4.2, 0.0},        {"vlp32", 3, -15.639, -1.4, 2.304},
       {"vlp32", 6, -0.667, 4.2, 6.912},     {"vlp32", 13, 1.333, -1.4, 13.824},
       {"vlp32", 20, -3.333, 4.2, 23.04},    {"vlp32", 29, 15.0, -1.4, 32.256},
       {"vlp32", 31, -1.333, -1.4, 34.56},   {"os1-64", 0, 16.611, 3.164, 0.0},
       {"os1-64", 2, 15.557, -1.055, 0.0},   {"os1-64", 19, 6.592, -3.164, 0.0},
       {"os1-64", 31, 0.264, -3.164, 0.0},   {"os1-64", 32, -0.264, 3.164, 0.0},
       {"os1-64", 45, -7.119, 1.055, 0.0},   {"os1-64", 63, -16.611, -3.164, 0.0},
       {"hesai-xt16", 0, 15.0, 0.0, 6.0},    {"hesai-xt16", 1, 13.0, 0.0, 9.024},
       {"hesai-xt16", 7, 1.0, 0.0, 27.168},  {"hesai-xt16", 8, -1.0, 0.0, 30.192},
       {"hesai-xt16", 15, -15.0, 0.0, 51.36}}};
  for (const PublishedLaser& expected : published) {
    const LidarModel model = lidar_model(expected.lidar);
    const Laser& laser = model.lasers.at(expected.laser);
    const std::string which = expected.lidar + (" laser " + std::to_string(expected.laser));
    EXPECT_NEAR(laser.elevation / kScannerDegree, expected.elevation_deg, 1e-9) << which;
    EXPECT_NEAR(laser.azimuth_offset / kScannerDegree, expected.azimuth_deg, 1e-9) << which;
    EXPECT_NEAR(1e-3 * laser.offset_ns, expected.offset_us, 1e-9) << which;
  }
  EXPECT_EQ(lidar_model("vlp32").lasers.size(), 32U);
  EXPECT_EQ(lidar_model("os1-64").lasers.size(), 64U);
  EXPECT_EQ(lidar_model("hesai-xt16").lasers.size(), 16U);
  EXPECT_EQ(lidar_model("os1-128").lasers.size(), 128U);
  EXPECT_DOUBLE_EQ(lidar_model("os1-128").radial_origin, 0.015806);
  EXPECT_DOUBLE_EQ(lidar_model("vlp32").range_unit, 0.004);
  EXPECT_NEAR(lidar_model("vlp32").lasers[0].vertical_origin, 0.019771, 1e-6);  // 42.4 mm, -25 deg
  EXPECT_DOUBLE_EQ(lidar_model("hesai-xt16").range_unit, 0.004);
  EXPECT_DOUBLE_EQ(lidar_model("os1-64").radial_origin, 0.012163);
}

TEST(LidarModelTest, OthersKeepToTheirPeriodsAndUnknownNamesAreRefused) {
  EXPECT_DOUBLE_EQ(lidar_model("os1-64").sequence_ns * 1024.0, 1e8);
  EXPECT_DOUBLE_EQ(lidar_model("os1-64-2048").sequence_ns * 2048.0, 1e8);
  EXPECT_EQ(lidar_model("os1-64-2048").lasers.size(), 64U);
  EXPECT_DOUBLE_EQ(lidar_model("os1-128-2048").sequence_ns * 2048.0, 1e8);
  EXPECT_EQ(lidar_model("os1-128-2048").lasers.size(), 128U);
  EXPECT_DOUBLE_EQ(lidar_model("hesai-xt16").sequence_ns * 2000.0, 1e8);
  for (const std::string& name : lidar_names()) {
    const LidarModel model = lidar_model(name);
    for (std::size_t i = 1; i < model.lasers.size(); ++i) {
      EXPECT_GE(model.lasers[i].offset_ns, model.lasers[i - 1].offset_ns) << name;
      // Firings never overtake those of the next sequence.
      EXPECT_LT(model.lasers[i].offset_ns - model.lasers[0].offset_ns, model.sequence_ns) << name;
    }
  }
  EXPECT_THROW((void)lidar_model("hdl-64"), std::invalid_argument);
}

// Halves, both signs, what is far from zero: as the C library rounds.
TEST(RoundingTest, IsTheCLibrarysInPlace) {
  const CounterRandom random(5, 1);
  for (std::uint64_t i = 0; i < 100'000; ++i) {
    const double value = random.uniform(i, -1.0, 1.0) * std::pow(10.0, static_cast<double>(i % 12));
    ASSERT_EQ(rounded(value), std::llround(value)) << value;
    const double half = std::floor(value) + 0.5;
    ASSERT_EQ(rounded(half), std::llround(half)) << half;
    ASSERT_EQ(rounded_to(0.002, value), std::round(value / 0.002) * 0.002) << value;
  }
  for (const double value : {0.0, -0.0, 0.25, -0.25, 0.75}) {
    EXPECT_EQ(rounded(value), std::llround(value)) << value;
  }
}

TEST(RotorTest, TurnsVectorsAndFramesLikeItsMatrix) {
  const double azimuth = 0.7;
  Eigen::Matrix3d R_lidar_rotor;
  R_lidar_rotor << std::cos(azimuth), std::sin(azimuth), 0.0, -std::sin(azimuth), std::cos(azimuth),
      0.0, 0.0, 0.0, 1.0;
  const Eigen::Vector3d v(1.0, -2.0, 3.0);
  const Eigen::Matrix3d R_map_lidar = so3_exp({0.3, -0.2, 2.0}).toRotationMatrix();
  EXPECT_EQ(Rotor(azimuth) * v, R_lidar_rotor * v);
  EXPECT_EQ(Rotor(azimuth).after(R_map_lidar), R_map_lidar * R_lidar_rotor);
}

TEST(RotorTest, TimeWithinATurnIsTheRemainderToTheBit) {
  const double turn_ns = lidar_model("vlp16").turn_ns;
  for (const std::string& name : lidar_names()) {
    const double step_ns = lidar_model(name).sequence_ns;
    for (double sequence = 0.0; sequence * step_ns < 36e12; sequence += 4999.0) {  // ten hours
      const double time_ns = sequence * step_ns;
      ASSERT_EQ(within_turn(time_ns, turn_ns), std::fmod(time_ns, turn_ns)) << name << time_ns;
    }
  }
  for (double turn = 1.0; turn < 1e6; ++turn) {
    ASSERT_EQ(within_turn(turn * turn_ns, turn_ns), 0.0);
    const double before_ns = std::nextafter(turn * turn_ns, 0.0);
    ASSERT_EQ(within_turn(before_ns, turn_ns), std::fmod(before_ns, turn_ns));
  }
}

TEST(ReturnModelTest, ABeamIsDetectedByADrawAgainstItsOdds) {
  const LidarModel model = lidar_model("vlp16");
  const CounterRandom random(5, 1);
  int detections = 0;
  for (std::uint64_t beam = 0; beam < 50'000; ++beam) {
    // A facing wall of concrete whose power goes from 1/1024 to 32 times what is detected half of
    // the time.
    const double wanted = std::exp2(random.uniform(8 * beam + 7, -10.0, 5.0));
    Hit hit{.distance = 40.0F, .cos_incidence = 1.0F, .material = Material::concrete};
    hit.passed = static_cast<float>(wanted * 0.1 / reflectivity(hit.material) *
                                    std::pow(40.0 / model.half_detection_range, 2.0));
    const double power = static_cast<double>(hit.passed) * reflectivity(hit.material) / 0.1 *
                         std::pow(model.half_detection_range / 40.0, 2.0);
    const double odds = std::pow(power, 1.0 / 0.15);
    const bool expected = random.uniform(8 * beam) < 0.997 * odds / (1.0 + odds);
    const auto returns = detect(model, footprint_rays(false), {&hit, 1}, random, beam);
    ASSERT_EQ(returns.count == 1, expected) << power;
    detections += returns.count;
  }
  EXPECT_GT(detections, 10'000);
  EXPECT_LT(detections, 40'000);
}

TEST(ScannerTest, FiringTimesAndAzimuthsAreTheSensors) {
  Studio studio(room());
  const SimulatedScan scan = studio.scanner.scan(3);
  ASSERT_FALSE(scan.scan.points.empty());
  // The first sequence that begins in the fourth turn: ceil(3e8 / 55296) = 5426.
  EXPECT_EQ(scan.first_sequence, 5426U);
  EXPECT_EQ(scan.scan.stamp_ns - studio.scanner.options().start_ns, 5426 * 55296);
  EXPECT_EQ(scan.end_sequence - scan.first_sequence, 1808U);
  for (std::size_t i = 0; i < scan.raw.size(); ++i) {
    const auto sequence = static_cast<std::int64_t>(scan.raw[i].sequence - scan.first_sequence);
    ASSERT_EQ(scan.scan.times_ns[i], sequence * 55296 + scan.raw[i].laser * 2304);
    // Clockwise from ahead; the rotor makes 360 deg in 100 ms and reads to 0.01 deg.
    const double turned =
        360.0 * std::fmod(1e-8 * static_cast<double>(scan.scan.stamp_ns + scan.scan.times_ns[i] -
                                                     studio.scanner.options().start_ns),
                          1.0);
    const Eigen::Vector3f& p = scan.scan.points[i];
    const double seen = -std::atan2(p.y(), p.x()) / kScannerDegree;
    ASSERT_NEAR(std::remainder(seen - turned, 360.0), 0.0, 0.0051 + 1e-4);
  }
}

TEST(ScannerTest, AStillRobotSeesStraightWalls) {
  ScannerOptions options;
  options.footprint = false;
  Studio studio(room(), "still", options);
  const SimulatedScan scan = studio.scanner.scan(0);
  ASSERT_GT(scan.scan.points.size(), 25000U);
  const Pose T_map_lidar = studio.scanner.motion().T_map_lidar(0.0);
  double sum = 0.0;
  for (const Eigen::Vector3f& point : scan.scan.points) {
    const double residual = distance_to_room(T_map_lidar * point.cast<double>());
    sum += residual * residual;
    ASSERT_LT(residual, 0.08);
  }
  EXPECT_LT(std::sqrt(sum / static_cast<double>(scan.scan.points.size())), 0.011);
}

TEST(ScannerTest, PointsThroughTheirOwnPoseLieOnTheWallsWithinTheNoise) {
  ScannerOptions options;
  options.footprint = false;
  for (const std::string& lidar : lidar_names()) {
    Studio studio(room(), "trot", options, lidar.c_str());
    const double sigma = studio.scanner.model().range_sigma;
    const SimulatedScan scan = studio.scanner.scan(45);
    double own = 0.0;
    double frozen = 0.0;
    const Pose start = studio.scanner.motion().T_map_lidar(instant(scan, 0, options));
    for (std::size_t i = 0; i < scan.scan.points.size(); ++i) {
      own += std::pow(distance_to_room(in_map(studio, scan, i)), 2);
      frozen += std::pow(distance_to_room(start * scan.scan.points[i].cast<double>()), 2);
      ASSERT_LT(distance_to_room(scan.true_points[i]), 2e-5) << lidar << " point " << i;
    }
    const auto count = static_cast<double>(scan.scan.points.size());
    EXPECT_LT(std::sqrt(own / count), 1.25 * sigma) << lidar;
    EXPECT_GT(std::sqrt(frozen / count), 2.0 * sigma) << lidar << ": the motion is not seen at all";
  }
}

TEST(ScannerTest, RangesAreWholeUnitsAndNoiseHasItsSize) {
  ScannerOptions options;
  options.footprint = false;
  Studio studio(room(), "still", options);
  const SimulatedScan scan = studio.scanner.scan(1);
  double sum = 0.0;
  double squares = 0.0;
  const Pose T_map_lidar = studio.scanner.motion().T_map_lidar(0.0);
  for (std::size_t i = 0; i < scan.raw.size(); ++i) {
    const double units = scan.raw[i].range / 0.002;
    ASSERT_NEAR(units, std::round(units), 1e-6);
    const Laser& laser = studio.scanner.model().lasers[scan.raw[i].laser];
    const Eigen::Vector3d origin = T_map_lidar * Eigen::Vector3d(0, 0, laser.vertical_origin);
    const double error = scan.raw[i].range - (scan.true_points[i] - origin).norm();
    sum += error;
    squares += error * error;
  }
  const auto count = static_cast<double>(scan.raw.size());
  EXPECT_NEAR(sum / count, 0.0, 4.0 * 0.01 / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), 0.01, 0.001);
}

TEST(ScannerTest, SameSeedSameBytesWhateverWasAskedBefore) {
  Studio a(room());
  Studio b(room());
  const SimulatedScan first = a.scanner.scan(9);
  (void)b.scanner.scan(2);
  (void)b.scanner.scan(30);
  EXPECT_TRUE(same_bytes(first, b.scanner.scan(9)));
  ScannerOptions options;
  options.seed = 1;
  Studio other(room(), "trot", options);
  EXPECT_FALSE(same_bytes(first, other.scanner.scan(9)));
}

TEST(ScannerTest, TruthNamesEveryScansStartMiddleAndEnd) {
  Studio studio(room());
  const Trajectory truth = true_trajectory(studio.scanner, 20);
  const auto has = [&](std::int64_t stamp) {
    return std::any_of(truth.begin(), truth.end(),
                       [&](const StampedPose& pose) { return pose.stamp_ns == stamp; });
  };
  for (std::size_t i = 1; i < truth.size(); ++i) {
    ASSERT_GT(truth[i].stamp_ns, truth[i - 1].stamp_ns);
    ASSERT_LE(truth[i].stamp_ns - truth[i - 1].stamp_ns, 2'500'000);
  }
  for (std::uint64_t index = 0; index < 20; ++index) {
    const SimulatedScan scan = studio.scanner.scan(index);
    EXPECT_TRUE(has(scan.scan.stamp_ns));
    EXPECT_TRUE(has((scan.scan.stamp_ns + scan.end_ns) / 2));
    EXPECT_TRUE(has(scan.end_ns));
  }
}

TEST(ScannerTest, FarDarkAndSlantedSurfacesDropOut) {
  const auto returns_from = [](double distance, Material material) {
    Scene scene;
    scene.mesh.add_box({-200, -200, -1}, {200, 200, 0}, Material::concrete);
    scene.mesh.add_box({distance, -200, 0}, {distance + 1, 200, 200}, material);
    scene.route = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    ScannerOptions options;
    options.footprint = false;
    Studio studio(std::move(scene), "still", options);
    const SimulatedScan scan = studio.scanner.scan(0);
    std::size_t count = 0;
    for (const Eigen::Vector3d& point : scan.true_points) count += point.x() > distance - 0.1;
    return count;
  };
  const std::size_t near = returns_from(15.0, Material::concrete);
  EXPECT_GT(near, returns_from(60.0, Material::concrete));
  EXPECT_GT(returns_from(60.0, Material::concrete), 4 * returns_from(60.0, Material::rubber));
}

TEST(ScannerTest, EdgesGiveMixedPixelsOnlyWithAFootprint) {
  Scene scene = room();
  // A post half a metre before the wall: nearer than the pulse is long, so both blend.
  scene.mesh.add_box({8.3, -1.0, 0.0}, {8.5, 1.0, 5.0}, Material::concrete);
  const auto mixed = [&](bool footprint) {
    ScannerOptions options;
    options.footprint = footprint;
    Studio studio(scene, "still", options);
    const SimulatedScan scan = studio.scanner.scan(0);
    return std::count(scan.labels.begin(), scan.labels.end(), std::uint8_t{kLabelMixed});
  };
  EXPECT_EQ(mixed(false), 0);
  EXPECT_GT(mixed(true), 10);
}

TEST(ScannerTest, DualReturnSeesBothSidesOfAnEdgeTheFartherMarkedLast) {
  Scene scene = room();
  scene.mesh.add_box({3.0, -1.0, 0.0}, {3.2, 1.0, 5.0}, Material::concrete);
  ScannerOptions options;
  options.dual_return = true;
  Studio studio(scene, "still", options);
  const SimulatedScan scan = studio.scanner.scan(0);
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < scan.raw.size(); ++i) {
    const RawReturn& a = scan.raw[i - 1];
    const RawReturn& b = scan.raw[i];
    if (a.sequence != b.sequence || a.laser != b.laser) continue;
    ++pairs;
    EXPECT_NE(a.last, b.last);
    EXPECT_EQ(b.last, b.range > a.range);
  }
  EXPECT_GT(pairs, 10U);
}

TEST(ScannerTest, TheRobotsBodyIsSeenOnRequestAndInPlace) {
  ScannerOptions options;
  options.robot_body = true;
  Studio studio(room(), "trot", options);
  const SimulatedScan scan = studio.scanner.scan(30);
  std::size_t body = 0;
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    if (scan.labels[i] != kLabelRobot) continue;
    ++body;
    EXPECT_LT(scan.scan.points[i].norm(), 0.9F);
    EXPECT_LT(scan.scan.points[i].z(), 0.0F);
  }
  EXPECT_GT(body, 20U);
}

TEST(ScannerTest, AMovingBoxIsMetWhereItIsAtThatInstant) {
  Scene scene = room();
  MovingObject box;
  constexpr double kSpeed = 10.0;
  box.mesh.add_box({-0.5, -0.5, 0.0}, {0.5, 0.5, 3.0}, Material::concrete);
  box.T_map_object = [](double time) {
    return Pose{Eigen::Quaterniond::Identity(), {6.0, kSpeed * (time - 0.35), 0.0}};
  };
  scene.moving.push_back(box);
  ScannerOptions options;
  options.footprint = false;
  Studio studio(std::move(scene), "still", options);
  std::size_t met = 0;
  for (const std::uint64_t index : {0, 1, 2, 3, 4, 5, 6}) {
    const SimulatedScan scan = studio.scanner.scan(index);
    for (std::size_t i = 0; i < scan.labels.size(); ++i) {
      if (scan.labels[i] != kLabelMoving) continue;
      ++met;
      const double y = kSpeed * (instant(scan, i, options) - 0.35);
      const Eigen::Vector3d local = scan.true_points[i] - Eigen::Vector3d(6.0, y, 0.0);
      EXPECT_NEAR(std::max(std::abs(local.x()), std::abs(local.y())), 0.5, 1e-4);
    }
  }
  EXPECT_GT(met, 200U);
}

}  // namespace
}  // namespace surefoot::simulation::test
