// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/topic_subscription.hpp"

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <utility>

#include "io/bags/topic_name.hpp"
#include "io/messages/cloud_message.hpp"
#include "io/messages/packet_message.hpp"
#include "io/recording.hpp"
#include "ros2/cyclone_log.hpp"
#include "ros2/names.hpp"
#include "ros2/raw_type.hpp"
#include "text/printable.hpp"

namespace surefoot::ros2 {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kLongestWait(100);
constexpr std::chrono::seconds kPatience(3);  // before it is said what is waited for
constexpr int kDepth = 5, kReliableDepth = 100;

bool is_readable(const SeenTopic& topic) {
  return io::is_cloud_type(topic.type) || io::is_packet_type(topic.type);
}

class TopicSubscription final : public live::TopicSource {
 public:
  TopicSubscription(std::shared_ptr<Participant> participant, SubscriptionOptions options)
      : participant_(std::move(participant)), options_(std::move(options)), begun_(Clock::now()) {
    if (!io::is_topic_name(options_.topic)) {
      throw std::invalid_argument("ROS 2 topic: got '" + text::printable(options_.topic) +
                                  "', expected a name such as /robot_1/points");
    }
    options_.topic = topic_of(wire_topic(options_.topic));
  }

  live::Received receive(live::TopicArrival& arrival) override {
    if (reader_.entity == 0 && !find_topic()) {
      std::this_thread::sleep_for(kLongestWait / 2);
      return live::Received::nothing;
    }
    if (take(arrival)) return live::Received::something;
    dds_attach_t attached = 0;
    (void)dds_waitset_wait(waitset_, &attached, 1, DDS_MSECS(kLongestWait.count()));
    if (take(arrival)) return live::Received::something;
    look_around();
    return live::Received::nothing;
  }

  const io::Topic& topic() const override { return topic_; }
  std::uint64_t lost() const override {
    dds_sample_lost_status_t status = {};
    if (reader_.entity == 0 || dds_get_sample_lost_status(reader_.entity, &status) < 0) return 0;
    return lost_before_ + status.total_count + overwritten_;
  }
  std::string name() const override {
    return "ROS 2 topic " + options_.topic + " (domain " + std::to_string(participant_->domain()) +
           ")";
  }

  std::string others() const override {
    std::string readable, text;
    std::size_t rest = 0;
    for (const SeenTopic& topic : participant_->seen_topics()) {
      if (!is_readable(topic)) {
        ++rest;
        continue;
      }
      readable += "\n  " + text::printable(topic.name) + " (" + text::printable(topic.type) + ", " +
                  (topic.reliable ? "reliable" : "best effort") + ")";
    }
    if (readable.empty()) {
      return "; no topic that scans can be made of is seen there, " + std::to_string(rest) +
             " others are";
    }
    return "; topics that scans can be made of:" + readable;
  }

 private:
  bool find_topic() {
    const std::vector<SeenTopic> seen = participant_->seen_topics();
    const auto named = [&](const SeenTopic& topic) { return topic.name == options_.topic; };
    const auto found = std::find_if(seen.begin(), seen.end(), [&](const SeenTopic& topic) {
      return named(topic) && is_readable(topic);
    });
    if (found != seen.end()) {
      begin(*found);
      return true;
    }
    const auto other = std::find_if(seen.begin(), seen.end(), named);
    if (other != seen.end()) {
      throw io::ReadError(name() + ": it is a " + text::printable(other->type) +
                          ", of which no scans can be made" + others());
    }
    if (!said_ && Clock::now() - begun_ > kPatience) say_once("nobody publishes it yet" + others());
    participant_->refresh();
    return false;
  }

  void begin(const SeenTopic& topic) {
    topic_ = {topic.name, topic.type, io::MessageEncoding::cdr};
    waitset_ = dds_create_waitset(DDS_CYCLONEDDS_HANDLE);
    listen();
    found_ = Clock::now();
    said_ = false;
  }

  void listen() {
    reader_ =
        participant_->add_reader(message_topic(topic_.name, topic_.type),
                                 {options_.reliable, options_.reliable ? kReliableDepth : kDepth,
                                  /*latched=*/false});
    (void)dds_set_status_mask(reader_.entity, DDS_DATA_AVAILABLE_STATUS);
    (void)dds_waitset_attach(waitset_, reader_.entity, 0);
    refused_before_ = refused_packets();
  }

  bool take(live::TopicArrival& arrival) {
    ddsi_serdata* sample = nullptr;
    dds_sample_info_t info;
    const std::uint64_t arrived = arrived_samples(reader_.type);  // what comes now is no loss
    while (dds_takecdr(reader_.entity, &sample, 1, &info, DDS_ANY_STATE) == 1) {
      const bool valid = info.valid_data;
      RawSample raw;
      if (valid) raw = copy_raw_sample(sample);
      ddsi_serdata_unref(sample);
      if (!valid) continue;  // somebody left
      arrival.bytes = std::move(raw.bytes);
      arrival.arrival_ns = raw.arrival_ns;
      arrival.received = raw.received;
      ++taken_;
      last_taken_ = raw.received;
      refused_before_ = refused_packets();
      return true;
    }
    overwritten_ = arrived - std::min(arrived, taken_);
    return false;
  }

  /// A sample that Cyclone refuses is asked for again and again, and what comes after it waits for
  /// it. A new reader begins after it.
  void pass_over_refused() {
    const bool is_silent = Clock::now() - last_taken_ > kPatience / 3;
    if (!options_.reliable || !is_silent || refused_packets() == refused_before_) return;
    lost_before_ = lost();
    taken_ = overwritten_ = 0;
    (void)dds_waitset_detach(waitset_, reader_.entity);
    participant_->remove_reader(reader_);
    listen();
    say_once("a message does not begin as CDR: it is passed over, with what waited for it");
  }

  /// While there is nothing to do.
  void look_around() {
    participant_->refresh();
    pass_over_refused();
    if (taken_ > 0 || Clock::now() - found_ < kPatience) return;
    dds_requested_incompatible_qos_status_t status = {};
    (void)dds_get_requested_incompatible_qos_status(reader_.entity, &status);
    if (status.total_count > 0) {
      say_once(options_.reliable ? "who publishes it offers best effort, and reliable is asked for"
                                 : "who publishes it offers other terms than are asked for");
    }
  }

  void say_once(const std::string& text) {
    if (!std::exchange(said_, true) && options_.say) options_.say(name() + ": " + text);
  }

  std::shared_ptr<Participant> participant_;
  SubscriptionOptions options_;
  io::Topic topic_;
  Participant::Endpoint reader_;
  dds_entity_t waitset_ = 0;
  Clock::time_point begun_, found_, last_taken_;
  std::uint64_t refused_before_ = 0;  ///< packets, when something was taken last
  std::uint64_t taken_ = 0;           ///< from the reader that there is
  std::uint64_t overwritten_ = 0;     ///< by newer ones, or, for a moment, about to be there
  std::uint64_t lost_before_ = 0;     ///< by a reader that there was
  bool said_ = false;
};

}  // namespace

std::unique_ptr<live::TopicSource> subscribe(std::shared_ptr<Participant> participant,
                                             SubscriptionOptions options) {
  return std::make_unique<TopicSubscription>(std::move(participant), std::move(options));
}

}  // namespace surefoot::ros2
