// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <optional>
#include <utility>

#include "io/bags/bag_recording.hpp"
#include "live/replay_pace.hpp"
#include "live/topic_source.hpp"

namespace surefoot::live {
namespace {

class BagSource final : public TopicSource {
 public:
  BagSource(io::BagTopic bag, double speed)
      : bag_(std::move(bag)), name_(bag_.parts.bag), pace_(speed) {
    bag_.parts.messages.begin(bag_.topic);
  }

  Received receive(TopicArrival& arrival) override {
    if (!waiting_) waiting_ = bag_.parts.messages.next();
    if (!waiting_) return Received::end;
    if (!pace_.is_due(waiting_->logged_ns)) return Received::nothing;
    arrival.bytes.assign(waiting_->bytes.begin(), waiting_->bytes.end());
    arrival.arrival_ns = waiting_->logged_ns;
    arrival.received = std::chrono::steady_clock::now();
    waiting_.reset();
    return Received::something;
  }

  const io::Topic& topic() const override { return bag_.topic; }
  std::string calibration() const override { return bag_.calibration; }
  bool patient() const override { return pace_.is_at_once(); }
  std::string name() const override { return name_; }

 private:
  io::BagTopic bag_;
  std::string name_;
  ReplayPace pace_;
  std::optional<io::Message> waiting_;
};

}  // namespace

std::unique_ptr<TopicSource> replay_bag(const std::filesystem::path& path,
                                        const io::OpenOptions& options, double speed) {
  return std::make_unique<BagSource>(io::open_bag_topic(path, options), speed);
}

}  // namespace surefoot::live
