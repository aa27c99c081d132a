// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// One page of runs and comparisons, by the folders that they left.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace surefoot::experiments {

struct ReportRequest {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path truth;   ///< empty: of each recording its own
  std::filesystem::path output;  ///< empty: in the folder, or here for several
  std::string title;
  std::size_t map_points = 0;  ///< of each map at most; 0: the usual
};

struct ReportOutcome {
  std::filesystem::path file;
  bool is_whole = false;  ///< nothing is left out
};

/// `complain` is told of a folder that cannot be read, and left out, and of what else the page
/// lacks. Throws io::ReadError where none can be read, io::WriteError.
[[nodiscard]] ReportOutcome report_folders(
    const ReportRequest& request, const std::function<void(const std::string& text)>& complain);

}  // namespace surefoot::experiments
