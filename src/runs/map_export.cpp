// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/map_export.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "io/counted.hpp"
#include "io/file_writer.hpp"
#include "io/files/geotiff_writer.hpp"
#include "io/files/las_writer.hpp"
#include "io/files/mesh_writer.hpp"
#include "io/files/pcd_writer.hpp"
#include "io/files/ply_writer.hpp"
#include "io/yaml_word.hpp"
#include "mapping/held_pieces.hpp"
#include "report/page.hpp"
#include "runs/saved_map.hpp"

namespace surefoot::runs {

namespace {

namespace fs = std::filesystem;

template <typename T>
std::vector<Eigen::Vector3<T>> points_of(const mapping::SavedMap& map) {
  std::vector<Eigen::Vector3<T>> points;
  for (const mapping::Piece& piece : map.pieces) {
    const auto cloud = mapping::cloud_of(piece);
    for (const Eigen::Vector3f& point : cloud->points) {
      points.emplace_back((piece.T_world_piece * point.cast<double>()).cast<T>());
    }
  }
  return points;
}

/// All points, from an origin [m]: in a file beside the tiles, since a city's are more than a
/// memory holds, or in memory where no file can be made or shown there.
class TilePoints {
 public:
  TilePoints(const mapping::SavedMap& map, const Eigen::Vector3d& origin, const fs::path& folder)
      : file_(mapping::CloudFile::make(folder)) {
    for (const mapping::Piece& piece : map.pieces) {
      const auto cloud = mapping::cloud_of(piece);
      for (const Eigen::Vector3f& point : cloud->points) {
        held_.emplace_back((piece.T_world_piece * point.cast<double>() - origin).cast<float>());
      }
      if (file_ != nullptr) put_away();
    }
  }

  [[nodiscard]] std::span<Eigen::Vector3f> all() {
    if (file_ == nullptr) return held_;
    const std::span<std::byte> bytes = file_->mapped();
    if (bytes.empty() && put_away_ > 0) {
      throw io::WriteError("the points of all tiles cannot be shown as memory: " +
                           std::to_string(put_away_ * kSize) + " bytes");
    }
    return {reinterpret_cast<Eigen::Vector3f*>(bytes.data()), bytes.size() / kSize};
  }

 private:
  static constexpr std::size_t kSize = sizeof(Eigen::Vector3f);

  void put_away() {
    std::uint64_t at = 0;
    const auto* bytes = reinterpret_cast<const char*>(held_.data());
    if (!file_->append({bytes, held_.size() * kSize}, at)) {
      throw io::WriteError("no room for the points of all tiles beside them: expected " +
                           std::to_string(kSize) + " bytes a point");
    }
    put_away_ += held_.size();
    held_.clear();
  }

