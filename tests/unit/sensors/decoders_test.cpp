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

// Whose packets are as large and begin alike.
TEST(Rs16, OtherModelsOfRoboSenseAreRefusedByName) {
  auto packet = test::rs16_packet(9000, 40, 5'000);
  for (const auto& [model, name] : {std::pair{2, "RS-LiDAR-32"}, {3, "RS-Bpearl"}}) {
    packet[30] = static_cast<unsigned char>(model);
    std::string reason;
    EXPECT_EQ(find_decoder(bytes_of(packet), "", {}, reason), nullptr);
    EXPECT_NE(reason.find(name), std::string::npos) << reason;
  }
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

}  // namespace
}  // namespace surefoot::sensors
