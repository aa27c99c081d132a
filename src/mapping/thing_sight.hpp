// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What was seen of single things from a piece of way: in how many of its moments something was hit
// in a cube, and in how many beams went through it and nothing stood near. Where others walk by at
// another moment, it is still seen that nothing stays.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/voxel_table.hpp"
#include "mapping/kept_scan.hpp"
#include "mapping/piece_ground.hpp"

namespace surefoot::mapping {

/// What looks in a piece's frame come to, as few bytes. They stand in the order of their stamps.
[[nodiscard]] std::string seen_in(const std::vector<KeptScan>& looks, const PieceGround& ground);

class ThingSight {
 public:
  /// Of what seen_in() has written. Throws std::invalid_argument if that is no such thing.
  explicit ThingSight(std::string_view bytes);

  /// How many moments.
  struct Moments {
    int through = 0;  ///< beams went through, and nothing stood near
    int hit = 0;
  };
  /// Of a place in the piece's frame [m].
  [[nodiscard]] Moments at(const Eigen::Vector3d& place) const;

 private:
  using Block = std::array<std::uint8_t, 64>;  // of 4 x 4 x 4 cubes: 16 times through, and hit

  VoxelTable table_;  // index into blocks_
  std::vector<Block> blocks_;
};

}  // namespace surefoot::mapping
