// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/topic_publisher.hpp"

#include <condition_variable>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace surefoot::ros2 {
namespace {

constexpr std::size_t kMostWaiting = 60;  // some ten scans' messages

TopicQos qos_of(const std::string& topic) {
  if (topic == "/tf") return {true, 100, false};
  const bool latched =
      topic == "/tf_static" || topic.ends_with("/path") || topic.ends_with("/local_map");
  return latched ? TopicQos{true, 1, true} : TopicQos{true, 10, false};
}

class TopicPublisher final : public io::BagWriter {
 public:
  explicit TopicPublisher(std::shared_ptr<Participant> participant)
      : participant_(std::move(participant)), thread_([this] { send_all(); }) {}
  ~TopicPublisher() override { stop(); }

  std::size_t add_topic(const std::string& name, const io::MessageDefinition& definition) override {
    const auto [known, is_new] = numbers_.emplace(name, writers_.size());
    if (is_new) {
      writers_.push_back(
          participant_->add_writer(message_topic(name, definition.type), qos_of(name)));
    }
    return known->second;
  }

  void write(std::size_t topic, std::int64_t /*stamp_ns*/, std::string_view message) override {
    {
      const std::lock_guard lock(mutex_);
      if (waiting_.size() >= kMostWaiting) waiting_.pop_front();
      waiting_.push_back({writers_.at(topic), std::string(message)});
    }
    changed_.notify_one();
  }

  void finish() override { stop(); }
  bool is_latched() const override { return true; }

 private:
  struct Waiting {
    Participant::Endpoint writer;
    std::string message;
  };

  void send_all() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] { return !waiting_.empty() || stopped_; });
      if (waiting_.empty()) return;
      const Waiting first = std::move(waiting_.front());
      waiting_.pop_front();
      lock.unlock();
      (void)Participant::write(first.writer, first.message);
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
  std::vector<Participant::Endpoint> writers_;
  std::map<std::string, std::size_t> numbers_;  ///< by topic
  std::mutex mutex_;                            ///< of what follows
  std::condition_variable changed_;
  std::deque<Waiting> waiting_;
  bool stopped_ = false;
  std::thread thread_;
};

}  // namespace

std::unique_ptr<io::BagWriter> publish(std::shared_ptr<Participant> participant) {
  return std::make_unique<TopicPublisher>(std::move(participant));
}

}  // namespace surefoot::ros2
