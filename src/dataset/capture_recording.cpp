// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "dataset/capture_recording.hpp"

#include <cmath>
#include <cstdio>
#include <map>

#include "dataset/capture_file.hpp"
#include "dataset/sensor_clock.hpp"
#include "dataset/vlp16_packet.hpp"
#include "dataset/vlp16_revolutions.hpp"

namespace surefoot::dataset {
namespace {

constexpr std::size_t kPositionPacketBytes = 512;
constexpr std::uint16_t kPositionPort = 8308;

class CaptureRecording final : public Recording {
 public:
  CaptureRecording(CaptureFile file, std::string name, const OpenOptions& options)
      : file_(std::move(file)), name_(std::move(name)), options_(options), revolutions_(options) {
    // So that a capture of something else is refused when it is opened.
    while (!revolutions_.pending() && read_frame()) {
    }
    if (counts_.data_packets == 0) {
      throw ReadError(name_ + ": " + std::to_string(counts_.packets) +
                      " packets, no VLP-16 data packet of 1206 bytes to UDP port " +
                      std::to_string(options_.udp_port) + " among them" + traffic_seen());
    }
    notes_.push_back("return mode: " + return_mode_name(return_mode_));
    notes_.push_back(clock_.note());
  }

  std::optional<ScanItem> next() override {
    std::optional<Revolution> revolution = revolutions_.take();
    while (!revolution && !ended_) {
      if (!read_frame()) {
        end();
      }
      revolution = revolutions_.take();
    }
    if (!revolution) {
      return std::nullopt;
    }
    ScanItem item;
    item.name = "revolution " + std::to_string(next_++);
    item.layout = "VLP-16 packets: distance u16, reflectivity u8, time u32";
    if (!revolution->is_whole()) {
      char text[64];
      std::snprintf(text, sizeof(text), "partial revolution: firings over %.1f of 360 deg",
                    revolution->turned_deg);
      item.remark = text;
    }
    item.scan = std::move(revolution->scan);
    return item;
  }

  std::optional<std::size_t> size() const override { return std::nullopt; }
  void skip(std::size_t scans) override {
    while (scans > 0 && next()) {
      --scans;
    }
  }
  double progress() const override { return ended_ ? 1.0 : file_.progress(); }
  const std::vector<std::string>& notes() const override { return notes_; }
  std::string description() const override {
    return "VLP-16 capture, return mode " + return_mode_name(return_mode_);
  }
  CaptureCounts capture_counts() const override { return counts_; }

 private:
  void end() {
    ended_ = true;
    revolutions_.finish();
    if (!file_.cut_short().empty()) {
      notes_.push_back("the capture is cut short: " + file_.cut_short());
    }
    if (counts_.lost > 0) {
      notes_.push_back("by the sensor's clock " + std::to_string(counts_.lost) +
                       " data packets are missing");
    }
  }

  // Reads one frame; false at the end.
  bool read_frame() {
    const std::optional<CapturedFrame> frame = file_.next();
    if (!frame) {
      return false;
    }
    ++counts_.packets;
    const UdpDatagram datagram = find_udp(file_.link(), frame->bytes);
    const bool to_port = datagram.destination_port == options_.udp_port;
    if (datagram.content == FrameContent::kTruncated) {
      ++counts_.truncated;
    } else if (datagram.content == FrameContent::kOther) {
      ++counts_.other;
    } else if (datagram.destination_port == kPositionPort &&
               datagram.payload.size() == kPositionPacketBytes) {
      ++counts_.position_packets;
    } else if (!to_port) {
      ++counts_.other;
      remember_traffic(datagram);
    } else if (const auto packet = parse_vlp16_packet(datagram.payload)) {
      use(*packet, frame->stamp_ns);
    } else {
      ++counts_.truncated;
      remember_traffic(datagram);
    }
    return true;
  }

  void use(const Vlp16Packet& packet, std::int64_t capture_ns) {
    const bool known =
        packet.product == vlp16::kProductVlp16 && !return_mode_name(packet.return_mode).empty();
    if (!known && counts_.data_packets == 0) {
      throw ReadError(name_ + ": data packets of product " + product_name(packet.product) +
                      ", return mode " + std::to_string(packet.return_mode) +
                      "; expected product 0x22 (VLP-16), return mode 55, 56 or 57");
    }
    const std::optional<SensorClock::Reading> reading =
        known ? clock_.read(packet.past_hour_us, capture_ns) : std::nullopt;
    if (!reading) {
      ++counts_.other;  // another sensor's, repeated, or out of order
      return;
    }
    ++counts_.data_packets;
    return_mode_ = packet.return_mode;
    if (reading->jumped) {
      revolutions_.finish();
      notes_.push_back("the sensor's clock was set during revolution " + std::to_string(next_) +
                       "; the capture's clock bridges it");
    } else {
      count_lost(packet, reading->since_last_ns);
    }
    revolutions_.add(packet, reading->stamp_ns, reading->since_last_ns);
  }

  void count_lost(const Vlp16Packet& packet, std::int64_t since_last_ns) {
    const double period_ns = vlp16::kSequenceNs * static_cast<double>(packet.sequences());
    const double packets = std::round(static_cast<double>(since_last_ns) / period_ns);
    counts_.lost += packets > 1.0 ? static_cast<std::size_t>(packets) - 1 : 0;
  }

  void remember_traffic(const UdpDatagram& datagram) {
    constexpr std::size_t kMostKinds = 64;
    if (counts_.data_packets == 0 && traffic_.size() < kMostKinds) {
      ++traffic_[{datagram.destination_port, datagram.payload.size()}];
    }
  }

  std::string traffic_seen() const {
    auto most = traffic_.begin();
    for (auto it = traffic_.begin(); it != traffic_.end(); ++it) {
      most = it->second > most->second ? it : most;
    }
    return most == traffic_.end() ? std::string("; no UDP at all")
                                  : "; most are of " + std::to_string(most->first.second) +
                                        " bytes to port " + std::to_string(most->first.first);
  }

  CaptureFile file_;
  std::string name_;
  OpenOptions options_;
  Vlp16Revolutions revolutions_;
  SensorClock clock_;
  CaptureCounts counts_;
  std::map<std::pair<std::uint16_t, std::size_t>, std::size_t> traffic_;  ///< by port and size
  std::vector<std::string> notes_;
  std::uint8_t return_mode_ = 0;
  std::size_t next_ = 0;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<Recording> open_capture(const std::filesystem::path& file,
                                        const OpenOptions& options) {
  try {
    return std::make_unique<CaptureRecording>(CaptureFile(file), file.string(), options);
  } catch (const ReadError& error) {
    const std::string what = error.what();
    throw ReadError(what.starts_with(file.string()) ? what : file.string() + ": " + what);
  }
}

std::unique_ptr<Recording> open_capture(std::FILE* file, const std::string& name,
                                        const OpenOptions& options) {
  return std::make_unique<CaptureRecording>(CaptureFile(file), name, options);
}

}  // namespace surefoot::dataset
