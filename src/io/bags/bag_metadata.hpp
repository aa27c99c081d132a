// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::io {

/// What rosbag2 says of a bag in the metadata.yaml beside its files, as far as readers need it.
struct BagMetadata {
  std::string storage;                    ///< "sqlite3", "mcap"; empty: not said
  std::string compression_mode;           ///< "FILE", "MESSAGE", empty or "NONE"
  std::vector<std::string> files;         ///< their names, without folders, in the bag's order
  std::optional<std::uint64_t> messages;  ///< in all of them
};

/// The few lines that are needed, of YAML as rosbag2 writes it; whatever else there is does not
/// matter. Any text is safe.
[[nodiscard]] BagMetadata parse_bag_metadata(std::string_view text);

}  // namespace surefoot::io
