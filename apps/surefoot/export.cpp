// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot export: a saved map as files that other programs read.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <memory>
#include <string>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "io/counted.hpp"
#include "process/progress.hpp"
#include "runs/map_export.hpp"

namespace surefoot::app {

namespace {

io::EarthPlace earth_place(const std::array<double, 4>& given) {
  const auto [latitude, longitude, height, azimuth] = given;
  if (!(std::abs(latitude) <= 90.0 && std::abs(longitude) <= 180.0 && std::abs(height) <= 1e5 &&
        std::abs(azimuth) <= 360.0)) {
    throw CLI::ValidationError(
        "--tiles-at", fmt::format("got {} {} {} {}, expected a latitude of -90 to 90, a longitude "
                                  "of -180 to 180, a height of up to 100 km, an azimuth of -360 to "
                                  "360",
                                  latitude, longitude, height, azimuth));
  }
  return {latitude, longitude, height, azimuth};
}

void add_elevation_options(CLI::App& command, runs::MapExport& files) {
  CLI::Option* elevation = command.add_option(
      "--elevation", files.elevation,
      "heights of the ground, to FILE.asc and FILE_variance.asc (ESRI ASCII grid), or "
      "with slope, steps, roughness and traversability to FILE.tif (GeoTIFF)");
  command.add_option("--elevation-cell", files.elevation_cell, "[m]")
      ->check(command_line::number_within(0.02, 10.0))
      ->capture_default_str()
      ->needs(elevation);
  const auto add = [&](const char* name, double& value, const char* help, double most) {
    command.add_option(name, value, help)
        ->check(command_line::number_within(0.001, most))
        ->capture_default_str()
        ->needs(elevation);
  };
  add("--robot-radius", files.robot.radius,
      "for traversability: of a disc that covers the body [m]", 5.0);
  add("--max-slope", files.robot.most_slope_deg, "for traversability: of the ground [deg]", 80.0);
  add("--max-step", files.robot.most_step, "for traversability: height of a step [m]", 5.0);
  add("--max-roughness", files.robot.most_roughness,
      "for traversability: of the ground off its plane, root mean square [m]", 5.0);
}

struct ExportOptions {
  std::filesystem::path map;
  runs::MapExport files;
  std::array<double, 4> place{};
};

void add_point_options(CLI::App& command, ExportOptions& options) {
  runs::MapExport& files = options.files;
  command.add_option("--pcd", files.pcd, "points, to this PCD file");
  command.add_option("--ply", files.ply, "points, to this PLY file");
  command.add_option("--las", files.las, "points, to this LAS 1.4 file, in millimetres");
  CLI::Option* tiles = command.add_option(
      "--tiles", files.tiles, "points, as 3D Tiles into this new folder, for maps of any size");
  command
      .add_option("--tiles-at", options.place,
                  "where on the earth the map's origin is: LATITUDE LONGITUDE [deg], HEIGHT above "
                  "the ellipsoid [m], and the AZIMUTH of its x axis, clockwise from north [deg]")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->needs(tiles);
}

void add_surface_options(CLI::App& command, runs::MapExport& files) {
  CLI::Option* mesh = command.add_option("--mesh", files.mesh,
                                         "surfaces as triangles, to this PLY, OBJ or STL file");
  command
      .add_option("--mesh-cell", files.triangles.cell, "edges of triangles are about as long [m]")
      ->check(command_line::number_within(0.05, 2.0))
      ->capture_default_str()
      ->needs(mesh);
  CLI::Option* grid = command.add_option(
      "--grid", files.grid, "occupancy grid, to FILE.pgm and FILE.yaml as map_server reads them");
  command.add_option("--grid-cell,--cell", files.occupancy.cell, "of the occupancy grid [m]")
      ->check(command_line::number_within(0.01, 10.0))
      ->capture_default_str()
      ->needs(grid);
}

void print_exported(const runs::MapExport& files, const runs::MapExported& done) {
  if (done.tiles.tiles > 0) {
    fmt::print("{}: {} in {}, {}\n", files.tiles.string(), io::counted(done.tiles.points, "point"),
               io::counted(done.tiles.tiles, "tile"), io::counted(done.tiles.levels, "level"));
    if (std::filesystem::exists(files.tiles / "index.html")) {
      fmt::print(
          "to look at them: python3 -m http.server --bind 127.0.0.1 -d {}, and "
          "http://127.0.0.1:8000/ in a browser\n",
          files.tiles.string());
    }
  }
  if (!files.mesh.empty()) {
    fmt::print("{}: {}\n", files.mesh.string(), io::counted(done.triangles, "triangle"));
  }
  for (const runs::ExportedGrid& grid : done.grids) {
    fmt::print("{}: {} x {} cells of {} m\n", grid.file.string(), grid.width, grid.height,
               grid.cell);
  }
}

}  // namespace

void add_export_command(CLI::App& app, int& /*exit_code*/) {
  auto options = std::make_shared<ExportOptions>();
  runs::MapExport& files = options->files;
  CLI::App* command = app.add_subcommand(
      "export",
      "Write a map of surefoot map as points, as triangles, as a grid for planners, as heights");
  command
      ->add_option("map", options->map, "what surefoot map has written: map.surefoot or its folder")
      ->required();
  add_point_options(*command, *options);
  add_surface_options(*command, files);
  add_elevation_options(*command, files);
  command
      ->add_option("--frame", files.frame,
                   "of a map whose frames nothing joins this one alone, from 0 on")
      ->check(command_line::whole_number(0));
  command->add_flag("--overwrite", files.overwrite, "write also where files are already");
  command->callback([command, options] {
    if (command->count("--tiles-at") > 0) options->files.tiles_at = earth_place(options->place);
    process::Progress progress("blocks", false);
    const runs::MapExported done =
        runs::export_map(options->map, options->files, [&](std::size_t blocks, std::size_t all) {
          progress.update(blocks, static_cast<double>(blocks) / static_cast<double>(all));
        });
    progress.finish();
    print_exported(options->files, done);
    for (const std::string& note : done.notes) fmt::print(stderr, "note: {}\n", note);
  });
}

}  // namespace surefoot::app
