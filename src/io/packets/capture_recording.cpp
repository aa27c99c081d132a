// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/packets/capture_recording.hpp"

#include <tuple>

#include "io/packets/capture_file.hpp"
#include "io/packets/metadata_file.hpp"
#include "io/packets/packet_intake.hpp"
#include "io/packets/packet_numbers.hpp"

namespace surefoot::io {
namespace {

class CaptureRecording final : public Recording {
 public:
  CaptureRecording(CaptureFile file, std::string name, MetadataFile metadata,
                   const OpenOptions& options)
      : file_(std::move(file)), name_(std::move(name)), intake_(options, metadata.text) {
    if (!metadata.remark.empty()) notes_.push_back(metadata.remark);
    // So that a capture of something else is refused when it is opened.
    while (!scans().pending() && read_frame()) {
    }
    if (intake_.counts().data_packets == 0) {
      throw ReadError(
          name_ + ": " + std::to_string(packets_) + (packets_ == 1 ? " packet" : " packets") +
          ", no LiDAR's data packet" + intake_.port_text() + " among them" +
          intake_.traffic_seen() +
          (metadata.text.empty() && !metadata.remark.empty() ? " (" + metadata.remark + ")" : "") +
          (file_.cut_short().empty() ? "" : "; cut short: " + file_.cut_short()));
    }
    gather_notes();
  }

  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = take();
    while (!item && !ended_) {
      if (!read_frame()) {
        end();
      }
      item = take();
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
  const std::vector<std::string>& notes() const override { return notes_; }
  std::vector<std::string> losses() const override {
    if (!ended_ || file_.cut_short().empty()) return {};
    return {"the capture is cut short: " + file_.cut_short()};
  }
  std::string description() const override {
    return scans().sensor() + " capture, return mode " + scans().return_mode();
  }
  CaptureCounts capture_counts() const override {
    CaptureCounts counts = intake_.counts();
    counts.packets = packets_;
    counts.fragments = fragments_seen_;
    return counts;
  }

 private:
  PacketScans& scans() { return intake_.scans(); }
  const PacketScans& scans() const { return intake_.scans(); }

  std::optional<ScanItem> take() {
    std::optional<ScanItem> item = scans().take();
    gather_notes();
    if (item) {
      item->packets = numbers_.take(ended_ || scans().shared_packet());
      std::tie(item->packets->source_address, item->packets->port) = intake_.stream();
    }
    return item;
  }

  void end() {
    ended_ = true;
    scans().finish();
    gather_notes();
    if (!file_.cut_short().empty()) {
      notes_.push_back("the capture is cut short: " + file_.cut_short());
    }
    if (scans().lost() > 0) {
      notes_.push_back("by the sensor's clock " + std::to_string(scans().lost()) +
                       " data packets are missing");
    }
  }

  void gather_notes() {
    const std::vector<std::string>& notes = scans().notes();
    for (; gathered_ < notes.size(); ++gathered_) notes_.push_back(notes[gathered_]);
    const std::vector<std::string>& others = intake_.notes();
    for (; gathered_others_ < others.size(); ++gathered_others_) {
      notes_.push_back(others[gathered_others_]);
    }
  }

  // Reads one frame; false at the end.
  bool read_frame() {
    const std::optional<CapturedFrame> frame = file_.next();
    if (!frame) {
      return false;
    }
    const std::uint64_t number = packets_++;
    std::uint64_t begin = number;
    IpFragment fragment;
    UdpDatagram datagram = find_udp(file_.link(), frame->bytes, &fragment);
    if (datagram.content == FrameContent::fragment) {
      parts_begin_ = parts_begin_.value_or(number);
      begin = *parts_begin_;
      datagram = fragments_.add(fragment);
      if (datagram.content == FrameContent::fragment) {
        ++fragments_seen_;
        return true;
      }
      parts_begin_.reset();
    }
    const std::size_t before = intake_.counts().data_packets;
    intake_.add(frame->stamp_ns, datagram);
    if (intake_.counts().data_packets > before) numbers_.note(begin, number + 1);
    return true;
  }

  CaptureFile file_;
  std::string name_;
  PacketIntake intake_;
  FragmentBuffer fragments_;
  std::size_t packets_ = 0;
  std::size_t fragments_seen_ = 0;
  std::vector<std::string> notes_;
  std::size_t gathered_ = 0;         ///< of the scans' notes
  std::size_t gathered_others_ = 0;  ///< of other sensors
  bool ended_ = false;
  PacketNumbers numbers_;
  std::optional<std::uint64_t> parts_begin_;  ///< number of the frame, of the next datagram's
};

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
  return std::make_unique<CaptureRecording>(CaptureFile(file), name, MetadataFile{}, options);
}

}  // namespace surefoot::io
