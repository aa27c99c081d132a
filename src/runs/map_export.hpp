// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A saved map as files that other programs read.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "io/files/point_tiles.hpp"
#include "mapping/grid_map.hpp"
#include "mapping/surface_mesh.hpp"
#include "mapping/traversability.hpp"

namespace surefoot::runs {

/// Files to write; empty: not this one.
struct MapExport {
  std::filesystem::path pcd, ply, las;
  std::filesystem::path
      tiles;  ///< a new folder: 3D Tiles, and a page that shows them if there is one
  std::optional<io::EarthPlace> tiles_at;
  std::filesystem::path mesh;  ///< .ply, .obj or .stl
  mapping::MeshOptions triangles;
  std::filesystem::path grid;       ///< .pgm and .yaml beside each other
  std::filesystem::path elevation;  ///< .asc and _variance.asc; .tif: all layers in one
  mapping::GridOptions occupancy;
  double elevation_cell = 0.2;  ///< [m]
  mapping::LeggedRobot robot;
  std::optional<std::size_t> frame;  ///< of those that nothing joins this one alone, from 0 on
  bool overwrite = false;  ///< files that are there already, too (never a folder of tiles)
};

struct ExportedGrid {
  std::filesystem::path file;
  int width = 0, height = 0;  ///< cells
  double cell = 0.0;          ///< [m]
};

struct MapExported {
  std::vector<ExportedGrid> grids;
  io::TileCounts tiles;
  std::size_t triangles = 0;
  std::vector<std::string> notes;  ///< what to know of these files
};

/// `progress`: of the mesh, which takes longest. Throws io::ReadError, io::WriteError (before any
/// work where a file is there already), std::invalid_argument where nothing is asked for.
MapExported export_map(const std::filesystem::path& map, const MapExport& wanted,
                       const mapping::MeshProgress& progress = {});

}  // namespace surefoot::runs
