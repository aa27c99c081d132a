// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Ouster's decoder on returns of made packets: place, time, intensity and ring as the maker's SDK
// has them; which columns count; metadata.
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
using test::time_of;

constexpr double kOusterDegree = M_PI / 180.0;

struct OusterCase {
  const char* profile;
  std::size_t pixel_bytes;
  bool legacy;
  unsigned unit_mm;
};
const OusterCase kOusterCases[] = {{"LEGACY", 12, true, 1},
                                   {"RNG19_RFL8_SIG16_NIR16", 12, false, 1},
                                   {"RNG19_RFL8_SIG16_NIR16_DUAL", 16, false, 1},
                                   {"RNG15_RFL8_NIR8", 4, false, 8},
                                   {"RNG15_RFL8_WIN8", 4, false, 8},
                                   {"RNG15_RFL8_NIR8_DUAL", 8, false, 8},
                                   {"FIVE_WORD_PIXEL", 20, false, 1}};

TEST(Ouster, AReturnInEveryProfile) {
  for (const OusterCase& one : kOusterCases) {
    for (const bool old_form : {false, true}) {
      SCOPED_TRACE(one.profile);
      auto packet = test::ouster_packet(one.pixel_bytes, one.legacy, 700, 16, 5'000'000'000);
      const std::size_t at = test::ouster_pixel(one.pixel_bytes, one.legacy, 4, 1);
      test::put(packet, at, static_cast<std::uint16_t>(10'000 / one.unit_mm));
      DecoderOptions options;
      options.metadata = test::ouster_json(one.profile, old_form);
      const Firings firings = decode(packet, "OS-1-16", options);
      ASSERT_EQ(firings.points.size(), 1U);
      EXPECT_EQ(firings.time_ns, 5'000'000'000);
      EXPECT_EQ(time_of(firings, 0), 4 * 1'562'500);
      EXPECT_EQ(firings.firings[4].frame, 700U);
      // Column 20 of 64, altitude 13 deg, azimuth -1 deg; the lidar looks backwards, 36 mm up.
      const double encoder = 2.0 * M_PI * (1.0 - 20.0 / 64.0);
      const double along = 10.0 - 0.0158;
      const double angle = encoder + 1.0 * kOusterDegree;
      const double flat = along * std::cos(13.0 * kOusterDegree);
      const Eigen::Vector3d expected(-(flat * std::cos(angle) + 0.0158 * std::cos(encoder)),
                                     -(flat * std::sin(angle) + 0.0158 * std::sin(encoder)),
                                     along * std::sin(13.0 * kOusterDegree) + 0.036);
      EXPECT_LT((firings.points[0].position.cast<double>() - expected).norm(), 2e-6);
      EXPECT_EQ(firings.points[0].ring, 14);
    }
  }
}

// The short metadata of early files; the maker's SDK takes 36.18 mm for them.
TEST(Ouster, MetadataWithoutTheLidarsPlaceOnTheSensor) {
  auto packet = test::ouster_packet(12, true, 700, 16, 5'000'000'000);
  test::put(packet, test::ouster_pixel(12, true, 4, 1), std::uint16_t{10'000});
  DecoderOptions options;
  options.metadata = test::ouster_json("LEGACY", true);
  const Firings given = decode(packet, "OS-1-16", options);
  const std::size_t key = options.metadata.find("lidar_to_sensor_transform");
  options.metadata.replace(key, 5, "other");
  const Firings assumed = decode(packet, "OS-1-16", options);
  ASSERT_EQ(assumed.points.size(), 1U);
  const Eigen::Vector3f higher = assumed.points[0].position - given.points[0].position;
  EXPECT_LT((higher - Eigen::Vector3f(0.0F, 0.0F, 0.00018F)).norm(), 2e-6F);
}

/// An OS1's metadata whose key this is the first that stands there instead.
Eigen::Vector3d ouster_point(const std::string& key, const std::string& value) {
  auto packet = test::ouster_packet(12, true, 700, 0, 5'000'000'000);
  test::put(packet, test::ouster_pixel(12, true, 0, 7), std::uint16_t{10'000});  // 1 deg, +1 deg
  DecoderOptions options;
  options.metadata = test::ouster_json("LEGACY");
  const std::string origin = "\"lidar_origin_to_beam_origin_mm\": 15.8";
  options.metadata.replace(options.metadata.find(origin), origin.size(),
                           '"' + key + "\": " + value);
  return decode(packet, "OS-1-16", options).points.at(0).position.cast<double>();
}

/// In front of the lidar, which looks backwards and stands 36 mm up; [m] of the beams' origin.
Eigen::Vector3d ouster_point_at(double along, double out, double up) {
  const double flat = along * std::cos(kOusterDegree);
  return {-(flat * std::cos(-kOusterDegree) + out), -flat * std::sin(-kOusterDegree),
          along * std::sin(kOusterDegree) + up + 0.036};
}

// As the maker's SDK has it: a range counts from the lidar's origin, whose distance to the beams'
// is taken off.
TEST(Ouster, WhereItsBeamsBegin) {
  const Eigen::Vector3d told = ouster_point("lidar_origin_to_beam_origin_mm", "27.67");
  EXPECT_LT((told - ouster_point_at(10.0 - 0.02767, 0.02767, 0.0)).norm(), 2e-6);
  const Eigen::Vector3d untold = ouster_point("nothing", "0");
  EXPECT_LT((untold - ouster_point_at(10.0 - 0.012163, 0.012163, 0.0)).norm(), 2e-6);
  const Eigen::Vector3d higher =
      ouster_point("beam_to_lidar_transform", "[1, 0, 0, 15, 0, 1, 0, 0, 0, 0, 1, 20, 0, 0, 0, 1]");
  EXPECT_LT((higher - ouster_point_at(10.0 - 0.025, 0.015, 0.020)).norm(), 2e-6);
}

TEST(Ouster, AColumnThatSaysThatItIsNoneIsLeftOut) {
  const auto columns = [](bool legacy, std::size_t at, const std::string& bytes) {
    auto packet = test::ouster_packet(12, legacy, 700, 0, 5'000'000'000);
    test::put_bytes(packet, at, bytes);
    DecoderOptions options;
    options.metadata = test::ouster_json(legacy ? "LEGACY" : "RNG19_RFL8_SIG16_NIR16");
    return decode(packet, "OS-1-16", options).firings.size();
  };
  const std::size_t third = test::ouster_pixel(12, true, 3, 0) - 16;
  EXPECT_EQ(columns(true, third, test::little(5'003'000'000ULL)), 16U);
  EXPECT_EQ(columns(true, third, test::little(4'999'999'999ULL)), 15U) << "before the first";
  EXPECT_EQ(columns(true, third, test::little(5'300'000'000ULL)), 15U) << "long after it";
  EXPECT_EQ(columns(true, third + 8, test::little(std::uint16_t{64})), 15U) << "no such column";
  EXPECT_EQ(columns(true, third + 16 + 16 * 12, test::little(1U)), 15U) << "neither valid nor not";
  const std::size_t status = test::ouster_pixel(12, false, 3, 0) - 2;
  EXPECT_EQ(columns(false, status, test::little(std::uint16_t{0})), 15U);
}

// Four packets a turn, whose number has 16 bits; of a window nobody knows how many are sent.
TEST(Ouster, PacketsAreNumberedWhereAllColumnsAreSent) {
  const auto packet = test::ouster_packet(12, false, 700, 32, 5'000'000'000);
  DecoderOptions options;
  options.metadata = test::ouster_json("RNG19_RFL8_SIG16_NIR16");
  const Firings all = decode(packet, "OS-1-16", options);
  EXPECT_EQ(all.number, 700U * 4 + 2);
  EXPECT_EQ(all.numbers, 65'536U * 4);
  options.metadata.replace(options.metadata.find("[0, 63]"), 7, "[0, 47]");
  EXPECT_EQ(decode(packet, "OS-1-16", options).numbers, 0U);
}

TEST(Ouster, TheStrongerOfTwoReturns) {
  auto packet = test::ouster_packet(16, false, 1, 0, 1000);
  const std::size_t at = test::ouster_pixel(16, false, 0, 0);
  test::put(packet, at, std::uint16_t{4000});
  test::put(packet, at + 4, std::uint16_t{9000});
  test::put(packet, at + 8, std::uint16_t{50});
  test::put(packet, at + 10, std::uint16_t{20});
  DecoderOptions options;
  options.metadata = test::ouster_json("RNG19_RFL8_SIG16_NIR16_DUAL");
  const auto intensities = [&](ReturnChoice choice) {
    options.returns = choice;
    std::vector<float> values;
    for (const FiringPoint& point : decode(packet, "OS-1-16", options).points) {
      values.push_back(point.intensity);
    }
    return values;
  };
  EXPECT_EQ(intensities(ReturnChoice::strongest), std::vector<float>{50.0F});
  EXPECT_EQ(intensities(ReturnChoice::last), std::vector<float>{20.0F});
  EXPECT_EQ(intensities(ReturnChoice::both), (std::vector<float>{50.0F, 20.0F}));
}

TEST(Ouster, MetadataThatIsNoneIsNamed) {
  const auto packet = test::ouster_packet(12, true, 1, 0, 1000);
  const std::string good = test::ouster_json("LEGACY");
  std::string reason;
  EXPECT_EQ(find_decoder(bytes_of(packet), "", {}, reason), nullptr);
  EXPECT_NE(reason.find("--calibration"), std::string::npos) << reason;
  const auto message_of = [&](const std::string& json) {
    DecoderOptions options;
    options.calibration = json;
    return io::test::message_of<CalibrationError>(
        [&] { (void)find_decoder(bytes_of(packet), "", options, reason); });
  };
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string json = good;
    return json.replace(json.find(from), from.size(), to);
  };
  EXPECT_EQ(message_of(good), "");
  EXPECT_NE(message_of("no json").find("JSON"), std::string::npos);
  EXPECT_NE(message_of("[1]").find("JSON"), std::string::npos);
  EXPECT_NE(message_of(replaced("64x10", "fast")).find("lidar_mode"), std::string::npos);
  EXPECT_NE(message_of(replaced("\"columns_per_packet\": 16", "\"columns_per_packet\": 1000000000"))
                .find("columns_per_packet"),
            std::string::npos);
  EXPECT_NE(message_of(replaced("\"columns_per_packet\": 16", "\"columns_per_packet\": 15"))
                .find("15 columns"),
            std::string::npos);
  EXPECT_NE(message_of(replaced("LEGACY", "FUSA")).find("FUSA"), std::string::npos);
  EXPECT_NE(message_of(replaced("[15, ", "[")).find("15 altitude"), std::string::npos);
  EXPECT_NE(message_of(replaced("[15, ", "[\"x\", ")).find("altitude"), std::string::npos);
  EXPECT_NE(message_of(replaced("[0, 63]", "[0, 64]")).find("window"), std::string::npos);
  EXPECT_NE(message_of(replaced("36, 0, 0, 0, 1]", "36]")).find("4 x 4"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::sensors
