// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What Cyclone DDS says of this process, which it has one log for.
#pragma once

#include <cstdint>
#include <string>

namespace surefoot::ros2 {

/// What it says while this exists, instead of on stderr. One at a time.
class Complaints {
 public:
  Complaints();
  ~Complaints();
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;
  /// Joined by "; ".
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Packets that it refused since the first Complaints ended, of which it says nothing else: with a
/// sample in them that does not begin as CDR, say. Everything else goes to stderr as before.
[[nodiscard]] std::uint64_t refused_packets();

}  // namespace surefoot::ros2
