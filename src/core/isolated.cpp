// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/isolated.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "geometry/float_sums.hpp"

namespace surefoot {

namespace {

// A cell of directions is 100 sr over the number of points: some thirty of those of a LiDAR that
// sees a quarter of the sphere, and two rings of a VLP-16.
constexpr double kSolidAngle = 100.0;  // [sr] of all cells
constexpr double kCoarsest = 0.3;      // [rad] a cell's edge
constexpr float kNearest = 1e-6F;      // [m] so that the sensor itself has a direction, too

constexpr int kTableBits = 18;
constexpr std::uint32_t kTableMask = (1U << kTableBits) - 1;

/// Tells the cell of a point: a table's slot, whose neighbours are the cells before and behind. Two
/// far cells may share one, and a stray is then kept.
class Cells {
 public:
  explicit Cells(std::size_t points) {
    const double edge = std::min(kCoarsest, std::sqrt(kSolidAngle / static_cast<double>(points)));
    per_unit_ = static_cast<float>(1.0 / edge);
    // Half as long as wide: a cell, and those before and behind. A float's bits count the octaves
    // of its value, here of the squared range.
    per_octave_ = static_cast<float>(std::numbers::ln2 / edge / (1U << 23));
  }

  [[nodiscard]] std::uint32_t slot(const Eigen::Vector3f& point) const {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(squared_norm(point));
    const auto range = static_cast<std::uint32_t>(static_cast<float>(bits) * per_octave_);
    return ((direction(point) * 0x9E3779B1U) >> (32 - kTableBits)) + range;
  }

 private:
  /// On the faces of a cube about the sensor.
  [[nodiscard]] std::uint32_t direction(const Eigen::Vector3f& point) const {
    const Eigen::Vector3f size = point.cwiseAbs();
    const int axis = size.z() > std::max(size.x(), size.y()) ? 2 : size.y() > size.x() ? 1 : 0;
    const float scale = per_unit_ / std::max(size[axis], kNearest);
    const auto steps = [&](float along) {
      return static_cast<std::uint32_t>(along * scale + per_unit_);
    };
    const auto face = static_cast<std::uint32_t>(2 * axis + (point[axis] < 0.0F ? 1 : 0));
    return (face << 10 | steps(point[(axis + 1) % 3])) << 10 | steps(point[(axis + 2) % 3]);
  }

  float per_unit_;
  float per_octave_;
};

}  // namespace

std::vector<std::uint32_t> points_with_company(const std::vector<Eigen::Vector3f>& points,
                                               const Workers& workers) {
  const Cells cells(points.size());
  std::vector<std::uint32_t> slots(points.size());
  workers.for_chunks(points.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) slots[i] = cells.slot(points[i]);
  });
  std::vector<std::uint8_t> counts(kTableMask + 1, 0);  // no more than two need be told apart
  for (const std::uint32_t slot : slots) {
    std::uint8_t& count = counts[slot & kTableMask];
    count = static_cast<std::uint8_t>(std::min(count + 1, 2));
  }
  std::vector<std::uint32_t> kept;
  kept.reserve(points.size());
  for (std::uint32_t i = 0; i < slots.size(); ++i) {
    const auto count = [&](std::uint32_t slot) { return counts[slot & kTableMask]; };
    if (count(slots[i] - 1) + count(slots[i]) + count(slots[i] + 1) > 1) kept.push_back(i);
  }
  if (2 * kept.size() >= points.size()) return kept;
  kept.clear();
  for (std::uint32_t i = 0; i < slots.size(); ++i) kept.push_back(i);
  return kept;
}

}  // namespace surefoot
