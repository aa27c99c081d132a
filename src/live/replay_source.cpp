// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <optional>

#include "io/packets/capture_file.hpp"
#include "io/recording.hpp"
#include "live/datagram_source.hpp"
#include "live/replay_pace.hpp"

namespace surefoot::live {
namespace {

class ReplaySource final : public DatagramSource {
 public:
  ReplaySource(const std::filesystem::path& file, double speed)
      : file_(file), name_(file.string()), pace_(speed) {}

  Received receive(Arrival& arrival) override {
    if (!waiting_) waiting_ = next();
    if (!waiting_) return Received::end;
    if (!pace_.is_due(waiting_->arrival_ns)) return Received::nothing;
    arrival = *waiting_;
    arrival.received = std::chrono::steady_clock::now();
    waiting_.reset();
    return Received::something;
  }

  bool patient() const override { return pace_.is_at_once(); }
  std::string name() const override { return name_; }

 private:
  std::optional<Arrival> next() {
    while (const std::optional<io::CapturedFrame> frame = file_.next()) {
      io::IpFragment fragment;
      io::UdpDatagram datagram = io::find_udp(file_.link(), frame->bytes, &fragment);
      if (datagram.content == io::FrameContent::fragment) datagram = fragments_.add(fragment);
      if (datagram.content != io::FrameContent::udp) continue;
      return Arrival{datagram, frame->stamp_ns, {}};
    }
    return std::nullopt;
  }

  io::CaptureFile file_;
  std::string name_;
  ReplayPace pace_;
  io::FragmentBuffer fragments_;
  std::optional<Arrival> waiting_;
};

}  // namespace

std::unique_ptr<DatagramSource> replay_capture(const std::filesystem::path& file, double speed) {
  try {
    return std::make_unique<ReplaySource>(file, speed);
  } catch (const io::ReadError& error) {
    throw io::ReadError(file.string() + ": " + error.what());
  }
}

}  // namespace surefoot::live
