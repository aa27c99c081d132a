// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/topic_publisher.hpp"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ros2/send_queue.hpp"

namespace surefoot::ros2 {
namespace {

/// Who listens slowly to clouds misses some; nobody's transforms wait meanwhile.
TopicQos qos_of(const std::string& topic) {
  if (topic == "/tf") return {.depth = 100};
  if (topic == "/tf_static") return {.depth = 1, .latched = true};
  const bool latched = topic.ends_with("/path") || topic.ends_with("/local_map");
  if (latched) return {.depth = 1, .latched = true, .waits = false};
  return {.depth = 10, .waits = !topic.ends_with("/scan")};
}

/// Of a topic's messages; of those that only the last counts of, one.
std::size_t most_waiting(const TopicQos& qos) {
  constexpr std::size_t kMost = 10;  // a scan has one
  return std::min(kMost, static_cast<std::size_t>(qos.depth));
}

class TopicPublisher final : public io::BagWriter {
 public:
  explicit TopicPublisher(std::shared_ptr<Participant> participant)
      : participant_(std::move(participant)), thread_([this] { send_all(); }) {}
  ~TopicPublisher() override { stop(); }

  std::size_t add_topic(const std::string& name, const io::MessageDefinition& definition) override {
    const auto [known, is_new] = numbers_.emplace(name, writers_.size());
    if (is_new) {
      const std::lock_guard lock(mutex_);
      const TopicQos qos = qos_of(name);
      writers_.push_back(
          {participant_->add_writer(message_topic(name, definition.type), qos), most_waiting(qos)});
    }
    return known->second;
  }

  void write(std::size_t topic, std::int64_t /*stamp_ns*/, std::string_view message) override {
    {
      const std::lock_guard lock(mutex_);
      waiting_.add({topic, std::string(message)}, writers_.at(topic).most_waiting);
    }
    changed_.notify_one();
  }

  void finish() override { stop(); }
  bool is_latched() const override { return true; }

 private:
  struct Writer {
    Participant::Endpoint endpoint;
    std::size_t most_waiting;
  };

  void send_all() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return !waiting_.empty() || stopped_; });
      if (waiting_.empty()) return;
      const SendQueue::Message first = waiting_.take_first();
      const Participant::Endpoint writer = writers_.at(first.topic).endpoint;
      lock.unlock();
      (void)Participant::write(writer, first.content);
      lock.lock();
    }
  }

  void stop() {
    {
      const std::lock_guard lock(mutex_);
      stopped_ = true;
    }
    changed_.notify_one();
    if (thread_.joinable()) thread_.join();
  }

  std::shared_ptr<Participant> participant_;
  std::map<std::string, std::size_t> numbers_;  ///< by topic
  std::mutex mutex_;                            ///< of what follows
  std::vector<Writer> writers_;
  std::condition_variable changed_;
  SendQueue waiting_;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<io::BagWriter> publish(std::shared_ptr<Participant> participant) {
  return std::make_unique<TopicPublisher>(std::move(participant));
}

}  // namespace surefoot::ros2
