// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A figure of ratios to something usual, row by row on a logarithmic axis: what made things better
// lies to the left of 1, what made them worse to the right.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace surefoot::report {

struct RatioRow {
  std::string group = {};                 ///< rows of one group follow each other under its heading
  std::string label = {};                 ///< what the row is
  std::string remark = {};                ///< beside it, grey
  std::vector<double> ratios = {};        ///< a dot each; what is not finite is not drawn
  double median = 1.0;                    ///< a bar; if it is not finite there is none
  bool notable = false;                   ///< coloured, by the side of 1 on which the median lies
  std::vector<std::string> figures = {};  ///< right of the axes, one for each of `figure_names`
};

struct RatioFigure {
  std::string title = {};
  std::string axis = {};  ///< what the ratio is of
  std::vector<std::string> figure_names = {};
  double spread = 1.0;  ///< the band from 1 / spread to spread is shaded
  std::vector<RatioRow> rows = {};
};

/// Powers of ten, their doubles and fives within the range; both ends must be above zero.
[[nodiscard]] std::vector<double> logarithmic_ticks(double low, double high);

/// Writes the figure as PNG, SVG or PDF, by the extension of `path`. Ratios beyond 1/50 and 50 are
/// drawn at the border. Throws std::invalid_argument if there is no row or one has another number
/// of figures than there are names, std::runtime_error naming the path if it cannot be written.
void draw_ratio_figure(const RatioFigure& figure, const std::filesystem::path& path);

}  // namespace surefoot::report
