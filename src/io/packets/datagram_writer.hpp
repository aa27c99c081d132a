// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Datagrams as they arrived, to a capture that every reader of captures reads back: pcap with
// nanoseconds, IPv4 without a link layer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>

#include "io/packets/udp_datagram.hpp"

namespace surefoot::io {

class DatagramWriter {
 public:
  /// Throws WriteError where the file cannot be made.
  explicit DatagramWriter(const std::filesystem::path& file);

  /// Throws WriteError.
  void add(std::int64_t arrival_ns, const UdpDatagram& datagram);
  /// What was added lies in the file. Throws WriteError.
  void flush();

 private:
  [[noreturn]] void fail() const;

  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace surefoot::io
