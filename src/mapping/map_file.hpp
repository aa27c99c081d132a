// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A map to come back to, as bytes: pieces of way where they belong after all loops, what their
// places look like, and the graph between them. Version and checksum stand in it; what is cut short
// or changed is refused.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mapping/piece.hpp"
#include "mapping/place_descriptor.hpp"
#include "mapping/pose_graph.hpp"

namespace surefoot::mapping {

inline constexpr std::uint32_t kMapVersion = 2;  ///< that is written; version 1 is read, too

struct SavedMap {
  /// T_world_piece is the corrected pose. Points are kept to 2 mm, packed away.
  std::vector<Piece> pieces;
  std::vector<PlaceDescriptor> places;  ///< one a piece
  std::vector<PoseEdge> edges;          ///< odometry and loops
};

/// Of the pieces, at their corrected poses.
[[nodiscard]] PoseGraph graph_of(const SavedMap& map);

class MapFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// At the stream's place, which has to be one that can be gone back to.
void write_map(std::ostream& out, const SavedMap& map);
[[nodiscard]] std::string format_map(const SavedMap& map);
/// A map file of this content: with its head, the checksum in it.
[[nodiscard]] std::string sealed(std::string_view content, std::uint32_t version = kMapVersion);
/// Throws MapFileError that says what was seen and what was expected.
[[nodiscard]] SavedMap parse_map(std::string_view bytes);
/// The same of a stream's bytes from its beginning on. `clouds`: the file that it reads, where the
/// pieces' clouds stay; none: they are kept in memory.
[[nodiscard]] SavedMap read_map(std::istream& in, const std::shared_ptr<CloudFile>& clouds);

}  // namespace surefoot::mapping
