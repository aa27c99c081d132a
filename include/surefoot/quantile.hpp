// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace surefoot {

/// The value below which the share `q` (0 to 1) of the values lies: the nearest of them, of two
/// equally near ones the lower. 0 for no values.
template <typename Number>
[[nodiscard]] Number quantile(std::vector<Number> values, double q) {
  if (values.empty()) return Number{};
  const double place = q * static_cast<double>(values.size() - 1);
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(std::ceil(place - 0.5));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace surefoot
