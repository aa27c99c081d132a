// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Several recordings of one scene that differ in their seed alone: what is chance, what is not.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/comparison.hpp"
#include "evaluation/marked_table.hpp"

namespace surefoot::evaluation {

/// A figure of one method over the seeds of a scene that have it. A run that is not whole counts as
/// infinite; one that is whole, but too short for the figure, for none.
struct SeedSpread {
  double median = 0.0, low = 0.0, high = 0.0;
  int seeds = 0, lost = 0;
};

/// A scene of which there are several recordings.
struct SeededScene {
  std::string name = {};
  std::vector<std::size_t> recordings = {};  ///< of the comparison
  std::vector<SeedSpread> ape = {};          ///< [m] RMSE, one for each method
  std::vector<SeedSpread> relative = {};     ///< RMSE, in % over a distance, else in m
};

/// In the order of their first recordings; empty if every scene was recorded once.
[[nodiscard]] std::vector<SeededScene> seeded_scenes(const Comparison& comparison);

/// Whether two methods' ranges overlap: no difference that one could be sure of.
[[nodiscard]] bool overlap(const SeedSpread& a, const SeedSpread& b);

/// A row for each scene and figure: median and ends over the seeds, those that overlap with the
/// best one's marked with kOverlapMark. None if every scene was recorded once.
[[nodiscard]] std::optional<Table> seeds_table(const Comparison& comparison);
inline constexpr const char* kOverlapMark = "\u2248 ";

}  // namespace surefoot::evaluation
