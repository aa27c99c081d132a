// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/grid_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "mapping/submap.hpp"

namespace surefoot::mapping {

namespace {

constexpr double kMostCells = 4e8;

/// The cells that hold all points and the LiDAR's places, within `range` of these.
struct Frame {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  int width = 0, height = 0;
};

Frame frame_of(const std::vector<Piece>& pieces, double cell, double range) {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  const auto range2 = static_cast<float>(range * range);
  for (const Piece& piece : pieces) {
    const auto seen = cloud_of(piece);
    for (std::size_t i = 0; i < seen->points.size(); ++i) {
      if ((seen->points[i] - seen->eyes[seen->seen_from[i]]).squaredNorm() > range2) continue;
      const Eigen::Vector3d at = piece.T_world_piece * seen->points[i].cast<double>();
      low = low.cwiseMin(at.head<2>());
      high = high.cwiseMax(at.head<2>());
    }
  }
  Frame frame;
  if (!(low.array() <= high.array()).all()) {
    throw std::invalid_argument("a map without points, for a grid");
  }
  const Eigen::Vector2d cells = ((high - low) / cell).array() + 3.0;
  if (!(cells.x() * cells.y() < kMostCells)) {
    throw std::invalid_argument(
        "a grid with cells of " + std::to_string(cell) +
        " m would have more than 400 million of them: expected larger cells");
  }
  frame.low = (low.array() / cell).floor() * cell - cell;
  frame.width = static_cast<int>(cells.x());
  frame.height = static_cast<int>(cells.y());
  return frame;
}

/// Counts of what beams say about each cell.
class Evidence {
 public:
  Evidence(const Frame& frame, double cell)
      : frame_(frame),
        cell_(cell),
        hits_(static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height), 0),
        passes_(hits_.size(), 0) {}

  void hit(const Eigen::Vector2d& at) { count(at, hits_); }
  /// A beam at a robot's height, up to where it ends.
  void pass(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const Eigen::Vector2d way = to - from;
    const double length = way.norm();
    for (double along = 0.0; along < length; along += 0.9 * cell_) {
      count(from + along / length * way, passes_);
    }
  }
  [[nodiscard]] std::vector<std::uint8_t> decide() const {
    std::vector<std::uint8_t> cells(hits_.size(), OccupancyGrid::kUnknown);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      // What was gone through far more often than it was hit has moved away.
      if (hits_[i] > 0 && 8 * hits_[i] >= passes_[i]) {
        cells[i] = OccupancyGrid::kOccupied;
      } else if (passes_[i] > 0) {
        cells[i] = OccupancyGrid::kFree;
      }
    }
    return cells;
  }

 private:
  void count(const Eigen::Vector2d& at, std::vector<std::uint16_t>& counts) const {
    const Eigen::Vector2d index = (at - frame_.low) / cell_;
    if (!(index.x() >= 0.0 && index.y() >= 0.0 && index.x() < frame_.width &&
          index.y() < frame_.height)) {
      return;
    }
    std::uint16_t& value =
        counts[static_cast<std::size_t>(index.y()) * static_cast<std::size_t>(frame_.width) +
               static_cast<std::size_t>(index.x())];
    if (value < std::numeric_limits<std::uint16_t>::max()) ++value;
  }

  Frame frame_;
  double cell_;
  std::vector<std::uint16_t> hits_, passes_;
};

/// Between which shares of its way a beam from one height to another is within a robot's: outside
/// of it, it says nothing about where that can go. None: the second is not greater.
std::pair<double, double> shares_within(double from, double to, double low, double high) {
  const double rise = to - from;
  if (rise == 0.0) return {0.0, from > low && from < high ? 1.0 : 0.0};
  const auto [first, second] = std::minmax({(low - from) / rise, (high - from) / rise});
  return {std::clamp(first, 0.0, 1.0), std::clamp(second, 0.0, 1.0)};
}

}  // namespace

OccupancyGrid draw_occupancy(const std::vector<Piece>& pieces, const GridOptions& options) {
  const Frame frame = frame_of(pieces, options.cell, options.range);
  OccupancyGrid grid;
  grid.cell = options.cell;
  grid.low = frame.low;
  grid.width = frame.width;
  grid.height = frame.height;
  Evidence evidence(frame, options.cell);
  const auto range2 = static_cast<float>(options.range * options.range);
  for (const Piece& piece : pieces) {
    const Submap seen = make_submap(piece);
    const double ground = seen.ground;
    for (std::size_t i = 0; i < seen.points.size(); ++i) {
      const Eigen::Vector3f beam = seen.points[i] - seen.eyes[i];
      if (beam.squaredNorm() > range2) continue;
      const double height = seen.points[i].z() - ground;
      const Eigen::Vector3d from = piece.T_world_piece * seen.eyes[i].cast<double>();
      const Eigen::Vector3d to = piece.T_world_piece * seen.points[i].cast<double>();
      const bool stands = height > options.low && height < options.high;
      if (stands) evidence.hit(to.head<2>());
      const auto [enters, leaves] =
          shares_within(seen.eyes[i].z() - ground, height, options.low, options.high);
      const Eigen::Vector2d way = to.head<2>() - from.head<2>();
      const double begin = enters * way.norm();
      const double end = std::max(leaves * way.norm() - 2.0 * options.cell, 0.0);
      if (way.norm() > 0.0 && end >= begin) {
        const Eigen::Vector2d ahead = way.normalized();
        evidence.pass(from.head<2>() + begin * ahead, from.head<2>() + end * ahead);
      }
    }
  }
  grid.cells = evidence.decide();
  return grid;
}

