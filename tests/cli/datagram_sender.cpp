// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "datagram_sender.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <thread>

namespace surefoot::test {
namespace {

/// The system's line about the port; empty where nobody listens.
std::string table_line(std::uint16_t port) {
  char wanted[16];
  std::snprintf(wanted, sizeof(wanted), ":%04X ", port);
  std::ifstream table("/proc/net/udp");
  for (std::string line; std::getline(table, line);) {
    const std::size_t at = line.find(wanted);
    if (at != std::string::npos && at < 20) return line;  // as the local one
  }
  return {};
}

}  // namespace

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

DatagramSender::DatagramSender() : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
  const int other = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address = loopback(0);
  socklen_t size = sizeof(address);
  EXPECT_EQ(::bind(other, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(::getsockname(other, reinterpret_cast<sockaddr*>(&address), &size), 0);
  port_ = ntohs(address.sin_port);
  ::close(other);
}

DatagramSender::~DatagramSender() { ::close(socket_); }

void DatagramSender::send(const std::string& payload) const {
  const sockaddr_in address = loopback(port_);
  EXPECT_EQ(::sendto(socket_, payload.data(), payload.size(), 0,
                     reinterpret_cast<const sockaddr*>(&address), sizeof(address)),
            static_cast<ssize_t>(payload.size()));
}

void DatagramSender::reconnect() {
  const int other = ::socket(AF_INET, SOCK_DGRAM, 0);  // before, so that the port is another one
  ::close(socket_);
  socket_ = other;
}

bool DatagramSender::wait_for_listener() const {
  for (int i = 0; i < 1000; ++i) {
    if (!table_line(port_).empty()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

std::size_t DatagramSender::waiting() const {
  // sl local_address rem_address st tx_queue:rx_queue ...
  const std::string line = table_line(port_);
  unsigned long bytes = 0;
  (void)std::sscanf(line.c_str(), "%*d: %*s %*s %*x %*x:%lx", &bytes);
  return bytes;
}

}  // namespace surefoot::test
