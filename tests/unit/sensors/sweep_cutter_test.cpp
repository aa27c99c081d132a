// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/sweep_cutter.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

namespace surefoot::sensors {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kStamp = 1'700'000'000'000 * kMs;

/// Ten firings of a head that turns in 100 ms, a millisecond and a point each.
Firings packet_at(double azimuth_deg, bool with_points = true) {
  Firings packet;
  for (int i = 0; i < 10; ++i) {
    Firing firing;
    firing.offset_ns = i * kMs;
    firing.duration_ns = kMs;
    firing.azimuth_deg = azimuth_deg + 3.6 * i;
    firing.turned_deg = 3.6;
    if (with_points) packet.points.push_back({{1.0F, 0.0F, 0.0F}, 1.0F, 0, 0});
    firing.end = packet.points.size();
    packet.firings.push_back(firing);
  }
  return packet;
}

SweepCutter cutter() { return {SweepEnd::azimuth, 0.0, 360.0}; }

std::vector<std::size_t> points_of_sweeps(SweepCutter& sweeps) {
  sweeps.finish();
  std::vector<std::size_t> points;
  while (const std::optional<Sweep> sweep = sweeps.take()) {
    points.push_back(sweep->scan.points.size());
  }
  return points;
}

// The head stands where the azimuth goes on, but some turns later.
TEST(SweepCutter, AHoleOfWholeTurnsEndsASweep) {
  for (const std::int64_t since_last : {10 * kMs, 310 * kMs}) {
    SweepCutter sweeps = cutter();
    sweeps.add(packet_at(36.0), kStamp, 10 * kMs);
    sweeps.add(packet_at(72.0), kStamp + since_last, since_last);
    const bool hole = since_last > 100 * kMs;
    EXPECT_EQ(points_of_sweeps(sweeps),
              hole ? (std::vector<std::size_t>{10, 10}) : (std::vector<std::size_t>{20}));
  }
}

TEST(SweepCutter, AClockThatJumpsEndsASweep) {
  for (const std::int64_t jump : {-3'600'000 * kMs, -600 * kMs, -50 * kMs, 50 * kMs, 600 * kMs}) {
    SweepCutter sweeps = cutter();
    sweeps.add(packet_at(36.0), kStamp, 10 * kMs);
    sweeps.add(packet_at(72.0), kStamp + jump, 10 * kMs);
    EXPECT_EQ(points_of_sweeps(sweeps).size(), std::abs(jump) > 500 * kMs ? 2U : 1U) << jump;
  }
}

TEST(SweepCutter, WhatComesLateHasAPlaceInItsOwnSweepAlone) {
  SweepCutter sweeps = cutter();
  EXPECT_FALSE(sweeps.add_late(packet_at(36.0), kStamp)) << "there is none";
  sweeps.add(packet_at(36.0), kStamp, 10 * kMs);
  sweeps.add(packet_at(108.0), kStamp + 20 * kMs, 20 * kMs);
  EXPECT_FALSE(sweeps.add_late(packet_at(0.0), kStamp - 10 * kMs)) << "of the sweep before";
  EXPECT_FALSE(sweeps.add_late(packet_at(0.0), kStamp + 600 * kMs)) << "of a later one";
  EXPECT_TRUE(sweeps.add_late(packet_at(72.0), kStamp + 10 * kMs));
  EXPECT_EQ(points_of_sweeps(sweeps), std::vector<std::size_t>{30});
}

TEST(SweepCutter, ASweepThatWasNotFollowedSharesNoPacket) {
  SweepCutter sweeps = cutter();
  sweeps.add(packet_at(340.0), kStamp, 10 * kMs);  // past the cut in the middle of it
  sweeps.finish();
  EXPECT_FALSE(sweeps.take()->shares_packet);
  SweepCutter followed = cutter();
  Firings over = packet_at(340.0);
  for (Firing& firing : over.firings) {
    if (firing.azimuth_deg >= 360.0) firing.azimuth_deg -= 360.0;
  }
  followed.add(over, kStamp, 10 * kMs);
  EXPECT_TRUE(followed.take()->shares_packet);
  followed.finish();
  EXPECT_FALSE(followed.take()->shares_packet);
}

// A clock that stands ends no sweep of a sensor that is cut by time.
TEST(SweepCutter, HasNoMorePointsThanTheLargestSensorsSweep) {
  SweepCutter sweeps(SweepEnd::time, 0.0, 360.0);
  Firings packet;
  packet.points.assign(500'000, {{1.0F, 0.0F, 0.0F}, 1.0F, 0, 0});
  packet.firings.push_back({.end = packet.points.size()});
  for (int i = 0; i < 9; ++i) sweeps.add(packet, kStamp, 0);
  EXPECT_FALSE(sweeps.take().has_value());
  sweeps.add(packet, kStamp, 0);
  EXPECT_TRUE(sweeps.take().has_value());
}

TEST(SweepCutter, AFewFiringsThatMetNothingAreNoScan) {
  SweepCutter sweeps = cutter();
  sweeps.add(packet_at(36.0, false), kStamp, 10 * kMs);
  EXPECT_TRUE(points_of_sweeps(sweeps).empty());
}

}  // namespace
}  // namespace surefoot::sensors
