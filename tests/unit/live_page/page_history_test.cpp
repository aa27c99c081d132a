// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "live_page/page_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot::live_page {
namespace {

PageScan scan_at(int i, int segment = 0) {
  PageScan scan;
  scan.name = std::to_string(i);
  scan.stamp_ns = 100'000'000LL * i;
  scan.status = "ok";
  scan.segment = segment;
  scan.T_world_lidar.translation.x() = i;
  return scan;
}

/// A flat square of so many points each way, ten to a metre.
PageCloud floor_of(int side, int segment = 0) {
  PageCloud cloud;
  cloud.segment = segment;
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      cloud.points.push_back(Eigen::Vector3f(0.1F * static_cast<float>(x) + 0.05F,
                                             0.1F * static_cast<float>(y) + 0.05F, 0.05F));
    }
  }
  return cloud;
}

std::size_t base64_bytes(const nlohmann::ordered_json& text) {
  const std::string value = text.get<std::string>();
  const auto padding = static_cast<std::size_t>(std::count(value.begin(), value.end(), '='));
  return value.size() / 4 * 3 - padding;
}

std::size_t poses_in(const nlohmann::ordered_json& news) { return news["path"]["statuses"].size(); }

std::size_t points_in(const nlohmann::ordered_json& news) {
  const auto& positions = news["map"]["positions"];
  return positions.is_null() ? 0 : base64_bytes(positions["values"]) / 6;
}

TEST(PageHistory, TellsEachViewerWhatItHasNotBeenTold) {
  PageHistory history;
  Told early;
  EXPECT_TRUE(history.news(early)["scan"].is_null());
  for (int i = 0; i < 5; ++i) history.add(scan_at(i));
  auto news = history.news(early);
  EXPECT_EQ(poses_in(news), 5U);
  EXPECT_EQ(base64_bytes(news["path"]["positions"]), 5U * 12);
  EXPECT_EQ(news["scan"]["name"], "4");
  EXPECT_DOUBLE_EQ(news["scan"]["time"].get<double>(), 0.4);
  history.add(scan_at(5));
  news = history.news(early);
  EXPECT_EQ(poses_in(news), 1U);
  EXPECT_FALSE(news["path"]["anew"]);
  Told late;
  news = history.news(late);
  EXPECT_EQ(poses_in(news), 6U);
  EXPECT_TRUE(news["path"]["anew"]);
}

TEST(PageHistory, APathIsBoundedAndCoversTheWholeWay) {
  PageHistory::Limits limits;
  limits.poses = 100;
  PageHistory history(limits);
  Told told;
  for (int i = 0; i < 10'000; ++i) {
    history.add(scan_at(i));
    Told nobody;
    EXPECT_LE(poses_in(history.news(nobody)), 100U);
  }
  const auto news = history.news(told);
  for (const auto& status : news["path"]["statuses"]) EXPECT_EQ(status, "ok");
  EXPECT_GT(poses_in(news), 50U);
  EXPECT_EQ(news["scan"]["name"], "9999");
}

TEST(PageHistory, TheWayIsThatOfAllScansHoweverFewPosesAreKept) {
  PageHistory::Limits limits;
  limits.poses = 10;
  PageHistory history(limits);
  Told told;
  for (int i = 0; i < 100; ++i) {
    PageScan scan = scan_at(i);
    scan.T_world_lidar.translation.y() = i % 2;  // to and fro
    history.add(scan);
  }
  EXPECT_NEAR(history.news(told)["scan"]["way_m"].get<double>(), 99.0 * std::sqrt(2.0), 1e-9);
  history.add(scan_at(200, 1));
  EXPECT_EQ(history.news(told)["scan"]["way_m"], 0.0);
  history.add(scan_at(203, 1));
  EXPECT_EQ(history.news(told)["scan"]["way_m"], 3.0);
}

TEST(PageHistory, AMapIsBoundedAndToldInParts) {
  PageHistory::Limits limits;
  limits.points = 3000;
  limits.points_at_once = 1000;
  PageHistory history(limits);
  history.add(scan_at(0));
  history.add(floor_of(50));
  Told told;
  std::size_t points = 0;
  for (int i = 0; i < 3; ++i) points += points_in(history.news(told));
  EXPECT_EQ(points, 2500U);
  EXPECT_TRUE(history.all_told(told));
  history.add(floor_of(50));  // seen before
  EXPECT_TRUE(history.all_told(told));
  history.add(floor_of(100));
  auto news = history.news(told);
  EXPECT_TRUE(news["map"]["anew"]);
  EXPECT_GE(news["map"]["cube_m"], 0.2);
  points = points_in(news);
  while (!history.all_told(told)) points += points_in(history.news(told));
  EXPECT_LE(points, 3000U);
  EXPECT_GT(points, 600U);
}

TEST(PageHistory, ASegmentHasAPathAndAMapOfItsOwn) {
  PageHistory history;
  history.add(scan_at(0));
  history.add(floor_of(10));
  Told told;
  EXPECT_EQ(points_in(history.news(told)), 100U);
  history.add(scan_at(1, 1));
  history.add(floor_of(10));  // of the last one: too late
  const auto news = history.news(told);
  EXPECT_TRUE(news["path"]["anew"]);
  EXPECT_TRUE(news["map"]["anew"]);
  EXPECT_EQ(poses_in(news), 1U);
  EXPECT_EQ(points_in(news), 0U);
}

TEST(PageHistory, WhatIsNoNumberIsTold) {
  PageHistory history;
  PageScan scan = scan_at(0);
  scan.wrong_probability = std::numeric_limits<double>::quiet_NaN();
  history.add(scan);
  PageCloud cloud;
  cloud.points = {Eigen::Vector3f(NAN, 0, 0), Eigen::Vector3f(1e30F, 0, 0),
                  Eigen::Vector3f(1, 2, 3)};
  history.add(cloud);
  Told told;
  const auto news = history.news(told);
  EXPECT_TRUE(news["scan"]["wrong_probability"].is_null());
  EXPECT_EQ(points_in(news), 1U);
}

}  // namespace
}  // namespace surefoot::live_page
