// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/map_thinning.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace surefoot::report {

namespace {

constexpr double kMostCubes = (1 << 21) - 2;  // an axis, so that three indices fit 63 bits

struct Bounds {
  Eigen::Vector3f low = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
  Eigen::Vector3f high = Eigen::Vector3f::Constant(std::numeric_limits<float>::lowest());
};

/// A set of cube numbers by open addressing: sized once, for as many as there can be.
class CubeSet {
 public:
  explicit CubeSet(std::size_t most)
      : slots_(std::bit_ceil(2 * most + 2), kFree), mask_(slots_.size() - 1) {}

  void clear() { std::fill(slots_.begin(), slots_.end(), kFree); }
  /// False if it was there.
  bool insert(std::uint64_t cube) {
    std::size_t at = cube * 0x9E3779B97F4A7C15ULL >> 20 & mask_;
    for (; slots_[at] != kFree; at = (at + 1) & mask_) {
      if (slots_[at] == cube) return false;
    }
    slots_[at] = cube;
    return true;
  }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  std::vector<std::uint64_t> slots_;
  std::size_t mask_;
};

/// What thinning by one size of cubes gave.
struct Trial {
  std::vector<std::uint32_t> kept;  // complete only if `share` is 1
  double share = 1.0;               // of the points, after which the budget was exceeded

  [[nodiscard]] bool fits() const { return share == 1.0; }
  /// How many would have been kept of all points.
  [[nodiscard]] double estimate() const { return static_cast<double>(kept.size()) / share; }
};

Trial try_cubes(std::span<const Eigen::Vector3f> points, const Bounds& bounds, double cube,
                std::size_t budget, CubeSet& taken) {
  taken.clear();
  Trial trial;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    std::uint64_t number = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double offset = double{points[i][axis]} - double{bounds.low[axis]};
      const double index = std::min(std::floor(offset / cube), kMostCubes);
      number = number << 21 | static_cast<std::uint64_t>(index);
    }
    if (!taken.insert(number)) continue;
    trial.kept.push_back(static_cast<std::uint32_t>(i));
    if (trial.kept.size() > budget) {
      trial.share = static_cast<double>(i + 1) / (1.0 + static_cast<double>(points.size()));
      break;
    }
  }
  return trial;
}

/// Searches the side of the cubes between one that is too small and one that fits. Cubes that hold
/// a surface are as many as its area has squares: the side goes with the root of the number.
ThinnedCloud search_cubes(std::span<const Eigen::Vector3f> points, const Bounds& bounds,
                          std::size_t budget) {
  constexpr int kTrials = 8;
  constexpr double kFull = 0.88, kAim = 0.95;  // shares of the budget
  const double extent = (bounds.high.cast<double>() - bounds.low.cast<double>()).maxCoeff();
  double cube = extent > 0.0 ? 1e-3 * extent : 1.0;
  double too_small = 0.0, fits = std::numeric_limits<double>::infinity();
  CubeSet taken(budget + 1);
  ThinnedCloud best;
  for (int i = 0; i < kTrials || best.kept.empty(); ++i) {
    Trial trial = try_cubes(points, bounds, cube, budget, taken);
    const double wanted = kAim * static_cast<double>(budget);
    double next = cube * std::sqrt(trial.estimate() / wanted);
    if (trial.fits()) {
      fits = cube;
      best = {std::move(trial.kept), cube};
      if (static_cast<double>(best.kept.size()) >= kFull * static_cast<double>(budget)) break;
    } else {
      too_small = cube;
      next = std::max(next, 1.1 * cube);
    }
    cube = next > too_small && next < fits ? next : std::sqrt(too_small * fits);
  }
  return best;
}

}  // namespace

ThinnedCloud thin_cloud(std::span<const Eigen::Vector3f> points, std::size_t budget) {
  if (budget == 0 || points.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument("a map of " + std::to_string(points.size()) +
                                " points cannot be thinned to " + std::to_string(budget));
  }
  ThinnedCloud all;
  Bounds bounds;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i].allFinite()) continue;
    all.kept.push_back(static_cast<std::uint32_t>(i));
    bounds.low = bounds.low.cwiseMin(points[i]);
    bounds.high = bounds.high.cwiseMax(points[i]);
  }
  return all.kept.size() <= budget ? all : search_cubes(points, bounds, budget);
}

}  // namespace surefoot::report
