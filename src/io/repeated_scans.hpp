// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Scans that are sent again: a driver or a player that goes back by some scans, sends them once
// more, stamps and all, and goes on. No clock was set, and nothing was measured.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

#include "io/recording.hpp"

namespace surefoot::io {

/// A number for points, or for every so many-th of them: equal ones give equal numbers, others
/// hardly ever. Not a checksum against forgery.
[[nodiscard]] std::uint64_t number_of(const std::vector<Eigen::Vector3f>& points,
                                      std::size_t every = 1);

/// The scans that came, to tell those from them that come again. Remembers the last 10,000.
class SeenScans {
 public:
  /// Whether a scan with this stamp and these points came before. Some of the points are compared,
  /// to the last bit: no two scans of one stamp agree in so many.
  bool came_before(const Scan& scan);

 private:
  std::unordered_map<std::int64_t, std::uint64_t> numbers_;  // of the points, by stamps
  std::deque<std::int64_t> order_;
};

/// The recording without them; the first one is named.
[[nodiscard]] std::unique_ptr<Recording> leave_out_repeated(std::unique_ptr<Recording> recording);

}  // namespace surefoot::io
