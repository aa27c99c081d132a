// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// moving_objects RECORDING RUN...: what of moving objects is left in the maps. RECORDING is what
// `surefoot simulate --true-points --no-footprint` makes (mixed pixels would count as moved), each
// RUN what `surefoot run RECORDING -o RUN` does. Exit codes: 0, 2 for bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "core/voxel_key.hpp"
#include "core/voxel_table.hpp"
#include "evaluation/association.hpp"
#include "io/file_reader.hpp"
#include "io/files/folder_listing.hpp"
#include "io/files/pcd_reader.hpp"
#include "io/files/ply_reader.hpp"
#include "io/recording.hpp"
#include "io/trajectory_files.hpp"
#include "simulation/scanner.hpp"

namespace surefoot::benchmarks {

namespace {

namespace fs = std::filesystem;

constexpr double kFine = 0.1;    // [m] cubes that tell what stands from what moved
constexpr int kNear = 2;         // of these cubes each way: beyond drift and noise, within a leg
constexpr double kCoarse = 0.4;  // [m] cubes that tell how much of what stands is in the map
constexpr double kFar = 1e4;     // [m] of any place; voxel keys repeat farther away
constexpr double kStatic = simulation::kLabelStatic;

using Points = std::vector<Eigen::Vector3d>;

/// Those cubes of a grid that hold something.
class CubeSet {
 public:
  explicit CubeSet(double side) : inverse_side_(1.0 / side) {}

  void add(const Eigen::Vector3d& point) {
    const std::uint64_t key = voxel_key(voxel_index(point, inverse_side_));
    if (table_.find_or_insert(key, 0).second) keys_.push_back(key);
  }

  /// Whether one of them lies up to `reach` cubes each way from the point's own.
  [[nodiscard]] bool near(const Eigen::Vector3d& point, int reach) const {
    const VoxelIndex own = voxel_index(point, inverse_side_);
    for (int x = -reach; x <= reach; ++x) {
      for (int y = -reach; y <= reach; ++y) {
        for (int z = -reach; z <= reach; ++z) {
          if (holds(voxel_key(own + VoxelIndex(x, y, z)))) return true;
        }
      }
    }
    return false;
  }

  [[nodiscard]] bool holds(std::uint64_t key) const {
    return table_.find(key) != VoxelTable::kNone;
  }
  [[nodiscard]] const std::vector<std::uint64_t>& keys() const { return keys_; }

 private:
  double inverse_side_;
  VoxelTable table_;
  std::vector<std::uint64_t> keys_;
};

std::vector<double> numbers_of(const io::PointTable& table, const char* name) {
  const io::Column* column = table.find(name);
  if (column == nullptr) throw io::ReadError(fmt::format("its points have no {}", name));
  std::vector<double> numbers(table.size);
  io::for_each_value(*column, table.size,
                     [&](std::size_t i, auto value) { numbers[i] = double(value); });
  return numbers;
}

Points points_of(const io::PointTable& table) {
  const std::vector<double> x = numbers_of(table, "x"), y = numbers_of(table, "y"),
                            z = numbers_of(table, "z");
  Points points;
  points.reserve(table.size);
  for (std::size_t i = 0; i < table.size; ++i) {
    points.emplace_back(x[i], y[i], z[i]);
    if (!(points.back().norm() < kFar)) {  // nor is NaN
      throw io::ReadError(fmt::format("point {} is no place within {:.0f} km", i, 1e-3 * kFar));
    }
  }
  return points;
}

/// What stands, of every scan's true returns.
struct Truth {
  Trajectory trajectory;
  CubeSet fine{kFine};
  CubeSet coarse{kCoarse};
};

void add_scan(const fs::path& file, Truth& truth) {
  try {
    std::vector<std::byte> bytes;
    io::read_whole_file(file, bytes);
    const io::PointTable table = io::parse_pcd(bytes);
    const Points points = points_of(table);
    const std::vector<double> labels = numbers_of(table, "intensity");
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (labels[i] != kStatic) continue;
      truth.fine.add(points[i]);
      truth.coarse.add(points[i]);
    }
  } catch (const io::ReadError& error) {
    throw io::ReadError(file.string() + ": " + error.what());
  }
}

Truth read_truth(const fs::path& recording) {
  const fs::path folder = recording / "true";
  if (!fs::is_directory(folder)) {
    throw io::ReadError(folder.string() +
                        ": no such folder; surefoot simulate --true-points makes it");
  }
  Truth truth;
  truth.trajectory = io::read_tum(recording / "gt.tum");
  for (const fs::path& file : io::list_folder(folder, "pcd").files) add_scan(file, truth);
  if (truth.fine.keys().empty()) throw io::ReadError(folder.string() + ": nothing stands");
  return truth;
}

/// By the last pose, which was found in the whole map.
Pose map_in_truth(const fs::path& trajectory, const Truth& truth) {
  try {
    const auto both = evaluation::associate(truth.trajectory, io::read_tum(trajectory),
                                            {.method = evaluation::AssociationMethod::interpolate});
    return both.reference.back().pose * both.estimate.back().pose.inverse();
  } catch (const io::ReadError&) {
    throw;  // names the file
  } catch (const std::exception& error) {
    throw io::ReadError(trajectory.string() + " and the truth: " + error.what());
  }
}

Points read_map(const fs::path& file) {
  try {
    std::vector<std::byte> bytes;
    io::read_whole_file(file, bytes);
    return points_of(io::parse_ply(bytes));
  } catch (const io::ReadError& error) {
    throw io::ReadError(file.string() + ": " + error.what());
  }
}

void print_row(const fs::path& run, const Truth& truth) {
  const bool loops = fs::exists(run / "trajectory_optimized.tum");
  const Pose T_truth_map =
      map_in_truth(run / (loops ? "trajectory_optimized.tum" : "trajectory.tum"), truth);
  const bool after_loops = fs::exists(run / "map_optimized.ply");
  const Points map = read_map(run / (after_loops ? "map_optimized.ply" : "map.ply"));
  std::size_t moved = 0, found = 0;
  CubeSet mapped(kCoarse);
  for (const Eigen::Vector3d& point : map) {
    const Eigen::Vector3d place = T_truth_map * point;
    if (!truth.fine.near(place, kNear)) ++moved;
    mapped.add(place);
  }
  for (const std::uint64_t key : truth.coarse.keys()) found += mapped.holds(key) ? 1 : 0;
  const double share = double(found) / double(truth.coarse.keys().size());
  const fs::path name = run.has_filename() ? run.filename() : run.parent_path().filename();
  fmt::print("| {} | {} | {} | {:.1f} |\n", name.string(), map.size(), moved, 100.0 * share);
  std::fflush(stdout);
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  std::string recording;
  std::vector<std::string> runs;
  CLI::App app{"What of moving objects is left in the maps"};
  app.add_option("recording", recording, "Folder with gt.tum and true/")->required();
  app.add_option("runs", runs, "Folders with trajectory.tum and map.ply")->required();
  try {
    app.parse(argc, argv);
    const surefoot::benchmarks::Truth truth = surefoot::benchmarks::read_truth(recording);
    fmt::print(
        "| run | points in the map | of what moved | of what stands, in the map [%] |\n"
        "|---|---|---|---|\n");
    for (const std::string& run : runs) surefoot::benchmarks::print_row(run, truth);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "moving_objects: {}\n", error.what());
    return 2;
  }
}
