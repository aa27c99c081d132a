// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "io/recording.hpp"
#include "simulation/capture_writer.hpp"
#include "simulation/vlp16_encoder.hpp"
#include "support.hpp"
#include "support/scratch.hpp"

namespace surefoot::simulation::test {
namespace {

constexpr std::uint64_t kScans = 4;

/// A point's firing names it: instant and ring.
using Key = std::pair<std::int64_t, std::uint16_t>;

std::map<Key, Eigen::Vector3d> by_firing(const Scan& scan, double rounding_ns) {
  std::map<Key, Eigen::Vector3d> points;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    // The packet's clock counts microseconds, a firing every 2304 ns.
    const auto time = static_cast<double>(scan.stamp_ns + scan.times_ns[i]) + rounding_ns;
    points[{static_cast<std::int64_t>(time / 2304.0), scan.rings[i]}] =
        scan.points[i].cast<double>();
  }
  return points;
}

void capture(Scanner& scanner, const std::filesystem::path& file,
             std::vector<SimulatedScan>& scans) {
  CaptureWriter writer(file, vlp16::kUdpPort);
  Vlp16Encoder encoder(scanner.options().start_ns, scanner.options().dual_return);
  for (std::uint64_t index = 0; index < kScans; ++index) {
    scans.push_back(scanner.scan(index));
    for (const Vlp16DataPacket& packet : encoder.add(scans.back())) {
      writer.write(packet.sent_ns, packet.payload);
    }
  }
  if (const auto packet = encoder.finish()) writer.write(packet->sent_ns, packet->payload);
  writer.finish();
}

using PacketsTest = surefoot::test::Scratch;

TEST_F(PacketsTest, TheReaderDecodesThePointsThatWereSimulated) {
  const Scene scene = room();
  RayCaster rays(scene);
  // Time 0 on a whole number of firings and of microseconds (lcm of 2304 ns and 1 us: 288 us).
  ScannerOptions options;
  options.start_ns = 288'000LL * 3'500'000;
  Scanner scanner(rays, lidar_model("vlp16"),
                  make_motion(scene, rays, gait_model("trot"), 1.0, 7, kMount), options);
  std::vector<SimulatedScan> scans;
  const std::filesystem::path file = folder_ / "walk.pcap";
  capture(scanner, file, scans);

  const auto recording = io::open_recording(file, {});
  std::map<Key, Eigen::Vector3d> decoded;
  std::uint64_t revolutions = 0;
  while (const auto item = recording->next()) {
    ++revolutions;
    ASSERT_TRUE(item->scan.has_value());
    EXPECT_EQ(item->remark, "");
    decoded.merge(by_firing(*item->scan, 1152.0));
  }
  EXPECT_EQ(revolutions, kScans);
  std::size_t simulated = 0;
  std::size_t matched = 0;
  ASSERT_NE(scans.back().end_sequence % 24, 0U) << "the last packet is to be one that is not full";
  for (const SimulatedScan& scan : scans) {
    for (std::size_t i = 0; i < scan.raw.size(); ++i) {
      ++simulated;
      const auto time = scan.scan.stamp_ns + scan.scan.times_ns[i];
      const auto found = decoded.find({(time + 1152) / 2304, scan.scan.rings[i]});
      if (found == decoded.end()) continue;
      const Eigen::Vector3d point = scan.scan.points[i].cast<double>();
      // Azimuths between two readings are interpolated: 0.01 deg at the most.
      if ((found->second - point).norm() < 1.8e-4 * point.norm() + 1e-4) ++matched;
    }
  }
  EXPECT_GT(simulated, 90'000U);
  EXPECT_EQ(matched, simulated);
  EXPECT_EQ(decoded.size(), simulated);
}

TEST_F(PacketsTest, TheLastPacketIsWholeThoughTheRecordingEndsWithinIt) {
  SimulatedScan scan;
  scan.end_sequence = 3;
  RawReturn value;
  value.sequence = 2;
  value.laser = 15;
  value.range = 5.0;
  scan.raw.push_back(value);
  Vlp16Encoder encoder(0, false);
  EXPECT_TRUE(encoder.add(scan).empty());
  const auto packet = encoder.finish();
  ASSERT_TRUE(packet.has_value());
  const auto word = [&](std::size_t at) {
    return std::to_integer<unsigned>(packet->payload[at]) +
           256 * std::to_integer<unsigned>(packet->payload[at + 1]);
  };
  for (std::size_t block = 0; block < 12; ++block) {
    EXPECT_EQ(word(100 * block), 0xeeffU);
    // The head turns on: 110.592 us a block, 0.0036 deg a microsecond.
    EXPECT_EQ(word(100 * block + 2), std::lround(39.81312 * static_cast<double>(block)));
    for (std::size_t channel = 0; channel < 32; ++channel) {
      const bool measured = block == 1 && channel == 15;
      EXPECT_EQ(word(100 * block + 4 + 3 * channel), measured ? 2500U : 0U);
    }
  }
  EXPECT_FALSE(encoder.finish().has_value());
}

TEST_F(PacketsTest, BytesAreWhereTheManualPutsThem) {
  SimulatedScan scan;
  scan.first_sequence = 0;
  scan.end_sequence = 25;
  RawReturn value;
  value.sequence = 3;  // second sequence of block 1
  value.laser = 5;
  value.range = 12.346;
  value.intensity = 77;
  scan.raw.push_back(value);
  Vlp16Encoder encoder(3'600'000'000'000LL + 5'000'000, false);
  const auto packets = encoder.add(scan);
  ASSERT_EQ(packets.size(), 1U);
  const auto byte = [&](std::size_t at) {
    return std::to_integer<unsigned>(packets[0].payload[at]);
  };
  EXPECT_EQ(byte(100), 0xffU);
  EXPECT_EQ(byte(101), 0xeeU);
  // Block 1 begins 110.592 us into the turn: 39.81 hundredths of a degree.
  EXPECT_EQ(byte(102) + 256 * byte(103), 40U);
  const std::size_t channel = 100 + 4 + 3 * (16 + 5);
  EXPECT_EQ(byte(channel) + 256 * byte(channel + 1), 6173U);
  EXPECT_EQ(byte(channel + 2), 77U);
  EXPECT_EQ(byte(1200) + 256 * byte(1201) + 65536 * byte(1202), 5000U);
  EXPECT_EQ(byte(1204), 0x37U);
  EXPECT_EQ(byte(1205), 0x22U);
}

TEST_F(PacketsTest, DualPacketsHoldTheLastThenTheOtherReturn) {
  SimulatedScan scan;
  scan.end_sequence = 13;
  RawReturn near;
  near.laser = 2;
  near.range = 4.0;
  RawReturn far = near;
  far.range = 9.0;
  far.last = true;
  RawReturn alone = near;
  alone.laser = 3;
  alone.range = 6.0;
  scan.raw = {near, far, alone};
  Vlp16Encoder encoder(0, true);
  const auto packets = encoder.add(scan);
  ASSERT_EQ(packets.size(), 1U);
  const auto distance = [&](std::size_t block, std::size_t channel) {
    const std::byte* at = &packets[0].payload[block * 100 + 4 + 3 * channel];
    return std::to_integer<unsigned>(at[0]) + 256 * std::to_integer<unsigned>(at[1]);
  };
  EXPECT_EQ(distance(0, 2), 4500U);
  EXPECT_EQ(distance(1, 2), 2000U);
  EXPECT_EQ(distance(0, 3), 3000U);
  EXPECT_EQ(distance(1, 3), 3000U);
  EXPECT_EQ(std::to_integer<unsigned>(packets[0].payload[1204]), 0x39U);
}

}  // namespace
}  // namespace surefoot::simulation::test
