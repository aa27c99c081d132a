// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace surefoot::evaluation {

/// What is said about a set of errors; in the errors' unit, `sse` in its square.
struct Statistics {
  std::size_t count = 0;
  double max = 0.0;
  double mean = 0.0;
  double median = 0.0;  ///< of an even count: the mean of the two in the middle
  double min = 0.0;
  double rmse = 0.0;  ///< root of the mean square
  double std = 0.0;   ///< about the mean, divided by the count (not count - 1)
  double sse = 0.0;   ///< sum of squares
};

/// Throws std::invalid_argument if there are no errors.
[[nodiscard]] Statistics statistics_of(std::span<const double> errors);

}  // namespace surefoot::evaluation