// As map_server reads a pixel, its cell is taken with (255 - pixel) / 255: free below
// `free_thresh`, occupied above the other. Unknown's 0.19608 must lie between.
constexpr int kFreePixel = 254, kOccupiedPixel = 0, kUnknownPixel = 205;
constexpr const char* kThresholds = "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

std::string format_pgm(const OccupancyGrid& grid) {
  std::string text =
      "P5\n" + std::to_string(grid.width) + " " + std::to_string(grid.height) + "\n255\n";
  for (int y = grid.height - 1; y >= 0; --y) {  // an image begins at the top
    for (int x = 0; x < grid.width; ++x) {
      const std::uint8_t cell = grid.at(x, y);
      text += static_cast<char>(cell == OccupancyGrid::kFree       ? kFreePixel
                                : cell == OccupancyGrid::kOccupied ? kOccupiedPixel
                                                                   : kUnknownPixel);
    }
  }
  return text;
}

// Digits of a corner: of one far from the origin, as in UTM, six leave nothing below a metre.
constexpr int kExact = 12;

std::string format_grid_yaml(const OccupancyGrid& grid, const std::string& image) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(kExact);
  out << "image: " << image << "\nresolution: " << grid.cell << "\norigin: [" << grid.low.x()
      << ", " << grid.low.y() << ", 0.0]\nnegate: 0\n"
      << kThresholds;
  return out.str();
}

ElevationGrid draw_elevation(const std::vector<Piece>& pieces, double cell) {
  constexpr double kRange = 12.0;
  constexpr double kAbove = 0.6;  // the ground rises less than this about a piece [m]
  const Frame frame = frame_of(pieces, cell, kRange);
  ElevationGrid grid;
  grid.cell = cell;
  grid.low = frame.low;
  grid.width = frame.width;
  grid.height = frame.height;
  const auto cells = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
  std::vector<float> counts(cells, 0.0F);
  std::vector<double> sums(cells, 0.0), squares(cells, 0.0);
  for (const Piece& piece : pieces) {
    const Submap seen = make_submap(piece);
    for (std::size_t i = 0; i < seen.points.size(); ++i) {
      const double range = (seen.points[i] - seen.eyes[i]).norm();
      if (range > kRange || seen.points[i].z() - seen.ground > kAbove) continue;
      const Eigen::Vector3d at = piece.T_world_piece * seen.points[i].cast<double>();
      const Eigen::Vector2d index = (at.head<2>() - frame.low) / cell;
      const auto k = static_cast<std::size_t>(index.y()) * static_cast<std::size_t>(frame.width) +
                     static_cast<std::size_t>(index.x());
      if (k >= cells) continue;
      counts[k] += 1.0F;
      sums[k] += at.z();
      squares[k] += at.z() * at.z();
    }
  }
  grid.heights.assign(cells, std::numeric_limits<float>::quiet_NaN());
  grid.variances = grid.heights;
  for (std::size_t k = 0; k < cells; ++k) {
    if (counts[k] == 0.0F) continue;
    const double mean = sums[k] / counts[k];
    grid.heights[k] = static_cast<float>(mean);
    grid.variances[k] = static_cast<float>(std::max(squares[k] / counts[k] - mean * mean, 0.0));
  }
  return grid;
}

std::string format_asc(const ElevationGrid& grid, const std::vector<float>& values) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(kExact);
  out << "ncols " << grid.width << "\nnrows " << grid.height << "\nxllcorner " << grid.low.x()
      << "\nyllcorner " << grid.low.y() << "\ncellsize " << grid.cell << "\nNODATA_value -9999\n";
  out.precision(std::numeric_limits<float>::digits10 + 1);
  for (int y = grid.height - 1; y >= 0; --y) {
    for (int x = 0; x < grid.width; ++x) {
      const float value =
          values[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.width) +
                 static_cast<std::size_t>(x)];
      out << (x > 0 ? " " : "") << (std::isfinite(value) ? value : -9999.0F);
    }
    out << '\n';
  }
  return out.str();
}

}  // namespace surefoot::mapping
