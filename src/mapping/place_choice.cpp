// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/place_choice.hpp"

#include <algorithm>
#include <numbers>

namespace surefoot::mapping {

namespace {

// What speaks for the right place among those that a search names. Over 860 right and 6,900 wrong
// ones that were asked of three quarters of which every car and tree had moved, two of them with
// maps of others, too, logistic regression weighs them nearly like this, as a share of what lies on
// it: 0.1 of it makes the right place some 10 times as likely. What stands beside counts twice and
// more, since by less a place was found in a map of another quarter.
constexpr double kContradiction = 2.0;
constexpr double kMissing = 1.0;
constexpr double kMostMissing = 0.3;
constexpr double kBeside = 0.5;
// What tells a corner that is built like it: in 134 searches in which a wrong place fitted 0.5
// without it, points lay 0.033 to 0.073 m farther off than at home (2 to 98 %), in 441 in which the
// right one did 0.009 to 0.040. Chosen on these, in quarters and a street.
constexpr double kMisfit = 15.0;        // [1/m]
constexpr double kUsualMisfit = 0.025;  // [m] of right places
constexpr double kNotAsked = 0.15;      // what speaks against a place that was refused before

bool was_asked(const LoopCheck& check) {
  return check.verdict == LoopVerdict::taken || check.verdict == LoopVerdict::free_space;
}

/// Whether two of the places look alike here.
bool any_alike(const std::vector<AskedPlace>& asked, const Eigen::Vector3d& robot_in_world,
               const ChoiceLimits& limits) {
  constexpr double kLike = 0.6;
  const auto less = [](const AskedPlace& a, const AskedPlace& b) {
    return fit_of(a.check) < fit_of(b.check);
  };
  const auto most = std::max_element(asked.begin(), asked.end(), less);
  if (most == asked.end() || fit_of(most->check) < kLike) return false;
  return std::any_of(asked.begin(), asked.end(), [&](const AskedPlace& other) {
    return fit_of(other.check) > fit_of(most->check) - limits.alike &&
           !agree(most->T_map_world, other.T_map_world, robot_in_world, limits);
  });
}

}  // namespace

double fit_of(const LoopCheck& check) {
  const double against = was_asked(check) ? kContradiction * check.contradicted +
                                                kMissing * std::min(check.missing, kMostMissing) +
                                                kBeside * check.beside
                                          : kNotAsked;
  const double misfit = kMisfit * std::max(0.0, check.alignment.misfit - kUsualMisfit);
  return std::max(0.0, check.overlap - against - misfit);
}

bool agree(const Pose& one, const Pose& other, const Eigen::Vector3d& robot_in_world,
           const ChoiceLimits& limits) {
  const double turn = one.rotation.angularDistance(other.rotation) * 180.0 / std::numbers::pi;
  return (one * robot_in_world - other * robot_in_world).norm() < limits.agree_metres &&
         turn < limits.agree_degrees;
}

PlaceChoice choose_place(const std::vector<AskedPlace>& asked,
                         const Eigen::Vector3d& robot_in_world, const ChoiceLimits& limits) {
  PlaceChoice choice;
  choice.alike = any_alike(asked, robot_in_world, limits);
  const auto passes = [&](const LoopCheck& check) {
    return check.verdict == LoopVerdict::taken && check.alignment.held == 6 &&
           fit_of(check) >= limits.fit;
  };
  double best = 0.0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    if (!passes(asked[i].check) || fit_of(asked[i].check) < best) continue;
    best = fit_of(asked[i].check);
    choice.chosen = i;
  }
  if (!choice.chosen) return choice;
  // Whatever another one was refused for: that it lies there as well shows what looks alike here.
  double next = 0.0;
  for (const AskedPlace& other : asked) {
    if (agree(asked[*choice.chosen].T_map_world, other.T_map_world, robot_in_world, limits)) {
      continue;
    }
    next = std::max(next, fit_of(other.check));
    choice.several = choice.several || (limits.alone && passes(other.check));
  }
  choice.several = choice.several || next > best - limits.clearly;
  if (choice.several) choice.chosen.reset();
  choice.fit = best;
  return choice;
}

}  // namespace surefoot::mapping
