// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <optional>

#include "io/recording.hpp"
#include "live/captured_datagrams.hpp"
#include "live/datagram_source.hpp"
#include "live/replay_pace.hpp"

namespace surefoot::live {
namespace {

class ReplaySource final : public DatagramSource {
 public:
  ReplaySource(const std::filesystem::path& file, double speed)
      : datagrams_(io::CaptureFile(file)), name_(file.string()), pace_(speed) {}

  Received receive(Arrival& arrival) override {
    if (!waiting_) waiting_ = datagrams_.next();
    if (!waiting_) return Received::end;
    if (!pace_.is_due(waiting_->arrival_ns)) return Received::nothing;
    arrival = *waiting_;
    arrival.received = std::chrono::steady_clock::now();
    waiting_.reset();
    return Received::something;
  }

  bool patient() const override { return pace_.is_at_once(); }
  std::string name() const override { return name_; }
  std::string ended_early() const override { return datagrams_.cut_short(); }

 private:
  CapturedDatagrams datagrams_;
  std::string name_;
  ReplayPace pace_;
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
