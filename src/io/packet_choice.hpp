// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "io/conversion.hpp"
#include "io/conversion_lane.hpp"

namespace surefoot::io {

/// Packets by their numbers, that go into an output.
struct PacketChoice {
  std::vector<CapturedPackets> scans;  ///< in their order; those that touch are one
  std::uint64_t begin = 0, end = std::numeric_limits<std::uint64_t>::max();  ///< of what else goes
  bool every = true;                                                         ///< scan between them

  void add(const CapturedPackets& packets);
  [[nodiscard]] bool is_all() const {
    return every && begin == 0 && end == std::numeric_limits<std::uint64_t>::max();
  }
};

/// Reads the recording once; what of it goes is known only where scans end. Scans are counted in
/// the outcome: none where it was interrupted. Throws ReadError where none is in what is asked for.
[[nodiscard]] PacketChoice choose_packets(ConversionLane& lane, const ConversionRequest& request,
                                          const ConversionListener& listener,
                                          ConversionOutcome& outcome);

/// What the output has besides the scans that are asked for.
void note_neighbours(const PacketChoice& choice, ConversionOutcome& outcome);

/// Writes what an Ouster's packets are read by beside the output, where `metadata` is that.
void write_metadata_beside(const std::filesystem::path& output, const std::string& metadata,
                           ConversionOutcome& outcome);

}  // namespace surefoot::io
