// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <memory>

#include "io/recording.hpp"

namespace surefoot::io {

/// Scans that are separate files: those of a folder in natural order, or one. Throws ReadError.
[[nodiscard]] std::unique_ptr<Recording> open_scan_files(const std::filesystem::path& path,
                                                         const OpenOptions& options);

}  // namespace surefoot::io
