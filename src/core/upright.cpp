// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/upright.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include "core/downsample.hpp"
#include "geometry/float_sums.hpp"
#include "geometry/so3.hpp"

namespace surefoot {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

constexpr double kCell = 0.2;    // [m] side of the cells that columns are made of
constexpr double kLayer = 0.1;   // [m] between two levels
constexpr double kReach = 20.0;  // [m]
constexpr int kColumns = 200;    // along each side of what is within reach
constexpr int kCells = 64;       // of a column, half of them below the sensor
constexpr int kLayers = 400;
constexpr int kStands = 5;  // filled cells of a column that stands upright: a metre
constexpr std::size_t kMinPoints = 50;

constexpr double kApart = 4.0;    // [deg] between the directions that are tried at first
constexpr double kFinest = 0.25;  // [deg] and at last
constexpr double kAtEdge = 3.0;   // [deg] a best one so near to the steepest goes on beyond it
// The best must be better than half of all others by so many times. In buildings, streets and woods
// it was mostly 20 to 100 times; where nothing stands or lies less, or the best was at the edge.
constexpr double kStandsOut = 10.0;
constexpr double kMinUpright = 0.02;  // share of the cells: of less, chance makes as much

int place_of(double coordinate, double side, int count) {
  return static_cast<int>(std::floor(coordinate / side)) + count / 2;
}

bool is_within(int place, int count) { return place >= 0 && place < count; }

/// How much of a cloud stands upright and lies level, for any direction that is taken for up.
class Uprightness {
 public:
  explicit Uprightness(const std::vector<Eigen::Vector3f>& cloud) {
    for (const Eigen::Vector3f& point : downsample(cloud, kCell)) {
      if (static_cast<double>(norm(point)) < kReach) points_.emplace_back(point.cast<double>());
    }
  }

  [[nodiscard]] bool is_told() const { return points_.size() >= kMinPoints; }

  /// The share of filled cells that are in upright columns, times the chance that two points are at
  /// the same level.
  double operator()(const Eigen::Vector3d& up) {
    const Eigen::Matrix3d R = rotation_between(up, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    layers_.fill(0);
    for (const Eigen::Vector3d& point : points_) fill(R * point);
    const double upright = upright_share();
    return upright < kMinUpright ? 0.0 : upright * level_share();
  }

 private:
  void fill(const Eigen::Vector3d& p) {
    const int layer = place_of(p.z(), kLayer, kLayers);
    if (is_within(layer, kLayers)) ++layers_[static_cast<std::size_t>(layer)];
    const int x = place_of(p.x(), kCell, kColumns), y = place_of(p.y(), kCell, kColumns);
    const int z = place_of(p.z(), kCell, kCells);
    if (!is_within(x, kColumns) || !is_within(y, kColumns) || !is_within(z, kCells)) return;
    const auto at = static_cast<std::size_t>(x) * kColumns + static_cast<std::size_t>(y);
    if (columns_[at] == 0) touched_.push_back(at);
    columns_[at] |= std::uint64_t{1} << z;
  }

  /// Empties the columns.
  double upright_share() {
    int filled = 0, upright = 0;
    for (const std::size_t at : touched_) {
      const int cells = std::popcount(columns_[at]);
      filled += cells;
      if (cells >= kStands) upright += cells;
      columns_[at] = 0;
    }
    touched_.clear();
    return static_cast<double>(upright) / std::max(filled, 1);
  }

  [[nodiscard]] double level_share() const {
    double pairs = 0.0;
    for (const int count : layers_) pairs += static_cast<double>(count) * count;
    const auto all = static_cast<double>(points_.size());
    return pairs / (all * all);
  }

  std::vector<Eigen::Vector3d> points_;
  std::vector<std::uint64_t> columns_ =
      std::vector<std::uint64_t>(std::size_t{kColumns} * kColumns);
  std::vector<std::size_t> touched_;  // columns that are not empty
  std::array<int, kLayers> layers_{};
};

/// All about as far from each other as kApart.
std::vector<Eigen::Vector3d> directions_within(double max_tilt_deg) {
  std::vector<Eigen::Vector3d> directions = {Eigen::Vector3d::UnitZ()};
  for (double tilt_deg = kApart; tilt_deg <= max_tilt_deg; tilt_deg += kApart) {
    const double tilt = tilt_deg * kDegree;
    const int count = static_cast<int>(std::lround(360.0 * std::sin(tilt) / kApart));
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / count;
      directions.emplace_back(std::sin(tilt) * std::cos(angle), std::sin(tilt) * std::sin(angle),
                              std::cos(tilt));
    }
  }
  return directions;
}

/// Uphill from a direction, by ever smaller steps.
Eigen::Vector3d refined(Eigen::Vector3d up, double best, Uprightness& uprightness) {
  for (double step = 0.5 * kApart * kDegree; step >= kFinest * kDegree;) {
    const Eigen::Vector3d a = up.unitOrthogonal(), b = up.cross(a);
    bool better = false;
    for (const Eigen::Vector3d& by : {a, b, Eigen::Vector3d(-a), Eigen::Vector3d(-b)}) {
      const Eigen::Vector3d next = (up + step * by).normalized();
      const double value = uprightness(next);
      if (value <= best) continue;
      best = value;
      up = next;
      better = true;
    }
    if (!better) step *= 0.5;
  }
  return up;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::optional<Eigen::Vector3d> find_up(const std::vector<Eigen::Vector3f>& points,
                                       double max_tilt_deg) {
  Uprightness uprightness(points);
  if (!uprightness.is_told()) return std::nullopt;
  const std::vector<Eigen::Vector3d> directions = directions_within(max_tilt_deg);
  std::vector<double> values;
  values.reserve(directions.size());
  for (const Eigen::Vector3d& direction : directions) values.push_back(uprightness(direction));
  const auto best = std::max_element(values.begin(), values.end());
  if (*best <= 0.0 || *best < kStandsOut * median_of(values)) return std::nullopt;
  const Eigen::Vector3d up =
      refined(directions[static_cast<std::size_t>(best - values.begin())], *best, uprightness);
  if (up.z() < std::cos((max_tilt_deg - kAtEdge) * kDegree)) return std::nullopt;
  return up;
}

}  // namespace surefoot
