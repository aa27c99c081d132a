// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packet_conversion.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "io/bag_packet_conversion.hpp"
#include "io/bags/bag_files.hpp"
#include "io/bags/compression.hpp"
#include "io/conversion_lane.hpp"
#include "io/file_kind.hpp"
#include "io/file_writer.hpp"
#include "io/files/folder_listing.hpp"
#include "io/packet_choice.hpp"
#include "io/packets/capture_file.hpp"
#include "io/packets/frame_writer.hpp"
#include "io/packets/metadata_file.hpp"
#include "io/packets/udp_datagram.hpp"

namespace surefoot::io {
namespace {

namespace fs = std::filesystem;

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
    choice_ = choose_packets(lane_, request_, listener_, outcome_);
    if (outcome_.interrupted) return std::move(outcome_);
    UnfinishedOutput output(request_.output, false);
    copy_frames(output.path());
    if (outcome_.interrupted) return std::move(outcome_);
    output.finish();
    tell();
    return std::move(outcome_);
  }

 private:
  static fs::path capture_in(const fs::path& input);
  void note_idle_options();
  void copy_frames(const fs::path& output);
  void tell();

  const ConversionRequest& request_;
  const ConversionListener& listener_;
  fs::path input_;
  ConversionLane lane_;
  PacketChoice choice_;
  ConversionOutcome outcome_;
  std::size_t of_no_time_ = 0;
};

// Throws ReadError where it is none.
fs::path PacketConversion::capture_in(const fs::path& input) {
  std::error_code ignored;
  fs::path file = fs::is_directory(input, ignored) ? only_capture(input).value_or(input) : input;
  if (fs::is_regular_file(file, ignored) && kind_of(file) == FileKind::capture) return file;
  if (!fs::exists(file, ignored)) throw ReadError(file.string() + ": no such file or folder");
  throw ReadError(input.string() +
                  ": a capture is written of packets alone, another capture's or a bag's; points "
                  "cannot be turned back into them");
}

void PacketConversion::note_idle_options() {
  const auto idle = [&](bool given, const char* option) {
    if (given) outcome_.notes.push_back(std::string(option) + " counts for nothing here");
  };
  idle(!request_.topics.empty(), "--topic");
  idle(!request_.sink.topic.empty(), "--out-topic");
  idle(!request_.sink.frame.empty(), "--frame");
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
    if (!is_in_scan && !choice_.is_all() && is_of(sensor, from.link(), frame->bytes)) continue;
    to.add(*frame) ? ++outcome_.packets : ++of_no_time_;
    constexpr std::uint64_t kAtOnce = 1024;  // packets between two words of progress
    if (number % kAtOnce == 0) listener_.progress(outcome_.scans, 0.5 + 0.5 * from.progress());
  }
  outcome_.interrupted = listener_.interrupted();
  to.finish();
}

void PacketConversion::tell() {
  write_metadata_beside(request_.output, metadata_beside(input_).text, outcome_);
  outcome_.points = lane_.points();
  const std::vector<std::string>& notes = lane_.recording().notes();
  outcome_.notes.insert(outcome_.notes.end(), notes.begin(), notes.end());
  note_neighbours(choice_, outcome_);
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
  if (is_bag_input(request.input, request.reader)) return convert_bag_packets(request, listener);
  return PacketConversion(request, listener).execute();
}

}  // namespace surefoot::io
