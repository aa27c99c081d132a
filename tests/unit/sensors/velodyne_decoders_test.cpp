// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Velodyne's decoders on single returns of made packets: place, time, intensity and ring from the
// manuals' formulae and a few values of their tables.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "sensors/sensor_list.hpp"
#include "sensors/velodyne/velodyne_decoder.hpp"
#include "unit/sensors/decoded.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::sensors {
namespace {

using test::bytes_of;
using test::decode;
using test::expect_at;
using test::plain_options;
using test::time_of;
using test::turning;

constexpr double kVelodyneDegree = M_PI / 180.0;

TEST(Vlp32, AReturnOfASecondLaserOfAPair) {
  auto packet = test::velodyne_packet({0xeeff}, turning(9000, 20, 1), 7, 0x37, 0x28);
  test::set_velodyne(packet, 3, 9, 2500, 77);  // laser 9: 0.333 deg, azimuth offset -4.2 deg
  const Firings firings = decode(packet, "VLP-32C", plain_options());
  ASSERT_EQ(firings.points.size(), 1U);
  EXPECT_EQ(firings.time_ns, 7000);
  EXPECT_EQ(time_of(firings, 0), 3 * 55'296 + 4 * 2'304);
  expect_at(firings.points[0], 10.0, 90.6 + 0.2 * 4 * 2.304 / 55.296 - 4.2, 0.333);
  EXPECT_EQ(firings.points[0].intensity, 77.0F);
  EXPECT_EQ(firings.points[0].ring, 21);  // 21 lasers lie lower
}

// The lowest laser of each. Heights of the Puck Hi-Res' and the HDL-32E's as drawings 86-0129 and
// 86-0106 have them.
TEST(Velodyne, BeamsStartAtTheirHeightOnTheAxis) {
  struct Lowest {
    const char* sensor;
    unsigned product;
    std::size_t block, channel;
    double height;
  };
  const Lowest sensors[] = {{"Puck Hi-Res", 0x24, 0, 0, 0.0074},
                            {"VLP-32C", 0x28, 0, 0, 0.0424 * std::tan(25.0 * kVelodyneDegree)},
                            {"HDL-32E", 0x21, 0, 0, 0.01717},
                            {"VLS-128", 0xa1, 1, 4, 0.05863 * std::tan(25.0 * kVelodyneDegree)}};
  for (const Lowest& one : sensors) {
    const bool has_banks = one.product == 0xa1;
    std::vector<std::uint16_t> flags = {0xeeff};
    if (has_banks) flags = {0xeeff, 0xddff, 0xccff, 0xbbff};
    auto packet =
        test::velodyne_packet(flags, turning(0, 20, has_banks ? 4 : 1), 0, 0x37, one.product);
    test::set_velodyne(packet, one.block, one.channel, 2500, 1);
    const FiringPoint with = decode(packet, one.sensor).points.at(0);
    const FiringPoint without = decode(packet, one.sensor, plain_options()).points.at(0);
    EXPECT_EQ(with.ring, 0) << one.sensor;
    EXPECT_NEAR(with.position.z() - without.position.z(), one.height, 2e-5) << one.sensor;
  }
}

TEST(Hdl32, LasersFireOneAfterTheOther) {
  auto packet = test::velodyne_packet({0xeeff}, turning(35900, 16, 1), 0, 0x37, 0x21);
  test::set_velodyne(packet, 2, 31, 5000, 3);  // the last laser: 10.67 deg
  const Firings firings = decode(packet, "HDL-32E", plain_options());
  ASSERT_EQ(firings.points.size(), 1U);
  EXPECT_EQ(time_of(firings, 0), 2 * 46'080 + 31 * 1'152);
  expect_at(firings.points[0], 10.0, 359.32 + 0.16 * 31 * 1.152 / 46.08, 10.67);
  EXPECT_EQ(firings.points[0].ring, 31);
}

/// One of an HDL-32E by its factory byte. `distance`: of a channel of a block [2 mm].
template <typename Distance>
std::string measured_packet(Distance&& distance) {
  auto packet = test::velodyne_packet({0xeeff}, turning(100, 40, 1), 0, 0x37, 0x21);
  for (unsigned block = 0; block < 12; ++block) {
    for (unsigned channel = 0; channel < 32; ++channel) {
      test::set_velodyne(packet, block, channel, distance(block, channel), 50);
    }
  }
  return packet;
}

std::string model_of(const std::string& packet) {
  std::string reason;
  const auto model = find_velodyne_model(std::as_bytes(std::span(packet)), reason);
  return model ? model->name : reason;
}

// Captures of 2014 have 0x21 in a VLP-16's packets. Its lasers fire twice in a block.
TEST(Vlp16, AnOldOneThatCallsItselfAnHdl32IsKnownByItsLasers) {
  const auto lasers = [](unsigned times, unsigned noise) {
    return [=](unsigned block, unsigned channel) {
      return static_cast<std::uint16_t>(2000 + 150 * (channel % times) + 7 * block +
                                        noise * (channel / times));
    };
  };
  EXPECT_EQ(model_of(measured_packet(lasers(16, 15))), "VLP-16");
  EXPECT_EQ(model_of(measured_packet(lasers(32, 0))), "HDL-32E");
  EXPECT_EQ(model_of(measured_packet(lasers(16, 200))), "HDL-32E") << "not alike";
  const auto few = [&](unsigned block, unsigned channel) {
    return block == 0 ? lasers(16, 15)(block, channel) : std::uint16_t{0};
  };
  EXPECT_EQ(model_of(measured_packet(few)), "HDL-32E") << "too few pairs to tell";
  // Whatever the factory byte says, its packets are then read.
  const std::string packet = measured_packet(lasers(16, 15));
  DecoderOptions options;
  std::string reason;
  const auto decoder = find_decoder(std::as_bytes(std::span(packet)), "", options, reason);
  ASSERT_NE(decoder, nullptr);
  Firings firings;
  EXPECT_EQ(decoder->decode(std::as_bytes(std::span(packet)), firings), PacketKind::data);
  EXPECT_EQ(firings.firings.size(), 24U);
  EXPECT_EQ(named_sensor(std::as_bytes(std::span(packet))), "") << "--sensor contradicts nothing";
}

TEST(Vls128, BanksAndGroupsOfEight) {
  auto packet = test::velodyne_packet({0xeeff, 0xddff, 0xccff, 0xbbff}, turning(1000, 20, 4), 100,
                                      0x38, 0xa1);
  test::set_velodyne(packet, 4 + 2, 1, 2500, 9);  // second sequence, laser 65: group 8
  const Firings firings = decode(packet, "VLS-128", plain_options());
  ASSERT_EQ(firings.points.size(), 1U);
  EXPECT_EQ(time_of(firings, 0), -8'700 + 53'300 + 2'665 * 9);
  EXPECT_NEAR(firings.points[0].position.norm(), 10.0, 1e-5);
  EXPECT_EQ(firings.firings.size(), 3U);
  EXPECT_NEAR(firings.firings[1].azimuth_deg, 10.2, 1e-9);
}

// Firmware since 5.2.3 fires more slowly; packets say so by their times alone.
TEST(Vls128, ItsPaceIsToldByPacketsThatFollowEachOther) {
  const auto time_after = [](std::uint32_t since_us) {
    std::string reason;
    std::unique_ptr<PacketDecoder> decoder;
    Firings firings;
    for (std::uint32_t i = 0; i < 3; ++i) {
      auto packet = test::velodyne_packet({0xeeff, 0xddff, 0xccff, 0xbbff},
                                          turning(1000 + 60 * i, 20, 4), i * since_us, 0x38, 0xa1);
      test::set_velodyne(packet, 4 + 2, 1, 2500, 9);  // as above
      if (!decoder) decoder = find_decoder(bytes_of(packet), "", {}, reason);
      EXPECT_EQ(decoder->decode(bytes_of(packet), firings), PacketKind::data);
    }
    return time_of(firings, 0);
  };
  EXPECT_EQ(time_after(160), -8'700 + 53'300 + 2'665 * 9);
  EXPECT_EQ(time_after(173), -8'700 + 57'800 + 2'890 * 9);
  EXPECT_EQ(time_after(2 * 173), -8'700 + 53'300 + 2'665 * 9) << "every other one was lost";
}

// Two returns: blocks of one bank follow each other, and the last four are not used, whatever is in
// them.
std::string vls128_dual_packet(std::uint16_t unused) {
  std::vector<unsigned> azimuths(12, 1000);
  auto packet = test::velodyne_packet({0xeeff, 0xeeff, 0xddff, 0xddff, 0xccff, 0xccff, 0xbbff,
                                       0xbbff, unused, unused, unused, unused},
                                      azimuths, 100, 0x39, 0xa1);
  for (std::size_t block = 8; block < 12; ++block) test::put(packet, 100 * block + 2, unused);
  test::set_velodyne(packet, 9, 5, 2500, 9);
  return packet;
}

TEST(Vls128, UnusedBlocksOfADualReturnAreNoData) {
  for (const std::uint16_t unused : {std::uint16_t{0}, std::uint16_t{0xffff}}) {
    auto packet = vls128_dual_packet(unused);
    EXPECT_EQ(model_of(packet), "VLS-128");
    test::set_velodyne(packet, 2, 5, 2500, 9);
    EXPECT_EQ(decode(packet, "VLS-128").points.size(), 1U);
    packet[1204] = 0x37;  // of one return they would be in use
    EXPECT_EQ(model_of(packet), "");
  }
}

TEST(Vls128, DualReturn) {
  auto packet = vls128_dual_packet(0xffff);
  test::set_velodyne(packet, 2, 5, 2500, 9);
  test::set_velodyne(packet, 3, 5, 1000, 200);
  DecoderOptions options = plain_options();
  EXPECT_NEAR(decode(packet, "VLS-128", options).points.at(0).position.norm(), 4.0, 1e-5);
  options.returns = ReturnChoice::last;
  EXPECT_NEAR(decode(packet, "VLS-128", options).points.at(0).position.norm(), 10.0, 1e-5);
  options.returns = ReturnChoice::both;
  EXPECT_EQ(decode(packet, "VLS-128", options).points.size(), 2U);
}

// Without corrections an HDL-64E's laser is where its angles say; the stamp is the packet's end.
TEST(Hdl64, ACalibrationFileAndTimesBeforeTheStamp) {
  std::string yaml = "lasers:\n";
  for (int id = 0; id < 64; ++id) {
    yaml += "- {laser_id: " + std::to_string(id) +
            ", rot_correction: -0.1, vert_correction: 0.2, dist_correction: 0.5, "
            "vert_offset_correction: 0.1, horiz_offset_correction: 0.02}\n";
  }
  auto packet = test::velodyne_packet({0xeeff, 0xddff}, turning(27000, 18, 2), 5'000, 'V', 0x01);
  test::set_velodyne(packet, 11, 31, 4750, 50);  // the very last firing
  DecoderOptions options;
  options.calibration = yaml;
  const Firings firings = decode(packet, "HDL-64E-S3", options);
  ASSERT_EQ(firings.points.size(), 1U);
  EXPECT_EQ(time_of(firings, 0), -2'340);
  const double azimuth =
      270.9 * kVelodyneDegree + 0.1 + 0.18 * kVelodyneDegree * (48.0 - 2.34) / 48.0;
  const double flat = 10.0 * std::cos(0.2) - 0.1 * std::sin(0.2);
  const Eigen::Vector3f& point = firings.points[0].position;
  EXPECT_NEAR(point.x(), flat * std::cos(azimuth) + 0.02 * std::sin(azimuth), 1e-5);
  EXPECT_NEAR(point.y(), -(flat * std::sin(azimuth) - 0.02 * std::cos(azimuth)), 1e-5);
  EXPECT_NEAR(point.z(), 10.0 * std::sin(0.2) + 0.1 * std::cos(0.2), 1e-5);
  options.beam_origins = false;  // where its beams begin is what its file says
  EXPECT_EQ(decode(packet, "HDL-64E-S3", options).points.at(0).position,
            firings.points[0].position);
}

// VeloView: with two returns lasers are 7.2 us apart and the last one fires 3.5 us before the
// stamp.
TEST(Hdl64, TimesOfTwoReturns) {
  auto packet = test::velodyne_packet({0xeeff, 0xddff}, turning(27000, 18, 4), 5'000, 'V', 0x01);
  test::set_velodyne(packet, 8, 0, 2500, 50);
  test::set_velodyne(packet, 9, 31, 2500, 50);
  const Firings firings = decode(packet, "HDL-64E-S3", plain_options());
  ASSERT_EQ(firings.points.size(), 2U);
  EXPECT_EQ(time_of(firings, 0), -57'600);
  EXPECT_EQ(time_of(firings, 1), -3'500);
}

TEST(Hdl64, BrokenCalibrationsAreRefused) {
  const auto packet = test::velodyne_packet({0xeeff, 0xddff}, turning(0, 18, 2), 0, 'V', 1);
  std::string reason;
  for (const char* yaml : {"lasers: [{laser_id: 1}]", "lasers: 3", "[", "a: b", "\x01\x02"}) {
    DecoderOptions options;
    options.calibration = yaml;
    EXPECT_THROW((void)find_decoder(bytes_of(packet), "", options, reason), CalibrationError)
        << yaml;
  }
}

}  // namespace
}  // namespace surefoot::sensors
