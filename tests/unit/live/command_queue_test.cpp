// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live/command_queue.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace surefoot::live {
namespace {

CommandAnswer asked_and_worked(CommandQueue& queue,
                               const std::function<CommandAnswer(const std::string&)>& execute) {
  CommandAnswer answer;
  std::atomic<bool> answered{false};
  std::thread other([&] {
    answer = queue.ask("reset");
    answered = true;
  });
  while (!answered) queue.work(execute);
  other.join();
  return answer;
}

TEST(CommandQueue, DoesWhatIsAskedOnTheThreadThatWorks) {
  CommandQueue queue;
  const auto here = std::this_thread::get_id();
  const CommandAnswer answer = asked_and_worked(queue, [&](const std::string& command) {
    EXPECT_EQ(std::this_thread::get_id(), here);
    return CommandAnswer{true, command + " done"};
  });
  EXPECT_TRUE(answer.done);
  EXPECT_EQ(answer.text, "reset done");
}

TEST(CommandQueue, WhatIsThrownIsTheAnswer) {
  CommandQueue queue;
  const CommandAnswer answer = asked_and_worked(queue, [](const std::string&) -> CommandAnswer {
    throw std::runtime_error("the disk is full");
  });
  EXPECT_FALSE(answer.done);
  EXPECT_EQ(answer.text, "the disk is full");
}

TEST(CommandQueue, WhoWaitsIsToldOfTheEnd) {
  CommandQueue queue;
  CommandAnswer answer;
  std::thread other([&] { answer = queue.ask("reset"); });
  queue.close();
  other.join();
  EXPECT_FALSE(answer.done);
  EXPECT_EQ(answer.text, "the run has ended");
  EXPECT_EQ(queue.ask("reset").text, "the run has ended");
}

// Who asked was told so.
TEST(CommandQueue, WhatWasNotDoneBeforeTheEndIsNotDoneAfterIt) {
  CommandQueue queue;
  std::thread other([&] { (void)queue.ask("reset"); });
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  queue.close();
  other.join();
  int done = 0;
  queue.work([&](const std::string&) {
    ++done;
    return CommandAnswer{};
  });
  EXPECT_EQ(done, 0);
}

}  // namespace
}  // namespace surefoot::live
