// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "io/recording.hpp"
#include "sensors/sensor_list.hpp"
#include "sensors/sweep_cutter.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

using test::bytes_of;
using test::Measured;

using sensors::Sweep;

// A decoder and a cutter, as a recording puts them together.
class Stream {
 public:
  explicit Stream(const OpenOptions& options)
      : options_({options.dual_return, options.beam_origins, {}, {}}),
        cutter_(sensors::SweepEnd::azimuth, options.cut_azimuth_deg, 360.0) {}

  void add(const std::string& payload, std::int64_t stamp_ns, std::int64_t since_last_ns) {
    std::string reason;
    if (!decoder_) decoder_ = sensors::find_decoder(bytes_of(payload), "", options_, reason);
    ASSERT_NE(decoder_, nullptr);
    EXPECT_EQ(decoder_->sensor(), "VLP-16");
    ASSERT_EQ(decoder_->decode(bytes_of(payload), firings_), sensors::PacketKind::data);
    cutter_.add(firings_, stamp_ns, since_last_ns);
  }
  void finish() { cutter_.finish(); }
  std::optional<Sweep> take() { return cutter_.take(); }

 private:
  sensors::DecoderOptions options_;
  std::unique_ptr<sensors::PacketDecoder> decoder_;
  sensors::Firings firings_;
  sensors::SweepCutter cutter_;
};

