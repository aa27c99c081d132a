// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The way so far in a bounded number of poses, however long it gets: a live run may last for weeks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surefoot/trajectory.hpp"

namespace surefoot::runs {

/// Holds all poses until they are more than `most`; then every second one goes, and of what comes
/// one of so many is kept. The first and the newest one are always there.
class BoundedPath {
 public:
  explicit BoundedPath(std::size_t most) : most_(most) {}

  /// A pose that goes leaves `untrusted` to the one before it, so that no trouble goes unseen.
  void add(const StampedPose& pose, bool untrusted = false, int segment = 0);
  /// Begins anew.
  void clear() { *this = BoundedPath(most_); }

  [[nodiscard]] const Trajectory& poses() const { return poses_; }
  /// A flag a pose.
  [[nodiscard]] const std::vector<bool>& untrusted() const { return untrusted_; }
  /// A number a pose.
  [[nodiscard]] const std::vector<int>& segments() const { return segments_; }
  /// Poses that were added.
  [[nodiscard]] std::uint64_t added() const { return added_; }

 private:
  void drop_newest();
  void thin();

  std::size_t most_;
  std::uint64_t stride_ = 1;  ///< one pose of so many is kept
  std::uint64_t added_ = 0;
  Trajectory poses_;
  std::vector<bool> untrusted_;
  std::vector<int> segments_;
};

}  // namespace surefoot::runs
