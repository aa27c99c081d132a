// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/beams.hpp"
#include "geometry/float_sums.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace surefoot {

namespace {

// Cells about as wide as a LiDAR's usual step between rings, 2 deg.
constexpr int kColumns = 180, kRows = 60;

constexpr float kNear = 0.5F, kFar = 30.0F;  // [m] where surfels are asked about

// A beam that went through something ends behind it by so much at least [m], and this share of the
// distance: from half a metre's height one that passes a hand above the ground ends a quarter
// farther on.
constexpr double kBehind = 0.5, kBehindShare = 0.2;

// A plane that a beam meets at less than this (sine) may not have been in its way.
constexpr double kOblique = 0.2;

// Of what is no plane, a beam passes the middle within this share of the variance, or this [m].
constexpr double kMiddle = 0.5, kSmall = 0.1;

// Where on the sphere, in cells: not by angles but by what grows with them and needs no
// trigonometry (the octahedron's). Nowhere does it grow faster than by this per radian.
constexpr double kFastest = kColumns / 4.0;

struct Direction {
  float column, row;
};

Direction direction_of(const Eigen::Vector3f& d) {
  const float level = std::abs(d.x()) + std::abs(d.y());
  const float across = level > 0.0F ? d.y() / level : 0.0F;          // -1 to 1
  const float turn = d.x() >= 0.0F ? 1.0F + across : 3.0F - across;  // 0 to 4
  const float rise = 1.0F + d.z() / (level + std::abs(d.z()));       // 0 to 2
  return {turn * (kColumns / 4.0F), rise * (kRows / 2.0F)};
}

int cell_at(int column, int row) { return row * kColumns + column; }

int cell_of(const Direction& direction) {
  return cell_at(std::clamp(static_cast<int>(direction.column), 0, kColumns - 1),
                 std::clamp(static_cast<int>(direction.row), 0, kRows - 1));
}

/// Calls f(first, end) for runs of cells, which are all that lie up to so many columns and rows
/// away, until it says true.
template <typename Function>
bool any_about(const Direction& direction, float columns, float rows, const Function& f) {
  const int first_row = std::max(static_cast<int>(direction.row - rows), 0);
  const int last_row = std::min(static_cast<int>(direction.row + rows), kRows - 1);
  const int first = static_cast<int>(direction.column - columns + kColumns) - kColumns;
  const int last = static_cast<int>(direction.column + columns);
  for (int row = first_row; row <= last_row; ++row) {
    const auto ask = [&](int begin, int end) { return f(cell_at(begin, row), cell_at(end, row)); };
    if (ask(std::max(first, 0), std::min(last + 1, kColumns)) ||
        (first < 0 && ask(first + kColumns, kColumns)) ||
        (last >= kColumns && ask(0, last + 1 - kColumns))) {
      return true;
    }
  }
  return false;
}

/// How far some beams went through [m].
struct Span {
  float farthest, nearest;

  void widen(const Span& other) {
    farthest = std::max(farthest, other.farthest);
    nearest = std::min(nearest, other.nearest);
  }
};

/// How near to a surfel's mean a beam passes it [m^2].
double reach2_of(const Surfel& surfel) {
  const auto extent = static_cast<double>(surfel.extent);
  return surfel.directions == 1 ? extent : std::max(kMiddle * extent, kSmall * kSmall);
}

/// Whether a ray passes the middle of what lies at `d` from where it begins.
bool meets(const Surfel& surfel, const Eigen::Vector3d& ray, const Eigen::Vector3d& d) {
  if (surfel.directions != 1) return (d - d.dot(ray) * ray).squaredNorm() < reach2_of(surfel);
  const Eigen::Vector3d n = surfel.across(0);
  const double along = n.dot(ray);
  return std::abs(along) >= kOblique &&
         (n.dot(d) / along * ray - d).squaredNorm() < reach2_of(surfel);
}

}  // namespace

