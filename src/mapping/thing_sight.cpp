// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/thing_sight.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "core/voxel_key.hpp"
#include "mapping/bit_stream.hpp"

namespace surefoot::mapping {

namespace {

// Cubes are half as high as wide: beams lie farthest apart in height, and what passes over a
// railing is to say nothing of it.
constexpr float kPerMetre = 1.0F / 0.3F, kPerMetreUp = 1.0F / 0.15F;
constexpr float kStep = 0.27F;                    // [m] along a beam
constexpr float kNear = 0.3F, kFar = 70.0F;       // [m] of beams
constexpr float kBeforeEnd = 0.6F;                // [m] the end of a beam is not empty
constexpr float kLowest = 0.0F, kHighest = 2.8F;  // [m] over the ground: where things move
// [ns] A moment: who walks is in a cube for one or two.
constexpr std::int64_t kMoment = 500'000'000;
constexpr std::int64_t kMostMoments = 15;
// [sr] Of a cube a metre away, as a share of what a spinning LiDAR looks at.
constexpr float kCube = 0.3F * 0.15F / 3.3F;

constexpr int kBits = 2;                                // of a cube's index within its block
constexpr int kAcross = 9, kHalf = 1 << (kAcross - 1);  // bits of a cube's number along an axis

/// In cubes along each axis.
Eigen::Vector3f in_cubes(const Eigen::Vector3f& place) {
  return place.cwiseProduct(Eigen::Vector3f(kPerMetre, kPerMetre, kPerMetreUp));
}

/// Floor, as voxel_index has it, in single precision.
VoxelIndex cube_of(const Eigen::Vector3f& scaled) {
  VoxelIndex cube = scaled.cast<int>();
  for (int i = 0; i < 3; ++i) cube[i] -= static_cast<float>(cube[i]) > scaled[i] ? 1 : 0;
  return cube;
}

VoxelIndex block_of(const VoxelIndex& cube) {
  return {cube.x() >> kBits, cube.y() >> kBits, cube.z() >> kBits};
}

std::size_t within_block(const VoxelIndex& cube) {
  constexpr int kMask = (1 << kBits) - 1;
  return static_cast<std::size_t>((cube.x() & kMask) << 2 * kBits | (cube.y() & kMask) << kBits |
                                  (cube.z() & kMask));
}

VoxelIndex cube_in(const VoxelIndex& block, std::size_t within) {
  const auto i = static_cast<int>(within);
  constexpr int kMask = (1 << kBits) - 1;
  return block * (1 << kBits) + VoxelIndex(i >> 2 * kBits, i >> kBits & kMask, i & kMask);
}

std::uint64_t bit_of(const VoxelIndex& cube) { return std::uint64_t{1} << within_block(cube); }

/// Something for each block of cubes that was ever asked for.
template <typename Block>
class Blocks {
 public:
  Block& of(const VoxelIndex& cube) {
    const VoxelIndex block = block_of(cube);
    if (block == last_block_) return blocks_[last_].second;  // a beam's next cube mostly lies there
    const auto next = static_cast<std::uint32_t>(blocks_.size());
    const auto [index, fresh] = table_.find_or_insert(voxel_key(block), next);
    if (fresh) blocks_.emplace_back(block, Block{});
    last_block_ = block;
    last_ = index;
    return blocks_[index].second;
  }
  void clear() {
    table_.clear();
    blocks_.clear();
    last_block_ = kNoBlock;
  }
  [[nodiscard]] const std::vector<std::pair<VoxelIndex, Block>>& all() const { return blocks_; }

 private:
  inline static const VoxelIndex kNoBlock = VoxelIndex::Constant(std::numeric_limits<int>::max());

  VoxelTable table_;
  std::vector<std::pair<VoxelIndex, Block>> blocks_;
  VoxelIndex last_block_ = kNoBlock;
  std::uint32_t last_ = 0;
};

/// Of one moment, a bit a cube.
struct MomentBlock {
  std::uint64_t through = 0, hit = 0;
  std::uint64_t stands = 0, near = 0;  // something does in the cube; in it or beside it
};
/// Of all moments.
struct CountBlock {
  std::array<std::uint8_t, 64> through{}, hit{};
};

/// [m] From where on one of a look's beams is followed: nearer those of others go through the same
/// cubes. Every third is as dense as all of them, so much farther away; threes divide no number of
/// rings.
float begin_of(std::size_t beam, std::size_t beams) {
  const float once = std::sqrt(kCube * static_cast<float>(beams));  // [m] each cube is met once
  if (beam % 9 == 0) return kNear;
  return std::max(kNear, once / (beam % 3 == 0 ? 3.0F : std::sqrt(3.0F)));
}

/// The cubes that a beam went through from so far on [m], at the heights where things move.
void follow(const Eigen::Vector3f& eye, const Eigen::Vector3f& point, float begin,
            const PieceGround& ground, Blocks<MomentBlock>& moment) {
  const Eigen::Vector3f beam = point - eye;
  const float length = std::max(beam.norm(), 1e-3F);
  const float from = ground.height(eye);
  const float rise = (ground.height(point) - from) / length;
  float end = std::min(length - kBeforeEnd, kFar);
  if (std::abs(rise) > 1e-6F) {
    const float low = (kLowest - from) / rise, high = (kHighest - from) / rise;
    begin = std::max(begin, std::min(low, high));
    end = std::min(end, std::max(low, high));
  }
  const Eigen::Vector3f first = in_cubes(eye), along = in_cubes(beam / length);
  VoxelIndex last = VoxelIndex::Constant(std::numeric_limits<int>::max());
  for (float way = begin; way < end; way += kStep) {
    const VoxelIndex cube = cube_of(first + way * along);
    if (cube == last) continue;
    moment.of(cube).through |= bit_of(cube);
    last = cube;
  }
}

void mark_hit(const Eigen::Vector3f& point, const PieceGround& ground,
              Blocks<MomentBlock>& moment) {
  const float height = ground.height(point);
  if (height < kLowest || height > kHighest) return;
  const VoxelIndex cube = cube_of(in_cubes(point));
  MomentBlock& own = moment.of(cube);
  own.hit |= bit_of(cube);
  if ((own.stands & bit_of(cube)) != 0 || !ground.stands(point)) return;
  own.stands |= bit_of(cube);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      for (int z = -2; z <= 2; ++z) {
        const VoxelIndex about = cube + VoxelIndex(x, y, z);
        moment.of(about).near |= bit_of(about);
      }
    }
  }
}

