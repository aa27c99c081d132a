// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/walk_times.hpp"

#include <algorithm>
#include <limits>

#include "mapping/walk_clock.hpp"

namespace surefoot::runs {

std::vector<std::int64_t> walk_times(const std::vector<std::int64_t>& stamps_ns,
                                     const std::vector<std::optional<Pose>>& poses) {
  std::vector<std::int64_t> times(stamps_ns);
  mapping::WalkClock clock;
  std::int64_t last_ns = std::numeric_limits<std::int64_t>::min();  // along the walk
  for (std::size_t i = 0; i < times.size();) {
    std::size_t placed = i;
    while (placed < times.size() && !poses[placed]) ++placed;
    const std::int64_t next_ns = placed < times.size() ? clock.next(stamps_ns[placed])
                                                       : std::numeric_limits<std::int64_t>::max();
    for (; i < placed; ++i) {
      times[i] = last_ns = std::clamp(clock.at(stamps_ns[i]), last_ns, next_ns);
    }
    if (i < times.size()) times[i++] = last_ns = next_ns;
  }
  return times;
}

}  // namespace surefoot::runs
