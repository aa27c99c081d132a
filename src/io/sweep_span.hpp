// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

#include "surefoot/scan.hpp"

namespace surefoot::io {

/// From the first point to the last, after the stamp; both zero where points have no times.
struct SweepSpan {
  std::int32_t first_ns = 0, last_ns = 0;
};

[[nodiscard]] inline SweepSpan span_of(const Scan& scan) {
  if (scan.times_ns.empty()) return {};
  SweepSpan sweep{scan.times_ns.front(), scan.times_ns.front()};
  for (const std::int32_t time : scan.times_ns) {  // several at once, unlike minmax_element
    sweep.first_ns = std::min(sweep.first_ns, time);
    sweep.last_ns = std::max(sweep.last_ns, time);
  }
  return sweep;
}

}  // namespace surefoot::io
