// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace surefoot::evaluation {

Statistics statistics_of(std::span<const double> errors) {
  if (errors.empty()) throw std::invalid_argument("statistics of no errors");
  std::vector<double> sorted(errors.begin(), errors.end());
  std::sort(sorted.begin(), sorted.end());
  const std::size_t count = sorted.size();
  const auto n = static_cast<double>(count);
  Statistics result;
  result.count = count;
  result.min = sorted.front();
  result.max = sorted.back();
  result.median = 0.5 * (sorted[(count - 1) / 2] + sorted[count / 2]);
  double sum = 0.0;
  for (const double error : sorted) {
    sum += error;
    result.sse += error * error;
  }
  result.mean = sum / n;
  result.rmse = std::sqrt(result.sse / n);
  double spread = 0.0;
  for (const double error : sorted) spread += (error - result.mean) * (error - result.mean);
  result.std = std::sqrt(spread / n);
  return result;
}

}  // namespace surefoot::evaluation
