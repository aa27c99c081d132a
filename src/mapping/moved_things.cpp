// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/moved_things.hpp"

#include <algorithm>
#include <bit>

#include "mapping/held_pieces.hpp"
#include "mapping/submap.hpp"

namespace surefoot::mapping {

namespace {

constexpr float kAboveGround = 0.25F;   // [m] what moves stands out of it
constexpr float kHighest = 2.5F;        // and is no higher
constexpr double kWitnessReach = 15.0;  // [m] pieces that may have seen the same
constexpr std::size_t kMostWitnesses = 16;
constexpr std::size_t kKeptSights = 160;  // pieces' sights, some 0.1 MB each
constexpr int kWitnesses = 2;             // that have to have seen through

/// Heights over the ground of a piece, of places in its frame.
class Ground {
 public:
  explicit Ground(const Submap& submap)
      : up_(submap.to_slope.toRotationMatrix().row(2).cast<float>()),
        height_(static_cast<float>(submap.slope_ground)) {}
  [[nodiscard]] bool stands(const Eigen::Vector3f& place) const {
    const float above = up_.dot(place) - height_;
    return above > kAboveGround && above < kHighest;
  }

 private:
  Eigen::RowVector3f up_;
  float height_;
};

/// Where something stood above the ground when a piece was walked, and what beams went through.
std::shared_ptr<const ThingSight> seen_from(const Piece& piece) {
  const Submap submap = make_submap(piece);
  const Ground ground(submap);
  return std::make_shared<const ThingSight>(
      submap, [&](const Eigen::Vector3f& point) { return ground.stands(point); });
}

}  // namespace

std::shared_ptr<const ThingSight> MovedThings::sight(std::size_t piece) {
  const auto known = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const auto& entry) { return entry.first == piece; });
  if (known != kept_.end()) {
    // The one that was asked for longest ago goes first.
    std::rotate(known, known + 1, kept_.end());
    return kept_.back().second;
  }
  if (kept_.size() == kKeptSights) kept_.erase(kept_.begin());
  kept_.emplace_back(piece, seen_from(pieces_[piece]));
  return kept_.back().second;
}

/// Pieces near one. Of many, every second, fourth, eighth one of all visits: those beside it are
/// seen by the same.
std::vector<std::size_t> MovedThings::witnesses(std::size_t piece) const {
  std::vector<std::size_t> near;
  const Eigen::Vector3d& here = pieces_[piece].T_world_piece.translation;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Eigen::Vector3d apart = pieces_[i].T_world_piece.translation - here;
    if (i != piece && held_[i] == held_[piece] && apart.norm() < kWitnessReach) near.push_back(i);
  }
  if (near.size() <= kMostWitnesses) return near;
  std::stable_sort(near.begin(), near.end(), [](std::size_t a, std::size_t b) {
    return std::countr_zero(a) > std::countr_zero(b);
  });
  near.resize(kMostWitnesses);
  std::sort(near.begin(), near.end());
  return near;
}

std::vector<bool> MovedThings::gone(std::size_t piece, const std::vector<Eigen::Vector3f>& points) {
  const Ground ground(make_submap(pieces_[piece]));
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ground.stands(points[i])) asked.push_back(i);
  }
  struct Votes {
    int empty = 0, something = 0;
    int empty_since = 0;  // later than the last who saw something
  };
  std::vector<Votes> votes(asked.size());
  for (const std::size_t witness : witnesses(piece)) {
    const auto saw = sight(witness);
    const Pose T_witness_piece =
        pieces_[witness].T_world_piece.inverse() * pieces_[piece].T_world_piece;
    const bool later = pieces_[witness].stamp_ns > pieces_[piece].stamp_ns;
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const auto there = saw->at(T_witness_piece * points[asked[k]].cast<double>());
      const int empty = there == FreeSpace::Sight::empty ? 1 : 0;
      const int something = there == FreeSpace::Sight::occupied ? 1 : 0;
      votes[k].empty += empty;
      votes[k].something += something;
      if (later) votes[k].empty_since = something > 0 ? 0 : votes[k].empty_since + empty;
    }
  }
  std::vector<bool> result(points.size(), false);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const Votes& of = votes[k];
    result[asked[k]] =
        of.empty_since >= kWitnesses || (of.empty >= kWitnesses && of.something == 0);
  }
  return result;
}

std::vector<std::size_t> held_together(const PoseGraph& graph) {
  HeldPieces held(graph);
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < graph.poses.size(); ++i) result.push_back(held.set_of(i));
  return result;
}

void drop_moved(std::vector<Piece>& pieces, MovedThings& moved,
                const std::shared_ptr<CloudFile>& file) {
  std::vector<std::shared_ptr<const StoredCloud>> kept;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto cloud = cloud_of(pieces[i]);
    const std::vector<bool> gone = moved.gone(i, cloud->points);
    PieceCloud left;
    left.eyes = cloud->eyes;
    for (std::size_t k = 0; k < cloud->points.size(); ++k) {
      if (gone[k]) continue;
      left.points.push_back(cloud->points[k]);
      left.seen_from.push_back(cloud->seen_from[k]);
    }
    kept.push_back(left.points.size() == cloud->points.size() && pieces[i].stored
                       ? pieces[i].stored
                       : store(left, file));
  }
  // All at once: what is gone from one is a witness of what is gone from others.
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    static_cast<PieceCloud&>(pieces[i]) = PieceCloud{};
    pieces[i].stored = kept[i];
  }
}

}  // namespace surefoot::mapping
