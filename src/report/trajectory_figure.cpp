// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/trajectory_figure.hpp"

#include <stdexcept>

#include "report/box_view.hpp"
#include "report/canvas.hpp"
#include "report/figure_curves.hpp"
#include "report/figure_page.hpp"
#include "report/plot.hpp"

namespace surefoot::report {

namespace {

const Stroke kShadow{{0.72, 0.74, 0.78}, 1.5};  // of the reference, on the floor

constexpr double kLeftMargin = 96.0;  // [px] of axes whose numbers are not too wide for it

/// How panels of a view are laid out: the page's columns have a given width.
struct Frame {
  double height;                    // by the panel's width
  double left, right, top, bottom;  // [px] margins of the axes within the panel
};

Frame frame_of(FigureView view) {
  switch (view) {
    case FigureView::space:
      return {0.72, 0.0, 0.0, 44.0, 0.0};
    case FigureView::side:
      return {0.55, kLeftMargin, 18.0, 44.0, 74.0};
    case FigureView::top:
      break;
  }
  return {0.82, kLeftMargin, 18.0, 44.0, 74.0};
}

void draw_space(Canvas& canvas, const Rect& rect, const Curves& curves) {
  const BoxView view(rect, curves.ranges);
  draw_box(canvas, view);
  const auto at = [&](const Eigen::Vector3d& point) { return view.at(point); };
  const auto on_floor = [&](const Eigen::Vector3d& point) {
    return view.at({point.x(), point.y(), view.range(2).low});
  };
  const Border border{std::nullopt, &curves.ranges};
  draw_curve(canvas, curves.reference, on_floor, kShadow, border);
  draw_curves(canvas, curves, at, border);
}

/// x against y (`up` 1) or z (`up` 2).
void draw_plane(Canvas& canvas, const Rect& rect, const Curves& curves, int up) {
  const Range& x = curves.ranges[0];
  const Range& y = curves.ranges[static_cast<std::size_t>(up)];
  const auto area_in = [&](const Rect& within) {
    return up == 1 ? equal_aspect(within, x, y) : PlotArea{within, x, y};
  };
  const AxisLabels labels{.x = "x [m]", .y = up == 1 ? "y [m]" : "z [m]"};
  PlotArea area = area_in(rect);
  const double more = left_margin(canvas, area, labels) - kLeftMargin;
  if (more > 0.0) area = area_in({rect.x + more, rect.y, rect.width - more, rect.height});
  draw_grid(canvas, area, labels);
  canvas.clip(area.rect);
  const auto at = [&](const Eigen::Vector3d& point) { return area.at(point.x(), point[up]); };
  draw_curves(canvas, curves, at, {area.rect, nullptr});
  canvas.unclip();
  draw_axes(canvas, area, labels);
}

void draw_panel(Canvas& canvas, const Rect& rect, const FigurePanel& panel,
                const std::string& title) {
  const Frame frame = frame_of(panel.view);
  const Rect axes{rect.x + frame.left, rect.y + frame.top, rect.width - frame.left - frame.right,
                  rect.height - frame.top - frame.bottom};
  canvas.text(title, {rect.x + (frame.left > 0.0 ? frame.left : 16.0), rect.y + 28.0},
              {.size = 23.0, .bold = true});
  const Curves curves = curves_of(panel);
  if (panel.view == FigureView::space) {
    draw_space(canvas, axes, curves);
  } else {
    draw_plane(canvas, axes, curves, panel.view == FigureView::top ? 1 : 2);
  }
  draw_remarks(canvas, axes, panel.remarks);
}

std::vector<LegendEntry> legend_entries(const TrajectoryFigure& figure) {
  std::vector<LegendEntry> entries = {{"reference", reference_stroke()}};
  for (std::size_t i = 0; i < figure.names.size(); ++i) {
    entries.push_back({figure.names[i], stroke_of(i)});
  }
  entries.push_back({"start", {}, LegendEntry::Kind::start});
  entries.push_back({"end", {}, LegendEntry::Kind::end});
  return entries;
}

void check(const TrajectoryFigure& figure) {
  if (figure.panels.empty()) throw std::invalid_argument("a figure needs a panel");
  for (const FigurePanel& panel : figure.panels) {
    if (panel.estimates.size() != figure.names.size()) {
      throw std::invalid_argument("panel '" + panel.title + "' has " +
                                  std::to_string(panel.estimates.size()) + " estimates for " +
                                  std::to_string(figure.names.size()) + " names");
    }
    if (!panel.cut.empty() && panel.cut.size() != panel.estimates.size()) {
      throw std::invalid_argument("panel '" + panel.title + "' has " +
                                  std::to_string(panel.cut.size()) + " flags for " +
                                  std::to_string(panel.estimates.size()) + " estimates");
    }
    if (!panel.begins.empty() && panel.begins.size() != panel.estimates.size()) {
      throw std::invalid_argument("panel '" + panel.title + "' has begins of " +
                                  std::to_string(panel.begins.size()) + " estimates, expected " +
                                  std::to_string(panel.estimates.size()));
    }
  }
}

}  // namespace

void draw_trajectory_figure(const TrajectoryFigure& figure, const std::filesystem::path& path) {
  check(figure);
  FigurePage page{.legend = legend_entries(figure)};
  for (const FigurePanel& panel : figure.panels) {
    page.heights.push_back(frame_of(panel.view).height);
  }
  page.draw = [&](Canvas& canvas, const Rect& rect, std::size_t i) {
    const FigurePanel& panel = figure.panels[i];
    draw_panel(canvas, rect, panel, numbered_title(i, figure.panels.size(), panel.title));
  };
  draw_figure_page(page, path);
}

}  // namespace surefoot::report
