// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Hesai's spinning LiDARs as their manuals and public drivers describe them. A packet has a header,
// blocks of one azimuth each, and a tail with return mode and time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace surefoot::sensors {

struct HesaiChannel {
  double elevation_deg = 0.0;
  double azimuth_deg = 0.0;      ///< added to the block's, clockwise
  std::int32_t time_ns = 0;      ///< after its block's time
  std::int32_t odd_time_ns = 0;  ///< QT128: in the other of its two firing sequences
};

/// Where the fields of a packet's tail lie, after its beginning [bytes].
struct HesaiTail {
  std::size_t begin = 0;  ///< of the tail in the packet
  std::size_t return_mode = 0;
  std::size_t date = 0;  ///< year, month, day, hour, minute, second
  std::size_t microseconds = 0;
  std::optional<std::size_t> sequence;  ///< of the packet's number, where the packet is so long
  std::optional<std::size_t> mode_flag;
};

struct HesaiModel {
  std::string name;
  std::vector<HesaiChannel> channels;
  std::size_t header_bytes = 12;  ///< 12, 8 or none
  std::size_t blocks = 0;
  std::size_t block_header_bytes = 2;  ///< azimuth; 4 with a flag before it
  std::size_t unit_bytes = 4;          ///< distance, reflectivity (and confidence)
  HesaiTail tail;
  std::vector<std::size_t> sizes;  ///< of packets: without and with what is optional [bytes]
  double block_ns = 0.0;  ///< from one block (or pair of blocks of one azimuth) to the next
  double last_ns = 0.0;   ///< time of the last block after the packet's, where blocks count back
  bool counts_forward = false;  ///< last_ns is that of the first block
  bool two_loops = false;       ///< QT128: channels fire in one of two sequences, by block

  [[nodiscard]] std::size_t block_bytes() const {
    return block_header_bytes + unit_bytes * channels.size();
  }
};

/// PandarXT-16, PandarXT-32, PandarXT-32M, PandarQT64, PandarQT128, Pandar40P, Pandar64.
[[nodiscard]] const std::vector<HesaiModel>& hesai_models();

}  // namespace surefoot::sensors
