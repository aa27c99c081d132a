// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/sweep_bend.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace surefoot {
namespace {

constexpr std::size_t kSegments = 6;
constexpr std::int64_t kScanNs = 100'000'000;
constexpr double kSegment = 0.1 / kSegments;  // [s]

using Pattern = std::array<Twist, kSegments + 1>;  // of a scan's knots, LiDAR frame

/// Up and down once in a sweep, and a step where one ends and the next begins.
Pattern bend_of(double size) {
  Pattern pattern;
  for (std::size_t k = 0; k <= kSegments; ++k) {
    const double turn = static_cast<double>(k) / kSegments;
    pattern[k] << 0.2, 0.0, 0.5, 1.0, -2.0, 0.7;
    pattern[k] *= size * (std::sin(2.0 * std::numbers::pi * turn) + 0.5 * (turn - 0.5));
  }
  return pattern;
}

/// A robot that walks in a circle, its body swinging, but not in time with the sensor's turns.
Pose walking(double t, double swing) {
  const double yaw = 0.4 * t, beat = 2.0 * std::numbers::pi * 2.3 * t;
  const Pose body{so3_exp({0.0, 0.0, yaw}), {2.5 * std::sin(yaw), -2.5 * std::cos(yaw), 0.4}};
  return body * Pose{so3_exp(swing * Eigen::Vector3d(std::sin(beat), std::cos(2.0 * beat), 0.0)),
                     {0.0, 0.0, 0.3 * swing * std::sin(beat)}};
}

/// The n-th scan's knots on its true way, each moved by a pattern.
KnotWindow scan_of(int n, double swing, const Pattern& pattern, std::size_t segments = kSegments) {
  KnotWindow window{{}, kSegment, kSegment, n * kScanNs, (n + 1) * kScanNs};
  window.step = 0.1 / static_cast<double>(segments);
  for (std::size_t k = 0; k <= segments + 1; ++k) {
    const Pose pose = walking(0.1 * n + (static_cast<double>(k) - 1.0) * window.step, swing);
    const Twist& moved = pattern[k == 0 ? kSegments - 1 : (k - 1) % pattern.size()];
    window.knots.push_back(displaced(pose, rotated(pose.rotation, moved)));
  }
  return window;
}

/// RMS [m, rad] of the differences of two scans' knots.
double difference_of(const KnotWindow& one, const KnotWindow& other) {
  double squares = 0.0;
  for (std::size_t k = 0; k < one.knots.size(); ++k) {
    squares += difference(one.knots[k], other.knots[k]).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(one.knots.size()));
}

TEST(SweepBend, WhatIsTheSameInEveryScanIsTakenOutOfTheMotion) {
  const Pattern bend = bend_of(0.01);
  SweepBend bends;
  for (int n = 0; n < 8; ++n) bends.learn(scan_of(n, 0.0, bend));
  const KnotWindow bent = scan_of(8, 0.0, bend), truth = scan_of(8, 0.0, bend_of(0.0));
  // One in n is taken for straight, as the map it is learnt for.
  EXPECT_LT(difference_of(bends.straightened(bent), truth), 0.5 * difference_of(bent, truth));
}

TEST(SweepBend, ASwingOfTheBodyStays) {
  SweepBend bends;
  double changed = 0.0;
  for (int n = 0; n < 100; ++n) {
    const KnotWindow scan = scan_of(n, 0.02, bend_of(0.0));
    changed = std::max(changed, difference_of(bends.straightened(scan), scan));
    bends.learn(scan);
  }
  EXPECT_LT(changed, 0.0005);  // the swing is 0.02 rad; measured: 0.000005
}

// A map holds in equal parts what all its scans added; each is registered as it is bent.
TEST(SweepBend, AMapIsStraightenedAndNotBentTheOtherWay) {
  const double first = 0.01;
  SweepBend bends;
  double sum = first, worst = first;
  for (int n = 0; n < 60; ++n) {
    const double bent_by = sum / (n + 1);
    const KnotWindow registered = scan_of(n, 0.01, bend_of(bent_by));
    const KnotWindow added = bends.straightened(registered);
    bends.learn(registered);
    const KnotWindow truth = scan_of(n, 0.01, bend_of(0.0));
    const Twist was = difference(registered.knots[3], truth.knots[3]);
    const Twist is = difference(added.knots[3], truth.knots[3]);
    sum += bent_by * is.dot(was) / was.squaredNorm();
    worst = std::min(worst, sum / (n + 1));
  }
  EXPECT_LT(sum / 61.0, 0.2 * first);
  EXPECT_GT(worst, 0.0);  // measured: 0.0017; -0.0003 if u_k only fades
}

TEST(SweepBend, TheMeanPoseStays) {
  SweepBend bends;
  for (int n = 0; n < 10; ++n) bends.learn(scan_of(n, 0.0, bend_of(0.01)));
  const KnotWindow bent = scan_of(10, 0.0, bend_of(0.01));
  const KnotWindow straight = bends.straightened(bent);
  Twist mean = Twist::Zero();
  for (std::size_t k = 1; k < bent.knots.size(); ++k) {
    const bool outer = k == 1 || k + 1 == bent.knots.size();
    mean += (outer ? 0.5 : 1.0) * difference(straight.knots[k], bent.knots[k]);
  }
  EXPECT_LT(mean.norm() / kSegments, 1e-9);
}

TEST(SweepBend, FewScansTellNothingNorDoThoseFarApart) {
  const Pattern bend = bend_of(0.01);
  SweepBend few, apart;
  for (int n = 0; n < 5; ++n) few.learn(scan_of(n, 0.0, bend));
  for (int n = 0; n < 20; ++n) apart.learn(scan_of(6 * n, 0.0, bend));
  const KnotWindow bent = scan_of(120, 0.0, bend);
  EXPECT_EQ(difference_of(few.straightened(bent), bent), 0.0);
  EXPECT_EQ(difference_of(apart.straightened(bent), bent), 0.0);
  few.learn(scan_of(5, 0.0, bend));
  EXPECT_GT(difference_of(few.straightened(bent), bent), 0.0);
  few.clear();
  EXPECT_EQ(difference_of(few.straightened(bent), bent), 0.0);
}

TEST(SweepBend, AScanOfMoreSegmentsStaysAsItIs) {
  const Pattern bend = bend_of(0.01);
  SweepBend bends;
  for (int n = 0; n < 10; ++n) bends.learn(scan_of(n, 0.0, bend));
  const KnotWindow longer = scan_of(10, 0.0, bend, 2 * kSegments);
  EXPECT_EQ(difference_of(bends.straightened(longer), longer), 0.0);
  bends.learn(longer);
  const KnotWindow bent = scan_of(11, 0.0, bend);
  const KnotWindow before = bends.straightened(bent);
  bends.learn(bent);  // and with it from the longer one
  EXPECT_EQ(difference_of(bends.straightened(bent), before), 0.0);
}

TEST(SweepBend, AFirstScanOfMoreSegmentsIsNotHeldToBeUsual) {
  const Pattern bend = bend_of(0.01);
  SweepBend bends;
  bends.learn(scan_of(0, 0.0, bend));
  bends.learn(scan_of(1, 0.0, bend, 2 * kSegments));
  for (int n = 2; n < 12; ++n) bends.learn(scan_of(n, 0.0, bend));
  const KnotWindow bent = scan_of(12, 0.0, bend);
  EXPECT_GT(difference_of(bends.straightened(bent), bent), 0.0);
}

// Of what the scans of a long walk have in common, not all is the map's.
TEST(SweepBend, OfAnOlderMapAWeakBendIsNotBelieved) {
  const Pattern bend = bend_of(0.0003);
  SweepBend bends;
  for (int n = 0; n < 60; ++n) bends.learn(scan_of(n, 0.1, bend));
  const KnotWindow scan = scan_of(60, 0.1, bend);
  // By chance alone 0.00002 would be taken out of 0.0004.
  EXPECT_LT(difference_of(bends.straightened(scan), scan), 1e-9);
}

// By how much means differ is known by then: what does not wander is the map's.
TEST(SweepBend, OnALongWalkAWeakBendIsBelieved) {
  const Pattern bend = bend_of(0.0003);
  SweepBend bends;
  const auto left_after = [&](int n) {
    const KnotWindow bent = scan_of(n, 0.004, bend), truth = scan_of(n, 0.004, bend_of(0.0));
    return difference_of(bends.straightened(bent), truth) / difference_of(bent, truth);
  };
  for (int n = 0; n < 60; ++n) bends.learn(scan_of(n, 0.004, bend));
  EXPECT_GT(left_after(60), 0.9);
  for (int n = 60; n < 700; ++n) bends.learn(scan_of(n, 0.004, bend));
  EXPECT_LT(left_after(700), 0.6);  // measured: 0.45
}

// A gait that nearly keeps time with the sensor's turns bends each scan about as the last one.
TEST(SweepBend, ASwingThatNearlyKeepsTimeIsNotABend) {
  SweepBend bends;
  double changed = 0.0;
  for (int n = 0; n < 1500; ++n) {
    KnotWindow scan = scan_of(n, 0.0, bend_of(0.0));
    for (std::size_t k = 0; k < scan.knots.size(); ++k) {
      const double t = 0.1 * n + (static_cast<double>(k) - 1.0) * kSegment;
      const double swing = 0.01 * std::sin(2.0 * std::numbers::pi * 10.1 * t);
      scan.knots[k] = scan.knots[k] * Pose{so3_exp({0.0, swing, 0.0}), {}};
    }
    if (n > 100) changed = std::max(changed, difference_of(bends.straightened(scan), scan));
    bends.learn(scan);
  }
  EXPECT_LT(changed, 0.001);
}

// Who sets off, or into a turn, is faster at a scan's end than at its beginning, time and again.
TEST(SweepBend, WhoGetsFasterAndFasterIsNotABend) {
  SweepBend bends;
  double changed = 0.0;
  const auto turning = [](double t) {
    return Pose{so3_exp({0.0, 0.0, 1.5 * t * t}), {0.8 * t * t, 0.0, 0.4}};
  };
  for (int n = 0; n < 10; ++n) {
    KnotWindow window = scan_of(n, 0.0, bend_of(0.0));
    for (std::size_t k = 0; k < window.knots.size(); ++k) {
      window.knots[k] = turning(0.1 * n + (static_cast<double>(k) - 1.0) * kSegment);
    }
    changed = std::max(changed, difference_of(bends.straightened(window), window));
    bends.learn(window);
  }
  EXPECT_LT(changed, 0.001);
}

TEST(SweepBend, WhoStoodPerfectlyStillCanLearnYet) {
  const Pattern bend = bend_of(0.01);
  SweepBend bends;
  for (int n = 0; n < 10; ++n) {
    KnotWindow still = scan_of(n, 0.0, bend_of(0.0));
    for (Pose& knot : still.knots) knot = {};
    bends.learn(still);
  }
  for (int n = 10; n < 60; ++n) bends.learn(scan_of(n, 0.0, bend));
  const KnotWindow bent = scan_of(60, 0.0, bend);
  const KnotWindow truth = scan_of(60, 0.0, bend_of(0.0));
  EXPECT_LT(difference_of(bends.straightened(bent), truth), 0.5 * difference_of(bent, truth));
}

TEST(SweepBend, OneScanThatTurnsSuddenlyTellsLittle) {
  Pattern kink = bend_of(0.0);
  for (std::size_t k = 4; k <= kSegments; ++k) kink[k] << 0.0, 0.0, 0.0, 0.0, 0.0, 0.5;
  for (const auto& [at, scans] : {std::pair(6, 9), std::pair(25, 30)}) {
    SweepBend bends;
    for (int n = 0; n < scans; ++n) bends.learn(scan_of(n, 0.02, n == at ? kink : bend_of(0.0)));
    const KnotWindow scan = scan_of(scans, 0.02, bend_of(0.0));
    // Measured: 0.000004 rad, and counted in full 0.0039 in the young map.
    EXPECT_LT(difference_of(bends.straightened(scan), scan), 0.0005) << at;
  }
}

TEST(SweepBend, ItIsTheSensorsWhicheverWayThatFaces) {
  const Pattern bend = bend_of(0.01);
  const Pose turned{so3_exp({0.1, -0.2, 2.0}), {5.0, -3.0, 1.0}};
  const auto moved = [&](KnotWindow window) {
    for (Pose& knot : window.knots) knot = turned * knot;
    return window;
  };
  SweepBend here, there;
  for (int n = 0; n < 12; ++n) {
    here.learn(scan_of(n, 0.01, bend));
    there.learn(moved(scan_of(n, 0.01, bend)));
  }
  const KnotWindow bent = scan_of(12, 0.01, bend);
  EXPECT_LT(difference_of(there.straightened(moved(bent)), moved(here.straightened(bent))), 1e-9);
}

}  // namespace
}  // namespace surefoot
