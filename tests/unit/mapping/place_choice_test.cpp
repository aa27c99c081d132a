// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_choice.hpp"

#include <gtest/gtest.h>

namespace surefoot::mapping {
namespace {

AskedPlace asked(double x, double overlap, double contradicted, LoopVerdict verdict) {
  AskedPlace place;
  place.T_map_world.translation.x() = x;
  place.check.verdict = verdict;
  place.check.overlap = overlap;
  place.check.contradicted = contradicted;
  place.check.alignment.held = 6;
  return place;
}

const Eigen::Vector3d kRobot(40.0, 0.0, 0.0);

PlaceChoice choice_of(const std::vector<AskedPlace>& places) {
  return choose_place(places, kRobot, {});
}

TEST(PlaceChoice, WhatContradictsIsPaidForTwice) {
  EXPECT_DOUBLE_EQ(fit_of(asked(0.0, 0.8, 0.05, LoopVerdict::taken).check), 0.7);
  EXPECT_EQ(fit_of(asked(0.0, 0.1, 0.2, LoopVerdict::taken).check), 0.0);
  EXPECT_EQ(choice_of({asked(0.0, 0.81, 0.05, LoopVerdict::taken)}).chosen, 0U);
  const AskedPlace other = asked(30.0, 0.64, 0.0, LoopVerdict::no_overlap);
  EXPECT_EQ(choice_of({asked(0.0, 0.81, 0.05, LoopVerdict::taken), other}).chosen, 0U);
  EXPECT_FALSE(choice_of({asked(0.0, 0.79, 0.05, LoopVerdict::taken), other}).chosen);
}

TEST(PlaceChoice, TheBestOfThoseThatPassedIsChosen) {
  const auto choice = choice_of({asked(50.0, 0.95, 0.0, LoopVerdict::no_overlap)});
  EXPECT_FALSE(choice.chosen);
  EXPECT_FALSE(choice.several);
  EXPECT_EQ(choice_of({asked(0.0, 0.75, 0.0, LoopVerdict::taken),
                       asked(0.1, 0.85, 0.0, LoopVerdict::taken)})
                .chosen,
            1U);
  AskedPlace slides = asked(0.0, 0.9, 0.0, LoopVerdict::taken);
  slides.check.alignment.held = 5;
  EXPECT_FALSE(choice_of({slides}).chosen);
}

TEST(PlaceChoice, NoneIsChosenWhereAnotherFitsNearlyAsWell) {
  const AskedPlace best = asked(0.0, 0.85, 0.0, LoopVerdict::taken);
  for (const LoopVerdict verdict :
       {LoopVerdict::taken, LoopVerdict::starts_disagree, LoopVerdict::free_space}) {
    const PlaceChoice choice = choice_of({best, asked(30.0, 0.81, 0.0, verdict)});
    EXPECT_FALSE(choice.chosen);
    EXPECT_TRUE(choice.several);
    EXPECT_EQ(choice_of({best, asked(30.0, 0.79, 0.0, verdict)}).chosen, 0U);
    EXPECT_EQ(choice_of({best, asked(30.0, 0.83, 0.05, verdict)}).chosen, 0U);
    EXPECT_EQ(choice_of({best, asked(0.2, 0.85, 0.0, verdict)}).chosen.has_value(), true);
  }
}

/// Between 0.05 at 0.7 and 0.2 at 0.6.
TEST(PlaceChoice, TheLessAPlaceFitsTheFartherOthersHaveToBe) {
  const auto chosen = [](double fit, double other) {
    const PlaceChoice choice = choice_of({asked(0.0, fit, 0.0, LoopVerdict::taken),
                                          asked(30.0, other, 0.0, LoopVerdict::no_overlap)});
    EXPECT_FALSE(choice.several);
    EXPECT_FALSE(choice.chosen && choice.fit != fit);
    return choice.chosen.has_value();
  };
  EXPECT_TRUE(chosen(0.61, 0.42));
  EXPECT_FALSE(chosen(0.61, 0.43));
  EXPECT_TRUE(chosen(0.65, 0.52));
  EXPECT_FALSE(chosen(0.65, 0.53));
  EXPECT_FALSE(chosen(0.59, 0.0));
}

TEST(PlaceChoice, ATurnCountsWhereTheRobotIs) {
  Pose turned;
  turned.rotation = Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitZ());
  EXPECT_TRUE(agree(Pose{}, turned, Eigen::Vector3d::Zero(), {}));
  EXPECT_FALSE(agree(Pose{}, turned, kRobot, {}));
  turned.rotation = Eigen::AngleAxisd(0.04, Eigen::Vector3d::UnitZ());
  EXPECT_FALSE(agree(Pose{}, turned, Eigen::Vector3d::Zero(), {}));
}

}  // namespace
}  // namespace surefoot::mapping
