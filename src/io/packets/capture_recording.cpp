// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/capture_recording.hpp"

#include <map>

#include "io/ascii_values.hpp"
#include "io/file_reader.hpp"
#include "io/packets/capture_file.hpp"
#include "io/packets/packet_scans.hpp"

namespace surefoot::io {
namespace {

constexpr std::size_t kPositionPacketBytes = 512;
constexpr std::uint16_t kPositionPort = 8308;

class CaptureRecording final : public Recording {
 public:
  CaptureRecording(CaptureFile file, std::string name, std::string metadata,
                   const OpenOptions& options)
      : file_(std::move(file)),
        name_(std::move(name)),
        port_(options.udp_port),
        scans_(options, std::move(metadata)) {
    // So that a capture of something else is refused when it is opened.
    while (!scans_.pending() && read_frame()) {
    }
    if (counts_.data_packets == 0) {
      throw ReadError(
          name_ + ": " + std::to_string(counts_.packets) + " packets, no LiDAR's data packet" +
          (port_ != 0 ? " to UDP port " + std::to_string(port_) : std::string()) + " among them" +
          traffic_seen() + (file_.cut_short().empty() ? "" : "; cut short: " + file_.cut_short()));
    }
  }

  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = scans_.take();
    while (!item && !ended_) {
      if (!read_frame()) {
        end();
      }
      item = scans_.take();
    }
    return item;
  }

  std::optional<std::size_t> size() const override { return std::nullopt; }
  void skip(std::size_t scans) override {
    while (scans > 0 && next()) {
      --scans;
    }
  }
  double progress() const override { return ended_ ? 1.0 : file_.progress(); }
  const std::vector<std::string>& notes() const override {
    return ended_ ? notes_ : scans_.notes();
  }
  std::string description() const override {
    return scans_.sensor() + " capture, return mode " + scans_.return_mode();
  }
  CaptureCounts capture_counts() const override {
    CaptureCounts counts = counts_;
    counts.lost = scans_.lost();
    return counts;
  }

 private:
  // Where packets come from: the sensor's address, and the port that they go to.
  using Stream = std::pair<std::uint32_t, std::uint16_t>;

  void end() {
    ended_ = true;
    scans_.finish();
    notes_ = scans_.notes();
    if (!file_.cut_short().empty()) {
      notes_.push_back("the capture is cut short: " + file_.cut_short());
    }
    if (scans_.lost() > 0) {
      notes_.push_back("by the sensor's clock " + std::to_string(scans_.lost()) +
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
    IpFragment fragment;
    UdpDatagram datagram = find_udp(file_.link(), frame->bytes, &fragment);
    if (datagram.content == FrameContent::kFragment) {
      datagram = fragments_.add(fragment);
      if (datagram.content == FrameContent::kFragment) {
        ++counts_.fragments;
        return true;
      }
    }
    const Stream stream = {datagram.source_address, datagram.destination_port};
    if (datagram.content == FrameContent::kTruncated) {
      ++counts_.truncated;
    } else if (datagram.content == FrameContent::kOther) {
      ++counts_.other;
    } else if (datagram.destination_port == kPositionPort &&
               datagram.payload.size() == kPositionPacketBytes) {
      ++counts_.position_packets;
    } else if ((port_ != 0 && datagram.destination_port != port_) ||
               (counts_.data_packets > 0 && stream != stream_)) {
      ++counts_.other;
      remember_traffic(datagram);
    } else {
      use(datagram, frame->stamp_ns);
    }
    return true;
  }

  void use(const UdpDatagram& datagram, std::int64_t capture_ns) {
    switch (scans_.add(capture_ns, datagram.payload)) {
      case PacketUse::kUsed:
        // The first sensor's; a second one's would be mixed up with them.
        stream_ = {datagram.source_address, datagram.destination_port};
        ++counts_.data_packets;
        break;
      case PacketUse::kMalformed:
        ++counts_.truncated;
        remember_traffic(datagram);
        break;
      case PacketUse::kLate:
      case PacketUse::kOther:
        ++counts_.other;
        remember_traffic(datagram);
        break;
    }
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
    std::string seen = most == traffic_.end()
                           ? std::string("; no UDP at all")
                           : "; most are of " + std::to_string(most->first.second) +
                                 " bytes to port " + std::to_string(most->first.first);
    return scans_.reason().empty() ? seen : seen + ": " + scans_.reason();
  }

  CaptureFile file_;
  std::string name_;
  std::uint16_t port_;
  PacketScans scans_;
  CaptureCounts counts_;
  FragmentBuffer fragments_;
  Stream stream_ = {};
  std::map<std::pair<std::uint16_t, std::size_t>, std::size_t> traffic_;  ///< by port and size
  std::vector<std::string> notes_;
  bool ended_ = false;
};

// What an Ouster says about itself lies beside its capture: walk.json of walk.pcap.
std::string metadata_beside(std::filesystem::path file) {
  file.replace_extension(".json");
  std::error_code ignored;
  constexpr std::uintmax_t kMostBytes = 4'000'000;
  const std::uintmax_t size = std::filesystem::file_size(file, ignored);
  if (ignored || size > kMostBytes) {
    return {};
  }
  try {
    std::vector<std::byte> bytes;
    read_whole_file(file, bytes);
    return std::string(text_of(bytes));
  } catch (const ReadError&) {
    return {};
  }
}

}  // namespace

std::unique_ptr<Recording> open_capture(const std::filesystem::path& file,
                                        const OpenOptions& options) {
  try {
    return std::make_unique<CaptureRecording>(CaptureFile(file), file.string(),
                                              metadata_beside(file), options);
  } catch (const ReadError& error) {
    const std::string what = error.what();
    throw ReadError(what.starts_with(file.string()) ? what : file.string() + ": " + what);
  }
}

std::unique_ptr<Recording> open_capture(std::FILE* file, const std::string& name,
                                        const OpenOptions& options) {
  return std::make_unique<CaptureRecording>(CaptureFile(file), name, "", options);
}

}  // namespace surefoot::io
