// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Every sensor's decoder but Velodyne's on single returns of made packets: place, time, intensity
// and ring from the manuals' formulae and a few values of their tables.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "sensors/calendar.hpp"
#include "sensors/sensor_list.hpp"
#include "unit/sensors/decoded.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::sensors {
namespace {

using test::bytes_of;
using test::decode;
using test::time_of;
using test::turning;

constexpr double kDegree = M_PI / 180.0;

// Elevation and azimuth offset of the first channel, and its firing after the last block's time:
// the PandarQT128's as udp3_2_parser.cc of Hesai's SDK 2.0 counts it, forward from the packet's.
struct HesaiFacts {
  double elevation, azimuth;
  std::int64_t last_block_ns;
  double channel_us;
};

TEST(Hesai, AReturnOfTheFirstChannelInTheLastBlock) {
  const HesaiFacts facts[] = {
      {15.0, 0.0, 5'632, 0.368},           {14.9724, 0.0824, 5'632, 0.368},
      {19.407, 0.094, 5'632, 0.368},       {-52.121, 8.736, 525'710, 12.31},
      {-52.6268, 10.1083, 120'110, 2.312}, {14.794, -1.042, -28'580, -42.22},
      {14.9, -1.042, -42'580, -23.18}};
  for (std::size_t i = 0; i < test::hesai_layouts().size(); ++i) {
    const test::HesaiLayout& layout = test::hesai_layouts()[i];
    SCOPED_TRACE(layout.name);
    auto packet = test::hesai_packet(layout, 4500, 40, 1, 0x37, 123'456, 9);
    test::set_hesai(packet, layout, layout.blocks - 1, 0, 2500, 33);
    const Firings firings = decode(packet, layout.name);
    ASSERT_EQ(firings.points.size(), 1U);
    EXPECT_EQ(firings.time_ns, 1'673'403'349'123'456'000);
    EXPECT_EQ(firings.numbers, layout.sequence > 0 ? 1ULL << 32U : 0U);
    EXPECT_EQ(time_of(firings, 0),
              facts[i].last_block_ns + std::llround(1000 * facts[i].channel_us));
    const Firing& last = firings.firings.back();
    const double turn = 0.4 * 1000.0 * facts[i].channel_us / static_cast<double>(last.duration_ns);
    const double azimuth =
        (45.0 + 0.4 * double(layout.blocks - 1) + turn + facts[i].azimuth) * kDegree;
    const double elevation = facts[i].elevation * kDegree;
    const Eigen::Vector3d expected(10.0 * std::cos(elevation) * std::sin(azimuth),
                                   10.0 * std::cos(elevation) * std::cos(azimuth),
                                   10.0 * std::sin(elevation));
    EXPECT_LT((firings.points[0].position.cast<double>() - expected).norm(), 2e-5);
    EXPECT_EQ(firings.points[0].intensity, 33.0F);
  }
}

TEST(Hesai, TwoReturnsShareAnAzimuth) {
  for (const test::HesaiLayout& layout : test::hesai_layouts()) {
    SCOPED_TRACE(layout.name);
    auto packet = test::hesai_packet(layout, 4500, 40, 2, 0x39, 0, 0);
    test::set_hesai(packet, layout, 0, 5, 2500, 33);
    test::set_hesai(packet, layout, 1, 5, 1000, 200);
    DecoderOptions options;
    EXPECT_NEAR(decode(packet, layout.name, options).points.at(0).position.norm(), 4.0, 1e-5);
    options.returns = ReturnChoice::last;
    EXPECT_NEAR(decode(packet, layout.name, options).points.at(0).position.norm(), 10.0, 1e-5);
    options.returns = ReturnChoice::both;
    const Firings both = decode(packet, layout.name, options);
    EXPECT_EQ(both.points.size(), 2U);
    EXPECT_EQ(both.firings.size(), layout.blocks / 2);
  }
}

TEST(Hesai, ContradictionsAreMalformed) {
  const test::HesaiLayout& layout = test::hesai_layouts().front();
  const std::string good = test::hesai_packet(layout, 0, 18, 1, 0x37, 0, 0);
  std::string reason;
  const auto decoder = find_decoder(bytes_of(good), "", {}, reason);
  ASSERT_NE(decoder, nullptr);
  const auto kind_of = [&](std::size_t at, char value) {
    std::string packet = good;
    packet[at] = value;
    Firings firings;
    return decoder->decode(bytes_of(packet), firings);
  };
  EXPECT_EQ(kind_of(layout.mode, '\x11'), PacketKind::malformed);
  EXPECT_EQ(kind_of(layout.date + 1, 13), PacketKind::malformed);
  EXPECT_EQ(kind_of(layout.header + 1, '\xff'), PacketKind::malformed);  // 652 deg
  EXPECT_EQ(kind_of(6, 15), PacketKind::other);
}

TEST(Hesai, ACalibrationFileReplacesTheAngles) {
  const test::HesaiLayout& layout = test::hesai_layouts().front();
  auto packet = test::hesai_packet(layout, 0, 18, 1, 0x37, 0, 0);
  test::set_hesai(packet, layout, 7, 15, 2500, 1);
  DecoderOptions options;
  options.calibration = "Laser id,Elevation,Azimuth\n";
  for (int id = 1; id <= 16; ++id) {
    options.calibration += std::to_string(id) + "," + std::to_string(30 - id) + ",0.5\r\n";
  }
  const Eigen::Vector3f at = decode(packet, layout.name, options).points.at(0).position;
  EXPECT_NEAR(std::asin(at.z() / at.norm()) / kDegree, 14.0, 1e-4);
  const std::string good = options.calibration;
  std::string reason;
  const auto expect_refused = [&](const std::string& calibration) {
    options.calibration = calibration;
    EXPECT_THROW((void)find_decoder(bytes_of(packet), "", options, reason), CalibrationError)
        << calibration;
  };
  expect_refused(good + "17,0,0\n");
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  expect_refused(replaced("\n3,27,", "\n3,95,"));  // no elevation: no laser 3
  expect_refused(replaced("\n3,27,", "\n5,27,"));
}

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
      const double angle = encoder + 1.0 * kDegree;
      const double flat = along * std::cos(13.0 * kDegree);
      const Eigen::Vector3d expected(-(flat * std::cos(angle) + 0.0158 * std::cos(encoder)),
                                     -(flat * std::sin(angle) + 0.0158 * std::sin(encoder)),
                                     along * std::sin(13.0 * kDegree) + 0.036);
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
  const double flat = along * std::cos(kDegree);
  return {-(flat * std::cos(-kDegree) + out), -flat * std::sin(-kDegree),
          along * std::sin(kDegree) + up + 0.036};
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

TEST(Livox, PointsOfAllThreeTypes) {
  auto millimetres = test::livox_packet(1'700'000'000'000'000'000, 1, 14);
  test::put(millimetres, 36 + 14 * 6, std::int32_t{-1500});
  test::put(millimetres, 36 + 14 * 6 + 8, std::int32_t{250});
  millimetres[36 + 14 * 6 + 12] = 99;
  const Firings firings = decode(millimetres, "Livox Mid-360");
  ASSERT_EQ(firings.points.size(), 1U);
  EXPECT_EQ(firings.time_ns, 1'700'000'000'000'000'000);
  EXPECT_EQ(time_of(firings, 0), 6 * 5'000);
  EXPECT_EQ(firings.points[0].position, Eigen::Vector3f(-1.5F, 0.0F, 0.25F));
  EXPECT_EQ(firings.points[0].intensity, 99.0F);
  EXPECT_EQ(firings.points[0].ring, 2);

  auto centimetres = test::livox_packet(5, 2, 8);
  test::put(centimetres, 36 + 2, std::int16_t{-300});
  EXPECT_EQ(decode(centimetres, "Livox Mid-360").points.at(0).position,
            Eigen::Vector3f(0.0F, -3.0F, 0.0F));
  auto spherical = test::livox_packet(5, 3, 10);
  test::put(spherical, 36, std::uint32_t{2000});
  test::put(spherical, 36 + 4, std::uint16_t{9000});
  test::put(spherical, 36 + 6, std::uint16_t{9000});
  EXPECT_LT(
      (decode(spherical, "Livox Mid-360").points.at(0).position - Eigen::Vector3f(0.0F, 2.0F, 0.0F))
          .norm(),
      1e-6F);
  std::string reason;
  EXPECT_EQ(find_decoder(bytes_of(test::livox_packet(5, 0, 24)), "", {}, reason), nullptr);
  millimetres[5] = 95;  // fewer points than bytes for them
  EXPECT_EQ(find_decoder(bytes_of(millimetres), "", {}, reason), nullptr);
}

TEST(Rs16, SingleAndDual) {
  auto packet = test::rs16_packet(9000, 40, 5'000);
  test::set_rs16(packet, 2, 16 + 9, 2000, 12);  // the second sequence's laser 9: 13 deg
  std::string reason;
  const auto decoder = find_decoder(bytes_of(packet), "", {}, reason);
  ASSERT_NE(decoder, nullptr) << reason;
  Firings firings;
  ASSERT_EQ(decoder->decode(bytes_of(packet), firings), PacketKind::data);
  ASSERT_EQ(firings.points.size(), 1U);
  EXPECT_EQ(firings.time_ns, 1'673'403'349'005'000'000);
  EXPECT_EQ(time_of(firings, 0), 2 * 111'000 + 55'500 + 9 * 2'800);
  const double azimuth = (90.8 + 0.2 + 0.4 * 25.2 / 111.0) * kDegree;
  const double flat = 10.0 * std::cos(13.0 * kDegree) + 0.03825;
  EXPECT_NEAR(firings.points[0].position.x(), flat * std::cos(azimuth), 1e-5);
  EXPECT_NEAR(firings.points[0].position.y(), -flat * std::sin(azimuth), 1e-5);
  EXPECT_EQ(firings.points[0].ring, 14);
  // Half the time until the next packet: both returns of each firing.
  auto next = test::rs16_packet(9480, 20, 5'666);
  test::set_rs16(next, 1, 0, 1000, 12);
  test::set_rs16(next, 1, 16, 2000, 90);
  ASSERT_EQ(decoder->decode(bytes_of(next), firings), PacketKind::data);
  EXPECT_EQ(decoder->return_mode(), "dual");
  ASSERT_EQ(firings.points.size(), 1U);
  EXPECT_EQ(firings.points[0].intensity, 90.0F);
  EXPECT_EQ(time_of(firings, 0), 55'500);
}

// Packets that are lost leave intervals as of single returns.
TEST(Rs16, DualWherePacketsAreLost) {
  std::string reason;
  const auto decoder = find_decoder(bytes_of(test::rs16_packet(0, 40, 5'000)), "", {}, reason);
  Firings firings;
  double micros = 5'000.0;
  const auto mode_after = [&](double since) {
    micros += since;
    const auto packet = test::rs16_packet(0, 40, static_cast<unsigned>(micros));
    EXPECT_EQ(decoder->decode(bytes_of(packet), firings), PacketKind::data);
    return decoder->return_mode();
  };
  EXPECT_EQ(mode_after(0.0), "single");
  EXPECT_EQ(mode_after(666.0), "dual");
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(mode_after(1332.0), "dual") << i;
    EXPECT_EQ(mode_after(1998.0), "dual") << i;
    EXPECT_EQ(mode_after(666.0), "dual") << i;
  }
  for (int i = 0; i < 20; ++i) (void)mode_after(1332.0);
  EXPECT_EQ(decoder->return_mode(), "single") << "who set it otherwise";
}

TEST(SensorList, NamesInAnyForm) {
  EXPECT_TRUE(is_sensor_name("vlp16"));
  EXPECT_TRUE(is_sensor_name("PANDARXT-32"));
  EXPECT_FALSE(is_sensor_name("vlp17"));
  EXPECT_FALSE(is_sensor_name(""));
  std::string reason;
  const auto packet = test::velodyne_packet({0xeeff, 0xddff}, turning(0, 18, 2), 0, 'V', 1);
  const auto named = find_decoder(bytes_of(packet), "hdl64e-s2", {}, reason);
  ASSERT_NE(named, nullptr);
  EXPECT_EQ(named->sensor(), "HDL-64E-S2");
  EXPECT_EQ(find_decoder(bytes_of(packet), "PandarXT-16", {}, reason), nullptr);
}

TEST(Calendar, YearsAreTakenFromEitherCentury) {
  const auto at = [](unsigned char year, int zero) {
    const std::array<std::byte, 6> date = {std::byte{year}, std::byte{1},  std::byte{11},
                                           std::byte{2},    std::byte{15}, std::byte{49}};
    return unix_seconds(date, zero);
  };
  EXPECT_EQ(at(23, 2000), 1673403349);
  EXPECT_EQ(at(123, 2000), 1673403349);  // as Pandar64s of the field do
  EXPECT_EQ(at(123, 1900), 1673403349);
}

}  // namespace
}  // namespace surefoot::sensors