  std::shared_ptr<mapping::CloudFile> file_;
  std::vector<Eigen::Vector3f> held_;
  std::size_t put_away_ = 0;
};

/// Near the origin that they are counted from, floats keep their digits.
io::TileCounts export_tiles(const mapping::SavedMap& map, const MapExport& wanted) {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (const mapping::Piece& piece : map.pieces) {
    origin += piece.T_world_piece.translation / static_cast<double>(map.pieces.size());
  }
  origin = origin.array().round();
  fs::path beside_tiles = fs::absolute(wanted.tiles).parent_path();
  while (!fs::exists(beside_tiles)) beside_tiles = beside_tiles.parent_path();
  TilePoints points(map, origin, beside_tiles);
  const io::TileCounts counts =
      io::write_point_tiles(wanted.tiles, origin, points.all(), wanted.tiles_at);
  if (!report::tiles_page().empty()) {
    io::write_whole_file(wanted.tiles / "index.html", report::tiles_page());
  }
  return counts;
}

std::size_t export_mesh(const mapping::SavedMap& map, const MapExport& wanted,
                        const mapping::MeshProgress& progress) {
  const mapping::SurfaceMesh mesh = mapping::draw_mesh(map.pieces, wanted.triangles, progress);
  io::write_mesh(wanted.mesh, {mesh.vertices, mesh.triangles});
  return mesh.triangles.size();
}

/// The file itself, where its name ends so, or else the one beside it whose name does.
fs::path with_ending(fs::path file, const char* ending) {
  return io::has_ending(file, {ending}) ? file : file.replace_extension(ending);
}

/// The image and what tells of it.
std::array<fs::path, 2> occupancy_files(const MapExport& wanted) {
  return {with_ending(wanted.grid, ".pgm"), with_ending(wanted.grid, ".yaml")};
}

bool is_geotiff(const fs::path& file) { return io::has_ending(file, {".tif", ".tiff"}); }

/// Heights and their variances: of a GeoTIFF the same file.
std::array<fs::path, 2> elevation_files(const MapExport& wanted) {
  if (is_geotiff(wanted.elevation)) return {wanted.elevation, wanted.elevation};
  const fs::path heights = with_ending(wanted.elevation, ".asc");
  fs::path variances = heights;
  variances.replace_filename(heights.stem().string() + "_variance" + heights.extension().string());
  return {heights, variances};
}

/// What is no file at all is nobody's to write over; nor is the map that is read.
void check_replaced(const fs::path& file, const fs::path& map, bool overwrite) {
  if (!fs::exists(file)) return;
  std::error_code ignored;
  if (fs::equivalent(file, saved_map_file(map), ignored)) {
    throw io::WriteError(file.string() + ": is the map itself");
  }
  if (!fs::is_regular_file(file)) {
    throw io::WriteError(file.string() + ": is no file; choose another name");
  }
  if (!overwrite) {
    throw io::WriteError(file.string() + ": is there already; choose another name, or --overwrite");
  }
}

/// A name that says something else than what would be in the file.
void check_endings(const MapExport& wanted) {
  if (!wanted.mesh.empty()) static_cast<void>(io::mesh_format(wanted.mesh));
  io::require_ending(wanted.pcd, {".pcd"});
  io::require_ending(wanted.ply, {".ply"});
  io::require_ending(wanted.las, {".las"});
  io::require_ending(wanted.grid, {".pgm", ".yaml"});
  io::require_ending(wanted.elevation, {".asc", ".tif", ".tiff"});
}

/// What is somebody's already is not found after all the work, and not written over.
void check_files(const fs::path& map, const MapExport& wanted) {
  std::vector<fs::path> files = {wanted.pcd, wanted.ply, wanted.las, wanted.mesh};
  if (!wanted.grid.empty()) {
    const auto of_grid = occupancy_files(wanted);
    files.insert(files.end(), of_grid.begin(), of_grid.end());
  }
  if (!wanted.elevation.empty()) {
    const auto [heights, variances] = elevation_files(wanted);
    files.push_back(heights);
    if (variances != heights) files.push_back(variances);
  }
  std::set<fs::path> known;
  if (!wanted.tiles.empty()) {
    io::require_tiles_folder(wanted.tiles);
    known.insert(fs::absolute(wanted.tiles).lexically_normal());
  }
  for (const fs::path& file : files) {
    if (file.empty()) continue;
    if (!known.insert(fs::absolute(file).lexically_normal()).second) {
      throw std::invalid_argument(file.string() + ": is asked for twice");
    }
    check_replaced(file, map, wanted.overwrite);
  }
}

ExportedGrid export_occupancy(const mapping::SavedMap& map, const MapExport& wanted) {
  const mapping::OccupancyGrid grid = mapping::draw_occupancy(map.pieces, wanted.occupancy);
  const auto [image, description] = occupancy_files(wanted);
  io::write_whole_file(image, mapping::format_pgm(grid));
  io::write_whole_file(description,
                       mapping::format_grid_yaml(grid, io::yaml_word(image.filename().string())));
  return {image, grid.width, grid.height, grid.cell};
}

/// Layers by the names that GridMap's users give them.
std::string elevation_layers(const mapping::ElevationGrid& grid,
                             const mapping::LeggedRobot& robot) {
  const mapping::Traversability found = mapping::draw_traversability(grid, robot);
  return io::format_geotiff({grid.width,
                             grid.height,
                             grid.cell,
                             grid.low.x(),
                             grid.low.y(),
                             {{"elevation", grid.heights},
                              {"variance", grid.variances},
                              {"slope", found.slope},
                              {"step_height", found.step},
                              {"roughness", found.roughness},
                              {"traversability", found.score}}});
}

ExportedGrid export_elevation(const mapping::SavedMap& map, const MapExport& wanted) {
  const mapping::ElevationGrid grid = mapping::draw_elevation(map.pieces, wanted.elevation_cell);
  const auto [heights, variances] = elevation_files(wanted);
  if (is_geotiff(heights)) {
    io::write_whole_file(heights, elevation_layers(grid, wanted.robot));
  } else {
    io::write_whole_file(heights, mapping::format_asc(grid, grid.heights));
    io::write_whole_file(variances, mapping::format_asc(grid, grid.variances));
  }
  return {heights, grid.width, grid.height, grid.cell};
}

/// What is to be written: all of it, or one of the frames that nothing joins.
void choose_frame(const MapExport& wanted, mapping::SavedMap& map,
                  std::vector<std::string>& notes) {
  const std::vector<std::size_t> frames = mapping::frames_of(mapping::graph_of(map));
  const std::size_t count =
      frames.empty() ? 0 : *std::max_element(frames.begin(), frames.end()) + 1;
  if (!wanted.frame) {
    if (count > 1) {
      notes.push_back(fmt::format(
          "{} frames that nothing joins lie over each other; --frame N writes one, from 0 on",
          count));
    }
    return;
  }
  if (*wanted.frame >= count) {
    throw std::invalid_argument(fmt::format("--frame {}: the map has {}, counted from 0 on",
                                            *wanted.frame, io::counted(count, "frame")));
  }
  std::vector<mapping::Piece> pieces;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (frames[i] == *wanted.frame) pieces.push_back(std::move(map.pieces[i]));
  }
  map = {std::move(pieces), {}, {}};  // nothing else of it is written
}

/// Floats have 24 bits: far from the origin, as in coordinates of a country, that is little.
void tell_of_floats(const mapping::SavedMap& map, const MapExport& wanted,
                    std::vector<std::string>& notes) {
  constexpr double kFar = 10e3;  // [m] where they are a millimetre apart
  double farthest = 0.0;
  for (const mapping::Piece& piece : map.pieces) {
    farthest = std::max(farthest, piece.T_world_piece.translation.lpNorm<Eigen::Infinity>());
  }
  const bool mesh_in_floats =
      !wanted.mesh.empty() && io::mesh_format(wanted.mesh) != io::MeshFormat::obj;
  if (farthest < kFar || (wanted.ply.empty() && wanted.pcd.empty() && !mesh_in_floats)) return;
  notes.push_back(
      fmt::format("{:.0f} km from the map's origin the floats of PLY, PCD and STL are "
                  "{:.2g} m apart; --las, --tiles and a mesh in OBJ lose nothing there",
                  1e-3 * farthest, std::ldexp(1.0, std::ilogb(farthest) - 23)));
}

}  // namespace

