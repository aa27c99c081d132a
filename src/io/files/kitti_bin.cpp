// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/kitti_bin.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "io/recording.hpp"

namespace surefoot::io {

namespace {

constexpr std::array<const char*, 5> kNames = {"x", "y", "z", "intensity", "ring"};
constexpr std::size_t kKitti = 4, kNuScenes = 5;  // float32 a point

PointTable table_of(std::span<const std::byte> file, std::size_t width) {
  PointTable table;
  table.format = width == kKitti ? "KITTI .bin" : "nuScenes .bin";
  table.size = file.size() / (width * sizeof(float));
  const bool swapped = std::endian::native != std::endian::little;
  for (std::size_t i = 0; i < width; ++i) {
    table.columns.push_back({kNames[i], ScalarType::f32, file.data() + i * sizeof(float),
                             width * sizeof(float), swapped});
  }
  return table;
}

/// How many points' last value is no number of a laser, and how many of an intensity.
struct Oddities {
  std::size_t no_ring = 0;
  std::size_t below_zero = 0;
};

Oddities oddities_of(const PointTable& table) {
  constexpr double kMostRings = 255.0;
  Oddities odd;
  for_each_value(table.columns.back(), table.size, [&](std::size_t, auto value) {
    const auto number = static_cast<double>(value);
    if (!(number >= 0.0 && number <= kMostRings && number == std::floor(number))) ++odd.no_ring;
    if (number < 0.0) ++odd.below_zero;
  });
  return odd;
}

/// Whether every point has a laser's number after its intensity. Points of four values, read as of
/// five, have coordinates there.
bool has_rings(std::span<const std::byte> file) {
  if (file.empty() || file.size() % (kNuScenes * sizeof(float)) != 0) return false;
  return oddities_of(table_of(file, kNuScenes)).no_ring == 0;
}

/// Whether most points, read as KITTI's, have a y and an intensity that are next to nothing and not
/// zero: NCLT's, whose integers have the laser's number in these places' highest bits.
bool are_integers(const PointTable& table) {
  constexpr double kNextToNothing = 1e-12;
  std::vector<int> tiny(table.size, 0);
  for (const std::size_t column : {std::size_t{1}, table.columns.size() - 1}) {
    for_each_value(table.columns[column], table.size, [&](std::size_t k, auto value) {
      const double size = std::abs(static_cast<double>(value));
      if (size > 0.0 && size < kNextToNothing) ++tiny[k];
    });
  }
  return 2 * static_cast<std::size_t>(std::count(tiny.begin(), tiny.end(), 2)) > table.size;
}

}  // namespace

PointTable parse_kitti_bin(std::span<const std::byte> file) {
  if (has_rings(file)) return table_of(file, kNuScenes);
  if (are_integers(table_of(file, kKitti))) {
    throw ReadError(
        ".bin: neither KITTI's nor nuScenes' float32 values (NCLT's uint16?); convert it to PCD");
  }
  constexpr const char* kExpected =
      "; expected float32 x y z intensity a point (KITTI) or x y z intensity ring (nuScenes)";
  if (file.size() % (kKitti * sizeof(float)) != 0) {
    throw ReadError("KITTI .bin: " + std::to_string(file.size()) + " bytes, no multiple of 16" +
                    kExpected);
  }
  PointTable table = table_of(file, kKitti);
  // Of points of another number of values some fourth ones are coordinates, which have signs.
  const std::size_t below_zero = oddities_of(table).below_zero;
  if (50 * below_zero > table.size) {
    throw ReadError("KITTI .bin: every fourth value would be an intensity, and " +
                    std::to_string(below_zero) + " of " + std::to_string(table.size) +
                    " are below zero" + kExpected);
  }
  return table;
}

void correct_kitti_hdl64(std::vector<Eigen::Vector3f>& points) {
  constexpr double kAngle = 0.205 * std::numbers::pi / 180.0;
  const double cosine = std::cos(kAngle);
  const double sine = std::sin(kAngle);
  for (Eigen::Vector3f& point : points) {
    const double horizontal = std::hypot(point.x(), point.y());
    if (!(horizontal > 0.0)) {
      continue;
    }
    const double height = point.z();
    const double scale = (horizontal * cosine - height * sine) / horizontal;
    point.x() = static_cast<float>(point.x() * scale);
    point.y() = static_cast<float>(point.y() * scale);
    point.z() = static_cast<float>(horizontal * sine + height * cosine);
  }
}

}  // namespace surefoot::io
