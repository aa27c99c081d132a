// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Which of two returns of one firing is kept, of every sensor that has two.
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "unit/sensors/decoded.hpp"
#include "unit/sensors/encoders.hpp"

namespace surefoot::sensors {
namespace {

using test::bytes_of;
using test::turning;

struct Return {
  std::uint16_t distance;  ///< in the packet's unit; 0: none
  std::uint8_t strength;
};
constexpr Return kNear{1000, 0}, kFar{2500, 0}, kNone{0, 0};

Return times(Return measured, int strength) {
  return {measured.distance, static_cast<std::uint8_t>(strength)};
}

struct DualSensor {
  const char* name;
  std::function<std::string(Return, Return)> packet;
  std::string metadata = {};
  std::string before = {};  ///< a packet that tells it that there are two returns
};

std::vector<DualSensor> dual_sensors() {
  std::vector<DualSensor> sensors;
  sensors.push_back({"VLP-16", [](Return one, Return other) {
                       auto packet =
                           test::velodyne_packet({0xeeff}, turning(9000, 40, 2), 0, 0x39, 0x22);
                       test::set_velodyne(packet, 2, 3, one.distance, one.strength);
                       test::set_velodyne(packet, 3, 3, other.distance, other.strength);
                       return packet;
                     }});
  sensors.push_back({"PandarXT-32", [](Return one, Return other) {
                       const test::HesaiLayout& layout = test::hesai_layouts()[1];
                       auto packet = test::hesai_packet(layout, 4500, 18, 2, 0x39, 0, 0);
                       test::set_hesai(packet, layout, 2, 3, one.distance, one.strength);
                       test::set_hesai(packet, layout, 3, 3, other.distance, other.strength);
                       return packet;
                     }});
  sensors.push_back({"OS-1-16",
                     [](Return one, Return other) {
                       auto packet = test::ouster_packet(16, false, 1, 0, 1000);
                       const std::size_t at = test::ouster_pixel(16, false, 2, 3);
                       test::put(packet, at, one.distance);
                       test::put(packet, at + 4, other.distance);
                       test::put(packet, at + 8, std::uint16_t{one.strength});
                       test::put(packet, at + 10, std::uint16_t{other.strength});
                       return packet;
                     },
                     test::ouster_json("RNG19_RFL8_SIG16_NIR16_DUAL")});
  sensors.push_back({"RS-LiDAR-16",
                     [](Return one, Return other) {
                       auto packet = test::rs16_packet(9480, 20, 5'666);
                       test::set_rs16(packet, 2, 3, one.distance, one.strength);
                       test::set_rs16(packet, 2, 16 + 3, other.distance, other.strength);
                       return packet;
                     },
                     {},
                     test::rs16_packet(9240, 20, 5'000)});
  return sensors;
}

/// Intensities of what is kept.
std::vector<float> kept(const DualSensor& sensor, ReturnChoice choice, Return one, Return other) {
  DecoderOptions options;
  options.returns = choice;
  options.metadata = sensor.metadata;
  const std::string packet = sensor.packet(one, other);
  std::string reason;
  const auto decoder =
      find_decoder(bytes_of(sensor.before.empty() ? packet : sensor.before), "", options, reason);
  Firings firings;
  if (decoder == nullptr || decoder->decode(bytes_of(packet), firings) != PacketKind::data) {
    ADD_FAILURE() << reason;
    return {};
  }
  EXPECT_EQ(decoder->sensor(), sensor.name);
  std::vector<float> intensities;
  for (const FiringPoint& point : firings.points) intensities.push_back(point.intensity);
  return intensities;
}

using Kept = std::vector<float>;

TEST(DualReturns, TheStrongerIsKept) {
  for (const DualSensor& sensor : dual_sensors()) {
    SCOPED_TRACE(sensor.name);
    const auto strongest = [&](Return one, Return other) {
      return kept(sensor, ReturnChoice::strongest, one, other);
    };
    EXPECT_EQ(strongest(times(kNear, 20), times(kFar, 90)), Kept{90.0F});
    EXPECT_EQ(strongest(times(kNear, 90), times(kFar, 20)), Kept{90.0F});
    EXPECT_EQ(strongest(times(kFar, 90), times(kNear, 20)), Kept{90.0F});
    EXPECT_EQ(strongest(times(kNone, 0), times(kFar, 20)), Kept{20.0F});
    EXPECT_EQ(strongest(times(kFar, 20), times(kNone, 0)), Kept{20.0F});
    EXPECT_EQ(strongest(times(kNone, 200), times(kFar, 20)), Kept{20.0F}) << "noise of no return";
    EXPECT_EQ(strongest(times(kFar, 20), times(kNone, 200)), Kept{20.0F});
  }
}

TEST(DualReturns, BothAreKeptUnlessTheyAreOne) {
  for (const DualSensor& sensor : dual_sensors()) {
    SCOPED_TRACE(sensor.name);
    const auto both = [&](Return one, Return other) {
      return kept(sensor, ReturnChoice::both, one, other);
    };
    EXPECT_EQ(both(times(kNear, 20), times(kFar, 90)), (Kept{20.0F, 90.0F}));
    EXPECT_EQ(both(times(kFar, 90), times(kFar, 90)), Kept{90.0F});
    EXPECT_EQ(both(times(kNone, 0), times(kFar, 90)), Kept{90.0F});
    EXPECT_TRUE(both(times(kNone, 0), times(kNone, 0)).empty());
  }
}

// A Velodyne's first block holds it; of the others it is the farther one.
TEST(DualReturns, TheLastIsKeptWhereThatIsAskedFor) {
  for (const DualSensor& sensor : dual_sensors()) {
    SCOPED_TRACE(sensor.name);
    const auto last = [&](Return one, Return other) {
      return kept(sensor, ReturnChoice::last, one, other);
    };
    EXPECT_EQ(last(times(kFar, 20), times(kNear, 90)), Kept{20.0F});
    if (std::string(sensor.name) == "VLP-16") continue;
    EXPECT_EQ(last(times(kNear, 90), times(kFar, 20)), Kept{20.0F});
    EXPECT_EQ(last(times(kNone, 0), times(kFar, 20)), Kept{20.0F});
  }
}

// Where the last return is the strongest one, Velodyne's other block holds the second strongest.
TEST(DualReturns, OfTwoAsStrongAVelodynesStrongestIsThatOfTheOtherBlock) {
  DecoderOptions options;
  auto packet = test::velodyne_packet({0xeeff}, turning(9000, 40, 2), 0, 0x39, 0x22);
  test::set_velodyne(packet, 2, 3, 2500, 50);
  test::set_velodyne(packet, 3, 3, 1000, 50);
  const Firings firings = test::decode(packet, "VLP-16", options);
  ASSERT_EQ(firings.points.size(), 1U);
  EXPECT_LT(firings.points[0].position.norm(), 3.0F);
}

}  // namespace
}  // namespace surefoot::sensors
