// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/point_raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/color_map.hpp"

namespace surefoot::report {

namespace {

constexpr int kOversampling = 2;     // samples a pixel and direction, against jagged edges
constexpr double kFillTarget = 2.5;  // splats over each sample where there are points
constexpr int kLargestSplat = 7;     // [samples]
constexpr float kEmpty = -std::numeric_limits<float>::infinity();

/// What is seen at each sample: the point nearest to the viewer.
struct DepthBuffer {
  int width, height;
  std::vector<float> depth;     // [m] towards the viewer, kEmpty where nothing is seen
  std::vector<float> height_z;  // [m] z of the point in the map frame
  DepthBuffer(int columns, int rows)
      : width(columns),
        height(rows),
        depth(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), kEmpty),
        height_z(depth.size(), 0.0F) {}
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }
};

struct Sample {
  int column, row;
  float depth, z;
};

/// Calls use(Sample) for every point that falls into the buffer.
template <typename Use>
void for_each_sample(std::span<const Eigen::Vector3f> points, const ParallelView& view, Use use) {
  for (const Eigen::Vector3f& point_f : points) {
    const Eigen::Vector3d point = point_f.cast<double>();
    if (!is_drawable(point)) continue;
    const Pixel pixel = kOversampling * view.project(point);
    if (!(pixel.x() >= 0.0 && pixel.x() < kOversampling * view.width && pixel.y() >= 0.0 &&
          pixel.y() < kOversampling * view.height)) {
      continue;
    }
    use(Sample{static_cast<int>(pixel.x()), static_cast<int>(pixel.y()),
               static_cast<float>(view.axes.row(2).dot(point)), static_cast<float>(point.z())});
  }
}

/// Side of the square that stands for a point, so that surfaces close where points are dense.
int splat_size(std::span<const Eigen::Vector3f> points, const ParallelView& view) {
  // Coverage is counted in cells of 8 x 8 samples: the area that has points at all.
  constexpr int kCell = 8;
  const int columns = kOversampling * view.width / kCell + 1;
  const int rows = kOversampling * view.height / kCell + 1;
  std::vector<std::uint8_t> occupied(static_cast<std::size_t>(columns) *
                                     static_cast<std::size_t>(rows));
  double seen = 0.0;
  for_each_sample(points, view, [&](const Sample& sample) {
    const std::ptrdiff_t cell =
        std::ptrdiff_t{sample.row / kCell} * columns + sample.column / kCell;
    occupied[static_cast<std::size_t>(cell)] = 1;
    seen += 1.0;
  });
  const auto cells = static_cast<double>(std::count(occupied.begin(), occupied.end(), 1));
  const double side = std::sqrt(kFillTarget * cells * kCell * kCell / std::max(seen, 1.0));
  return std::clamp(static_cast<int>(std::lround(side)), 2, kLargestSplat);
}

DepthBuffer splat(std::span<const Eigen::Vector3f> points, const ParallelView& view) {
  DepthBuffer buffer(kOversampling * view.width, kOversampling * view.height);
  const int size = splat_size(points, view);
  for_each_sample(points, view, [&](const Sample& sample) {
    const int first_row = std::max(sample.row - size / 2, 0);
    const int first_column = std::max(sample.column - size / 2, 0);
    const int last_row = std::min(sample.row - size / 2 + size, buffer.height);
    const int last_column = std::min(sample.column - size / 2 + size, buffer.width);
    for (int row = first_row; row < last_row; ++row) {
      for (int column = first_column; column < last_column; ++column) {
        const std::size_t at = buffer.index(column, row);
        if (sample.depth <= buffer.depth[at]) continue;
        buffer.depth[at] = sample.depth;
        buffer.height_z[at] = sample.z;
      }
    }
  });
  return buffer;
}

/// Brightness in (0, 1] of a sample: darker, the farther it lies behind its surroundings. Opposite
/// neighbours count as a pair, so that a plane is never darkened, however it is tilted.
double eye_dome_shade(const DepthBuffer& buffer, int column, int row, double metres_per_sample) {
  constexpr std::array<std::array<int, 2>, 4> kPairs = {{{3, 0}, {2, 2}, {0, 3}, {-2, 2}}};
  constexpr double kReach = 3.0;       // [samples] from the sample to its neighbours
  constexpr double kMostBehind = 3.0;  // a pair's share is limited, which keeps edges thin
  constexpr double kStrength = 0.13;
  const auto depth_at = [&](int c, int r) {
    const bool inside = c >= 0 && r >= 0 && c < buffer.width && r < buffer.height;
    return inside ? buffer.depth[buffer.index(c, r)] : kEmpty;
  };
  const double own = depth_at(column, row);
  double behind = 0.0;
  for (const auto& [right, down] : kPairs) {
    const float one = depth_at(column + right, row + down);
    const float other = depth_at(column - right, row - down);
    if (one == kEmpty || other == kEmpty) continue;
    const double step = 0.5 * (double{one} + double{other}) - own;
    behind += std::clamp(step / (kReach * metres_per_sample), 0.0, kMostBehind);
  }
  return std::exp(-kStrength * behind);
}

std::uint32_t premultiplied(const Eigen::Vector4d& sum_rgba, double samples) {
  const auto byte = [&](double value) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(value / samples, 0.0, 1.0) * 255.0));
  };
  return byte(sum_rgba[3]) << 24 | byte(sum_rgba[0]) << 16 | byte(sum_rgba[1]) << 8 |
         byte(sum_rgba[2]);
}

}  // namespace

Pixel ParallelView::project(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d seen = axes.topRows<2>() * point - center;
  return {0.5 * width + pixels_per_metre * seen.x(), 0.5 * height - pixels_per_metre * seen.y()};
}

ParallelView top_view(const PlotArea& area) {
  return {.center = {area.x.center(), area.y.center()},
          .pixels_per_metre = area.rect.width / area.x.width(),
          .width = static_cast<int>(area.rect.width),
          .height = static_cast<int>(area.rect.height)};
}

Raster draw_points(std::span<const Eigen::Vector3f> points, const ParallelView& view,
                   const Range& heights) {
  const DepthBuffer buffer = splat(points, view);
  const double metres_per_sample = 1.0 / (kOversampling * view.pixels_per_metre);
  Raster raster{view.width, view.height, {}};
  raster.argb.reserve(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      Eigen::Vector4d sum = Eigen::Vector4d::Zero();
      for (int i = 0; i < kOversampling * kOversampling; ++i) {
        const int column = kOversampling * x + i % kOversampling;
        const int row = kOversampling * y + i / kOversampling;
        const std::size_t at = buffer.index(column, row);
        if (buffer.depth[at] == kEmpty) continue;
        const Color color = viridis((double{buffer.height_z[at]} - heights.low) / heights.width());
        const double shade = eye_dome_shade(buffer, column, row, metres_per_sample);
        sum += Eigen::Vector4d(shade * color.red, shade * color.green, shade * color.blue, 1.0);
      }
      raster.argb.push_back(premultiplied(sum, kOversampling * kOversampling));
    }
  }
  return raster;
}

}  // namespace surefoot::report
