// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What is fuzzed: readers fed with any bytes. They may refuse them, and nothing else.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace surefoot::fuzz {

struct Target {
  const char* name;
  /// Reads the bytes; an exception other than ReadError, a crash or a hang is a finding.
  void (*read)(std::span<const std::byte> bytes);
  /// Valid input to start from.
  std::vector<std::string> (*seeds)();
};

[[nodiscard]] std::span<const Target> file_targets();
[[nodiscard]] std::span<const Target> packet_targets();
[[nodiscard]] std::span<const Target> stamp_targets();
[[nodiscard]] std::span<const Target> program_targets();  // what commands read besides recordings
[[nodiscard]] std::span<const Target> map_targets();
[[nodiscard]] std::span<const Target> bag_targets();  // and of the messages in them
[[nodiscard]] std::vector<Target> targets();          // all of them

}  // namespace surefoot::fuzz
