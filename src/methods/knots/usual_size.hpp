// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace surefoot {

/// Of how many segments scans usually are: as the first one, until another number comes three times
/// in a row. A gap before a scan is bridged by more of them.
class UsualSize {
 public:
  /// Whether a scan is of the usual size; what was learnt of another one is of no use once that
  /// changes.
  [[nodiscard]] bool takes(std::size_t segments) {
    if (segments != other_) in_a_row_ = 0;
    other_ = segments;
    ++in_a_row_;
    if (usual_ == 0 || in_a_row_ >= kInARow) usual_ = segments;
    return segments == usual_;
  }

 private:
  static constexpr int kInARow = 3;

  std::size_t usual_ = 0, other_ = 0;
  int in_a_row_ = 0;
};

}  // namespace surefoot
