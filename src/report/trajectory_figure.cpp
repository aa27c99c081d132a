// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/trajectory_figure.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include "report/box_view.hpp"
#include "report/canvas.hpp"
#include "report/figure_curves.hpp"
#include "report/plot.hpp"

namespace surefoot::report {

namespace {

constexpr int kDots = 2;                // of a PNG for each pixel of the page
constexpr double kPageMargin = 24.0;    // [px]
constexpr double kLegendLine = 44.0;    // [px]
constexpr double kLegendSample = 52.0;  // [px]
constexpr double kTextSize = 21.0;      // [px]

const Stroke kShadow{{0.72, 0.74, 0.78}, 1.5};  // of the reference, on the floor

/// How panels of a view are laid out: the page's columns have a given width.
struct Frame {
  double height;                    // by the panel's width
  double left, right, top, bottom;  // [px] margins of the axes within the panel
};

Frame frame_of(FigureView view) {
  switch (view) {
    case FigureView::kSpace:
      return {0.72, 0.0, 0.0, 44.0, 0.0};
    case FigureView::kSide:
      return {0.55, 96.0, 18.0, 44.0, 74.0};
    case FigureView::kTop:
      break;
  }
  return {0.82, 96.0, 18.0, 44.0, 74.0};
}

struct Layout {
  int columns;
  double panel_width;  // [px]
};

Layout layout_for(std::size_t panels) {
  if (panels == 1) return {1, 760.0};
  return panels <= 4 ? Layout{2, 620.0} : Layout{3, 560.0};
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
  const PlotArea area = up == 1 ? equal_aspect(rect, x, y) : PlotArea{rect, x, y};
  const AxisLabels labels{.x = "x [m]", .y = up == 1 ? "y [m]" : "z [m]"};
  draw_grid(canvas, area, labels);
  canvas.clip(rect);
  const auto at = [&](const Eigen::Vector3d& point) { return area.at(point.x(), point[up]); };
  draw_curves(canvas, curves, at, {rect, nullptr});
  canvas.unclip();
  draw_axes(canvas, area, labels);
}

void draw_remarks(Canvas& canvas, const Rect& rect, const std::vector<std::string>& remarks) {
  double baseline = rect.y + 24.0;
  for (const std::string& remark : remarks) {
    const TextStyle text{.size = 17.0, .color = {0.35, 0.37, 0.42}, .anchor = Anchor::kRight};
    const double width = canvas.text_width(remark, text);
    canvas.fill({rect.right() - width - 14.0, baseline - 17.0, width + 8.0, 23.0},
                {1.0, 1.0, 1.0, 0.8});
    canvas.text(remark, {rect.right() - 10.0, baseline}, text);
    baseline += 23.0;
  }
}

/// "(a) title" above the axes, as figures with several panels are cited.
std::string numbered(std::size_t index, std::size_t count, const std::string& title) {
  if (count == 1 || index > 25) return title;
  return std::string("(") + static_cast<char>('a' + index) + ") " + title;
}

void draw_panel(Canvas& canvas, const Rect& rect, const FigurePanel& panel,
                const std::string& title) {
  const Frame frame = frame_of(panel.view);
  const Rect axes{rect.x + frame.left, rect.y + frame.top, rect.width - frame.left - frame.right,
                  rect.height - frame.top - frame.bottom};
  canvas.text(title, {rect.x + (frame.left > 0.0 ? frame.left : 16.0), rect.y + 28.0},
              {.size = 23.0, .bold = true});
  const Curves curves = curves_of(panel);
  if (panel.view == FigureView::kSpace) {
    draw_space(canvas, axes, curves);
  } else {
    draw_plane(canvas, axes, curves, panel.view == FigureView::kTop ? 1 : 2);
  }
  draw_remarks(canvas, axes, panel.remarks);
}

/// An entry of the legend: a line, or one of the two markers.
struct Entry {
  std::string name;
  Stroke stroke;
  enum class Kind { kLine, kStart, kEnd } kind = Kind::kLine;
};

std::vector<Entry> legend_entries(const TrajectoryFigure& figure) {
  std::vector<Entry> entries = {{"reference", reference_stroke()}};
  for (std::size_t i = 0; i < figure.names.size(); ++i) {
    entries.push_back({figure.names[i], stroke_of(i)});
  }
  entries.push_back({"start", {}, Entry::Kind::kStart});
  entries.push_back({"end", {}, Entry::Kind::kEnd});
  return entries;
}

double sample_width(const Entry& entry) {
  return entry.kind == Entry::Kind::kLine ? kLegendSample : 22.0;
}

/// The entries that share a line, and how long it is.
struct LegendLine {
  std::vector<Entry> entries;
  double width = 0.0;
};

constexpr double kEntryGap = 26.0;
constexpr double kSampleGap = 10.0;

std::vector<LegendLine> legend_lines(Canvas& canvas, const TrajectoryFigure& figure, double width) {
  std::vector<LegendLine> lines(1);
  for (const Entry& entry : legend_entries(figure)) {
    const double wide = sample_width(entry) + kSampleGap +
                        canvas.text_width(entry.name, {.size = kTextSize}) + kEntryGap;
    if (!lines.back().entries.empty() && lines.back().width + wide > width) lines.emplace_back();
    lines.back().entries.push_back(entry);
    lines.back().width += wide;
  }
  return lines;
}

void draw_legend(Canvas& canvas, const std::vector<LegendLine>& lines, double page_width) {
  double baseline = kPageMargin + 24.0;
  for (const LegendLine& line : lines) {
    double x = 0.5 * (page_width - line.width + kEntryGap);
    for (const Entry& entry : line.entries) {
      const Pixel middle(x + 0.5 * sample_width(entry), baseline - 7.0);
      const std::array<Pixel, 2> sample = {Pixel(x, middle.y()),
                                           Pixel(x + sample_width(entry), middle.y())};
      if (entry.kind == Entry::Kind::kLine) canvas.line(sample, entry.stroke);
      if (entry.kind == Entry::Kind::kStart) draw_start(canvas, middle);
      if (entry.kind == Entry::Kind::kEnd) draw_end(canvas, middle);
      x += sample_width(entry) + kSampleGap;
      canvas.text(entry.name, {x, baseline}, {.size = kTextSize});
      x += canvas.text_width(entry.name, {.size = kTextSize}) + kEntryGap;
    }
    baseline += kLegendLine;
  }
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
  }
}

}  // namespace