Beams::Beams(const Eigen::Vector3d& sensor, const std::vector<Eigen::Vector3d>& rays,
             const std::vector<double>& ranges)
    : sensor_(sensor), begins_(kColumns * kRows + 1, 0), beams_(rays.size()) {
  std::vector<int> cells(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) {
    cells[i] = cell_of(direction_of(rays[i].cast<float>()));
    ++begins_[cells[i]];
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : begins_) begin = sum += begin;
  for (std::size_t i = rays.size(); i-- > 0;) {
    beams_[--begins_[cells[i]]] = {rays[i], (ranges[i] - kBehind) / (1.0 + kBehindShare)};
  }
  find_clear();
}

void Beams::find_clear() {
  constexpr float kNone = std::numeric_limits<float>::max();
  // Of each cell; then of it and its neighbours in its row; then of the rows about it, too.
  std::vector<Span> own(std::size_t{kColumns} * kRows, {0.0F, kNone});
  for (std::size_t cell = 0; cell < own.size(); ++cell) {
    for (std::uint32_t i = begins_[cell]; i < begins_[cell + 1]; ++i) {
      const auto of_beam = static_cast<float>(std::max(beams_[i].clear, 0.0));
      own[cell].widen({of_beam, of_beam});
    }
  }
  std::vector<Span> in_row = own;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const int last = column == 0 ? kColumns - 1 : column - 1;
      const int next = column == kColumns - 1 ? 0 : column + 1;
      Span& span = in_row[cell_at(column, row)];
      span.widen(own[cell_at(last, row)]);
      span.widen(own[cell_at(next, row)]);
    }
  }
  clear2_.resize(own.size());
  free2_.resize(own.size());
  for (int row = 0; row < kRows; ++row) {
    const int below = std::max(row - 1, 0), above = std::min(row + 1, kRows - 1);
    for (int column = 0; column < kColumns; ++column) {
      const int cell = cell_at(column, row);
      Span span = in_row[cell];
      span.widen(in_row[cell_at(column, below)]);
      span.widen(in_row[cell_at(column, above)]);
      clear2_[cell] = span.farthest * span.farthest;
      free2_[cell] = span.nearest == kNone ? 0.0F : span.nearest * span.nearest;
    }
  }
}

bool Beams::may_pass(const Eigen::Vector3f& place) const {
  const Eigen::Vector3f d = place - sensor_.cast<float>();
  const float squared = squared_norm(d);
  if (squared < kNear * kNear || squared > kFar * kFar) return false;
  return clear2_[cell_of(direction_of(d))] > squared;
}

Beams::Answer Beams::at(const Eigen::Vector3d& place) const {
  const Eigen::Vector3f d = (place - sensor_).cast<float>();
  const float squared = squared_norm(d);
  if (squared < kNear * kNear || squared > kFar * kFar) return Answer::none;
  const int cell = cell_of(direction_of(d));
  if (squared < free2_[cell]) return Answer::free;
  const auto end =
      static_cast<float>(std::sqrt(clear2_[cell]) * (1.0 + kBehindShare) + 2.0 * kBehind);
  if (clear2_[cell] <= 0.0F || squared > end * end) return Answer::none;
  return Answer::open;
}

double Beams::telling() const {
  const auto tells = [](const Beam& beam) { return beam.clear > static_cast<double>(kNear); };
  const auto telling = std::count_if(beams_.begin(), beams_.end(), tells);
  return static_cast<double>(telling) /
         static_cast<double>(std::max<std::size_t>(beams_.size(), 1));
}

bool Beams::pass(const Surfel& surfel) const {
  const Eigen::Vector3d d = surfel.mean - sensor_;
  const double distance = d.norm();
  if (surfel.directions == 1 && std::abs(surfel.across(0).dot(d)) < kOblique * distance) {
    return false;
  }
  const double reach = kFastest * std::sqrt(reach2_of(surfel));
  const auto columns = static_cast<float>(std::min(reach / d.head<2>().norm(), 1.0));
  const auto rows = static_cast<float>(std::min(reach / distance, 1.0));
  return any_about(direction_of(d.cast<float>()), columns, rows, [&](int first, int end) {
    return std::any_of(
        beams_.begin() + begins_[first], beams_.begin() + begins_[end],
        [&](const Beam& beam) { return beam.clear > distance && meets(surfel, beam.ray, d); });
  });
}

}  // namespace surefoot
