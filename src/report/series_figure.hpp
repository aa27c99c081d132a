// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A figure of positive quantities over time, such as errors of several methods: one curve a method,
// on a logarithmic axis, since good and bad methods are orders of magnitude apart.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace surefoot::report {

struct TimeSeries {
  std::vector<double> times;   ///< [s]
  std::vector<double> values;  ///< as many; what is not above zero and finite is not drawn
  std::vector<std::size_t> begins = {};  ///< of them, with which another line begins, ascending
};

struct SeriesPanel {
  std::string title = {};                 ///< UTF-8, one line
  std::vector<TimeSeries> curves = {};    ///< one for each of the figure's names; may be empty
  std::vector<std::string> remarks = {};  ///< lines in the panel's corner
};

struct SeriesFigure {
  std::vector<std::string> names = {};  ///< of the curves, in the legend
  std::string quantity = {};            ///< with its unit: "position error [m]"
  std::vector<SeriesPanel> panels = {};
};

/// Writes the figure as PNG, SVG or PDF, by the extension of `path`. Throws std::invalid_argument
/// if there is no panel or one has another number of curves than there are names,
/// std::runtime_error naming the path if it cannot be written.
void draw_series_figure(const SeriesFigure& figure, const std::filesystem::path& path);

}  // namespace surefoot::report
