// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/outlook.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "surefoot/quantile.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::size_t kAzimuths = 180;  // of two degrees, as beams lie apart
constexpr std::size_t kElevations = 90;
constexpr double kPerRadian = 90.0 / std::numbers::pi;
constexpr double kRing = 0.8;           // [m] 64 of them reach farther than a piece
constexpr double kNearestTold = 2.0;    // [m]
constexpr double kFarthestTold = 48.0;  // [m] pieces reach little farther
constexpr double kOutermost = 0.01;     // share of beams: a few swing farther than the rest

}  // namespace

Outlook::Outlook(const Submap& submap, const Eigen::Vector3d& near)
    : eye_(near), rings_(kAzimuths * kElevations, 0) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<float> elevations;
  elevations.reserve(submap.points.size());
  for (std::size_t i = 0; i < submap.points.size(); ++i) {
    const Eigen::Vector3f beam = submap.points[i] - submap.eyes[i];
    elevations.push_back(std::atan2(beam.z(), beam.head<2>().norm()));
    const Eigen::Vector3d eye = submap.eyes[i].cast<double>();
    if (const double apart = (eye - near).squaredNorm(); apart < least) {
      least = apart;
      eye_ = eye;
    }
  }
  if (elevations.empty()) return;
  lowest_ = quantile(elevations, kOutermost);
  highest_ = quantile(std::move(elevations), 1.0 - kOutermost);
  for (const Eigen::Vector3f& point : submap.points) {
    const Direction to = direction_of(point.cast<double>());
    const auto ring = static_cast<std::size_t>(to.distance / kRing);
    if (ring < 64) rings_[to.elevation * kAzimuths + to.azimuth] |= std::uint64_t{1} << ring;
  }
}

Outlook::Direction Outlook::direction_of(const Eigen::Vector3d& place) const {
  const Eigen::Vector3d way = place - eye_;
  const double steepness = std::atan2(way.z(), way.head<2>().norm());
  const double turn = std::atan2(way.y(), way.x()) + std::numbers::pi;
  const double rise = steepness + 0.5 * std::numbers::pi;
  return {static_cast<std::size_t>(turn * kPerRadian) % kAzimuths,
          std::min(static_cast<std::size_t>(rise * kPerRadian), kElevations - 1), steepness,
          way.norm()};
}

Outlook::Sight Outlook::at(const Eigen::Vector3d& place) const {
  const Direction to = direction_of(place);
  if (to.distance < kNearestTold || to.distance > kFarthestTold) return Sight::unknown;
  if (to.steepness < lowest_ || to.steepness > highest_) return Sight::unknown;
  std::uint64_t about = 0;  // in this direction and those beside it
  const std::size_t low = std::max<std::size_t>(to.elevation, 1) - 1;
  for (std::size_t row = low; row < std::min(to.elevation + 2, kElevations); ++row) {
    for (const std::size_t side : {kAzimuths - 1, kAzimuths, kAzimuths + 1}) {
      about |= rings_[row * kAzimuths + (to.azimuth + side) % kAzimuths];
    }
  }
  const auto ring = static_cast<std::size_t>(to.distance / kRing);
  const std::uint64_t before = (std::uint64_t{1} << (ring - 1)) - 1;
  const std::uint64_t here = std::uint64_t{7} << (ring - 1);
  if ((about & here) != 0) return Sight::seen;
  return (about & before) != 0 ? Sight::unknown : Sight::missing;
}

}  // namespace surefoot::mapping
