// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The curves of a figure's panel: which part of them is shown, and in which style.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "report/canvas.hpp"
#include "report/plot.hpp"
#include "report/trajectory_figure.hpp"

namespace surefoot::report {

/// Where a point of space is on the page.
using Projection = std::function<Pixel(const Eigen::Vector3d&)>;

/// A panel's points, ready to be drawn.
struct Curves {
  std::vector<Eigen::Vector3d> reference;
  std::vector<std::vector<Eigen::Vector3d>> estimates;
  std::vector<std::vector<std::size_t>> begins;  ///< of each, points with which a line begins
  std::array<Range, 3> ranges;                   ///< shown of x, y and z; all wider than zero
};

/// Without what cannot be drawn.
[[nodiscard]] Curves curves_of(const FigurePanel& panel);

/// Styles of the reference and of the n-th name. No two of the first twelve names have both colour
/// and style in common.
[[nodiscard]] Stroke reference_stroke();
[[nodiscard]] Stroke stroke_of(std::size_t name);

/// Where a curve is drawn: in a plane up to the panel's border, in space up to the box, which has
/// no border on the page.
struct Border {
  std::optional<Rect> rect;
  const std::array<Range, 3>* box = nullptr;
};

/// A line through the points, without those that the eye could not tell from the one before and
/// without what lies outside: dashes along a path of a million kilometres take cairo minutes.
/// Another line begins with each of the points `begins`, ascending.
void draw_curve(Canvas& canvas, const std::vector<Eigen::Vector3d>& points, const Projection& at,
                const Stroke& stroke, const Border& border,
                const std::vector<std::size_t>& begins = {});

/// All curves of a panel, and start and end of the reference.
void draw_curves(Canvas& canvas, const Curves& curves, const Projection& at, const Border& border);
void draw_start(Canvas& canvas, const Pixel& at);
void draw_end(Canvas& canvas, const Pixel& at);

}  // namespace surefoot::report
