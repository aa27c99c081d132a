// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace surefoot::live {

/// When what was recorded is due, as if it came now.
class ReplayPace {
 public:
  /// @param speed times the recording's own; 0: at once.
  explicit ReplayPace(double speed) : speed_(speed) {}
  /// Waits for it, a tenth of a second at most; whether it is time now. To be asked with the stamps
  /// of recording in their order, again where it is not time yet.
  [[nodiscard]] bool is_due(std::int64_t stamp_ns);
  [[nodiscard]] bool is_at_once() const { return speed_ <= 0.0; }

 private:
  double speed_;
  std::optional<std::int64_t> last_ns_;
  std::chrono::steady_clock::time_point due_;
};

}  // namespace surefoot::live
