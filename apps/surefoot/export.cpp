// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot export: a saved map as files that other programs read.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "io/file_writer.hpp"
#include "io/files/las_writer.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "mapping/grid_map.hpp"
#include "runs/saved_map.hpp"

namespace surefoot::app {

namespace {

namespace fs = std::filesystem;

struct ExportOptions {
  fs::path map, pcd, ply, las, grid, elevation;
  mapping::GridOptions occupancy;
  double elevation_cell = 0.2;
};

template <typename T>
std::vector<Eigen::Vector3<T>> points_of(const mapping::SavedMap& map) {
  std::vector<Eigen::Vector3<T>> points;
  for (const mapping::Piece& piece : map.pieces) {
    for (const Eigen::Vector3f& point : piece.points) {
      points.emplace_back((piece.T_world_piece * point.cast<double>()).cast<T>());
    }
  }
  return points;
}

fs::path beside(const fs::path& file, const std::string& ending) {
  fs::path result = file;
  return result.replace_extension(ending);
}

void export_map(const ExportOptions& options) {
  if (options.pcd.empty() && options.ply.empty() && options.las.empty() && options.grid.empty() &&
      options.elevation.empty()) {
    throw std::invalid_argument(
        "nothing to write: expected --pcd, --ply, --las, --grid or --elevation");
  }
  const mapping::SavedMap map = runs::read_saved_map(options.map);
  if (!options.ply.empty()) io::write_ply(options.ply, points_of<float>(map));
  if (!options.pcd.empty()) {
    Scan points;
    points.points = points_of<float>(map);
    io::write_pcd(options.pcd, points);
  }
  if (!options.las.empty()) io::write_las(options.las, points_of<double>(map));
  if (!options.grid.empty()) {
    const mapping::OccupancyGrid grid = mapping::draw_occupancy(map.pieces, options.occupancy);
    const fs::path image = beside(options.grid, ".pgm");
    io::write_whole_file(image, mapping::format_pgm(grid));
    io::write_whole_file(beside(options.grid, ".yaml"),
                         mapping::format_grid_yaml(grid, image.filename().string()));
    fmt::print("{}: {} x {} cells of {} m\n", image.string(), grid.width, grid.height, grid.cell);
  }
  if (!options.elevation.empty()) {
    const mapping::ElevationGrid grid = mapping::draw_elevation(map.pieces, options.elevation_cell);
    const fs::path heights = beside(options.elevation, ".asc");
    io::write_whole_file(heights, mapping::format_asc(grid, grid.heights));
    fs::path variances = heights;
    variances.replace_filename(heights.stem().string() + "_variance.asc");
    io::write_whole_file(variances, mapping::format_asc(grid, grid.variances));
    fmt::print("{}: {} x {} cells of {} m\n", heights.string(), grid.width, grid.height, grid.cell);
  }
}

}  // namespace

void add_export_command(CLI::App& app, int& /*exit_code*/) {
  auto options = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand(
      "export", "Write a map of surefoot map as points, as a grid for planners, as heights");
  command
      ->add_option("map", options->map, "what surefoot map has written: map.surefoot or its folder")
      ->required();
  command->add_option("--pcd", options->pcd, "points, to this PCD file");
  command->add_option("--ply", options->ply, "points, to this PLY file");
  command->add_option("--las", options->las, "points, to this LAS 1.4 file, in millimetres");
  command->add_option("--grid", options->grid,
                      "occupancy grid, to FILE.pgm and FILE.yaml as map_server reads them");
  command->add_option("--cell", options->occupancy.cell, "of the occupancy grid [m]")
      ->check(command_line::number_within(0.01, 10.0))
      ->capture_default_str();
  command->add_option("--elevation", options->elevation,
                      "heights of the ground, to FILE.asc and FILE_variance.asc (ESRI ASCII grid)");
  command->add_option("--elevation-cell", options->elevation_cell, "[m]")
      ->check(command_line::number_within(0.02, 10.0))
      ->capture_default_str();
  command->callback([options] { export_map(*options); });
}

}  // namespace surefoot::app
