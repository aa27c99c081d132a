// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/comparison.hpp"

#include <algorithm>

namespace surefoot::evaluation {

RepeatSpread spread_of(const MethodResult& result, double MeasuredRun::*figure) {
  if (result.runs.empty()) return {};
  std::vector<double> values;
  for (const MeasuredRun& run : result.runs) values.push_back(run.*figure);
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return {0.5 * (values[(n - 1) / 2] + values[n / 2]), values.front(), values.back()};
}

std::uint64_t peak_memory(const MethodResult& result) {
  std::uint64_t peak = 0;
  for (const MeasuredRun& run : result.runs) peak = std::max(peak, run.peak_memory_bytes);
  return peak;
}

std::map<std::string, std::size_t> not_ok(const MethodResult& result) {
  if (result.runs.empty()) return {};
  std::map<std::string, std::size_t> statuses = result.runs.front().statuses;
  statuses.erase("ok");
  const auto first = statuses.find("first_scan");
  if (first != statuses.end() && --first->second == 0) statuses.erase(first);
  return statuses;
}

int most_jobs(const Comparison& comparison) {
  int most = 1;
  for (const ComparedRecording& recording : comparison.recordings) {
    for (const MethodResult& result : recording.results) {
      for (const MeasuredRun& run : result.runs) most = std::max(most, run.jobs);
    }
  }
  return most;
}

}  // namespace surefoot::evaluation