void count(const Blocks<MomentBlock>& moment, Blocks<CountBlock>& counts) {
  for (const auto& [where, of_moment] : moment.all()) {
    const std::uint64_t through = of_moment.through & ~of_moment.near;
    if ((through | of_moment.hit) == 0) continue;
    CountBlock& block = counts.of(where * (1 << kBits));
    for (std::uint64_t left = through | of_moment.hit; left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const bool hit = (of_moment.hit >> i & 1) != 0;
      ++(hit ? block.hit : block.through)[i];
    }
  }
}

struct CountedCube {
  std::uint32_t number;  // row by row, upwards first
  std::uint8_t through, hit;
};

std::vector<CountedCube> sorted(const Blocks<CountBlock>& counts) {
  std::vector<CountedCube> result;
  for (const auto& [where, block] : counts.all()) {
    for (std::size_t i = 0; i < block.through.size(); ++i) {
      if (block.through[i] == 0 && block.hit[i] == 0) continue;
      const VoxelIndex at = cube_in(where, i) + VoxelIndex::Constant(kHalf);
      if (at.minCoeff() < 0 || at.maxCoeff() >= 2 * kHalf) continue;
      const auto number =
          static_cast<std::uint32_t>(at.x() << 2 * kAcross | at.y() << kAcross | at.z());
      result.push_back({number, block.through[i], block.hit[i]});
    }
  }
  std::sort(result.begin(), result.end(),
            [](const CountedCube& a, const CountedCube& b) { return a.number < b.number; });
  return result;
}

}  // namespace

std::string seen_in(const std::vector<KeptScan>& looks, const PieceGround& ground) {
  Blocks<CountBlock> counts;
  Blocks<MomentBlock> moment;
  const std::int64_t span = looks.empty() ? 0 : looks.back().stamp_ns - looks.front().stamp_ns;
  const std::int64_t length = std::max(kMoment, span / kMostMoments + 1);
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const KeptScan& look = looks[i];
    for (std::size_t at = 0; at < look.points.size(); ++at) {
      const Eigen::Vector3f& point = look.points[at];
      follow(look.eye, point, begin_of(at, look.points.size()), ground, moment);
      if ((point - look.eye).squaredNorm() < kFar * kFar) mark_hit(point, ground, moment);
    }
    const auto moment_of = [&](const KeptScan& of) {
      return (of.stamp_ns - looks.front().stamp_ns) / length;
    };
    if (i + 1 < looks.size() && moment_of(looks[i + 1]) == moment_of(look)) continue;
    count(moment, counts);
    moment.clear();
  }
  const std::vector<CountedCube> cubes = sorted(counts);
  BitWriter out;
  out.put(static_cast<std::uint32_t>(cubes.size()), 32);
  std::uint32_t next = 0;
  for (const CountedCube& cube : cubes) {
    out.put_gamma(cube.number - next);
    out.put_gamma(cube.through);
    out.put_gamma(cube.hit);
    next = cube.number + 1;
  }
  return out.take();
}

ThingSight::ThingSight(std::string_view bytes) {
  BitReader in(bytes);
  const std::uint32_t cubes = in.get(32);
  std::uint32_t number = 0;
  for (std::uint32_t i = 0; i < cubes; ++i, ++number) {
    number += in.get_gamma();
    const std::uint32_t through = in.get_gamma(), hit = in.get_gamma();
    if (number >= 1U << 3 * kAcross || through > kMostMoments || hit > kMostMoments) {
      throw std::invalid_argument("no cube that was seen");
    }
    constexpr std::uint32_t kMask = (1U << kAcross) - 1U;
    const VoxelIndex cube =
        VoxelIndex(static_cast<int>(number >> 2 * kAcross),
                   static_cast<int>(number >> kAcross & kMask), static_cast<int>(number & kMask)) -
        VoxelIndex::Constant(kHalf);
    const auto [index, fresh] = table_.find_or_insert(voxel_key(block_of(cube)),
                                                      static_cast<std::uint32_t>(blocks_.size()));
    if (fresh) blocks_.push_back({});
    blocks_[index][within_block(cube)] = static_cast<std::uint8_t>(through << 4 | hit);
  }
  blocks_.shrink_to_fit();
}

ThingSight::Moments ThingSight::at(const Eigen::Vector3d& place) const {
  const VoxelIndex cube = cube_of(in_cubes(place.cast<float>()));
  const std::uint32_t index = table_.find(voxel_key(block_of(cube)));
  if (index == VoxelTable::kNone) return {};
  const int both = blocks_[index][within_block(cube)];
  return {both >> 4, both & 15};
}

}  // namespace surefoot::mapping
