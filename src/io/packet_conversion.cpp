// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packet_conversion.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "io/bags/compression.hpp"
#include "io/conversion_lane.hpp"
#include "io/file_kind.hpp"
#include "io/file_writer.hpp"
#include "io/files/folder_listing.hpp"
#include "io/packets/capture_file.hpp"
#include "io/packets/frame_writer.hpp"
#include "io/packets/metadata_file.hpp"
#include "io/packets/udp_datagram.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

/// Frames by their numbers, that go into the output.
struct Choice {
  std::vector<CapturedPackets> scans;  ///< in their order; those that touch are one
  std::uint64_t begin = 0, end = std::numeric_limits<std::uint64_t>::max();  ///< of what else goes

  void add(const CapturedPackets& packets) {
    if (!scans.empty() && packets.first <= scans.back().end) {
      scans.back().end = std::max(scans.back().end, packets.end);
    } else {
      scans.push_back(packets);
    }
  }
};

bool is_pcapng(const fs::path& file) {
  std::array<std::byte, 4> begin{};
  return open_stream(file)->read(begin) == begin.size() && begin[0] == std::byte{0x0a};
}

// Whether a frame is of the sensor's data, or a part of one.
bool is_of(const CapturedPackets& sensor, LinkLayer link, std::span<const std::byte> frame) {
  IpFragment part;
  const UdpDatagram datagram = find_udp(link, frame, &part);
  if (datagram.content == FrameContent::fragment) {
    return part.source_address == sensor.source_address;
  }
  return datagram.content == FrameContent::udp && datagram.destination_port == sensor.port &&
         datagram.source_address == sensor.source_address;
}

class PacketConversion {
 public:
  PacketConversion(const ConversionRequest& request, const ConversionListener& listener)
      : request_(request),
        listener_(listener),
        input_(capture_in(request.input)),
        lane_(open_recording(input_, request.reader), request) {
    require_unused(request.output, false);
    note_idle_options();
  }

  ConversionOutcome execute() {
    choose_scans();
    if (outcome_.scans == 0 && outcome_.interrupted) return std::move(outcome_);
    if (outcome_.scans == 0) {
      throw ReadError(request_.input.string() + ": no scan in what is asked for");
    }
    UnfinishedOutput output(request_.output, false);
    copy_frames(output.path());
    output.finish();
    tell();
    return std::move(outcome_);
  }

 private:
  static fs::path capture_in(const fs::path& input);
  void note_idle_options();
  void choose_scans();
  void copy_frames(const fs::path& output);
  [[nodiscard]] bool is_all() const {
    return request_.stride == 1 && choice_.begin == 0 &&
           choice_.end == std::numeric_limits<std::uint64_t>::max();
  }
  void tell();
  void copy_metadata();

  const ConversionRequest& request_;
  const ConversionListener& listener_;
  fs::path input_;
  ConversionLane lane_;
  Choice choice_;
  ConversionOutcome outcome_;
  std::size_t of_no_time_ = 0;
};

// Throws ReadError where it is none.
fs::path PacketConversion::capture_in(const fs::path& input) {
  std::error_code ignored;
  const fs::path file =
      fs::is_directory(input, ignored) ? only_capture(input).value_or(input) : input;
  if (fs::is_regular_file(file, ignored) && kind_of(file) == FileKind::capture) return file;
  if (!fs::exists(file, ignored)) throw ReadError(file.string() + ": no such file or folder");
  throw ReadError(input.string() +
                  ": a capture is written of another capture's packets alone; points cannot be "
                  "turned back into packets, and a bag's are not written as one");
}

void PacketConversion::note_idle_options() {
  const auto idle = [&](bool given, const char* option) {
    if (given) outcome_.notes.push_back(std::string(option) + " counts for nothing here");
  };
  idle(!request_.topics.empty(), "--topic");
  idle(!request_.sink.topic.empty(), "--out-topic");
  idle(!request_.sink.frame.empty(), "--frame");
}

// Reads the capture once; what of it goes is known only where scans end.
void PacketConversion::choose_scans() {
  std::optional<std::int64_t> first_ns;
  while (const ScanItem* const item = lane_.item()) {
    if ((outcome_.interrupted = listener_.interrupted())) {
      outcome_.scans = 0;  // nothing is written yet
      return;
    }
    if (item->scan && item->packets) {
      const std::int64_t at_ns = item->scan->stamp_ns;
      if (!first_ns) first_ns = at_ns;
      if (lane_.is_within(*first_ns, at_ns)) {
        choice_.add(*item->packets);
        lane_.count();
        listener_.progress(++outcome_.scans, 0.5 * lane_.recording().progress());
      }
    }
    lane_.pass();
  }
  if (choice_.scans.empty()) return;
  if (!request_.begins_with_all()) choice_.begin = choice_.scans.front().first;
  if (!request_.ends_with_all()) choice_.end = choice_.scans.back().end;
}

void PacketConversion::copy_frames(const fs::path& output) {
  CaptureFile from(input_);
  FrameWriter to(output, from);
  const CapturedPackets sensor = choice_.scans.front();
  auto scan = choice_.scans.begin();
  std::uint64_t number = 0;
  for (; const auto frame = from.next(); ++number) {
    if (number >= choice_.end || (listener_.interrupted())) break;
    if (number < choice_.begin) continue;
    while (scan != choice_.scans.end() && number >= scan->end) ++scan;
    const bool is_in_scan = scan != choice_.scans.end() && number >= scan->first;
    if (!is_in_scan && !is_all() && is_of(sensor, from.link(), frame->bytes)) continue;
    to.add(*frame) ? ++outcome_.packets : ++of_no_time_;
    constexpr std::uint64_t kAtOnce = 1024;  // packets between two words of progress
    if (number % kAtOnce == 0) listener_.progress(outcome_.scans, 0.5 + 0.5 * from.progress());
  }
  outcome_.interrupted = listener_.interrupted();
  to.finish();
}

// What an Ouster's packets are read by: walk.json of walk.pcap.
void PacketConversion::copy_metadata() {
  const std::string text = metadata_beside(input_).text;
  const fs::path copy = fs::path(request_.output).replace_extension(".json");
  if (text.find("beam_altitude_angles") == std::string::npos) return;
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(copy, ignored))) {
    outcome_.notes.push_back(copy.string() +
                             " is there already and stays; the packets are read by what it says");
    return;
  }
  write_whole_file(copy, text);
  outcome_.notes.push_back("what the sensor says of itself went with it: " + copy.string());
}

void PacketConversion::tell() {
  copy_metadata();
  outcome_.points = lane_.points();
  const std::vector<std::string>& notes = lane_.recording().notes();
  outcome_.notes.insert(outcome_.notes.end(), notes.begin(), notes.end());
  if (!is_all()) {
    outcome_.notes.emplace_back(
        "packets go whole: where one has the end of a scan and the beginning of the next, some "
        "firings of a neighbour go, too, and are read as a partial scan");
  }
  if (of_no_time_ > 0) {
    outcome_.losses.push_back("lost: " + std::to_string(of_no_time_) +
                              " packets stamped before 1970 or after 2106, which pcap cannot say");
  }
  if (is_pcapng(input_)) {
    outcome_.losses.emplace_back(
        "lost: what pcapng has besides packets (names of interfaces, comments)");
  }
}

}  // namespace

ConversionOutcome convert_packets(const ConversionRequest& request,
                                  const ConversionListener& listener) {
  return PacketConversion(request, listener).execute();
}

}  // namespace surefoot::io
