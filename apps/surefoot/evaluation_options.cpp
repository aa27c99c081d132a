// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation_options.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <string>

#include "evaluation/option_names.hpp"
#include "option_checks.hpp"

namespace surefoot::app {

namespace {

constexpr const char* kGroup = "Evaluation";

template <typename Choice, std::size_t count>
CLI::CheckedTransformer words(const evaluation::ChoiceNames<Choice, count>& names) {
  std::map<std::string, Choice> map;
  for (const auto& [name, choice] : names) map.emplace(name, choice);
  return CLI::CheckedTransformer(map);
}

}  // namespace

void add_pairing_options(CLI::App& command, evaluation::AssociationOptions& options) {
  command
      .add_option("--pair", options.method,
                  "nearest: poses with the nearest stamps; interpolate: the reference at the "
                  "estimate's stamps")
      ->transform(words(evaluation::kPairingNames))
      ->group(kGroup);
  command
      .add_option("--max-diff", options.max_difference,
                  "Largest difference of two stamps that are paired [s]")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_option("--max-gap", options.max_gap,
                  "Longest gap of the reference that is interpolated [s]")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str()
      ->group(kGroup);
  command.add_option("--offset", options.offset, "Added to the estimates' stamps [s]")
      ->check(CLI::Range(-1e9, 1e9))
      ->capture_default_str()
      ->group(kGroup);
}

void add_error_options(CLI::App& command, evaluation::EvaluationOptions& options) {
  command
      .add_option("--align", options.alignment,
                  "none, origin, yaw (and translation), se3 (the default), sim3 or scale")
      ->transform(words(evaluation::kAlignmentNames))
      ->group(kGroup);
  command
      .add_option("--align-poses", options.alignment_poses, "Align the first poses only; 0: all")
      ->check(whole_number(0))
      ->group(kGroup);
  auto& stretches = options.stretches;
  command.add_option("--delta", stretches.delta, "Length of a stretch of the relative error")
      ->capture_default_str()
      ->group(kGroup);
  command.add_option("--delta-unit", stretches.unit, "Of --delta: frames, m, s or deg")
      ->transform(words(evaluation::kDeltaUnitNames))
      ->group(kGroup);
  command
      .add_flag("--all-pairs,!--no-all-pairs", stretches.all_pairs,
                "A stretch from every pose, not one after the other")
      ->group(kGroup);
  command
      .add_option("--delta-tolerance", stretches.tolerance,
                  "With --all-pairs: accepted deviation as a share of --delta")
      ->check(CLI::Range(0.0, 1.0))
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
