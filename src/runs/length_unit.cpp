// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/length_unit.hpp"

#include <fmt/format.h>

#include <vector>

#include "evaluation/statistics.hpp"
#include "geometry/returns.hpp"
#include "io/recording.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::runs {

namespace {

// LiDARs that robots carry see up to 100 .. 300 m, and what surrounds a robot is mostly near: in
// millimetres, a room's walls are beyond 1000.
constexpr double kFarthestMedian = 300.0;  // [m]

}  // namespace

std::optional<std::string> odd_range(double median_range) {
  if (!(median_range > kFarthestMedian)) return std::nullopt;
  return fmt::format(
      "half of the points are farther than {:.0f} m; expected coordinates in metres, are these "
      "millimetres?",
      median_range);
}

void refuse_other_units(const Scan& scan, const std::string& where) {
  std::vector<double> ranges;
  for (const Eigen::Vector3f& point : scan.points) {
    if (is_return(point)) ranges.push_back(point.cast<double>().norm());
  }
  if (const auto odd = odd_range(quantile(ranges, 0.5))) {
    throw io::ReadError(where + ": " + *odd);
  }
}

}  // namespace surefoot::runs
