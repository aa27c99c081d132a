// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "io/recording.hpp"

namespace surefoot::io {

/// What a recording's scans come from; neither: files of scans.
struct RecordingKind {
  bool as_bag = false;   ///< messages
  bool packets = false;  ///< a sensor's, in a capture or in messages
};

/// A note for each option that somebody gave and that says nothing about this kind of recording.
[[nodiscard]] std::vector<std::string> idle_options(const OpenOptions& options,
                                                    const RecordingKind& kind);

}  // namespace surefoot::io
