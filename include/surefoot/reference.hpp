// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>

#include "surefoot/config.hpp"
#include "surefoot/estimate.hpp"
#include "surefoot/odometry.hpp"
#include "surefoot/scan.hpp"

namespace surefoot {

/// A trajectory to hold others against: from all scans of a recording at once, each against the map
/// of what was seen before it and after it. docs/reference.md.
///
///     surefoot::Reference reference;
///     for (const surefoot::Scan& scan : scans) reference.add_scan(scan);
///     reference.refine();
///     surefoot::Odometry answers = reference.replay();
///     for (const surefoot::Scan& scan : scans) answers.add_scan(scan);
///
/// It keeps some 3,000 points of every scan: 60 kB. The same scans give the same bits, at any
/// number of threads. An object belongs to one thread at a time.
class Reference {
 public:
  /// Throws ConfigError, also where the method is not surefoot: no other's motion within a scan is
  /// estimated. `threads`: at most this many; 1 where the library was built without threads.
  explicit Reference(const Config& config = {}, int threads = 1);
  ~Reference();
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;
  Reference(Reference&&) noexcept;
  Reference& operator=(Reference&&) noexcept;

  /// What the odometry says of a scan, from which refine() begins. Never throws for what is in it.
  Estimate add_scan(const Scan& scan);
  /// Moves all scans to where the map of all of them has them, in several passes. Poses of
  /// different segments are left apart, each in the frame of its first scan. `goes_on` is told the
  /// share that is done, 0 to 1; where it says false that is the end. Returns whether all passes
  /// were made.
  bool refine(const std::function<bool(double share)>& goes_on = {});
  /// Segments that refine() left where the odometry has them: what their scans saw has no solution,
  /// or one that no robot walks. In rising order; none before.
  [[nodiscard]] std::vector<int> unrefined() const;
  /// Answers the scans that were added, in their order, with what is known of them now. Of scans
  /// that were not registered it says what the odometry said, carried along by the scan before.
  [[nodiscard]] Odometry replay() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace surefoot
