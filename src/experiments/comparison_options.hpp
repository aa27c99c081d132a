// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a comparison was asked for.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "evaluation/evaluate.hpp"
#include "evaluation/option_names.hpp"
#include "evaluation/verdict.hpp"

namespace surefoot::experiments {

/// How much of the truth a whole run has an estimate for.
enum class Cover {
  automatic,  ///< the truth; the recording's part of it if only a part of the scans is used
  truth,      ///< all of it
  recording   ///< the part between the recording's first and last scan
};

inline constexpr evaluation::ChoiceNames<Cover, 3> kCoverNames = {
    {{"auto", Cover::automatic}, {"truth", Cover::truth}, {"recording", Cover::recording}}};

/// A share of a comparison's runs: every `of`-th, from the `number`-th on.
struct ComparePart {
  std::size_t number = 1, of = 1;
};
/// "3/8"; throws std::invalid_argument.
[[nodiscard]] ComparePart parse_part(const std::string& text);

struct CompareOptions {
  std::vector<std::filesystem::path> recordings;
  std::vector<std::filesystem::path> truths;  ///< empty, or one for each of `recordings`
  std::vector<std::string> suites;            ///< names of the suite's sets, or folders
  std::vector<std::string> methods = {"surefoot", "paper"};
  std::vector<std::string> settings;  ///< "key=value" for every method

  int repeats = 1;
  int jobs = 1;
  std::optional<ComparePart> part;  ///< of the runs, and no tables; none: whatever is left
  bool list_runs = false;           ///< and do none
  std::filesystem::path output = "results/comparison";
  bool overwrite = false;  ///< also files of such names that no comparison has left
  bool figures = true;
  bool retry_failed = false;
  bool quiet = false;

  int threads = 1;
  std::size_t start = 0, count = 0, stride = 1;  ///< count 0: all
  bool no_map = false;
  std::vector<std::string> passed;  ///< further arguments of `surefoot run`

  evaluation::EvaluationOptions evaluation = {
      .stretches = {.delta = 10.0, .unit = evaluation::DeltaUnit::metres, .all_pairs = true},
      .stretches_from_reference = true};
  evaluation::VerdictRules rules;
  Cover cover = Cover::automatic;
  bool needs_every_truth = false;  ///< else a recording without one is a failure among others
};

/// Throws std::invalid_argument where a further argument of `surefoot run` is one that a comparison
/// sets itself: the runs would be others than it says.
void check_passed(const std::vector<std::string>& passed);

/// The arguments that every run gets besides its recording, its folder and its parameters.
[[nodiscard]] std::vector<std::string> run_arguments(const CompareOptions& options);

}  // namespace surefoot::experiments