void draw_trajectory_figure(const TrajectoryFigure& figure, const std::filesystem::path& path) {
  check(figure);
  const PageFormat format = page_format_of(path);
  const std::size_t count = figure.panels.size();
  const Layout layout = layout_for(count);
  const auto columns = static_cast<std::size_t>(layout.columns);
  const double page_width = 2.0 * kPageMargin + layout.columns * layout.panel_width;
  Canvas ruler(1, 1, PageFormat::kPng);  // measures text before the page's height is known
  const std::vector<LegendLine> legend =
      legend_lines(ruler, figure, page_width - 2.0 * kPageMargin);
  std::vector<double> tops = {kPageMargin + kLegendLine * static_cast<double>(legend.size())};
  for (std::size_t first = 0; first < count; first += columns) {
    double height = 0.0;
    for (std::size_t i = first; i < std::min(first + columns, count); ++i) {
      height = std::max(height, frame_of(figure.panels[i].view).height * layout.panel_width);
    }
    tops.push_back(tops.back() + height);
  }
  Canvas canvas(static_cast<int>(page_width), static_cast<int>(tops.back() + kPageMargin), format,
                kDots);
  draw_legend(canvas, legend, page_width);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = i / columns;
    const double left = kPageMargin + static_cast<double>(i % columns) * layout.panel_width;
    draw_panel(canvas, {left, tops[row], layout.panel_width, tops[row + 1] - tops[row]},
               figure.panels[i], numbered(i, count, figure.panels[i].title));
  }
  canvas.save(path);
}

}  // namespace surefoot::report
