// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What each part of a method is worth: a comparison of the method as it is with changes of it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluation/comparison.hpp"

namespace surefoot::evaluation {

/// What was changed, in words.
struct AblationChange {
  std::string contribution = {};  ///< "Deskewing"
  std::string change = {};        ///< "none"
  std::string equations = {};     ///< "(5)-(12)"
};

/// One change over all recordings. A run that is not whole has an infinite error: "lost".
struct AblationRow {
  AblationChange change = {};
  std::vector<double> errors = {};                 ///< [m] APE RMSE, one for each recording
  std::vector<std::string> outcomes = {};          ///< why it is lost; empty for a whole run
  std::vector<std::optional<double>> ratios = {};  ///< none where the method as it is is lost
  /// Of the ratios; infinite where lost, none where no recording has a ratio.
  std::optional<double> median = {}, low = {}, high = {};
  int worse = 0, better = 0;  ///< whole runs beyond a factor of two
  int lost = 0;
};

struct Ablation {
  std::vector<std::string> recordings = {};
  std::vector<double> usual = {};      ///< [m] median error over the references, by recording
  std::vector<AblationRow> rows = {};  ///< the references first
  std::size_t references = 0;
  double spread = 1.0;  ///< factor by which a median ratio differs from 1 by chance, at most
};

/// The comparison's first `references` methods are the method as it is and harmless changes of it;
/// `changes` says what each method is.
///
/// A row's ratio is its error over the references' median. For a reference that median is over the
/// others; how far these ratios are from 1 is what chance does. The spread is the factor within
/// which 99 % of the medians lie that one gets by taking, for each recording, one of them at
/// random. Throws std::invalid_argument unless there is a change for each method and a reference.
[[nodiscard]] Ablation ablate(const Comparison& comparison,
                              const std::vector<AblationChange>& changes, std::size_t references);

/// Whether the row's median differs from 1 by no more than the spread; so does none.
[[nodiscard]] bool is_below_spread(const AblationRow& row, const Ablation& ablation);

}  // namespace surefoot::evaluation
