// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <utility>

#include "io/packets/datagram_writer.hpp"
#include "io/packets/packet_intake.hpp"
#include "live/scan_stream.hpp"

namespace surefoot::live {
namespace {

using Clock = std::chrono::steady_clock;

class PacketStream final : public ScanStream {
 public:
  PacketStream(std::unique_ptr<DatagramSource> source, const io::OpenOptions& options,
               std::string metadata, const std::filesystem::path& record)
      : source_(std::move(source)),
        writer_(record.empty() ? nullptr : std::make_unique<io::DatagramWriter>(record)),
        intake_(options, std::move(metadata)) {}

  std::optional<LiveScan> next(const std::function<bool()>& go_on) override {
    source_->ask(go_on);
    while (true) {
      if (std::optional<io::ScanItem> item = intake_.scans().take()) {
        if (writer_) writer_->flush();
        return LiveScan{std::move(*item), last_.value_or(Clock::time_point{})};
      }
      if (ended_) return std::nullopt;
      if (!go_on() || !receive()) end();
    }
  }

  StreamState state() const override {
    StreamState state;
    state.received = datagrams_;
    state.lost = source_->overflowed();
    state.packets = intake_.counts();
    state.packets.packets = datagrams_;
    state.notes = intake_.scans().notes();
    state.notes.insert(state.notes.end(), end_notes_.begin(), end_notes_.end());
    state.description = intake_.scans().sensor() + " live from " + source_->name() +
                        ", return mode " + intake_.scans().return_mode();
    return state;
  }
  std::optional<Clock::time_point> last() const override { return last_; }
  bool patient() const override { return source_->patient(); }

  std::string nothing_text() const override {
    if (intake_.counts().data_packets > 0) return {};
    return source_->name() + ": " + std::to_string(datagrams_) +
           " datagrams, no LiDAR's data packet" + intake_.port_text() + " among them" +
           (datagrams_ > 0 ? intake_.traffic_seen() : std::string());
  }

 private:
  /// False at the end.
  bool receive() {
    const Received received = source_->receive(arrival_);
    if (received != Received::something) return received == Received::nothing;
    last_ = arrival_.received;
    ++datagrams_;
    if (writer_) writer_->add(arrival_.arrival_ns, arrival_.datagram);
    intake_.add(arrival_.arrival_ns, arrival_.datagram);
    return true;
  }

  void end() {
    ended_ = true;
    last_ = Clock::now();  // only now is it known that the last scan is complete
    intake_.scans().finish();
    if (writer_) writer_->flush();
    if (intake_.scans().lost() > 0) {
      end_notes_.push_back("by the sensor's clock " + std::to_string(intake_.scans().lost()) +
                           " data packets are missing");
    }
    if (const std::string why = source_->ended_early(); !why.empty()) {
      end_notes_.push_back("it ends early: " + why);
    }
    if (source_->overflowed() > 0) {
      end_notes_.push_back(std::to_string(source_->overflowed()) +
                           " datagrams were lost because the socket was full");
    }
  }

  std::unique_ptr<DatagramSource> source_;
  std::unique_ptr<io::DatagramWriter> writer_;
  io::PacketIntake intake_;
  Arrival arrival_;
  std::size_t datagrams_ = 0;
  std::optional<Clock::time_point> last_;
  std::vector<std::string> end_notes_;
  bool ended_ = false;
};

}  // namespace

std::unique_ptr<ScanStream> packet_stream(std::unique_ptr<DatagramSource> source,
                                          const io::OpenOptions& options, std::string metadata,
                                          const std::filesystem::path& record) {
  return std::make_unique<PacketStream>(std::move(source), options, std::move(metadata), record);
}

}  // namespace surefoot::live
