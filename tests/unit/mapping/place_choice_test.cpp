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

TEST(PlaceChoice, WhatSpeaksAgainstAPlaceIsPaidFor) {
  EXPECT_DOUBLE_EQ(fit_of(asked(0.0, 0.8, 0.05, LoopVerdict::taken).check), 0.7);
  EXPECT_EQ(fit_of(asked(0.0, 0.1, 0.2, LoopVerdict::taken).check), 0.0);
  AskedPlace place = asked(0.0, 0.8, 0.0, LoopVerdict::taken);
  place.check.missing = 0.04;
  EXPECT_DOUBLE_EQ(fit_of(place.check), 0.76);
  place.check.beside = 0.1;
  EXPECT_DOUBLE_EQ(fit_of(place.check), 0.71);
  place.check.alignment.misfit = 0.024;
  EXPECT_DOUBLE_EQ(fit_of(place.check), 0.71) << "is usual";
  place.check.alignment.misfit = 0.029;
  EXPECT_DOUBLE_EQ(fit_of(place.check), 0.65);
  place.check.missing = 0.5;
  EXPECT_DOUBLE_EQ(fit_of(place.check), 0.39) << "0.3 of it at most";
}

/// Of what speaks against a place that was refused before that, nothing is known.
TEST(PlaceChoice, APlaceThatWasRefusedBeforeFitsLess) {
  EXPECT_DOUBLE_EQ(fit_of(asked(0.0, 0.8, 0.0, LoopVerdict::free_space).check), 0.8);
  for (const LoopVerdict verdict : {LoopVerdict::starts_disagree, LoopVerdict::bent}) {
    EXPECT_DOUBLE_EQ(fit_of(asked(0.0, 0.8, 0.0, verdict).check), 0.65);
  }
}

TEST(PlaceChoice, TheBestOfThoseThatPassedIsChosen) {
  const auto choice = choice_of({asked(50.0, 0.95, 0.0, LoopVerdict::no_overlap)});
  EXPECT_FALSE(choice.chosen);
  EXPECT_FALSE(choice.several);
  const auto best = choice_of(
      {asked(0.0, 0.75, 0.0, LoopVerdict::taken), asked(0.1, 0.85, 0.0, LoopVerdict::taken)});
  EXPECT_EQ(best.chosen, 1U);
  EXPECT_EQ(best.fit, 0.85);
  EXPECT_FALSE(choice_of({asked(0.0, 0.39, 0.0, LoopVerdict::taken)}).chosen);
  EXPECT_TRUE(choice_of({asked(0.0, 0.41, 0.0, LoopVerdict::taken)}).chosen);
  AskedPlace slides = asked(0.0, 0.9, 0.0, LoopVerdict::taken);
  slides.check.alignment.held = 5;
  EXPECT_FALSE(choice_of({slides}).chosen);
}

TEST(PlaceChoice, NoneIsChosenWhereAnotherFitsNearlyAsWell) {
  const AskedPlace best = asked(0.0, 0.85, 0.0, LoopVerdict::taken);
  for (const LoopVerdict verdict : {LoopVerdict::taken, LoopVerdict::free_space}) {
    const PlaceChoice choice = choice_of({best, asked(30.0, 0.76, 0.0, verdict)});
    EXPECT_FALSE(choice.chosen);
    EXPECT_TRUE(choice.several);
    EXPECT_EQ(choice_of({best, asked(30.0, 0.74, 0.0, verdict)}).chosen, 0U);
    EXPECT_EQ(choice_of({best, asked(30.0, 0.83, 0.05, verdict)}).chosen, 0U);
    EXPECT_EQ(choice_of({best, asked(0.2, 0.85, 0.0, verdict)}).chosen.has_value(), true);
  }
}

/// Its rivals as well, though not all was asked of them.
TEST(PlaceChoice, APlaceThatWasRefusedBeforeIsARivalIfItFits) {
  const AskedPlace best = asked(0.0, 0.75, 0.0, LoopVerdict::taken);
  for (const LoopVerdict verdict : {LoopVerdict::starts_disagree, LoopVerdict::bent}) {
    EXPECT_TRUE(choice_of({best, asked(30.0, 0.81, 0.0, verdict)}).several);
    EXPECT_EQ(choice_of({best, asked(30.0, 0.79, 0.0, verdict)}).chosen, 0U);
  }
}

/// Storeys are built alike, and of the right one the map may be the worse.
TEST(PlaceChoice, NoneIsChosenWhereAnotherPassesTooIfItHasToBeAlone) {
  ChoiceLimits limits;
  limits.alone = true;
  const auto chosen = [&](double overlap, LoopVerdict verdict) {
    const std::vector<AskedPlace> places = {asked(0.0, 0.9, 0.0, LoopVerdict::taken),
                                            asked(30.0, overlap, 0.0, verdict)};
    EXPECT_TRUE(choice_of(places).chosen);
    return choose_place(places, kRobot, limits).chosen.has_value();
  };
  EXPECT_FALSE(chosen(0.41, LoopVerdict::taken));
  EXPECT_TRUE(chosen(0.39, LoopVerdict::taken));
  EXPECT_TRUE(chosen(0.6, LoopVerdict::free_space)) << "that is refuted";
}

/// Where walls are missing it is a street that is built like it.
TEST(PlaceChoice, ATwinThatIsRefutedIsNoRival) {
  const AskedPlace best = asked(0.0, 0.75, 0.0, LoopVerdict::taken);
  AskedPlace twin = asked(30.0, 0.76, 0.0, LoopVerdict::free_space);
  EXPECT_FALSE(choice_of({best, twin}).chosen);
  twin.check.missing = 0.28;
  EXPECT_EQ(choice_of({best, twin}).chosen, 0U);
}

TEST(PlaceChoice, TwoPlacesThatFitWellAndNearlyAsWellAreAlike) {
  const AskedPlace best = asked(0.0, 0.75, 0.0, LoopVerdict::taken);
  const auto alike = [&](double x, double overlap) {
    return choice_of({best, asked(x, overlap, 0.0, LoopVerdict::free_space)}).alike;
  };
  EXPECT_TRUE(alike(30.0, 0.66));
  EXPECT_FALSE(alike(30.0, 0.64));
  EXPECT_FALSE(alike(0.2, 0.75)) << "the same place";
  EXPECT_FALSE(choice_of({asked(0.0, 0.59, 0.0, LoopVerdict::taken),
                          asked(30.0, 0.59, 0.0, LoopVerdict::taken)})
                   .alike)
      << "so much fits many places";
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
