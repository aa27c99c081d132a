// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot export: a saved map as files that other programs read.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "runs/map_export.hpp"

namespace surefoot::app {

void add_export_command(CLI::App& app, int& /*exit_code*/) {
  struct ExportOptions {
    std::filesystem::path map;
    runs::MapExport files;
  };
  auto options = std::make_shared<ExportOptions>();
  runs::MapExport& files = options->files;
  CLI::App* command = app.add_subcommand(
      "export", "Write a map of surefoot map as points, as a grid for planners, as heights");
  command
      ->add_option("map", options->map, "what surefoot map has written: map.surefoot or its folder")
      ->required();
  command->add_option("--pcd", files.pcd, "points, to this PCD file");
  command->add_option("--ply", files.ply, "points, to this PLY file");
  command->add_option("--las", files.las, "points, to this LAS 1.4 file, in millimetres");
  command->add_option("--grid", files.grid,
                      "occupancy grid, to FILE.pgm and FILE.yaml as map_server reads them");
  command->add_option("--cell", files.occupancy.cell, "of the occupancy grid [m]")
      ->check(command_line::number_within(0.01, 10.0))
      ->capture_default_str();
  command->add_option("--elevation", files.elevation,
                      "heights of the ground, to FILE.asc and FILE_variance.asc (ESRI ASCII grid)");
  command->add_option("--elevation-cell", files.elevation_cell, "[m]")
      ->check(command_line::number_within(0.02, 10.0))
      ->capture_default_str();
  command->callback([options] {
    for (const runs::ExportedGrid& grid : runs::export_map(options->map, options->files)) {
      fmt::print("{}: {} x {} cells of {} m\n", grid.file.string(), grid.width, grid.height,
                 grid.cell);
    }
  });
}

}  // namespace surefoot::app
