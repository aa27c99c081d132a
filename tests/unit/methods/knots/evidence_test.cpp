// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/evidence.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "methods/knots/verdict_weights.hpp"

namespace surefoot {
namespace {

/// What sensors at `from` see of a cylinder of this radius about the z axis through `centre`.
View inside(const Eigen::Vector3d& from, const Eigen::Vector3d& centre, double radius) {
  std::vector<Eigen::Vector3d> points;
  for (int row = -7; row <= 7; ++row) {
    for (int column = 0; column < 360; ++column) {
      const double azimuth = column * std::numbers::pi / 180.0;
      const Eigen::Vector3d ray(std::cos(azimuth), std::sin(azimuth), 0.035 * row);
      // |from + t ray - centre| = radius in the plane
      const Eigen::Vector2d d = (from - centre).head<2>();
      const double b = d.dot(ray.head<2>());
      const double t = -b + std::sqrt(b * b - d.squaredNorm() + radius * radius);
      points.emplace_back(from + t * ray);
    }
  }
  return {from, points};
}

TEST(Evidence, WhatIsSeenAgainDoesNotContradict) {
  LastViews last;
  EXPECT_EQ(last.contradiction(inside({0, 0, 0}, {0, 0, 0}, 8.0)), 0.0) << "nothing to ask";
  last.add(inside({0, 0, 0}, {0, 0, 0}, 8.0));
  EXPECT_LT(last.contradiction(inside({0.3, 0, 0}, {0, 0, 0}, 8.0)), 0.01);
}

TEST(Evidence, AWallThatTheLastBeamsWentThroughContradicts) {
  LastViews last;
  last.add(inside({0, 0, 0}, {0, 0, 0}, 8.0));
  // The same room, taken to be 3 m farther on: one wall stands in what was free, the other was
  // seen where now beams go through.
  EXPECT_GT(last.contradiction(inside({3, 0, 0}, {3, 0, 0}, 8.0)), 0.2);
  // A room within the room, all of it in what was free.
  EXPECT_GT(last.contradiction(inside({0, 0, 0}, {0, 0, 0}, 3.0)), 0.5);
}

TEST(Evidence, WhatLiesBehindTellsNothing) {
  LastViews last;
  last.add(inside({0, 0, 0}, {0, 0, 0}, 3.0));
  // Of a larger room the small one's beams say nothing; the large one's go through its walls.
  const double share = last.contradiction(inside({0, 0, 0}, {0, 0, 0}, 20.0));
  EXPECT_DOUBLE_EQ(share, 1.0);
}

// Five scans are between two that are asked, and two are: who was let in and walks at the sensor's
// side is seen against what was there half a second ago, but not for ever.
TEST(Evidence, AViewIsHeldAgainstTwoOfWhichOneIsHalfASecondOld) {
  const View far = inside({0, 0, 0}, {0, 0, 0}, 8.0), near = inside({0, 0, 0}, {0, 0, 0}, 3.0);
  LastViews last;
  last.add(far);
  const auto add = [&](int times) {
    for (int i = 0; i < times; ++i) last.add(near);
    return last.contradiction(near);
  };
  EXPECT_GT(add(4), 0.9) << "held against the first alone";
  EXPECT_NEAR(add(1), 0.33, 0.25) << "and against the fifth";
  EXPECT_GT(last.contradiction(near), 0.1);
  EXPECT_GT(add(4), 0.1) << "still against both";
  EXPECT_EQ(add(1), 0.0) << "the first is forgotten";
}

TEST(Evidence, IsTheLogarithmOfTheRatioToTheUsual) {
  UsualSigns usual;
  const Signs calm{0.1, 0.2, 0.05, 2.0};
  for (int scan = 0; scan < 300; ++scan) usual.learn(calm, 1.0, 0.1);
  const Evidence none = usual.compare(calm);
  for (const EvidenceField& field : kEvidenceFields) {
    EXPECT_NEAR(none.*field.member, 0.0, 1e-6) << field.name;
  }
  const Evidence worse = usual.compare({0.32, 0.2, 0.11, 1.0});
  EXPECT_NEAR(worse.misfit, std::log(0.33 / 0.11), 1e-6);
  EXPECT_NEAR(worse.contradiction, std::log(0.12 / 0.06), 1e-6);
  EXPECT_EQ(worse.motion, 0.0) << "less than usual is no evidence";
  EXPECT_NEAR(usual.compare({0.1, 0.2, 0.05, 2.0, 1.0}).unconverged, std::log(1.1 / 0.1), 1e-6);
  EXPECT_EQ(usual.compare({0.1, 0.2, 0.05, 1e9}).motion, 4.0) << "the most";
}

TEST(Evidence, WhatIsWrongDoesNotBecomeUsual) {
  UsualSigns usual;
  const Signs calm{0.1, 0.2, 0.05, 2.0}, wrong{0.9, 0.9, 0.9, 900.0};
  for (int scan = 0; scan < 100; ++scan) usual.learn(calm, 1.0, 0.1);
  const Evidence before = usual.compare(wrong);
  for (int scan = 0; scan < 100; ++scan) usual.learn(wrong, 1e-6, 0.1);
  EXPECT_NEAR(usual.compare(wrong).misfit, before.misfit, 1e-3);
  for (int scan = 0; scan < 100; ++scan) usual.learn(wrong, 1.0, 0.1);
  EXPECT_NEAR(usual.compare(wrong).misfit, 0.0, 1e-3) << "but what is right all the time does";
}

TEST(Evidence, HazardGrowsWithEveryPartOfTheEvidence) {
  const double nothing = hazard({});
  EXPECT_NEAR(nothing, 1.0 / (1.0 + std::exp(-kVerdictOffset)), 1e-12);
  EXPECT_LT(nothing, 1e-3);
  for (const EvidenceField& field : kEvidenceFields) {
    EXPECT_GE(kVerdictWeights.*field.member, 0.0) << field.name;
    Evidence evidence;
    evidence.*field.member = 0.5;
    const double logit = kVerdictOffset + 0.5 * kVerdictWeights.*field.member;
    EXPECT_NEAR(hazard(evidence), 1.0 / (1.0 + std::exp(-logit)), 1e-12) << field.name;
  }
}

TEST(Evidence, WhatFitsClearlyBetterElsewhereIsHalfOfAProof) {
  Evidence evidence;
  evidence.rival = 0.99 * std::log(kClearlyBetter);
  EXPECT_EQ(hazard_beside_rival(evidence), hazard(evidence));
  evidence.rival = 1.01 * std::log(kClearlyBetter);
  EXPECT_EQ(hazard_beside_rival(evidence), 0.5);
  evidence.misfit = evidence.contradiction = evidence.unconverged = 4.0;
  EXPECT_EQ(hazard_beside_rival(evidence), hazard(evidence));  // which is more
}

TEST(Evidence, WhatIsMoreProbablyWrongThanAnyScanIsDoubtful) {
  EXPECT_FALSE(is_doubtful(hazard({})));
  EXPECT_FALSE(is_doubtful(0.99 * kVerdictBase / 10.0));
  EXPECT_TRUE(is_doubtful(1.01 * kVerdictBase / 10.0));
}

TEST(Evidence, TenScansHazardsMakeOneProbability) {
  Verdict verdict;
  EXPECT_NEAR(verdict.add(0.5), 0.5, 1e-12);
  EXPECT_NEAR(verdict.add(0.1), 1.0 - 0.5 * 0.9, 1e-12);
  for (int scan = 0; scan < 8; ++scan) (void)verdict.add(0.0);
  EXPECT_NEAR(verdict.add(0.0), 0.1, 1e-12) << "the first is eleven scans old";
  verdict.clear();
  EXPECT_NEAR(verdict.add(0.2), 0.2, 1e-12);
}

TEST(Evidence, WhatTakesLongHasNotSettledUnlessItSlides) {
  EXPECT_TRUE(has_settled(true, 12, false));
  EXPECT_FALSE(has_settled(true, 13, false));
  EXPECT_TRUE(has_settled(true, 13, true));
  EXPECT_FALSE(has_settled(false, 10, false));
  EXPECT_FALSE(has_settled(false, 100, true));
}

TEST(Evidence, WhatIsNewToTheMapComesWithTheWay) {
  Evidence evidence;
  evidence.unseen = 2.0;
  evidence.gap = std::log(3.0);
  EXPECT_NEAR(after_gap(evidence).unseen, 2.0 - std::log(3.0), 1e-6) << "a third a period";
  EXPECT_EQ(after_gap(evidence).gap, evidence.gap);
  evidence.gap = 3.0;
  EXPECT_EQ(after_gap(evidence).unseen, 0.0);
  EXPECT_EQ(evidence_where_lost(evidence, false, false).unseen, 0.0);
  EXPECT_EQ(evidence_where_lost(evidence, false, true).unseen, 2.0) << "it was carried";
}

// Of one who is lost: a wide covariance speaks against a place where others look like it.
TEST(Evidence, OfWhoIsLost) {
  Evidence evidence;
  evidence.gap = 1.0;
  evidence.uncertainty = 2.0;
  evidence.misfit = 3.0;
  evidence.rival = -1.0;
  for (const bool slides : {false, true}) {
    for (const bool large : {false, true}) {
      const Evidence lost = evidence_where_lost(evidence, slides, large);
      EXPECT_EQ(lost.gap, 0.0);
      EXPECT_EQ(lost.uncertainty, slides || large ? 2.0 : 0.0);
      EXPECT_EQ(lost.misfit, 3.0);
      EXPECT_EQ(lost.rival, large ? 0.0 : -1.0);
    }
  }
}

}  // namespace
}  // namespace surefoot
