// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/map_merge_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "io/decimal_time.hpp"
#include "io/file_writer.hpp"
#include "mapping/map_merge.hpp"
#include "runs/loops_csv.hpp"
#include "runs/run_files.hpp"
#include "runs/saved_map.hpp"

namespace surefoot::runs {

namespace fs = std::filesystem;

namespace {

void make_merge_folder(const fs::path& folder, bool overwrite) {
  for (const char* name : {kSavedMapFile, kLoopsFile, kPiecesFile}) {
    if (!overwrite && fs::exists(folder / name)) {
      throw std::runtime_error((folder / name).string() +
                               ": is there already; choose another folder, or --overwrite");
    }
  }
  fs::create_directories(folder);
}

/// Where the pieces of a joint map lie, and of which map each one is.
std::string pieces_csv(const std::vector<mapping::Piece>& pieces,
                       const std::vector<std::size_t>& maps) {
  std::string text = "map,stamp,x,y,z,qx,qy,qz,qw\n";
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Eigen::Vector3d& t = pieces[i].T_world_piece.translation;
    const Eigen::Quaterniond& q = pieces[i].T_world_piece.rotation;
    text += fmt::format("{},{},{:.6f},{:.6f},{:.6f},{:.9f},{:.9f},{:.9f},{:.9f}\n", maps[i],
                        io::format_seconds(pieces[i].stamp_ns), t.x(), t.y(), t.z(), q.x(), q.y(),
                        q.z(), q.w());
  }
  return text;
}

}  // namespace

bool MergeOutcome::joined() const {
  return std::all_of(maps.begin(), maps.end(), [](const MergedMap& map) { return map.joined; });
}

MergeOutcome merge_saved_maps(const std::vector<fs::path>& maps, const fs::path& folder,
                              bool overwrite, bool leave_out,
                              const std::function<void(std::size_t, std::size_t)>& on_piece) {
  MergeOutcome outcome;
  mapping::MergeOptions options;
  options.on_piece = on_piece;
  std::vector<mapping::SavedMap> read;
  for (const fs::path& map : maps) read.push_back(read_saved_map(map));
  make_merge_folder(folder, overwrite);
  mapping::SavedMap joint = read.front();
  std::vector<std::size_t> map_of(joint.pieces.size(), 1);  // of each of its pieces
  for (std::size_t i = 1; i < maps.size(); ++i) outcome.maps.push_back({.path = maps[i]});
  std::vector<std::string> loops(maps.size());  // of each map's last attempt
  // What joins none of the first may join what is joined to it later.
  for (bool more = true; more;) {
    more = false;
    for (std::size_t i = 0; i < outcome.maps.size(); ++i) {
      MergedMap& map = outcome.maps[i];
      if (map.joined) continue;
      mapping::MapJoin join = mapping::join_maps(joint, read[i + 1], options);
      loops[i + 1] = join_csv(join, i + 2);
      map = {map.path,     join.joint.has_value(),    join.loops.size(),
             join.taken,   join.comparison.near,      join.message,
             join.begin(), read[i + 1].pieces.size(), join.held()};
      if (!join.joint) continue;
      joint = std::move(*join.joint);
      map_of.resize(joint.pieces.size(), i + 2);
      more = true;
    }
    more = more && !outcome.joined();
  }
  io::write_whole_file(folder / kLoopsFile,
                       std::accumulate(loops.begin(), loops.end(), std::string(join_csv_header())));
  outcome.pieces = joint.pieces.size();
  const bool any = std::any_of(outcome.maps.begin(), outcome.maps.end(),
                               [](const MergedMap& map) { return map.joined; });
  outcome.written = outcome.joined() || (leave_out && any);
  if (outcome.written) {
    io::write_whole_file(folder / kPiecesFile, pieces_csv(joint.pieces, map_of));
    write_saved_map(folder / kSavedMapFile, joint);
  }
  return outcome;
}

}  // namespace surefoot::runs
