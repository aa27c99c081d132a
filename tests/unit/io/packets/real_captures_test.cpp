// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Captures of sensors, which lie beside the project.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "io/recording.hpp"

namespace surefoot::io {
namespace {

std::filesystem::path shared(const char* file) {
  return std::filesystem::path(SUREFOOT_SHARED_DATA) / file;
}

TEST(Capture, ARealSensor) {
  const auto file = shared("vlp16_pcap/sample_velodyne_vlp16_gps.pcap");
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << file << " is absent";
  }
  const auto recording = open_recording(file);
  std::vector<ScanItem> items;
  while (auto item = recording->next()) {
    items.push_back(std::move(*item));
  }
  ASSERT_EQ(items.size(), 5U);
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_EQ(items[i].remark.empty(), i >= 1 && i <= 3) << items[i].remark;
  }
  for (std::size_t i = 2; i <= 4; ++i) {  // 10 turns a second
    EXPECT_NEAR(double(items[i].scan->stamp_ns - items[i - 1].scan->stamp_ns), 1e8, 1e6);
  }
  EXPECT_EQ(recording->capture_counts().data_packets, 293U);
  EXPECT_EQ(recording->capture_counts().position_packets, 57U);
  EXPECT_EQ(recording->capture_counts().lost, 0U);
}

TEST(Capture, ARealHdl32) {
  const auto file = shared("other_pcap/sample_velodyne_hdl32.pcap");
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << file << " is absent";
  }
  const auto recording = open_recording(file);
  EXPECT_NE(recording->description().find("HDL-32E"), std::string::npos);
  std::size_t whole = 0;
  while (const auto item = recording->next()) {
    whole += item->remark.empty() ? 1 : 0;
    EXPECT_EQ(*std::max_element(item->scan->rings.begin(), item->scan->rings.end()), 31);
  }
  EXPECT_GE(whole, 1U);
}

// Its packets are longer than a frame: fragments. What the sensor says about itself lies beside it.
TEST(Capture, ARealOuster) {
  const auto file = shared("ouster_os1/OS-1-128_v2.3.0_1024x10_lb_n3.pcap");
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << file << " is absent";
  }
  const auto recording = open_recording(file);
  EXPECT_NE(recording->description().find("OS-1-128 capture"), std::string::npos);
  std::vector<std::size_t> points;
  while (const auto item = recording->next()) {
    EXPECT_EQ(item->remark, "");
    points.push_back(item->scan->points.size());
    const auto [first, last] =
        std::minmax_element(item->scan->times_ns.begin(), item->scan->times_ns.end());
    EXPECT_NEAR(1e-9 * (*last - *first), 0.0999, 2e-4);
  }
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[0] + points[1] + points[2], 322'536U);
  EXPECT_EQ(recording->capture_counts().data_packets, 192U);
  EXPECT_EQ(recording->capture_counts().lost, 0U);
}

}  // namespace
}  // namespace surefoot::io
