// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/floam/floam_features.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace surefoot {

namespace {

// What the original hides in its code.
constexpr std::size_t kReach = 5;          // neighbours on each side
constexpr std::size_t kLeastPoints = 131;  // of a line that is used
constexpr std::size_t kSectors = 6;        // of a line
constexpr int kEdgesPerSector = 20;        // at most
constexpr double kEdgeCurvature = 0.1;     // [m^2] an edge has more
constexpr double kSameSurface = 0.05;      // [m^2] squared distance of neighbours on one surface

/// One laser's points in the order of the scan.
struct Line {
  std::vector<std::uint32_t> indices;  // into the scan
  std::vector<Eigen::Vector3f> points;
};

struct Curvature {
  double value;
  std::size_t at;  // in the line
};

std::vector<Line> split_lines(const PreparedScan& scan, const FloamParameters& config) {
  std::vector<Line> lines(static_cast<std::size_t>(config.scan_line));
  const bool by_ring = config.use_rings && !scan.rings.empty();
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Eigen::Vector3f& point = scan.points[i];
    const double distance = static_cast<double>(point.head<2>().norm());
    if (distance < config.min_dis || distance > config.max_dis) continue;
    const int line = by_ring ? scan.rings[i] : line_of(point, config.scan_line);
    if (line < 0 || line >= config.scan_line) continue;
    lines[static_cast<std::size_t>(line)].indices.push_back(static_cast<std::uint32_t>(i));
    lines[static_cast<std::size_t>(line)].points.push_back(point);
  }
  return lines;
}

/// Marks an edge's neighbours along the line, as far as they follow one another closely.
void mark_neighbours(const Line& line, std::size_t edge, std::vector<bool>& picked) {
  for (const int side : {1, -1}) {
    std::size_t last = edge;
    for (std::size_t k = 1; k <= kReach; ++k) {
      const std::size_t next = side > 0 ? last + 1 : last - 1;
      const double gap2 =
          static_cast<double>((line.points[next] - line.points[last]).squaredNorm());
      if (gap2 > kSameSurface) break;
      picked[next] = true;
      last = next;
    }
  }
}

/// One sector's features, from its points in the order of curvature.
void extract_from_sector(const Line& line, std::span<Curvature> sector, FloamFeatures& features) {
  std::sort(sector.begin(), sector.end(), [](const Curvature& a, const Curvature& b) {
    return a.value < b.value || (a.value == b.value && a.at < b.at);
  });
  std::vector<bool> picked(line.points.size(), false);
  int edges = 0;
  for (auto it = sector.rbegin(); it != sector.rend(); ++it) {
    if (picked[it->at]) continue;
    if (it->value <= kEdgeCurvature) break;
    picked[it->at] = true;
    if (++edges > kEdgesPerSector) break;  // the point after the last edge is nothing at all
    features.edges.push_back(line.indices[it->at]);
    mark_neighbours(line, it->at, picked);
  }
  for (const Curvature& point : sector) {
    if (!picked[point.at]) features.surfaces.push_back(line.indices[point.at]);
  }
}

void extract_from_line(const Line& line, bool whole_sectors, FloamFeatures& features) {
  std::vector<Curvature> curvatures;
  for (std::size_t i = kReach; i + kReach < line.points.size(); ++i) {
    curvatures.push_back({curvature(line.points, i), i});
  }
  const std::size_t length = curvatures.size() / kSectors;
  const std::size_t lost = whole_sectors ? 0 : 1;
  for (std::size_t sector = 0; sector < kSectors; ++sector) {
    const std::size_t begin = sector * length;
    const std::size_t end = sector + 1 == kSectors ? curvatures.size() : begin + length;
    extract_from_sector(line, std::span(curvatures).subspan(begin, end - begin - lost), features);
  }
}

}  // namespace

double curvature(const std::vector<Eigen::Vector3f>& line, std::size_t i) {
  Eigen::Vector3f sum = line[i - kReach];
  for (std::size_t k = i - kReach + 1; k < i; ++k) sum += line[k];
  sum -= 2.0F * static_cast<float>(kReach) * line[i];
  for (std::size_t k = i + 1; k <= i + kReach; ++k) sum += line[k];
  return sum.cast<double>().squaredNorm();
}

int line_of(const Eigen::Vector3f& point, int scan_line) {
  const double distance = static_cast<double>(point.head<2>().norm());
  const double angle =
      std::atan2(static_cast<double>(point.z()), distance) * 180.0 / std::numbers::pi;
  switch (scan_line) {
    case 16:  // VLP-16: -15 to 15 degrees, 2 apart
      return static_cast<int>((angle + 15.0) / 2.0 + 0.5);
    case 32:  // HDL-32: -30.67 to 10.67 degrees, 4/3 apart
      return static_cast<int>((angle + 92.0 / 3.0) * 3.0 / 4.0);
    default:  // HDL-64: two blocks, counted from above
      if (angle > 2.0 || angle < -24.33) return -1;
      return angle >= -8.83 ? static_cast<int>((2.0 - angle) * 3.0 + 0.5)
                            : 32 + static_cast<int>((-8.83 - angle) * 2.0 + 0.5);
  }
}

FloamFeatures extract_features(const PreparedScan& scan, const FloamParameters& config) {
  FloamFeatures features;
  for (const Line& line : split_lines(scan, config)) {
    if (line.points.size() < kLeastPoints) continue;
    extract_from_line(line, config.whole_sectors, features);
  }
  return features;
}

}  // namespace surefoot
