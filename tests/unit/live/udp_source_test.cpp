// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "live/datagram_source.hpp"

namespace surefoot::live {
namespace {

// Else all that waited would have come an hour ago, and who ends a run by --silence would.
TEST(UdpSource, AClockThatIsSetMakesNoPacketOldOrNew) {
  constexpr std::int64_t kNow = 1'700'000'000'000'000'000, kMs = 1'000'000, kHour = 3'600'000 * kMs;
  EXPECT_EQ(waited(kNow - 3 * kMs, kNow), std::chrono::milliseconds(3));
  EXPECT_EQ(waited(kNow - kHour, kNow), std::chrono::seconds(1));
  EXPECT_EQ(waited(kNow + kHour, kNow), std::chrono::seconds(0));
}

class Sender {
 public:
  Sender() : id_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~Sender() { ::close(id_); }
  Sender(const Sender&) = delete;
  Sender& operator=(const Sender&) = delete;
  void send(std::uint16_t port, const std::string& payload) const {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::sendto(id_, payload.data(), payload.size(), 0, reinterpret_cast<sockaddr*>(&to),
                       sizeof(to)),
              static_cast<ssize_t>(payload.size()));
  }

 private:
  int id_;
};

/// How old the source says that a datagram is which has waited for a while, by both clocks [s].
std::pair<double, double> ages_after(std::chrono::milliseconds wait, const Sender& sender,
                                     DatagramSource& source, std::uint16_t port) {
  Arrival arrival;
  sender.send(port, "abc");
  std::this_thread::sleep_for(wait);
  EXPECT_EQ(source.receive(arrival), Received::something);
  EXPECT_EQ(arrival.datagram.source_address, 0x7f00'0001U);
  EXPECT_EQ(arrival.datagram.payload.size(), 3U);
  const std::chrono::duration<double> wall = std::chrono::system_clock::now().time_since_epoch();
  const std::chrono::duration<double> steady = std::chrono::steady_clock::now() - arrival.received;
  return {wall.count() - 1e-9 * static_cast<double>(arrival.arrival_ns), steady.count()};
}

// It waits in the socket while a scan is worked on; the kernel says when it came. The first ones it
// stamps when they are asked for, until it has begun to stamp what comes.
TEST(UdpSource, ADatagramIsAsOldAsTheKernelSays) {
  const std::unique_ptr<DatagramSource> source = listen_udp("127.0.0.1", 0);
  const std::string name = source->name();
  const auto port = static_cast<std::uint16_t>(std::stoi(name.substr(name.rfind(' '))));
  const Sender sender;
  std::pair<double, double> ages;
  for (int i = 0; i < 20 && ages.first < 0.03; ++i) {
    ages = ages_after(std::chrono::milliseconds(31), sender, *source, port);
  }
  EXPECT_GE(ages.first, 0.03);
  EXPECT_GE(ages.second, 0.03);
  EXPECT_EQ(source->overflowed(), 0U);
}

}  // namespace
}  // namespace surefoot::live
