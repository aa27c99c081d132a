// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The recordings of a comparison: where they are, where their truth is, and what they are called.
#pragma once

#include <string>
#include <vector>

#include "experiments/comparison_options.hpp"
#include "experiments/fingerprint.hpp"

namespace surefoot::experiments {

struct CompareInput {
  std::string name;            ///< unique, fit for a folder's name
  std::filesystem::path path;  ///< absolute
  std::filesystem::path truth;
  FilesMark mark = {};     ///< of what is run or evaluated: others' files are not looked for
  std::string title = {};  ///< what tables and figures call it: unique, as it was given
};

/// A name for each path, unique and of letters that every file system takes: the last part of the
/// path, after its parent's where that is needed.
[[nodiscard]] std::vector<std::string> folder_names(
    const std::vector<std::filesystem::path>& paths);
/// The same with all letters that a line can show.
[[nodiscard]] std::vector<std::string> shown_names(const std::vector<std::filesystem::path>& paths);
/// The text with every letter replaced that not every file system takes.
[[nodiscard]] std::string folder_name(const std::string& text);

/// The recordings that were given, then the suites' in the order of their names; of a set that is
/// not made yet, those that it will hold.
/// Throws std::runtime_error for what does not exist, is given twice, or leaves nothing to compare.
[[nodiscard]] std::vector<CompareInput> find_inputs(const CompareOptions& options);

/// Makes those of --suite's sets that are named and not there yet, in the output folder, if all
/// else that was given is there.
/// @returns false if it was interrupted. Throws std::runtime_error.
[[nodiscard]] bool make_suites(const CompareOptions& options);

}  // namespace surefoot::experiments
