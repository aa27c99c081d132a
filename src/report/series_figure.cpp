// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/series_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "report/figure_curves.hpp"
#include "report/figure_page.hpp"
#include "report/plot.hpp"
#include "report/ratio_figure.hpp"

namespace surefoot::report {

namespace {

constexpr double kHeight = 0.6;            // of a panel, as a share of its width
constexpr double kLargestSpan = 1e5;       // from the axis' lower end to its upper one at most
constexpr std::size_t kMostPoints = 4000;  // of a curve

bool is_shown(double time, double value) {
  return is_drawable(time) && is_drawable(value) && value > 0.0;
}

/// Times, and decades of the values.
PlotArea area_of(const Rect& rect, const SeriesPanel& panel) {
  std::vector<double> times, decades;
  for (const TimeSeries& curve : panel.curves) {
    for (std::size_t i = 0; i < curve.times.size(); ++i) {
      if (!is_shown(curve.times[i], curve.values[i])) continue;
      times.push_back(curve.times[i]);
      decades.push_back(std::log10(curve.values[i]));
    }
  }
  Range y = range_of(decades);
  y.low = std::max(y.low, y.high - std::log10(kLargestSpan));
  return {rect, time_range(times), padded(y, 0.05, 1.0)};
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

void draw_frame(Canvas& canvas, const PlotArea& area, const std::string& quantity) {
  const TextStyle number{.size = 18.0, .anchor = Anchor::center};
  const Ticks times = nice_ticks(area.x, 6);
  for (const double time : times.values) {
    const std::array<Pixel, 2> ends = {area.at(time, area.y.low), area.at(time, area.y.high)};
    canvas.line(ends, kGrid);
    canvas.text(tick_label(time, times.step), ends[0] + Pixel(0.0, 26.0), number);
  }
  const double low = std::pow(10.0, area.y.low), high = std::pow(10.0, area.y.high);
  const bool many = area.y.width() > 2.5;  // decades: their powers of ten are enough
  for (const double value : logarithmic_ticks(low, high)) {
    const double decade = std::log10(value);
    if (many && std::abs(decade - std::round(decade)) > 1e-6) continue;
    const std::array<Pixel, 2> ends = {area.at(area.x.low, decade), area.at(area.x.high, decade)};
    canvas.line(ends, kGrid);
    canvas.text(number_text(value), ends[0] + Pixel(-10.0, 7.0),
                {.size = 18.0, .anchor = Anchor::right});
  }
  canvas.outline(area.rect, kFrame);
  canvas.text("time [s]", {area.rect.center().x(), area.rect.bottom() + 56.0},
              {.size = 20.0, .anchor = Anchor::center});
  canvas.text(quantity, {area.rect.x - 74.0, area.rect.center().y()},
              {.size = 20.0, .anchor = Anchor::center, .upward = true});
}

void draw_series(Canvas& canvas, const PlotArea& area, const TimeSeries& curve,
                 const Stroke& stroke) {
  std::vector<Pixel> line;
  const std::size_t stride = curve.times.size() / kMostPoints + 1;
  auto next = curve.begins.begin();
  for (std::size_t i = 0; i < curve.times.size(); i += stride) {
    if (next != curve.begins.end() && *next <= i) {
      canvas.line(line, stroke);
      line.clear();
      while (next != curve.begins.end() && *next <= i) ++next;
    }
    if (!is_shown(curve.times[i], curve.values[i])) continue;
    const double decade = std::max(std::log10(curve.values[i]), area.y.low - 1.0);
    line.push_back(area.at(curve.times[i], decade));
  }
  canvas.line(line, stroke);
}

void draw_panel(Canvas& canvas, const Rect& rect, const SeriesPanel& panel,
                const std::string& title, const std::string& quantity) {
  const Rect axes{rect.x + 96.0, rect.y + 44.0, rect.width - 114.0, rect.height - 118.0};
  canvas.text(title, {axes.x, rect.y + 28.0}, {.size = 23.0, .bold = true});
  const PlotArea area = area_of(axes, panel);
  draw_frame(canvas, area, quantity);
  canvas.clip(axes);
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    draw_series(canvas, area, panel.curves[i], stroke_of(i));
  }
  canvas.unclip();
  draw_remarks(canvas, axes, panel.remarks);
}

void check(const SeriesFigure& figure) {
  if (figure.panels.empty()) throw std::invalid_argument("a figure needs a panel");
  for (const SeriesPanel& panel : figure.panels) {
    bool whole = panel.curves.size() == figure.names.size();
    for (const TimeSeries& curve : panel.curves) {
      whole = whole && curve.times.size() == curve.values.size();
    }
    if (!whole) {
      throw std::invalid_argument("panel '" + panel.title +
                                  "' needs a curve for each name, with a value for each time");
    }
  }
}

}  // namespace

void draw_series_figure(const SeriesFigure& figure, const std::filesystem::path& path) {
  check(figure);
  FigurePage page;
  for (std::size_t i = 0; i < figure.names.size(); ++i) {
    page.legend.push_back({figure.names[i], stroke_of(i)});
  }
  page.heights.assign(figure.panels.size(), kHeight);
  page.draw = [&](Canvas& canvas, const Rect& rect, std::size_t i) {
    const SeriesPanel& panel = figure.panels[i];
    draw_panel(canvas, rect, panel, numbered_title(i, figure.panels.size(), panel.title),
               figure.quantity);
  };
  draw_figure_page(page, path);
}

}  // namespace surefoot::report
