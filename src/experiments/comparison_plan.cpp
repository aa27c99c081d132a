// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/comparison_plan.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "experiments/compare_results.hpp"

namespace surefoot::experiments {

std::vector<PlannedRun> plan_runs(std::size_t inputs, std::size_t variants, int repeats) {
  std::vector<PlannedRun> runs;
  for (int repeat = 1; repeat <= repeats; ++repeat) {
    for (std::size_t input = 0; input < inputs; ++input) {
      for (std::size_t variant = 0; variant < variants; ++variant) {
        runs.push_back({input, variant, repeat});
      }
    }
  }
  return runs;
}

std::vector<PlannedRun> share_of(const std::vector<PlannedRun>& runs, const ComparePart& part) {
  std::vector<PlannedRun> share;
  for (std::size_t i = part.number - 1; i < runs.size(); i += part.of) share.push_back(runs[i]);
  return share;
}

std::string runs_text(const std::vector<PlannedRun>& runs, const std::vector<CompareInput>& inputs,
                      const std::vector<MethodVariant>& variants) {
  using OrderedJson = nlohmann::ordered_json;
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const CompareInput& input = inputs[runs[i].input];
    const MethodVariant& variant = variants[runs[i].variant];
    const OrderedJson line = {{"part", fmt::format("{}/{}", i + 1, runs.size())},
                              {"recording", input.path.string()},
                              {"method", variant.label},
                              {"repeat", runs[i].repeat},
                              {"folder", run_folder(input, variant, runs[i].repeat).string()}};
    text += line.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + '\n';
  }
  return text;
}

}  // namespace surefoot::experiments
