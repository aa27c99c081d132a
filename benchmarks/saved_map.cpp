// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// saved_map MAP...: what a saved map costs: its bytes, opening it, looking for a place in it, and
// solving its graph anew from the odometry, in processor time. A line of CSV each; MAP is a
// map.surefoot, or the folder it lies in. Exit codes: 0, 2 for bad input.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <ctime>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "mapping/loop_solution.hpp"
#include "mapping/map_on_disk.hpp"
#include "mapping/place_index.hpp"
#include "mapping/pose_graph_solver.hpp"
#include "memory.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::benchmarks {

namespace {

constexpr double kWayBetween = 25.0;    // [m] as LoopOptions has it
constexpr std::size_t kSearches = 200;  // at most, evenly picked, the last pieces among them

/// Of the processor: what else the machine does is no matter.
template <typename Work>
double seconds_of(const Work& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Milliseconds of looking for each of some pieces among all that were walked long enough before.
std::vector<float> search_all(const mapping::SavedMap& map) {
  mapping::PlaceIndex index;
  for (const mapping::PlaceDescriptor& place : map.places) index.add(place);
  std::vector<float> times;
  const std::size_t every = map.pieces.size() / kSearches + 1;
  for (std::size_t k = 0; k < map.pieces.size(); k += every) {
    const std::size_t query = map.pieces.size() - 1 - k;
    const mapping::Submap seen = mapping::make_submap(map.pieces, query);
    times.push_back(static_cast<float>(1e3 * seconds_of([&] {
                                         (void)index.search(
                                             mapping::describe_with_offsets(seen),
                                             [&](std::size_t place) {
                                               return map.pieces[query].way -
                                                          map.pieces[place].way >=
                                                      kWayBetween;
                                             },
                                             mapping::LoopOptions{}.candidates);
                                       })));
  }
  return times;
}

/// The odometry alone, and the loops that were taken.
mapping::PoseGraph unsolved(const mapping::SavedMap& map, std::vector<mapping::PoseEdge>& loops) {
  mapping::PoseGraph graph;
  for (const mapping::Piece& piece : map.pieces) graph.poses.push_back(piece.T_world_piece);
  for (const mapping::PoseEdge& edge : map.edges) {
    if (edge.inlier) {
      graph.edges.push_back(edge);
      if (edge.to == edge.from + 1) graph.poses[edge.to] = graph.poses[edge.from] * edge.T_from_to;
    } else {
      loops.push_back(edge);
    }
  }
  return graph;
}

void measure(const std::filesystem::path& path) {
  mapping::SavedMap map;
  const double opened = seconds_of([&] { map = mapping::load_map(path); });
  const double memory = resident_megabytes();
  if (map.pieces.empty()) throw std::runtime_error(path.string() + ": holds no piece of way");
  const double kilometres = 1e-3 * map.pieces.back().way;
  const auto file = std::filesystem::is_directory(path) ? path / mapping::kMapFileName : path;
  const std::vector<float> searches = search_all(map);
  std::vector<mapping::PoseEdge> loops;
  mapping::PoseGraph graph = unsolved(map, loops);
  const double solved = seconds_of([&] { (void)mapping::solve_with_loops(graph, loops); });
  fmt::print("{},{:.2f},{},{},{:.1f},{:.2f},{:.0f},{:.1f},{:.1f},{:.2f}\n", path.string(),
             kilometres, map.pieces.size(), loops.size(),
             1e-6 * static_cast<double>(std::filesystem::file_size(file)) / kilometres,
             opened / kilometres, memory, quantile(searches, 0.5), quantile(searches, 1.0), solved);
}

}  // namespace

}  // namespace surefoot::benchmarks

int main(int argc, char** argv) {
  std::vector<std::string> maps;
  CLI::App app{"What saved maps cost"};
  app.add_option("maps", maps, "map.surefoot, or the folder it lies in")->required();
  try {
    app.parse(argc, argv);
    fmt::print(
        "map,way [km],pieces,loops,disk [MB/km],opened [s/km],memory [MB],\"search, median [ms]\","
        "\"search, longest [ms]\",graph solved [s]\n");
    for (const std::string& map : maps) surefoot::benchmarks::measure(map);
    return 0;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  } catch (const std::exception& error) {
    fmt::print(stderr, "saved_map: {}\n", error.what());
    return 2;
  }
}
