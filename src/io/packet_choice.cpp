// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packet_choice.hpp"

#include <algorithm>
#include <optional>

#include "io/file_writer.hpp"

namespace surefoot::io {

namespace fs = std::filesystem;

void PacketChoice::add(const CapturedPackets& packets) {
  if (!scans.empty() && packets.first <= scans.back().end) {
    scans.back().end = std::max(scans.back().end, packets.end);
  } else {
    scans.push_back(packets);
  }
}

PacketChoice choose_packets(ConversionLane& lane, const ConversionRequest& request,
                            const ConversionListener& listener, ConversionOutcome& outcome) {
  PacketChoice choice;
  choice.every = request.stride == 1;
  std::optional<std::int64_t> first_ns;
  while (const ScanItem* const item = lane.item()) {
    if ((outcome.interrupted = listener.interrupted())) {
      return {};  // nothing is written yet
    }
    if (item->scan && item->packets) {
      const std::int64_t at_ns = item->scan->stamp_ns;
      if (!first_ns) first_ns = at_ns;
      if (lane.is_within(*first_ns, at_ns)) {
        choice.add(*item->packets);
        lane.count();
        listener.progress(++outcome.scans, 0.5 * lane.recording().progress());
      }
    }
    lane.pass();
  }
  if (choice.scans.empty()) {
    throw ReadError(request.input.string() + ": no scan in what is asked for");
  }
  if (!request.begins_with_all()) choice.begin = choice.scans.front().first;
  if (!request.ends_with_all()) choice.end = choice.scans.back().end;
  return choice;
}

void note_neighbours(const PacketChoice& choice, ConversionOutcome& outcome) {
  if (choice.is_all()) return;
  outcome.notes.emplace_back(
      "packets go whole: where one has the end of a scan and the beginning of the next, some "
      "firings of a neighbour go, too, and are read as a partial scan");
}

void write_metadata_beside(const fs::path& output, const std::string& metadata,
                           ConversionOutcome& outcome) {
  const fs::path copy = fs::path(output).replace_extension(".json");
  if (metadata.find("beam_altitude_angles") == std::string::npos) return;
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(copy, ignored))) {
    outcome.notes.push_back(copy.string() +
                            " is there already and stays; the packets are read by what it says");
    return;
  }
  write_whole_file(copy, metadata);
  outcome.notes.push_back("what the sensor says of itself went with it: " + copy.string());
}

}  // namespace surefoot::io
