// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A saved map as files that other programs read.
#pragma once

#include <filesystem>
#include <vector>

#include "mapping/grid_map.hpp"

namespace surefoot::runs {

/// Files to write; empty: not this one.
struct MapExport {
  std::filesystem::path pcd, ply, las;
  std::filesystem::path grid;       ///< .pgm and .yaml beside each other
  std::filesystem::path elevation;  ///< .asc and _variance.asc
  mapping::GridOptions occupancy;
  double elevation_cell = 0.2;  ///< [m]
};

struct ExportedGrid {
  std::filesystem::path file;
  int width = 0, height = 0;  ///< cells
  double cell = 0.0;          ///< [m]
};

/// Throws io::ReadError, io::WriteError, std::invalid_argument where nothing is asked for.
std::vector<ExportedGrid> export_map(const std::filesystem::path& map, const MapExport& wanted);

}  // namespace surefoot::runs
