// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bag_packet_conversion.hpp"

#include <algorithm>
#include <stdexcept>

#include "io/bags/bag_files.hpp"
#include "io/bags/bag_recording.hpp"
#include "io/file_writer.hpp"
#include "io/messages/packet_message.hpp"
#include "io/packet_choice.hpp"
#include "io/packets/datagram_writer.hpp"
#include "text/printable.hpp"

namespace surefoot::io {
namespace {

// The port that the maker's sensors send to: no bag tells it, and a capture has to.
std::uint16_t usual_port(const std::string& type) {
  constexpr std::uint16_t kOuster = 7502, kOthers = 2368;
  return type.find("PacketMsg") != std::string::npos ? kOuster : kOthers;
}

OpenOptions options_for(const ConversionRequest& request) {
  if (request.topics.size() > 1) {
    throw std::invalid_argument("a capture holds one sensor's packets: choose one with --topic");
  }
  OpenOptions options = request.reader;
  if (!request.topics.empty()) options.topic = request.topics.front();
  return options;
}

// Throws ReadError where it holds points.
BagTopic packet_topic(const ConversionRequest& request, const OpenOptions& options) {
  BagTopic bag = open_bag_topic(request.input, options);
  if (is_packet_type(bag.topic.type)) return bag;
  throw ReadError(request.input.string() + ": " + text::printable(bag.topic.name) +
                  " holds points, which cannot be turned back into packets; expected a sensor's "
                  "packets for a capture");
}

/// Copies the packets that are chosen; what could not be written.
class PacketCopy {
 public:
  PacketCopy(const std::filesystem::path& output, const Topic& topic, const PacketChoice& choice)
      : writer_(output), choice_(choice) {
    datagram_.content = FrameContent::udp;
    datagram_.destination_port = usual_port(topic.type);
  }

  void add(const MessagePacket& packet, std::int64_t logged_ns) {
    const std::uint64_t number = number_++;
    while (scan_ < choice_.scans.size() && number >= choice_.scans[scan_].end) ++scan_;
    const bool in_scan = scan_ < choice_.scans.size() && number >= choice_.scans[scan_].first;
    if (number < choice_.begin || number >= choice_.end || !(in_scan || choice_.every)) return;
    const std::int64_t stamp_ns = packet.stamp_ns == 0 ? logged_ns : packet.stamp_ns;
    constexpr std::int64_t kEnd = 4'294'967'296'000'000'000;  // of a capture's seconds
    if (stamp_ns < 0 || stamp_ns >= kEnd) {
      ++of_no_time_;
      return;
    }
    datagram_.payload = packet.bytes;
    writer_.add(stamp_ns, datagram_);
    ++written_;
  }
  void finish() { writer_.flush(); }
  [[nodiscard]] std::size_t written() const { return written_; }
  [[nodiscard]] std::size_t of_no_time() const { return of_no_time_; }
  [[nodiscard]] bool is_over() const { return number_ >= choice_.end; }

 private:
  DatagramWriter writer_;
  const PacketChoice& choice_;
  UdpDatagram datagram_;
  std::uint64_t number_ = 0;
  std::size_t scan_ = 0, written_ = 0, of_no_time_ = 0;
};

void copy_packets(const ConversionRequest& request, const Topic& topic,
                  const ConversionListener& listener, PacketCopy& copy,
                  ConversionOutcome& outcome) {
  const auto bag = open_bag(request.input);
  bag->want(topic.name);
  while (const std::optional<Message> message = bag->next()) {
    if (copy.is_over() || (outcome.interrupted = listener.interrupted())) break;
    if (message->topic->type != topic.type || message->topic->name != topic.name) continue;
    try {
      for_each_packet(*message,
                      [&](const MessagePacket& packet) { copy.add(packet, message->logged_ns); });
    } catch (const ReadError& error) {
      ++outcome.unreadable;
      listener.complain("cut short: " + text::printable(error.what()));
    }
    listener.progress(outcome.scans, 0.5 + 0.5 * bag->progress());
  }
  copy.finish();
}

}  // namespace

ConversionOutcome convert_bag_packets(const ConversionRequest& request,
                                      const ConversionListener& listener) {
  const OpenOptions options = options_for(request);
  const BagTopic bag = packet_topic(request, options);
  require_unused(request.output, false);
  ConversionOutcome outcome;
  ConversionLane lane(open_recording(request.input, options), request);
  const PacketChoice choice = choose_packets(lane, request, listener, outcome);
  if (outcome.interrupted) return outcome;
  UnfinishedOutput output(request.output, false);
  PacketCopy copy(output.path(), bag.topic, choice);
  copy_packets(request, bag.topic, listener, copy, outcome);
  if (outcome.interrupted) return outcome;
  output.finish();
  outcome.packets = copy.written();
  outcome.points = lane.points();
  write_metadata_beside(request.output, bag.calibration, outcome);
  const std::vector<std::string>& notes = lane.recording().notes();
  outcome.notes.insert(outcome.notes.end(), notes.begin(), notes.end());
  note_neighbours(choice, outcome);
  if (copy.of_no_time() > 0) {
    outcome.losses.push_back("lost: " + std::to_string(copy.of_no_time()) +
                             " packets stamped before 1970 or after 2106, which pcap cannot say");
  }
  outcome.losses.emplace_back(
      "lost: the bag's other topics, and the messages around the packets; the sensor's address and "
      "port, which no bag tells, are 0.0.0.0 and its maker's");
  return outcome;
}

}  // namespace surefoot::io
