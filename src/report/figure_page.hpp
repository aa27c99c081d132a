// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A figure's page: panels side by side and below each other, under one legend.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/canvas.hpp"

namespace surefoot::report {

/// An entry of the legend: a line, or one of the two markers.
struct LegendEntry {
  enum class Kind { line, start, end };
  std::string name;
  Stroke stroke;
  Kind kind = Kind::line;
};

struct FigurePage {
  std::vector<LegendEntry> legend;
  std::vector<double> heights = {};  ///< of each panel, as a share of its width
  /// Draws a panel into its rectangle.
  std::function<void(Canvas& canvas, const Rect& rect, std::size_t panel)> draw = {};
};

/// "(a) title", as figures with several panels are cited.
[[nodiscard]] std::string numbered_title(std::size_t panel, std::size_t count,
                                         const std::string& title);
/// Lines in the upper right corner of a panel's axes.
void draw_remarks(Canvas& canvas, const Rect& rect, const std::vector<std::string>& remarks);

/// Writes the page as PNG, SVG or PDF, by the extension of `path`. Throws std::runtime_error naming
/// the path if it cannot be written.
void draw_figure_page(const FigurePage& page, const std::filesystem::path& path);

}  // namespace surefoot::report
