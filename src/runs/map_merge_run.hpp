// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Saved maps in, one map out.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "surefoot/pose.hpp"

namespace surefoot::runs {

/// What came of one of the maps but the first.
struct MergedMap {
  std::filesystem::path path;
  bool joined = false;
  std::size_t compared = 0;        ///< places
  std::size_t taken = 0;           ///< loops
  std::size_t near = 0;            ///< places that both have seen
  std::string message = {};        ///< why not
  std::optional<Pose> begin = {};  ///< where it begins in the first map's frame
  std::size_t pieces = 0;          ///< of it;
  std::size_t held = 0;            ///< so many are held to the first, the others are left out
};

struct MergeOutcome {
  std::size_t pieces = 0;  ///< of the joint map
  std::vector<MergedMap> maps;

  [[nodiscard]] bool joined() const;  ///< all of them
  bool written = false;               ///< the joint map
};

/// Joins each of the maps to the first, or to those that were joined to it before. Writes loops.csv
/// to the folder and, if all were joined (with `leave_out`: if any was), in the first one's frame
/// map.surefoot and pieces.csv, which says where each piece of way lies. Throws io::ReadError,
/// io::WriteError; unless `overwrite`, std::runtime_error where one of these files is there
/// already.
[[nodiscard]] MergeOutcome merge_saved_maps(
    const std::vector<std::filesystem::path>& maps, const std::filesystem::path& folder,
    bool overwrite, bool leave_out = false,
    const std::function<void(std::size_t done, std::size_t all)>& on_piece = {});

}  // namespace surefoot::runs
