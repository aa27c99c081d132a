// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

#include "command_line/option_checks.hpp"
#include "command_line/option_group.hpp"
#include "evaluation/option_names.hpp"

namespace surefoot::app {

namespace {

constexpr double kMostOffset = 4e9;  // [s] from 1970 to 2096

template <typename Choice, std::size_t count>
std::vector<std::pair<std::string, Choice>> words(
    const evaluation::ChoiceNames<Choice, count>& names) {
  return {names.begin(), names.end()};
}

template <typename Choice, std::size_t count>
std::string default_of(const evaluation::ChoiceNames<Choice, count>& names, Choice choice) {
  return fmt::format(" (default: {})", evaluation::name_of(names, choice));
}

std::string default_of(const char* on, const char* off, bool value) {
  return fmt::format(" (default: {})", value ? on : off);
}

}  // namespace

void add_pairing_options(CLI::App& command, evaluation::AssociationOptions& options) {
  command_line::OptionGroup group(command, "Evaluation");
  group.add_choice("--pair", options.method,
                   "nearest: poses with the nearest stamps; interpolate: the reference at the "
                   "estimate's stamps" +
                       default_of(evaluation::kPairingNames, options.method),
                   words(evaluation::kPairingNames));
  group
      .add("--max-diff", options.max_difference,
           "Largest difference of two stamps that are paired [s]")
      ->check(command_line::number_within(0.0, 1e6))
      ->capture_default_str();
  group.add("--max-gap", options.max_gap, "Longest gap of the reference that is interpolated [s]")
      ->check(command_line::number_within(0.0, 1e6))
      ->capture_default_str();
  group.add("--offset", options.offset, "Added to the estimates' stamps [s]")
      ->check(command_line::number_within(-kMostOffset, kMostOffset))
      ->capture_default_str();
}

void add_error_options(CLI::App& command, evaluation::EvaluationOptions& options) {
  command_line::OptionGroup group(command, "Evaluation");
  group.add_choice(
      "--align", options.alignment,
      "none, origin, yaw (and translation), se3, poses (se3 by positions and orientations), sim3 "
      "or scale" +
          default_of(evaluation::kAlignmentNames, options.alignment),
      words(evaluation::kAlignmentNames));
  group.add("--align-poses", options.alignment_poses, "Align the first poses only; 0: all")
      ->check(command_line::whole_number(0));
  auto& stretches = options.stretches;
  group.add("--delta", stretches.delta, "Length of a stretch of the relative error")
      ->capture_default_str();
  group.add_choice(
      "--delta-unit", stretches.unit,
      "Of --delta: frames, m, s or deg" + default_of(evaluation::kDeltaUnitNames, stretches.unit),
      words(evaluation::kDeltaUnitNames));
  group.add_flag("--all-pairs,!--no-all-pairs", stretches.all_pairs,
                 "A stretch from every pose, not one after the other" +
                     default_of("--all-pairs", "--no-all-pairs", stretches.all_pairs));
  group
      .add("--delta-tolerance", stretches.tolerance,
           "With --all-pairs: accepted deviation as a share of --delta")
      ->check(command_line::number_within(0.0, 1.0))
      ->capture_default_str();
  group.add_flag("--pairs-from-reference,!--pairs-from-estimate", options.stretches_from_reference,
                 "Measure the stretches along the reference" +
                     default_of("--pairs-from-reference", "--pairs-from-estimate",
                                options.stretches_from_reference));
  group
      .add("--segments", options.segment_lengths,
           "Lengths of KITTI's segment error [m], such as 10,20,50")
      ->delimiter(',')
      ->allow_extra_args(false);
}

}  // namespace surefoot::app
