// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A box in space, seen obliquely from above, with axes along its edges: the frame of a 3-D plot.
#pragma once

#include <Eigen/Core>
#include <array>

#include "report/canvas.hpp"
#include "report/plot.hpp"

namespace surefoot::report {

/// Parallel projection of data coordinates. x and y have one scale unless the box would become too
/// narrow; z has its own, so that the box is never flat.
class BoxView {
 public:
  /// Ranges of x, y and z; all must be wider than zero. The box, its numbers and its labels lie
  /// within `rect`.
  BoxView(const Rect& rect, const std::array<Range, 3>& ranges);

  [[nodiscard]] Pixel at(const Eigen::Vector3d& point) const;
  [[nodiscard]] const Range& range(int axis) const {
    return ranges_[static_cast<std::size_t>(axis)];
  }

 private:
  [[nodiscard]] Eigen::Vector2d project(const Eigen::Vector3d& point) const;

  std::array<Range, 3> ranges_;
  Eigen::Vector3d scale_;  ///< edge lengths of the box by the widths of the ranges
  double zoom_ = 1.0;
  Pixel offset_ = Pixel::Zero();
};

/// The three faces behind the data with their grid, and the axes with numbers and labels.
void draw_box(Canvas& canvas, const BoxView& view);

}  // namespace surefoot::report
