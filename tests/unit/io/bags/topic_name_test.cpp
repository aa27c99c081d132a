// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/bags/topic_name.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "io/conversion.hpp"

namespace surefoot::io {
namespace {

TEST(TopicName, IsWhatRosLetsATopicHave) {
  for (const char* name : {"/points", "points", "/robot_1/points", "/utlidar/cloud", "_p"}) {
    EXPECT_TRUE(is_topic_name(name)) << name;
  }
  for (const char* name : {"", "/", "//points", "/a//b", "/points/", "/bad topic", "/1st", "/a/1st",
                           "points\n", "/p\xc3\xbc"}) {
    EXPECT_FALSE(is_topic_name(name)) << name;
  }
}

TEST(TopicName, NoOtherIsWrittenToABag) {
  ConversionRequest request;
  request.input = "none.bag";
  request.output = "out.mcap";
  request.sink.topic = "a b";
  EXPECT_THROW((void)convert_recording(request, {}), std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::io
