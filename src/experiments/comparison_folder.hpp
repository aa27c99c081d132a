// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "runs/report_maker.hpp"

namespace surefoot::experiments {

/// Whether the folder holds a comparison's compare.json.
[[nodiscard]] bool is_comparison_folder(const std::filesystem::path& folder);

/// Adds the comparison's tables, and of each recording and method the first run that left results.
/// Throws io::ReadError.
void add_comparison(const std::filesystem::path& folder, runs::ReportMaker& maker);

/// Throws std::runtime_error where a file lies in the folder that has the name of a comparison's
/// results and is none: no compare.json of ours is there.
void refuse_foreign_results(const std::filesystem::path& folder);

}  // namespace surefoot::experiments
