// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/moved_things.hpp"

#include <algorithm>
#include <bit>

#include "mapping/held_pieces.hpp"
#include "mapping/piece_ground.hpp"
#include "mapping/submap.hpp"

namespace surefoot::mapping {

namespace {

constexpr float kHighest = 2.5F;        // [m] what moves is no higher
constexpr double kWitnessReach = 25.0;  // [m] pieces that may have seen the same
constexpr std::size_t kMostWitnesses = 16;
constexpr std::size_t kKeptSights = 40;  // pieces' sights, some 0.5 MB each

// In so many moments beams have to have gone through, and in so many times fewer something hit.
constexpr int kThrough = 3, kTimes = 2;
// In so many from one piece's on something stood, oftener than not: it came and stays.
constexpr int kStays = 4;
// In so many, from so many pieces, later on: it went.
constexpr int kThroughSince = 8, kPiecesSince = 2, kTimesSince = 9;

/// Moments in which a place was seen, over the pieces from one on.
struct SeenMoments {
  int through = 0, hit = 0;
  int pieces = 0;  // from which beams went through

  void add(const ThingSight::Moments& of) {
    through += of.through;
    hit += of.hit;
    pieces += of.through > 0 ? 1 : 0;
  }
  [[nodiscard]] bool through_often(int least, int times) const {
    return through >= least && through > times * hit;
  }
};

/// What all witnesses say of a place, asked from the last to the first.
struct Said {
  SeenMoments all;
  bool went = false;   // later pieces see through it
  bool stays = false;  // something stands there from the piece on that saw it

  void add(const ThingSight::Moments& of, std::size_t witness, std::size_t piece) {
    all.add(of);
    if (witness > piece && all.pieces >= kPiecesSince) {
      went = went || all.through_often(kThroughSince, kTimesSince);
    }
    if (witness == piece) stays = all.hit >= kStays && all.hit > all.through;
  }
  [[nodiscard]] bool gone() const {
    return went || (all.through_often(kThrough, kTimes) && !stays);
  }
};

}  // namespace

const ThingSight* MovedThings::sight(std::size_t piece) {
  if (!pieces_[piece].things) return nullptr;
  const auto known = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const auto& entry) { return entry.first == piece; });
  if (known != kept_.end()) {
    // The one that was asked for longest ago goes first.
    std::rotate(known, known + 1, kept_.end());
  } else {
    if (kept_.size() == kKeptSights) kept_.erase(kept_.begin());
    kept_.emplace_back(piece, std::make_unique<const ThingSight>(pieces_[piece].things->packed()));
  }
  return kept_.back().second.get();
}

/// A piece and those near it. Of many, every second, fourth, eighth one of all visits: those beside
/// it are seen by the same.
std::vector<std::size_t> MovedThings::witnesses(std::size_t piece) const {
  std::vector<std::size_t> near;
  const Eigen::Vector3d& here = pieces_[piece].T_world_piece.translation;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const Eigen::Vector3d apart = pieces_[i].T_world_piece.translation - here;
    if (held_[i] == held_[piece] && apart.norm() < kWitnessReach) near.push_back(i);
  }
  if (near.size() <= kMostWitnesses) return near;
  std::stable_sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) {
    if (a == piece || b == piece) return a == piece && b != piece;
    return std::countr_zero(a) > std::countr_zero(b);
  });
  near.resize(kMostWitnesses);
  std::sort(near.begin(), near.end());
  return near;
}

std::vector<bool> MovedThings::gone(std::size_t piece, const std::vector<Eigen::Vector3f>& points) {
  const PieceGround ground(make_submap(pieces_[piece]));
  std::vector<std::size_t> asked;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (ground.height(points[i]) < kHighest && ground.stands(points[i])) asked.push_back(i);
  }
  std::vector<Said> said(asked.size());
  const std::vector<std::size_t> near = witnesses(piece);
  for (auto witness = near.rbegin(); witness != near.rend(); ++witness) {
    const ThingSight* saw = sight(*witness);
    if (saw == nullptr) continue;
    const Pose T_witness_piece =
        pieces_[*witness].T_world_piece.inverse() * pieces_[piece].T_world_piece;
    const Eigen::Matrix3d R = T_witness_piece.rotation.toRotationMatrix();
    for (std::size_t k = 0; k < asked.size(); ++k) {
      const Eigen::Vector3d place =
          R * points[asked[k]].cast<double>() + T_witness_piece.translation;
      said[k].add(saw->at(place), *witness, piece);
    }
  }
  std::vector<bool> result(points.size(), false);
  for (std::size_t k = 0; k < asked.size(); ++k) result[asked[k]] = said[k].gone();
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
