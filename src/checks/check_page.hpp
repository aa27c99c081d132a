// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "checks/recording_check.hpp"

namespace surefoot::checks {

/// A page of its own, without scripts: the verdict, what was found, and the scans drawn one by one.
[[nodiscard]] std::string to_html(const RecordingCheck& check, const std::string& name);
/// Only such a page may go for a page: the name may be the recording's own, or any other file's.
/// Throws std::invalid_argument; an empty name is none.
void require_page_or_nothing(const std::filesystem::path& file);

}  // namespace surefoot::checks