MapExported export_map(const fs::path& map, const MapExport& wanted,
                       const mapping::MeshProgress& progress) {
  if (wanted.pcd.empty() && wanted.ply.empty() && wanted.las.empty() && wanted.tiles.empty() &&
      wanted.mesh.empty() && wanted.grid.empty() && wanted.elevation.empty()) {
    throw std::invalid_argument(
        "nothing to write: expected --pcd, --ply, --las, --tiles, --mesh, --grid or --elevation");
  }
  check_endings(wanted);  // before all the work
  check_files(map, wanted);
  mapping::SavedMap saved = read_saved_map(map);
  MapExported done;
  choose_frame(wanted, saved, done.notes);
  tell_of_floats(saved, wanted, done.notes);
  if (!wanted.ply.empty()) io::write_ply(wanted.ply, points_of<float>(saved));
  if (!wanted.pcd.empty()) {
    Scan points;
    points.points = points_of<float>(saved);
    io::write_pcd(wanted.pcd, points);
  }
  if (!wanted.las.empty()) io::write_las(wanted.las, points_of<double>(saved));
  if (!wanted.tiles.empty()) done.tiles = export_tiles(saved, wanted);
  if (!wanted.mesh.empty()) done.triangles = export_mesh(saved, wanted, progress);
  if (!wanted.grid.empty()) done.grids.push_back(export_occupancy(saved, wanted));
  if (!wanted.elevation.empty()) done.grids.push_back(export_elevation(saved, wanted));
  return done;
}

}  // namespace surefoot::runs
