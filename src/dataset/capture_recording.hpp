// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

#include "dataset/recording.hpp"

namespace surefoot::dataset {

/// The revolutions of a VLP-16 in a packet capture. Throws ReadError where there is none, or where
/// the packets are another sensor's.
[[nodiscard]] std::unique_ptr<Recording> open_capture(const std::filesystem::path& file,
                                                      const OpenOptions& options);
/// The same from an open file, which is taken over; `name` is for messages.
[[nodiscard]] std::unique_ptr<Recording> open_capture(std::FILE* file, const std::string& name,
                                                      const OpenOptions& options);

}  // namespace surefoot::dataset
