// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string_view>

#include "fuzz/targets.hpp"
#include "fuzz/whole_way.hpp"
#include "mapping/map_file.hpp"
#include "mapping/submap.hpp"

namespace surefoot::fuzz {
namespace {

constexpr std::size_t kHead = 25;  // magic, version, checksum

void read_map_of(std::uint32_t version, std::string_view content) {
  try {
    const mapping::SavedMap map = mapping::parse_map(mapping::sealed(content, version));
    for (std::size_t i = 0; i < map.pieces.size(); ++i) {
      (void)mapping::describe_place(mapping::make_submap(map.pieces, i));
    }
    (void)mapping::parse_map(mapping::format_map(map));
  } catch (const mapping::MapFileError&) {
  }
}

/// What follows a map's head; that is made right, since by chance no checksum is.
void read_map(Bytes bytes) {
  const std::string_view content(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  read_map_of(1, content);
  read_map_of(mapping::kMapVersion, content);
}

Seeds map_seeds() {
  mapping::SavedMap map;
  for (int i = 0; i < 2; ++i) {
    mapping::Piece piece;
    piece.T_world_piece.translation.x() = 5.0 * i;
    piece.way = 5.0 * i;
    piece.eyes = {{0.0F, 0.0F, 0.5F}};
    piece.points = {{1.0F, 2.0F, 0.25F}, {-1.0F, 3.0F, 1.5F}};
    piece.seen_from = {0, 0};
    map.pieces.push_back(piece);
    map.places.push_back(mapping::describe_place(mapping::make_submap(piece)));
  }
  mapping::PoseEdge edge;
  edge.to = 1;
  map.edges = {edge};
  return {mapping::format_map(map).substr(kHead), mapping::format_map({}).substr(kHead)};
}

constexpr Target kTargets[] = {{"map", read_map, map_seeds}};

}  // namespace

std::span<const Target> map_targets() { return kTargets; }

}  // namespace surefoot::fuzz
