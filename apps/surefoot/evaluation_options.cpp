// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation_options.hpp"

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "evaluation/option_names.hpp"
#include "option_checks.hpp"

namespace surefoot::app {

namespace {

constexpr const char* kGroup = "Evaluation";
constexpr double kMostOffset = 4e9;  // [s] from 1970 to 2096

template <typename Choice, std::size_t count>
std::vector<std::pair<std::string, Choice>> words(
    const evaluation::ChoiceNames<Choice, count>& names) {
  return {names.begin(), names.end()};
}

}  // namespace

void add_pairing_options(CLI::App& command, evaluation::AssociationOptions& options) {
  add_choice(command, "--pair", options.method,
             "nearest: poses with the nearest stamps; interpolate: the reference at the "
             "estimate's stamps",
             words(evaluation::kPairingNames))
      ->group(kGroup);
  command
      .add_option("--max-diff", options.max_difference,
                  "Largest difference of two stamps that are paired [s]")
      ->check(number_within(0.0, 1e6))
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_option("--max-gap", options.max_gap,
                  "Longest gap of the reference that is interpolated [s]")
      ->check(number_within(0.0, 1e6))
      ->capture_default_str()
      ->group(kGroup);
  command.add_option("--offset", options.offset, "Added to the estimates' stamps [s]")
      ->check(number_within(-kMostOffset, kMostOffset))
      ->capture_default_str()
      ->group(kGroup);
}

void add_error_options(CLI::App& command, evaluation::EvaluationOptions& options) {
  add_choice(command, "--align", options.alignment,
             "none, origin, yaw (and translation), se3 (the default), poses (se3 by positions "
             "and orientations), sim3 or scale",
             words(evaluation::kAlignmentNames))
      ->group(kGroup);
  command
      .add_option("--align-poses", options.alignment_poses, "Align the first poses only; 0: all")
      ->check(whole_number(0))
      ->group(kGroup);
  auto& stretches = options.stretches;
  command.add_option("--delta", stretches.delta, "Length of a stretch of the relative error")
      ->capture_default_str()
      ->group(kGroup);
  add_choice(command, "--delta-unit", stretches.unit, "Of --delta: frames, m, s or deg",
             words(evaluation::kDeltaUnitNames))
      ->group(kGroup);
  command
      .add_flag("--all-pairs,!--no-all-pairs", stretches.all_pairs,
                "A stretch from every pose, not one after the other")
      ->group(kGroup);
  command
      .add_option("--delta-tolerance", stretches.tolerance,
                  "With --all-pairs: accepted deviation as a share of --delta")
      ->check(number_within(0.0, 1.0))
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_flag("--pairs-from-reference,!--pairs-from-estimate", options.stretches_from_reference,
                "Measure the stretches along the reference")
      ->group(kGroup);
  command
      .add_option("--segments", options.segment_lengths,
                  "Lengths of KITTI's segment error [m], such as 10,20,50")
      ->delimiter(',')
      ->group(kGroup);
}

}  // namespace surefoot::app
