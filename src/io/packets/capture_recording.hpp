// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "io/recording.hpp"

namespace surefoot::io {

/// The sweeps of the first LiDAR in a packet capture. Throws ReadError where there is none that is
/// known.
[[nodiscard]] std::unique_ptr<Recording> open_capture(const std::filesystem::path& file,
                                                      const OpenOptions& options);
/// The same from an open file, which is taken over; `name` is for messages.
[[nodiscard]] std::unique_ptr<Recording> open_capture(std::FILE* file, const std::string& name,
                                                      const OpenOptions& options);

}  // namespace surefoot::io
