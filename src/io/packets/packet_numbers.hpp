// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "io/recording.hpp"

namespace surefoot::io {

/// Which packets a scan is of, by their numbers. Data packets are told as they come, a scan as soon
/// as it is there.
class PacketNumbers {
 public:
  /// The numbers of a data packet, of several where it came in parts.
  void note(std::uint64_t begin, std::uint64_t end) {
    if (end_ == 0) scan_begin_ = begin;
    begin_ = begin;
    end_ = end;
  }
  /// @param has_last whether the last data packet is of the scan, too, and not of the next alone.
  [[nodiscard]] CapturedPackets take(bool has_last) {
    CapturedPackets packets;
    packets.first = scan_begin_;
    packets.end = has_last ? end_ : begin_;
    scan_begin_ = begin_;
    return packets;
  }

 private:
  std::uint64_t scan_begin_ = 0, begin_ = 0, end_ = 0;
};

}  // namespace surefoot::io