Scan decode(const std::string& payload, const OpenOptions& options = {}) {
  Stream stream(options);
  stream.add(payload, 1'000'000'000, 0);
  stream.finish();
  return stream.take().value().scan;
}

Measured only(std::size_t block, std::size_t channel, std::size_t at_block,
              std::size_t at_channel) {
  const bool here = block == at_block && channel == at_channel;
  return {static_cast<std::uint16_t>(here ? 5000 : 0), 50};  // 10 m
}

// Every firing of a single-return packet: its place, time and ring from the manual's formulae.
TEST(Vlp16, EveryFiringOfASingleReturnPacket) {
  const int elevations[] = {-15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15};
  OpenOptions options;
  options.beam_origins = false;
  for (std::size_t block = 0; block < 12; ++block) {
    for (std::size_t channel = 0; channel < 32; ++channel) {
      const Scan scan =
          decode(test::vlp16_payload(35000, 40, 0, 0x37,
                                     [&](auto b, auto c) { return only(b, c, block, channel); }),
                 options);
      ASSERT_EQ(scan.points.size(), 1U);
      const std::size_t laser = channel % 16;
      const double in_block_us = 55.296 * double(channel / 16) + 2.304 * double(laser);
      const double azimuth =
          (350.0 + 0.4 * double(block) + 0.4 * in_block_us / 110.592) * M_PI / 180.0;
      const double elevation = elevations[laser] * M_PI / 180.0;
      EXPECT_EQ(scan.times_ns[0], std::lround(1000 * (110.592 * double(block) + in_block_us)));
      EXPECT_NEAR(scan.points[0].x(), 10.0 * std::cos(elevation) * std::cos(azimuth), 2e-6);
      EXPECT_NEAR(scan.points[0].y(), -10.0 * std::cos(elevation) * std::sin(azimuth), 2e-6);
      EXPECT_NEAR(scan.points[0].z(), 10.0 * std::sin(elevation), 2e-6);
      EXPECT_EQ(scan.rings[0], (elevations[laser] + 15) / 2);
      EXPECT_EQ(scan.intensities[0], 50.0F);
    }
  }
}

TEST(Vlp16, VerticalCorrectionIsTheLasersOwnHeight) {
  const auto measure = [](auto block, auto channel) { return only(block, channel, 0, 0); };
  OpenOptions without;
  without.beam_origins = false;
  const std::string payload = test::vlp16_payload(0, 40, 0, 0x37, measure);
  EXPECT_NEAR(decode(payload).points[0].z() - decode(payload, without).points[0].z(),
              -0.04191 * std::tan(-15.0 * M_PI / 180.0), 5e-5);
}

// Two blocks of one azimuth: the last return, then the strongest or the second strongest.
TEST(Vlp16, DualReturnChoicesAndTimes) {
  const auto measure = [](std::size_t block, std::size_t channel) {
    const bool odd = block % 2 == 1;
    switch (channel) {
      case 0:
        return odd ? Measured{1000, 90} : Measured{2000, 10};  // the near one is stronger
      case 1:
        return odd ? Measured{1000, 10} : Measured{2000, 90};  // the last is the strongest
      case 2:
        return Measured{1500, 40};  // one return alone
      case 3:
        return odd ? Measured{0, 0} : Measured{1500, 40};
      default:
        return Measured{0, 0};
    }
  };
  const std::string payload = test::vlp16_payload(100, 40, 0, 0x39, measure);
  const auto ranges = [&](ReturnChoice choice) {
    OpenOptions options;
    options.dual_return = choice;
    options.beam_origins = false;
    const Scan scan = decode(payload, options);
    std::vector<long> millimetres;
    for (std::size_t i = 0; i < scan.points.size() / 6; ++i) {  // of the first of six pairs
      millimetres.push_back(std::lround(1000.0 * scan.points[i].norm()));
    }
    return millimetres;
  };
  EXPECT_EQ(ranges(ReturnChoice::strongest), (std::vector<long>{2000, 4000, 3000, 3000}));
  EXPECT_EQ(ranges(ReturnChoice::last), (std::vector<long>{4000, 4000, 3000, 3000}));
  EXPECT_EQ(ranges(ReturnChoice::both), (std::vector<long>{4000, 2000, 4000, 2000, 3000, 3000}));
  const Scan scan = decode(payload);
  ASSERT_EQ(scan.times_ns.size(), 24U);
  EXPECT_EQ(scan.times_ns[1], 2'304);
  EXPECT_EQ(scan.times_ns[4], 110'592);  // the second pair: two sequences later
}

TEST(Vlp16, AzimuthInterpolatesOverZero) {
  OpenOptions options;
  options.beam_origins = false;
  options.cut_azimuth_deg = 180.0;  // away from here
  const Scan scan = decode(
      test::vlp16_payload(35990, 40, 0, 0x37,
                          [](auto block, auto channel) { return only(block, channel, 0, 17); }),
      options);
  ASSERT_EQ(scan.points.size(), 1U);
  // Half the step of 0.4 deg, and a laser's share: from 359.9 to 0.1 deg.
  const double azimuth = (-0.1 + 0.2 + 0.2 * 2.304 / 55.296) * M_PI / 180.0;
  EXPECT_NEAR(std::atan2(-scan.points[0].y(), scan.points[0].x()), azimuth, 1e-7);
}

TEST(Vlp16, RevolutionsAreCutWhereTheAzimuthWraps) {
  for (const double cut_deg : {0.0, 180.0}) {
    OpenOptions options;
    options.cut_azimuth_deg = cut_deg;
    Stream revolutions(options);
    std::vector<Sweep> ended;
    // 188 packets of 4.8 deg: 2.5 turns from 100 deg on.
    for (unsigned i = 0; i * 480 < 90000; ++i) {
      const std::string payload = test::vlp16_payload(10000 + i * 480, 40, 0, 0x37, [](auto, auto) {
        return Measured{500, 1};
      });
      revolutions.add(payload, i * 1'327'104LL, 1'327'104);
    }
    revolutions.finish();
    while (auto revolution = revolutions.take()) {
      ended.push_back(std::move(*revolution));
    }
    ASSERT_EQ(ended.size(), cut_deg == 0.0 ? 3U : 4U);
    EXPECT_FALSE(ended.front().whole);
    EXPECT_NEAR(ended.front().turned_deg, cut_deg == 0.0 ? 260.0 : 80.0, 0.5);
    EXPECT_TRUE(ended[1].whole);
    EXPECT_NEAR(ended[1].turned_deg, 360.0, 0.5);
    EXPECT_FALSE(ended.back().whole);
    for (const Sweep& one : ended) {
      EXPECT_TRUE(std::is_sorted(one.scan.times_ns.begin(), one.scan.times_ns.end()));
      EXPECT_EQ(one.scan.times_ns.front(), 0);
    }
  }
}

TEST(Vlp16, AStandingHeadDoesNotFillTheMemory) {
  Stream revolutions({});
  const std::string payload = test::vlp16_payload(100, 0, 0, 0x37, [](auto, auto) {
    return Measured{500, 1};
  });
  std::size_t ended = 0;
  for (int i = 0; i < 1000; ++i) {
    revolutions.add(payload, i * 1'327'104LL, 1'327'104);
    ended += revolutions.take() ? 1 : 0;
  }
  EXPECT_GE(ended, 2U);
}

TEST(Vlp16, NotADataPacket) {
  std::string payload = test::vlp16_payload(0, 40, 0, 0x37, [](auto, auto) {
    return Measured{0, 0};
  });
  const auto is_data = [](const std::string& bytes) {
    std::string reason;
    return sensors::find_decoder(bytes_of(bytes), "", {}, reason) != nullptr;
  };
  EXPECT_TRUE(is_data(payload));
  EXPECT_FALSE(is_data(payload.substr(1)));
  EXPECT_FALSE(is_data(payload + "x"));
  std::string far = payload;
  far[103] = '\xff';  // an azimuth of more than 360 deg
  EXPECT_FALSE(is_data(far));
  payload[100] = '\0';  // a block's flag
  EXPECT_FALSE(is_data(payload));
}

}  // namespace
}  // namespace surefoot::io
