// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A packet capture (pcap, microseconds, Ethernet) of the UDP datagrams that a sensor sends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>

namespace surefoot::simulation {

class CaptureWriter {
 public:
  /// @param port source and destination of the datagrams.
  /// @throws std::runtime_error where the file cannot be made.
  CaptureWriter(const std::filesystem::path& file, std::uint16_t port);

  /// One broadcast datagram. @param sent_ns instant that the capture shows.
  void write(std::int64_t sent_ns, std::span<const std::byte> payload);
  /// @throws std::runtime_error where something could not be written.
  void finish();

 private:
  std::filesystem::path path_;
  std::uint16_t port_;
  std::ofstream file_;
};

}  // namespace surefoot::simulation
