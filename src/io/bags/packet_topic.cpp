// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <deque>

#include "io/bags/topic_recordings.hpp"
#include "io/messages/packet_message.hpp"
#include "io/packets/packet_numbers.hpp"
#include "io/packets/packet_scans.hpp"

namespace surefoot::io {
namespace {

class PacketTopic final : public Recording {
 public:
  PacketTopic(TopicRecordingParts parts, const Topic& topic, const OpenOptions& options,
              std::string calibration)
      : parts_(std::move(parts)), scans_(options, std::move(calibration)) {
    parts_.messages.begin(topic);
    while (!scans_.pending() && items_.empty() && read_message()) {
    }
    gather_notes();
  }

  std::optional<ScanItem> next() override {
    while (items_.empty() && !ended_) {
      if (!read_message()) end();
    }
    if (items_.empty()) return std::nullopt;
    ScanItem item = std::move(items_.front());
    items_.pop_front();
    return item;
  }

  std::optional<std::size_t> size() const override { return std::nullopt; }
  void skip(std::size_t scans) override {
    while (scans > 0 && next()) --scans;
  }
  double progress() const override { return parts_.messages.progress(); }
  const std::vector<std::string>& notes() const override { return parts_.notes; }
  std::vector<std::string> losses() const override { return parts_.messages.losses(); }
  std::string topic() const override { return parts_.messages.topic().name; }
  std::string description() const override {
    return parts_.messages.description() + ", packets of " + scans_.sensor();
  }
  CaptureCounts capture_counts() const override {
    CaptureCounts counts = counts_;
    counts.lost = scans_.lost();
    counts.reordered = scans_.reordered();
    return counts;
  }

 private:
  // False at the end. A message that is damaged becomes an item without scan.
  bool read_message() {
    const std::optional<Message> message = parts_.messages.next();
    if (!message) {
      parts_.note_late_topics();
      return false;
    }
    const std::size_t number = messages_++;
    try {
      for_each_packet(*message, [&](const MessagePacket& packet) { add(packet, *message); });
    } catch (const ReadError& error) {
      ScanItem item;
      item.name = "message " + std::to_string(number);
      item.error =
          parts_.bag + ": " + message->topic->name + ", " + item.name + ": " + error.what();
      items_.push_back(std::move(item));
    }
    gather_notes();
    return true;
  }

  void add(const MessagePacket& packet, const Message& message) {
    logged_ns_ = message.logged_ns;
    const std::uint64_t number = counts_.packets++;
    const std::int64_t stamp_ns = packet.stamp_ns == 0 ? message.logged_ns : packet.stamp_ns;
    switch (scans_.add(stamp_ns, packet.bytes)) {
      case PacketUse::used:
        ++counts_.data_packets;
        numbers_.note(number, number + 1);
        break;
      case PacketUse::malformed:
        ++counts_.truncated;
        break;
      case PacketUse::late:
      case PacketUse::other:
        ++counts_.other;
        break;
    }
    take_scans();
  }

  void take_scans() {
    while (std::optional<ScanItem> item = scans_.take()) {
      item->packets = numbers_.take(ended_ || scans_.shared_packet());
      item->logged_ns = logged_ns_;
      items_.push_back(std::move(*item));
    }
  }

  void gather_notes() {
    const auto gather = [this](const std::vector<std::string>& notes, std::size_t& taken) {
      for (; taken < notes.size(); ++taken) parts_.notes.push_back(notes[taken]);
    };
    gather(scans_.notes(), scan_notes_);
    gather(parts_.messages.notes(), bag_notes_);
  }

  void end() {
    ended_ = true;
    scans_.finish();
    take_scans();
    gather_notes();
    if (scans_.lost() > 0) {
      parts_.notes.push_back("by the sensor's clock " + std::to_string(scans_.lost()) +
                             " data packets are missing");
    }
  }

  TopicRecordingParts parts_;
  PacketScans scans_;
  std::deque<ScanItem> items_;
  CaptureCounts counts_;
  PacketNumbers numbers_;
  std::size_t messages_ = 0;
  std::int64_t logged_ns_ = 0;  // of the last one with packets
  std::size_t scan_notes_ = 0;
  std::size_t bag_notes_ = 0;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<Recording> open_packet_topic(TopicRecordingParts parts, const Topic& topic,
                                             const OpenOptions& options, std::string calibration) {
  return std::make_unique<PacketTopic>(std::move(parts), topic, options, std::move(calibration));
}

}  // namespace surefoot::io
