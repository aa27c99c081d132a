// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Trajectories as figures: of a comparison, and of an evaluation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/compare_results.hpp"

namespace surefoot::experiments {

/// trajectories_3d, _side and _top and errors_over_time, each as .svg, .pdf and .png, with a panel
/// for each recording that has a truth; the folder is made. Throws std::runtime_error.
void draw_comparison(const CompareResults& results, const std::filesystem::path& folder);

/// The three views of one reference (`paths.truth`) and its aligned estimates on one page. Throws
/// std::runtime_error.
void draw_views(const ComparedPaths& paths, const std::vector<std::string>& names,
                const std::filesystem::path& file);

}  // namespace surefoot::experiments
