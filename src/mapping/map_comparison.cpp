// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mapping/loop_finder.hpp"

namespace surefoot::mapping {

namespace {

constexpr double kNear = 5.0;           // pieces so near see the same [m]
constexpr std::size_t kMostPairs = 40;  // that are compared, spread over all
constexpr std::size_t kMostKept = 40;   // some 10 MB each

}  // namespace

std::shared_ptr<const VerifiableSubmap> TwoMaps::submap(std::size_t piece) {
  const auto known = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const auto& entry) { return entry.first == piece; });
  if (known != kept_.end()) return known->second;
  if (kept_.size() == kMostKept) kept_.pop_front();
  kept_.emplace_back(piece, std::make_shared<VerifiableSubmap>(make_submap(pieces_, piece)));
  return kept_.back().second;
}

MapComparison TwoMaps::compare(const std::vector<std::size_t>& of_first,
                               const std::vector<std::size_t>& of_second) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (const std::size_t b : of_second) {
    const Eigen::Vector3d at = pieces_[b].T_world_piece.translation;
    std::size_t nearest = 0;
    double distance = std::numeric_limits<double>::infinity();
    for (const std::size_t a : of_first) {
      const Eigen::Vector3d apart = pieces_[a].T_world_piece.translation - at;
      if (std::abs(apart.z()) < kHalfStorey && apart.norm() < distance) {
        distance = apart.norm();
        nearest = a;
      }
    }
    if (distance < kNear) pairs.emplace_back(nearest, b);
  }
  MapComparison result;
  result.near = pairs.size();
  std::size_t compared = 0;
  const std::size_t every = (pairs.size() + kMostPairs - 1) / kMostPairs;
  for (std::size_t i = 0; i < pairs.size(); i += every) {
    const auto [a, b] = pairs[i];
    const Pose T_a_b = pieces_[a].T_world_piece.inverse() * pieces_[b].T_world_piece;
    const auto one = submap(a);
    const auto other = submap(b);
    ++compared;
    result.contradicted += contradiction_between(*one, *other, T_a_b);
    result.overlap += overlap_between(one->registration(), other->registration(), T_a_b);
  }
  if (compared == 0) return result;
  result.contradicted /= static_cast<double>(compared);
  result.overlap /= static_cast<double>(compared);
  return result;
}

}  // namespace surefoot::mapping
