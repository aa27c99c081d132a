// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What was seen from a piece of way, as few bytes: some four a point. A map of kilometres is mostly
// this, and only what is compared is ever unpacked.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace surefoot::mapping {

struct PieceCloud {
  std::vector<Eigen::Vector3f> points;   ///< [m] the piece's frame
  std::vector<std::uint16_t> seen_from;  ///< of each point: which of `eyes`
  std::vector<Eigen::Vector3f> eyes;     ///< where the LiDAR was [m]
};

/// Points are kept to 2 mm on each axis, as far as 64 m from the frame's origin, in an order of
/// their own: neighbours follow each other.
[[nodiscard]] std::string pack(const PieceCloud& cloud);
/// Throws std::invalid_argument that says what is wrong with the bytes.
[[nodiscard]] PieceCloud unpack(std::string_view bytes);

}  // namespace surefoot::mapping
