// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/traversability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace surefoot::mapping {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

struct Offset {
  int x = 0, y = 0;
};

std::vector<Offset> disc_of(double radius, double cell) {
  const int reach = static_cast<int>(std::floor(std::max(radius / cell, 1.0)));
  const double reach2 = std::max(radius * radius / (cell * cell), 2.0);  // the eight neighbours
  std::vector<Offset> disc;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      if (x * x + y * y <= reach2) disc.push_back({x, y});
    }
  }
  return disc;
}

class Heights {
 public:
  explicit Heights(const ElevationGrid& grid) : grid_(grid) {}
  [[nodiscard]] float at(int x, int y) const {
    if (x < 0 || y < 0 || x >= grid_.width || y >= grid_.height) return kNone;
    return grid_.heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.width) +
                         static_cast<std::size_t>(x)];
  }

 private:
  const ElevationGrid& grid_;
};

/// From the cell before this one to the one behind it along an axis, less what the ground rises
/// beside them anyway: a ramp is no step, where it begins and ends included. A kerb stands between
/// two cells or within one; two cells apart it has its whole height either way.
double step_across(const Heights& heights, int x, int y, int dx, int dy) {
  const float before = heights.at(x - dx, y - dy), behind = heights.at(x + dx, y + dy);
  if (std::isnan(before) || std::isnan(behind)) return 0.0;
  const double rise = behind - before;
  const double way = rise < 0.0 ? -1.0 : 1.0;
  const double far_before = way * (before - heights.at(x - 2 * dx, y - 2 * dy));
  const double far_behind = way * (heights.at(x + 2 * dx, y + 2 * dy) - behind);
  double beside = 0.0;
  if (far_before > beside) beside = far_before;  // not if NaN
  if (far_behind > beside) beside = far_behind;
  return std::max(way * rise - 2.0 * beside, 0.0);
}

struct Plane {
  double slope = 0.0;      // [rad]
  double roughness = 0.0;  // [m]
  bool known = false;
};

Plane plane_through(const Heights& heights, const std::vector<Offset>& disc, int x, int y,
                    double cell) {
  double n = 0.0, mx = 0.0, my = 0.0, mz = 0.0;
  for (const Offset& offset : disc) {
    const double z = heights.at(x + offset.x, y + offset.y);
    if (std::isnan(z)) continue;
    n += 1.0;
    mx += offset.x;
    my += offset.y;
    mz += z;
  }
  Plane plane;
  if (n < 3.0 || 2.0 * n < static_cast<double>(disc.size())) return plane;
  mx /= n, my /= n, mz /= n;
  double xx = 0.0, xy = 0.0, yy = 0.0, xz = 0.0, yz = 0.0, zz = 0.0;
  for (const Offset& offset : disc) {
    const double z = heights.at(x + offset.x, y + offset.y) - mz;
    if (std::isnan(z)) continue;
    const double u = offset.x - mx, v = offset.y - my;
    xx += u * u, xy += u * v, yy += v * v;
    xz += u * z, yz += v * z, zz += z * z;
  }
  const double determinant = xx * yy - xy * xy;
  if (determinant < 1e-6 * xx * yy || !(determinant > 0.0)) return plane;  // cells in one line
  const double a = (yy * xz - xy * yz) / determinant, b = (xx * yz - xy * xz) / determinant;
  plane.slope = std::atan(std::hypot(a, b) / cell);
  plane.roughness = std::sqrt(std::max(zz - a * xz - b * yz, 0.0) / n);
  plane.known = true;
  return plane;
}

}  // namespace

Traversability draw_traversability(const ElevationGrid& grid, const LeggedRobot& robot) {
  const Heights heights(grid);
  const std::vector<Offset> disc = disc_of(robot.radius, grid.cell);
  std::vector<float> steps(grid.heights.size(), 0.0F);
  for (int y = 0, k = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x, ++k) {
      steps[static_cast<std::size_t>(k)] = static_cast<float>(
          std::max(step_across(heights, x, y, 1, 0), step_across(heights, x, y, 0, 1)));
    }
  }
  Traversability result;
  result.slope.assign(grid.heights.size(), kNone);
  result.step = result.roughness = result.score = result.slope;
  const double most_slope = robot.most_slope_deg * std::numbers::pi / 180.0;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const Plane plane = plane_through(heights, disc, x, y, grid.cell);
      if (!plane.known) continue;
      float step = 0.0F;
      for (const Offset& offset : disc) {
        const int at_x = x + offset.x, at_y = y + offset.y;
        if (std::isnan(heights.at(at_x, at_y))) continue;
        step = std::max(
            step, steps[static_cast<std::size_t>(at_y) * static_cast<std::size_t>(grid.width) +
                        static_cast<std::size_t>(at_x)]);
      }
      const auto k = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                     static_cast<std::size_t>(x);
      const double worst = std::max({plane.slope / most_slope, step / robot.most_step,
                                     plane.roughness / robot.most_roughness});
      result.slope[k] = static_cast<float>(plane.slope);
      result.step[k] = step;
      result.roughness[k] = static_cast<float>(plane.roughness);
      result.score[k] = static_cast<float>(std::max(1.0 - worst, 0.0));
    }
  }
  return result;
}

}  // namespace surefoot::mapping
