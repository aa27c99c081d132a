// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Trajectories of several methods against their reference, as papers print them: white page, one
// legend for all panels, colours that the colour-blind can tell apart, and line styles besides.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "surefoot/trajectory.hpp"

namespace surefoot::report {

enum class FigureView {
  space,  ///< x, y and z, seen obliquely; z is stretched
  side,   ///< x to the right, z up; both axes fill the panel
  top     ///< x to the right, y up; one scale
};

/// The reference's start is marked by a blue circle, its end by a yellow triangle.
struct FigurePanel {
  FigureView view = FigureView::top;
  std::string title = {};  ///< UTF-8, one line
  Trajectory reference = {};
  /// One for each of the figure's names, aligned to the reference; empty: none. What lies far off
  /// the reference does not widen the axes and is cut at the panel's border.
  std::vector<Trajectory> estimates = {};
  /// One for each estimate, or empty: those that do not widen the axes at all.
  std::vector<bool> cut = {};
  std::vector<std::string> remarks = {};  ///< lines in the panel's corner: "icp: stopped at 41 %"
  /// One for each estimate, or empty: its poses with which another line begins, ascending. How the
  /// segments of a run lie to each other is not known.
  std::vector<std::vector<std::size_t>> begins = {};
};

struct TrajectoryFigure {
  std::vector<std::string> names;  ///< of the estimates, in the legend
  std::vector<FigurePanel> panels;
};

/// Writes the figure as PNG, SVG or PDF, by the extension of `path`. Poses that are not finite, or
/// farther than 1e9 m, are left out. The same input gives the same PNG, byte for byte, on one
/// machine. Throws std::invalid_argument if there is no panel or if one
/// has another number of estimates than there are names, or of
/// flags or lists of begins than of estimates, std::runtime_error naming the path if the
/// extension is another one or the file cannot be written.
void draw_trajectory_figure(const TrajectoryFigure& figure, const std::filesystem::path& path);

}  // namespace surefoot::report
