// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/downsample.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <tuple>

#include "core/voxel_key.hpp"
#include "geometry/float_sums.hpp"

namespace surefoot {

namespace {

/// A point that may stand for its voxel. Its rank is the less the nearer it is to the centre: a
/// float that is not negative lies among such as its bits do, so that one comparison of integers
/// tells.
struct Candidate {
  static constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

  std::uint64_t key = 0;       // of its voxel, hashed
  std::uint64_t rank = kNone;  // squared distance to the centre, then the point's index

  [[nodiscard]] std::uint32_t index() const { return static_cast<std::uint32_t>(rank); }
};

Candidate make_candidate(const Eigen::Vector3f& point, std::uint32_t at, double voxel,
                         double inverse_voxel) {
  const VoxelIndex index = voxel_index(point.cast<double>(), inverse_voxel);
  const Eigen::Vector3d centre = (index.cast<double>().array() + 0.5) * voxel;
  const float to_centre2 = squared_norm(point - centre.cast<float>());
  const std::uint64_t bits = std::bit_cast<std::uint32_t>(to_centre2);
  return {hash_key(voxel_key(index)), bits << 32 | at};
}

/// The best candidate of each voxel whose key begins with some bits: an open-addressing hash table.
/// The keys are hashes, so that the bits that follow tell the slot; then the slots lie nearly in
/// the keys' order, and sorting them costs next to nothing.
class BestOfPart {
 public:
  BestOfPart(const std::vector<Eigen::Vector3f>& points, int first_bits, std::size_t expected)
      : points_(points), first_bits_(first_bits) {
    resize(std::bit_ceil(std::max(expected, kFewest)));
  }

  void offer(const Candidate& candidate) {
    Candidate& best = slot_of(candidate.key);
    if (best.rank == Candidate::kNone) {
      best = candidate;
      if (2 * ++size_ > slots_.size()) grow();
    } else if (((candidate.rank ^ best.rank) >> 32) == 0) {
      if (comes_before(candidate, best)) best = candidate;
    } else {
      best.rank = std::min(best.rank, candidate.rank);  // no branch that nobody can foresee
    }
  }

  /// Any fixed order will do, but a spatial one: a voxel of the map takes the first points it is
  /// offered, and would fill up from one side, which pulls every later scan to that side.
  void append_to(std::vector<std::uint32_t>& indices) {
    std::erase_if(slots_, [](const Candidate& c) { return c.rank == Candidate::kNone; });
    const auto before = [](const Candidate& a, const Candidate& b) { return a.key < b.key; };
    for (auto at = slots_.begin(); at != slots_.end(); ++at) {  // by insertion
      const Candidate candidate = *at;
      auto to = at;
      for (; to != slots_.begin() && before(candidate, *(to - 1)); --to) *to = *(to - 1);
      *to = candidate;
    }
    for (const Candidate& candidate : slots_) indices.push_back(candidate.index());
  }

 private:
  static constexpr std::size_t kFewest = 256;  // slots

  void resize(std::size_t slots) {
    slots_.assign(slots, {});
    shift_ = 64 - std::countr_zero(slots);
  }

  /// Where a voxel's best candidate is, or can be put.
  [[nodiscard]] Candidate& slot_of(std::uint64_t key) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = (key << first_bits_) >> shift_;; i = (i + 1) & mask) {
      if (slots_[i].rank == Candidate::kNone || slots_[i].key == key) return slots_[i];
    }
  }

  void grow() {
    std::vector<Candidate> old;
    old.swap(slots_);
    resize(2 * old.size());
    for (const Candidate& candidate : old) {
      if (candidate.rank != Candidate::kNone) slot_of(candidate.key) = candidate;
    }
  }

  /// Of equally near points, so that the result does not depend on their order.
  [[nodiscard]] bool comes_before(const Candidate& a, const Candidate& b) const {
    const auto rank = [](const Eigen::Vector3f& p) { return std::make_tuple(p.x(), p.y(), p.z()); };
    return rank(points_[a.index()]) < rank(points_[b.index()]);
  }

  const std::vector<Eigen::Vector3f>& points_;
  int first_bits_;
  int shift_ = 0;
  std::size_t size_ = 0;
  std::vector<Candidate> slots_;
};

// Of so many points, at a first guess, one is the best of a voxel.
constexpr std::size_t kCrowd = 4;

}  // namespace

std::vector<std::uint32_t> downsample_indices(const std::vector<Eigen::Vector3f>& points,
                                              double voxel, const Workers& workers) {
  std::vector<Candidate> candidates(points.size());
  const double inverse_voxel = 1.0 / voxel;
  workers.for_chunks(points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      candidates[i] =
          make_candidate(points[i], static_cast<std::uint32_t>(i), voxel, inverse_voxel);
    }
  });
  // The voxels are dealt into parts by their keys' first bits, as many as there are threads: the
  // parts one after the other are in the order of the keys, however many there are.
  const std::size_t parts = std::bit_ceil(static_cast<std::size_t>(workers.threads()));
  const int first_bits = std::countr_zero(parts);
  std::vector<std::vector<std::uint32_t>> kept(parts);
  workers.for_each(parts, [&](std::size_t part) {
    BestOfPart best(points, first_bits, 2 * points.size() / (kCrowd * parts));
    for (const Candidate& candidate : candidates) {
      if ((std::rotl(candidate.key, first_bits) & (parts - 1)) == part) best.offer(candidate);
    }
    best.append_to(kept[part]);
  });
  std::vector<std::uint32_t> indices;
  for (const auto& part : kept) indices.insert(indices.end(), part.begin(), part.end());
  return indices;
}

std::vector<Eigen::Vector3f> downsample(const std::vector<Eigen::Vector3f>& points, double voxel,
                                        const Workers& workers) {
  std::vector<Eigen::Vector3f> thinned;
  for (const std::uint32_t i : downsample_indices(points, voxel, workers)) {
    thinned.push_back(points[i]);
  }
  return thinned;
}

}  // namespace surefoot
