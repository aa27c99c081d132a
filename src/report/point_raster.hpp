// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Millions of points as an image: splatted with a depth buffer, coloured by height and shaded by
// how far each pixel lies behind its neighbours (eye-dome lighting, Boucheny 2009).
#pragma once

#include <Eigen/Core>
#include <span>

#include "report/canvas.hpp"
#include "report/plot.hpp"

namespace surefoot::report {

/// A parallel projection of the map frame to an image.
struct ParallelView {
  /// Rows: image right, image up, towards the viewer; orthonormal, in the map frame.
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
  Eigen::Vector2d center = Eigen::Vector2d::Zero();  ///< [m] right and up, at the image's centre
  double pixels_per_metre = 1.0;
  int width = 0, height = 0;  ///< [px]

  /// Pixel of a point (y down).
  [[nodiscard]] Pixel project(const Eigen::Vector3d& point) const;
};

/// Seen from above, x to the right and y up.
[[nodiscard]] ParallelView top_view(const PlotArea& area);

/// The points as an image of the view's size; where there is no point, it is transparent.
/// Colours run from `heights.low` to `heights.high` (z [m], map frame).
[[nodiscard]] Raster draw_points(std::span<const Eigen::Vector3f> points, const ParallelView& view,
                                 const Range& heights);

}  // namespace surefoot::report
