// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/command_queue.hpp"

#include <chrono>
#include <exception>
#include <utility>

namespace surefoot::live {
namespace {

constexpr std::chrono::seconds kLongestAnswer(10);
constexpr std::size_t kMostWaiting = 100;

}  // namespace

CommandAnswer CommandQueue::ask(const std::string& command) {
  std::unique_lock lock(mutex_);
  if (closed_) return {false, "the run has ended"};
  if (waiting_.size() >= kMostWaiting) return {false, "too many commands wait"};
  const auto asked = std::make_shared<Asked>(Asked{command, {}, false});
  waiting_.push_back(asked);
  const bool answered = changed_.wait_for(lock, kLongestAnswer, [&] { return asked->answered; });
  if (!answered) return {false, "it was not done within ten seconds, and may yet be"};
  return asked->answer;
}

void CommandQueue::work(const std::function<CommandAnswer(const std::string&)>& execute) {
  std::unique_lock lock(mutex_);
  while (!waiting_.empty()) {
    const std::shared_ptr<Asked> asked = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    CommandAnswer answer;
    try {
      answer = execute(asked->command);
    } catch (const std::exception& error) {
      answer = {false, error.what()};
    }
    lock.lock();
    asked->answer = std::move(answer);
    asked->answered = true;
    changed_.notify_all();
  }
}

void CommandQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  for (const std::shared_ptr<Asked>& asked : waiting_) {
    asked->answer = {false, "the run has ended"};
    asked->answered = true;
  }
  waiting_.clear();
  changed_.notify_all();
}

}  // namespace surefoot::live
