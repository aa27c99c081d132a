// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot::process {

/// Catches Ctrl-C, SIGTERM and a terminal's end (SIGHUP) while it lives, so that a loop can end in
/// good order. A second Ctrl-C ends the program at once.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;
  [[nodiscard]] bool interrupted() const;

 private:
  bool ignores_hangup_ = false;
};

}  // namespace surefoot::process
