// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <thread>

#include "io/packets/capture_file.hpp"
#include "io/recording.hpp"
#include "live/datagram_source.hpp"

namespace surefoot::live {
namespace {

using Clock = std::chrono::steady_clock;
constexpr Clock::duration kLongestWait = std::chrono::milliseconds(100);

class ReplaySource final : public DatagramSource {
 public:
  ReplaySource(const std::filesystem::path& file, double speed)
      : file_(file), name_(file.string()), speed_(speed) {}

  Received receive(Arrival& arrival) override {
    if (!waiting_) waiting_ = next();
    if (!waiting_) return Received::end;
    const Clock::time_point due = due_at(waiting_->arrival_ns);
    const Clock::time_point now = Clock::now();
    if (due > now) {
      std::this_thread::sleep_for(std::min(due - now, kLongestWait));
      if (due - now > kLongestWait) return Received::nothing;
    }
    arrival = *waiting_;
    arrival.received = Clock::now();
    waiting_.reset();
    return Received::something;
  }

  bool patient() const override { return speed_ <= 0.0; }
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

  /// Clocks of captures jump; a pause is waited for, but a minute at most.
  Clock::time_point due_at(std::int64_t stamp_ns) {
    if (patient()) return Clock::time_point::min();
    constexpr std::int64_t kLongestPause = 60'000'000'000;
    const std::int64_t since_ns =
        last_ns_ ? std::clamp<std::int64_t>(stamp_ns - *last_ns_, 0, kLongestPause) : 0;
    if (!last_ns_) due_ = Clock::now();
    due_ +=
        std::chrono::nanoseconds(static_cast<std::int64_t>(static_cast<double>(since_ns) / speed_));
    last_ns_ = stamp_ns;
    return due_;
  }

  io::CaptureFile file_;
  std::string name_;
  double speed_;
  io::FragmentBuffer fragments_;
  std::optional<Arrival> waiting_;
  std::optional<std::int64_t> last_ns_;
  Clock::time_point due_;
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
