// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/point_cloud2_writer.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "io/messages/cloud_message.hpp"
#include "io/scan_builder.hpp"
#include "unit/io/support.hpp"

namespace surefoot::io {
namespace {

TEST(PointCloud2Writer, WhatIsWrittenIsReadBack) {
  Scan scan;
  scan.stamp_ns = -1'500'000'000;
  for (int i = 0; i < 3; ++i) {
    scan.points.emplace_back(1.0F + static_cast<float>(i), -2.0F, 0.25F);
    scan.intensities.push_back(0.5F);
    scan.times_ns.push_back(-100'000'000 + i * 50'000'000);
    scan.rings.push_back(static_cast<std::uint16_t>(i));
  }
  const std::string bytes = format_point_cloud2(scan, "frame", MessageWriter::Flavour::cdr);
  const CloudMessage cloud =
      read_cloud("sensor_msgs/PointCloud2", MessageEncoding::cdr, test::bytes_of(bytes));
  EXPECT_EQ(cloud.stamp_ns, scan.stamp_ns);
  EXPECT_EQ(cloud.frame, "frame");
  EXPECT_EQ(cloud.table.layout(),
            "PointCloud2: x f32, y f32, z f32, intensity f32, t i32, ring u16");
  const Scan back = build_scan(cloud.table, find_scan_columns(cloud.table, {}),
                               PointTimeRule{TimeUnit::nanoseconds, TimeReference::relative, true},
                               cloud.stamp_ns, StampAt::start)
                        .scan;
  EXPECT_EQ(back.points, scan.points);
  EXPECT_EQ(back.intensities, scan.intensities);
  EXPECT_EQ(back.times_ns, scan.times_ns);
  EXPECT_EQ(back.rings, scan.rings);
}

TEST(PointCloud2Writer, TellsTheLengthOfItsRowAndWhetherEachPointIsOne) {
  Scan scan;
  scan.points.assign(3, Eigen::Vector3f::Ones());
  const auto ros1 = [&] { return format_point_cloud2(scan, "f", MessageWriter::Flavour::ros1); };
  const std::string dense = ros1();
  constexpr std::uint32_t kRow = 3 * 12;
  EXPECT_EQ(dense.substr(dense.size() - 1 - kRow - 12, 12),
            test::little(12U) + test::little(kRow) + test::little(kRow));
  EXPECT_EQ(dense.back(), '\1');
  scan.points[1].y() = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(ros1().back(), '\0');
}

}  // namespace
}  // namespace surefoot::io
