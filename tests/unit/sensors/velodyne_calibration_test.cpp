// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Calibration files of Velodynes whose lasers have one firing sequence.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "sensors/sensor_list.hpp"
#include "unit/sensors/decoded.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::sensors {
namespace {

using test::bytes_of;
using test::decode;
using test::turning;

/// A VLP-16's calibration, laser by laser.
DecoderOptions calibrated(const std::vector<std::string>& ids, const std::string& corrections) {
  DecoderOptions options;
  options.calibration = "lasers:\n";
  for (const std::string& id : ids) {
    options.calibration +=
        "- {laser_id: " + id + ", rot_correction: -0.1, vert_correction: 0.2" + corrections + "}\n";
  }
  return options;
}

std::vector<std::string> sixteen_ids() {
  std::vector<std::string> ids;
  for (int id = 0; id < 16; ++id) ids.push_back(std::to_string(id));
  return ids;
}

std::string vlp16_packet() {
  auto packet = test::velodyne_packet({0xeeff}, turning(9000, 40, 1), 0, 0x37, 0x22);
  test::set_velodyne(packet, 0, 0, 4750, 1);  // 9.5 m
  return packet;
}

TEST(VelodyneCalibration, MovesPointsByAllThatItCorrects) {
  const DecoderOptions options = calibrated(
      sixteen_ids(),
      ", dist_correction: 0.5, vert_offset_correction: 0.1, horiz_offset_correction: 0.02");
  const Eigen::Vector3f point = decode(vlp16_packet(), "VLP-16", options).points.at(0).position;
  // As rawdata.cc of the ROS driver has it, for every Velodyne.
  const double azimuth = 0.5 * M_PI + 0.1;
  const double flat = 10.0 * std::cos(0.2) - 0.1 * std::sin(0.2);
  EXPECT_NEAR(point.x(), flat * std::cos(azimuth) + 0.02 * std::sin(azimuth), 1e-5);
  EXPECT_NEAR(point.y(), -(flat * std::sin(azimuth) - 0.02 * std::cos(azimuth)), 1e-5);
  EXPECT_NEAR(point.z(), 10.0 * std::sin(0.2) + 0.1 * std::cos(0.2), 1e-5);
}

// The files that come with the ROS driver have zeros there.
TEST(VelodyneCalibration, HeightsOfTheModelStayWhereTheFileKnowsNone) {
  const Eigen::Vector3f point =
      decode(vlp16_packet(), "VLP-16", calibrated(sixteen_ids(), ", vert_offset_correction: 0.0"))
          .points.at(0)
          .position;
  EXPECT_NEAR(point.z(), 9.5 * std::sin(0.2) + 0.0112, 1e-5);
}

TEST(VelodyneCalibration, BeamsOfOneOriginHaveNoHeightsOfTheFileEither) {
  auto options = calibrated(sixteen_ids(), ", vert_offset_correction: 0.1");
  options.beam_origins = false;
  const Eigen::Vector3f point = decode(vlp16_packet(), "VLP-16", options).points.at(0).position;
  EXPECT_NEAR(point.z(), 9.5 * std::sin(0.2), 1e-5);
}

// Files of an HDL-64E have them; some leave out the flag.
TEST(VelodyneCalibration, CorrectionsAtTwoPointsCountUnlessTheFileSaysNo) {
  const std::string two = ", dist_correction: 0.5, dist_correction_x: 0.4, dist_correction_y: 0.3";
  const auto with = [&](const std::string& flag) {
    const DecoderOptions options = calibrated(sixteen_ids(), two + flag);
    return decode(vlp16_packet(), "VLP-16", options).points.at(0).position;
  };
  const Eigen::Vector3f yes = with(", two_pt_correction_available: true");
  EXPECT_EQ(with(""), yes);
  EXPECT_NE(with(", two_pt_correction_available: false"), yes);
}

TEST(VelodyneCalibration, ADistanceUnitThatIsNoneOfVelodynesIsLeftOut) {
  const auto range = [&](const std::string& unit) {
    DecoderOptions options = calibrated(sixteen_ids(), "");
    options.calibration += "distance_resolution: " + unit + "\n";
    options.beam_origins = false;
    return decode(vlp16_packet(), "VLP-16", options).points.at(0).position.norm();
  };
  EXPECT_NEAR(range("0.002"), 9.5, 1e-4);
  EXPECT_NEAR(range("0.004"), 19.0, 1e-4);
  EXPECT_NEAR(range("2.0"), 9.5, 1e-4);
  EXPECT_NEAR(range("0.0"), 9.5, 1e-4);
}

TEST(VelodyneCalibration, EveryLaserIsNamedOnce) {
  std::string reason;
  const auto error_with = [&](std::size_t which, const std::string& id) {
    std::vector<std::string> ids = sixteen_ids();
    ids[which] = id;
    return io::test::message_of<CalibrationError>(
        [&] { (void)find_decoder(bytes_of(vlp16_packet()), "", calibrated(ids, ""), reason); });
  };
  EXPECT_EQ(error_with(3, "3"), "");
  EXPECT_NE(error_with(3, "4").find("laser 4"), std::string::npos);
  EXPECT_NE(error_with(3, "3.5").find("3.5"), std::string::npos);
  EXPECT_NE(error_with(3, "16").find("16"), std::string::npos);
  EXPECT_NE(error_with(3, "-1").find("-1"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::sensors
