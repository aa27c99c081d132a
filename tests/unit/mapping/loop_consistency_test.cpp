// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/loop_consistency.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "mapping/loop_solution.hpp"
#include "support/random.hpp"

namespace surefoot::mapping {
namespace {

/// Round a circle twice with an odometry that turns a little too far.
PoseGraph two_laps(std::vector<Pose>* truth = nullptr) {
  constexpr std::size_t kPerLap = 20;
  PoseGraph graph;
  Pose pose, true_pose;
  const Pose step = se3_exp((Twist() << 5.0, 0, 0, 0, 0, 2.0 * 3.14159265 / kPerLap).finished());
  for (std::size_t i = 0; i < 2 * kPerLap; ++i) {
    graph.poses.push_back(pose);
    if (truth != nullptr) truth->push_back(true_pose);
    true_pose = true_pose * step;
    const Pose drifted = step * se3_exp((Twist() << 0.02, 0, 0, 0, 0, 0.004).finished());
    if (i > 0) {
      PoseEdge edge;
      edge.from = i - 1;
      edge.to = i;
      edge.T_from_to = drifted;
      edge.information = Twist((Twist() << 400, 400, 400, 1e4, 1e4, 1e4).finished()).asDiagonal();
      graph.edges.push_back(edge);
    }
    pose = pose * drifted;
  }
  return graph;
}

PoseEdge loop(std::size_t from, std::size_t to, const Pose& motion) {
  PoseEdge edge;
  edge.from = from;
  edge.to = to;
  edge.T_from_to = motion;
  edge.information = 400.0 * Matrix6::Identity();
  edge.inlier = false;
  return edge;
}

TEST(LoopConsistency, RightLoopsAgreeAndAFalseOneIsAlone) {
  PoseGraph graph = two_laps();
  const std::size_t first = graph.edges.size();
  graph.edges.push_back(loop(2, 22, {}));
  graph.edges.push_back(loop(4, 24, {}));
  graph.edges.push_back(loop(6, 26, {}));
  Pose aside;
  aside.translation = {4.0, 2.0, 0.0};
  graph.edges.push_back(loop(5, 25, aside));
  const auto agree = pairwise_agreement(graph, {first, first + 1, first + 2, first + 3});
  EXPECT_EQ(largest_clique(agree), (std::vector<std::size_t>{0, 1, 2}));
  const std::vector<bool> supported = supported_loops(graph, 12);
  EXPECT_TRUE(supported[first] && supported[first + 1] && supported[first + 2]);
  EXPECT_FALSE(supported[first + 3]);
}

/// An odometry that goes wrong the same way on every metre is farther astray than its steps' own
/// covariances add up to.
TEST(LoopConsistency, WhatIsWrongAllAlongAddsUp) {
  std::vector<Pose> truth;
  PoseGraph graph = two_laps(&truth);
  for (PoseEdge& edge : graph.edges) {
    edge.way = 5.0;
    edge.information = 1e7 * Matrix6::Identity();
  }
  const std::size_t first = graph.edges.size();
  for (const std::size_t to : {22, 38}) {
    PoseEdge edge = loop(2, to, truth[2].inverse() * truth[to]);
    edge.information = 1e6 * Matrix6::Identity();
    graph.edges.push_back(edge);
  }
  EXPECT_FALSE(pairwise_agreement(graph, {first, first + 1})[0][1]);
  graph.systematic << 0.004, 0.004, 0.004, 8e-4, 8e-4, 8e-4;
  EXPECT_TRUE(pairwise_agreement(graph, {first, first + 1})[0][1]);
}

/// ... and cancels where two loops share it: the same lap walked twice.
TEST(LoopConsistency, WhatIsWrongAllAlongCancelsWhereLoopsShareIt) {
  PoseGraph graph = two_laps();
  for (PoseEdge& edge : graph.edges) {
    edge.way = 5.0;
    edge.information = 1e7 * Matrix6::Identity();
  }
  graph.systematic << 0.004, 0.004, 0.004, 8e-4, 8e-4, 8e-4;
  const std::size_t first = graph.edges.size();
  graph.edges.push_back(loop(2, 22, {}));
  Pose aside;
  aside.translation = {0.25, 0.25, 0.0};
  graph.edges.push_back(loop(12, 32, aside));
  for (std::size_t e = first; e < first + 2; ++e) {
    graph.edges[e].information = 1e4 * Matrix6::Identity();
  }
  EXPECT_FALSE(pairwise_agreement(graph, {first, first + 1})[0][1]);
  graph.edges[first + 1].T_from_to = {};
  EXPECT_TRUE(pairwise_agreement(graph, {first, first + 1})[0][1]);
}

/// Seen from elsewhere: a loop's own motion, and what its errors do at the end of it, count.
TEST(LoopConsistency, LoopsBetweenPlacesApartAgreeAsTheirMotionsSay) {
  std::vector<Pose> truth;
  PoseGraph graph = two_laps(&truth);
  const std::size_t first = graph.edges.size();
  const auto add = [&](std::size_t from, std::size_t to, const Pose& error) {
    graph.edges.push_back(loop(from, to, truth[from].inverse() * truth[to] * error));
  };
  add(2, 27, {});
  add(4, 33, {});
  Pose turned;
  turned.rotation = so3_exp({0.0, 0.0, 0.12});
  add(6, 35, turned);  // within what the loops leave open, at so long an arm
  Pose aside;
  aside.translation = {0.0, 12.0, 0.0};
  add(5, 30, aside);
  const auto agree = pairwise_agreement(graph, {first, first + 1, first + 2, first + 3});
  EXPECT_TRUE(agree[0][1] && agree[0][2] && agree[1][2]);
  EXPECT_FALSE(agree[0][3] || agree[1][3]);
}

/// Where the odometry began anew, 3 km from the first pose: that anything may lie between is no
/// sign that loops agree behind it, nor does it take the digits of what is known there.
TEST(LoopConsistency, ContradictingLoopsBehindABeginningAnewDoNotAgree) {
  constexpr std::size_t kBefore = 2;
  const PoseGraph laps = two_laps();
  PoseGraph graph;
  Pose far;
  far.translation = {3000.0, 0.0, 0.0};
  graph.poses = {{}, far};
  PoseEdge edge;
  edge.to = 1;
  edge.T_from_to = far;
  edge.information = 400.0 * Matrix6::Identity();
  graph.edges.push_back(edge);
  edge = {1, 2, {}, 1e-9 * Matrix6::Identity()};  // as odometry_edge() has it
  graph.edges.push_back(edge);
  for (const Pose& pose : laps.poses) graph.poses.push_back(far * pose);
  for (PoseEdge step : laps.edges) {
    step.from += kBefore;
    step.to += kBefore;
    graph.edges.push_back(step);
  }
  const std::size_t first = graph.edges.size();
  Pose aside;
  aside.translation = {4.0, 2.0, 0.0};
  graph.edges.push_back(loop(kBefore + 2, kBefore + 22, {}));
  graph.edges.push_back(loop(kBefore + 4, kBefore + 24, aside));
  graph.edges.push_back(loop(kBefore + 6, kBefore + 26, {}));
  const auto agree = pairwise_agreement(graph, {first, first + 1, first + 2});
  EXPECT_FALSE(agree[0][1] || agree[1][2]);
  EXPECT_TRUE(agree[0][2]);
}

/// More loops than are asked in pairs: the others are judged by those that agree.
TEST(KeepConsistent, OfManyLoopsKeepsTheRightOnes) {
  constexpr std::size_t kLap = 900;
  const Pose step{Eigen::Quaterniond(
                      Eigen::AngleAxisd(2.0 * 3.14159265358979 / kLap, Eigen::Vector3d::UnitZ())),
                  {5.0, 0.0, 0.0}};
  PoseGraph graph;
  graph.poses.emplace_back();
  for (std::size_t i = 0; i + 1 < 2 * kLap; ++i) {
    graph.poses.push_back(graph.poses.back() * step);
    PoseEdge edge;
    edge.from = i;
    edge.to = i + 1;
    edge.T_from_to = step;
    edge.information = 1e6 * Matrix6::Identity();
    graph.edges.push_back(edge);
  }
  std::vector<Loop> loops(kLap);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < kLap; ++i) {
    loops[i].place = i;
    loops[i].query = i + kLap;
    loops[i].check.verdict = LoopVerdict::taken;
    loops[i].check.overlap = 0.5 + 0.0001 * static_cast<double>(i % 7);
    loops[i].check.alignment.information = 400.0 * Matrix6::Identity();
    if (i % 9 != 4) continue;
    loops[i].check.alignment.T_target_source.translation = {3.0 + 0.01 * static_cast<double>(i),
                                                            -1.0, 0.0};
    ++wrong;
  }
  const std::vector<std::size_t> kept = keep_consistent(graph, loops);
  EXPECT_EQ(kept.size(), kLap - wrong);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
  for (std::size_t i = 0; i < kLap; ++i) {
    EXPECT_EQ(loops[i].check.verdict, i % 9 == 4 ? LoopVerdict::outvoted : LoopVerdict::taken) << i;
  }
}

/// Against all subsets.
TEST(LargestClique, IsTheLargest) {
  std::mt19937 random(4);
  for (int round = 0; round < 30; ++round) {
    constexpr std::size_t kSize = 12;
    std::vector<std::vector<bool>> agree(kSize, std::vector<bool>(kSize, false));
    for (std::size_t i = 0; i < kSize; ++i) {
      for (std::size_t k = i + 1; k < kSize; ++k) agree[i][k] = agree[k][i] = random() % 3 != 0;
    }
    std::size_t largest = 0;
    for (unsigned set = 1; set < 1U << kSize; ++set) {
      bool clique = true;
      std::size_t size = 0;
      for (std::size_t i = 0; i < kSize; ++i) {
        if ((set >> i & 1U) == 0) continue;
        ++size;
        for (std::size_t k = i + 1; k < kSize; ++k) {
          clique &= (set >> k & 1U) == 0 || agree[i][k];
        }
      }
      if (clique) largest = std::max(largest, size);
    }
    const std::vector<std::size_t> found = largest_clique(agree);
    EXPECT_EQ(found.size(), largest);
    for (const std::size_t a : found) {
      for (const std::size_t b : found) EXPECT_TRUE(a == b || agree[a][b]);
    }
  }
  EXPECT_TRUE(largest_clique({}).empty());
}

TEST(RobustSolution, CorrectsTheWayAndSwitchesOffWhatIsFalse) {
  if (!has_solver()) GTEST_SKIP() << "built without Ceres";
  std::vector<Pose> truth;
  PoseGraph graph = two_laps(&truth);
  const std::size_t first = graph.edges.size();
  for (const std::size_t i : {1, 5, 9, 13, 17}) graph.edges.push_back(loop(i, i + 20, {}));
  Pose aside;
  aside.translation = {6.0, 3.0, 0.0};
  graph.edges.push_back(loop(7, 27, aside));
  const double before = (graph.poses[30].translation - truth[30].translation).norm();
  const RobustSolution solution = solve_robustly(graph);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(solution.weights[first + k], 1.0);
  EXPECT_EQ(solution.weights[first + 5], 0.0);
  EXPECT_LT((graph.poses[30].translation - truth[30].translation).norm(), 0.5 * before);
  EXPECT_LT((graph.poses[30].translation - graph.poses[10].translation).norm(), 0.2);
}

}  // namespace
}  // namespace surefoot::mapping
