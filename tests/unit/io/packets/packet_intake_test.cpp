// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/packet_intake.hpp"

#include <gtest/gtest.h>

#include <array>

#include "io/recording.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

constexpr std::uint32_t kOneSensor = 0xc0a80101, kOtherSensor = 0xc0a80102;  // 192.168.1.1, 2
constexpr std::int64_t kHourBegins = 1'453'363'200'000'000'000;

struct Intake : ::testing::Test {
  /// Made by a VLP-16, the `number`th in a row; `product` names it in the packet.
  void add_data(unsigned number, std::uint32_t address = kOneSensor, std::uint16_t port = 2368,
                unsigned product = 0x22) {
    constexpr std::int64_t kPeriod = 1'327'104;
    add(test::vlp16_payload(
            number * 480 % 36000, 40, static_cast<std::uint32_t>(number * kPeriod / 1000), 0x37,
            [](auto, auto) {
              return test::Measured{500, 1};
            },
            product),
        address, port, kHourBegins + number * kPeriod);
  }
  void add(const std::string& payload, std::uint32_t address, std::uint16_t port,
           std::int64_t arrival_ns = kHourBegins) {
    intake_->add(arrival_ns, {FrameContent::udp, address, port, test::bytes_of(payload)});
  }
  void listen_to(std::uint16_t port) {
    OpenOptions options;
    options.udp_port = port;
    intake_ = std::make_unique<PacketIntake>(options, "");
  }
  std::unique_ptr<PacketIntake> intake_ = std::make_unique<PacketIntake>(OpenOptions{}, "");
};

TEST_F(Intake, CountsWhatIsNoData) {
  EXPECT_EQ(intake_->traffic_seen(), "; no UDP at all");
  intake_->add(0, {FrameContent::truncated, 0, 0, {}});
  intake_->add(0, {FrameContent::other, 0, 0, {}});
  EXPECT_EQ(intake_->counts().truncated, 1U);
  EXPECT_EQ(intake_->counts().other, 1U);
  add(std::string(512, 'p'), kOneSensor, 8308);
  EXPECT_EQ(intake_->counts().position_packets, 1U);
  EXPECT_EQ(intake_->traffic_seen(), "; 1 of a Velodyne's position, no data");
  add(std::string(512, 'p'), kOneSensor, 8309);
  add(std::string(511, 'p'), kOneSensor, 8308);
  EXPECT_EQ(intake_->counts().position_packets, 1U);
  EXPECT_EQ(intake_->counts().other, 3U);
  EXPECT_EQ(intake_->counts().data_packets, 0U);
}

TEST_F(Intake, SaysWhatMostOfTheTrafficIs) {
  constexpr std::array<std::uint16_t, 4> kPorts{7, 9, 9, 11};
  for (const std::uint16_t port : kPorts) add("what is this", kOneSensor, port);
  EXPECT_EQ(intake_->traffic_seen(), "; most are of 12 bytes to port 9");
  for (int i = 0; i < 3; ++i) add_data(0, kOneSensor, 10, 0x31);
  EXPECT_EQ(intake_->traffic_seen().find("; most are of 1206 bytes to port 10: "), 0U)
      << intake_->traffic_seen();
}

TEST_F(Intake, RemembersSoManyKindsOfTrafficAndNoMore) {
  for (std::uint16_t port = 1; port <= 64; ++port) add("x", kOneSensor, port);
  add("x", kOneSensor, 7);
  for (int i = 0; i < 9; ++i) add("x", kOneSensor, 65);
  EXPECT_EQ(intake_->traffic_seen(), "; most are of 1 bytes to port 7");
}

TEST_F(Intake, TakesOnePortAloneWhereItIsAsked) {
  EXPECT_EQ(intake_->port_text(), "");
  listen_to(2369);
  EXPECT_EQ(intake_->port_text(), " to UDP port 2369");
  add_data(0, kOneSensor, 2368);
  EXPECT_EQ(intake_->counts().data_packets, 0U);
  EXPECT_EQ(intake_->traffic_seen(), "; most are of 1206 bytes to port 2368");
  add_data(0, kOneSensor, 2369);
  EXPECT_EQ(intake_->counts().data_packets, 1U);
  EXPECT_EQ(intake_->stream(), (std::pair{kOneSensor, std::uint16_t{2369}}));
  add_data(1, kOtherSensor, 2368);
  EXPECT_TRUE(intake_->notes().empty()) << "what is not asked for is no news";
}

TEST_F(Intake, NamesAnotherSensorOnce) {
  add_data(0);
  add_data(1, kOneSensor, 2370);  // as long, and from the sensor itself
  add(std::string(1205, 'x'), kOtherSensor, 2368);
  EXPECT_TRUE(intake_->notes().empty());
  for (int i = 0; i < 2; ++i) {
    add_data(1, kOtherSensor, 2368);
    add_data(1, kOtherSensor, 2369);
  }
  EXPECT_EQ(intake_->notes(),
            (std::vector<std::string>{"another VLP-16 at 192.168.1.2:2368, not read",
                                      "another VLP-16 at 192.168.1.2:2369, not read (--udp-port "
                                      "takes another port)"}));
  for (std::uint32_t i = 0; i < 20; ++i) add_data(1, kOtherSensor + 1 + i);
  EXPECT_EQ(intake_->notes().size(), 10U);
  EXPECT_EQ(intake_->counts().data_packets, 1U);
}

TEST_F(Intake, CountsWhatIsMissingAndWhatCameLate) {
  add_data(0);
  add_data(1);
  add_data(4);
  EXPECT_EQ(intake_->counts().lost, 2U);
  EXPECT_EQ(intake_->counts().reordered, 0U);
  add_data(3);
  EXPECT_EQ(intake_->counts().lost, 1U);
  EXPECT_EQ(intake_->counts().reordered, 1U);
  EXPECT_EQ(intake_->counts().data_packets, 4U);
}

}  // namespace
}  // namespace surefoot::io
