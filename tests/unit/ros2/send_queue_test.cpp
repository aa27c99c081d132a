// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "ros2/send_queue.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace surefoot::ros2 {
namespace {

std::vector<std::string> contents(SendQueue& queue) {
  std::vector<std::string> all;
  while (!queue.empty()) all.push_back(queue.take_first().content);
  return all;
}

TEST(SendQueue, GivesThemAsTheyCame) {
  SendQueue queue;
  for (const char* content : {"a", "b", "c"}) queue.add({content[0] == 'b' ? 1U : 0U, content}, 2);
  EXPECT_EQ(contents(queue), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_TRUE(queue.empty());
}

// Clouds for whom nobody waits do not cost the others theirs, least of all what is told once.
TEST(SendQueue, WhereTooManyOfATopicWaitItsOldestGoes) {
  SendQueue queue;
  constexpr std::size_t kClouds = 0, kTransforms = 1, kFixed = 2;
  queue.add({kFixed, "fixed"}, 1);
  queue.add({kTransforms, "t0"}, 10);
  for (int i = 0; i < 100; ++i) queue.add({kClouds, "c" + std::to_string(i)}, 2);
  queue.add({kTransforms, "t1"}, 10);
  EXPECT_EQ(contents(queue), (std::vector<std::string>{"fixed", "t0", "c98", "c99", "t1"}));
  queue.add({kFixed, "old"}, 1);
  queue.add({kFixed, "new"}, 1);
  EXPECT_EQ(contents(queue), std::vector<std::string>{"new"});
}

}  // namespace
}  // namespace surefoot::ros2
