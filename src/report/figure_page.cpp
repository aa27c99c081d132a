// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/figure_page.hpp"

#include <algorithm>
#include <array>

#include "report/figure_curves.hpp"

namespace surefoot::report {

namespace {

constexpr int kDots = 2;              // of a PNG for each pixel of the page, where it can hold them
constexpr double kHighest = 32767.0;  // [dots] that cairo's images can hold
constexpr double kPageMargin = 24.0;  // [px]
constexpr double kLegendLine = 44.0;  // [px]
constexpr double kLegendSample = 52.0;  // [px]
constexpr double kTextSize = 21.0;      // [px]

struct Columns {
  std::size_t count;
  double width;  // [px] of each

  [[nodiscard]] double page_width() const {
    return 2.0 * kPageMargin + static_cast<double>(count) * width;
  }
};

Columns columns_for(std::size_t panels) {
  if (panels == 1) return {1, 760.0};
  return panels <= 4 ? Columns{2, 620.0} : Columns{3, 560.0};
}

double sample_width(const LegendEntry& entry) {
  return entry.kind == LegendEntry::Kind::line ? kLegendSample : 22.0;
}

/// The entries that share a line, and how long it is.
struct LegendLine {
  std::vector<LegendEntry> entries;
  double width = 0.0;
};

constexpr double kEntryGap = 26.0;
constexpr double kSampleGap = 10.0;

std::vector<LegendLine> legend_lines(Canvas& canvas, const std::vector<LegendEntry>& entries,
                                     double width) {
  std::vector<LegendLine> lines(1);
  for (const LegendEntry& entry : entries) {
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
    for (const LegendEntry& entry : line.entries) {
      const Pixel middle(x + 0.5 * sample_width(entry), baseline - 7.0);
      const std::array<Pixel, 2> sample = {Pixel(x, middle.y()),
                                           Pixel(x + sample_width(entry), middle.y())};
      if (entry.kind == LegendEntry::Kind::line) canvas.line(sample, entry.stroke);
      if (entry.kind == LegendEntry::Kind::start) draw_start(canvas, middle);
      if (entry.kind == LegendEntry::Kind::end) draw_end(canvas, middle);
      x += sample_width(entry) + kSampleGap;
      canvas.text(entry.name, {x, baseline}, {.size = kTextSize});
      x += canvas.text_width(entry.name, {.size = kTextSize}) + kEntryGap;
    }
    baseline += kLegendLine;
  }
}

struct Layout {
  Columns columns;
  std::vector<LegendLine> legend;
  std::vector<double> tops;  // [px] of each row, and the last one's end

  [[nodiscard]] double height() const { return tops.back() + kPageMargin; }
};

Layout layout_in(const FigurePage& page, const Columns& columns) {
  Canvas ruler(1, 1, PageFormat::png);  // measures text before the page's height is known
  Layout layout{
      columns, legend_lines(ruler, page.legend, columns.page_width() - 2.0 * kPageMargin), {}};
  layout.tops = {kPageMargin + kLegendLine * static_cast<double>(layout.legend.size())};
  for (std::size_t first = 0; first < page.heights.size(); first += columns.count) {
    double height = 0.0;
    for (std::size_t i = first; i < std::min(first + columns.count, page.heights.size()); ++i) {
      height = std::max(height, page.heights[i] * columns.width);
    }
    layout.tops.push_back(layout.tops.back() + height);
  }
  return layout;
}

/// With as many columns as it takes for a picture that can hold all rows.
Layout layout_of(const FigurePage& page) {
  Columns columns = columns_for(page.heights.size());
  Layout layout = layout_in(page, columns);
  while (layout.height() > kHighest && columns.count < page.heights.size()) {
    ++columns.count;
    layout = layout_in(page, columns);
  }
  return layout;
}

}  // namespace

std::string numbered_title(std::size_t panel, std::size_t count, const std::string& title) {
  if (count == 1 || panel > 25) return title;
  return std::string("(") + static_cast<char>('a' + panel) + ") " + title;
}

void draw_remarks(Canvas& canvas, const Rect& rect, const std::vector<std::string>& remarks) {
  double baseline = rect.y + 24.0;
  for (const std::string& remark : remarks) {
    const TextStyle text{.size = 17.0, .color = {0.35, 0.37, 0.42}, .anchor = Anchor::right};
    const double width = canvas.text_width(remark, text);
    canvas.fill({rect.right() - width - 14.0, baseline - 17.0, width + 8.0, 23.0},
                {1.0, 1.0, 1.0, 0.8});
    canvas.text(remark, {rect.right() - 10.0, baseline}, text);
    baseline += 23.0;
  }
}

void draw_figure_page(const FigurePage& page, const std::filesystem::path& path) {
  const PageFormat format = page_format_of(path);
  const Layout layout = layout_of(page);
  const auto& [columns, legend, tops] = layout;
  const int dots = kDots * layout.height() > kHighest ? 1 : kDots;
  Canvas canvas(static_cast<int>(columns.page_width()), static_cast<int>(layout.height()), format,
                dots);
  draw_legend(canvas, legend, columns.page_width());
  for (std::size_t i = 0; i < page.heights.size(); ++i) {
    const std::size_t row = i / columns.count;
    const double left = kPageMargin + static_cast<double>(i % columns.count) * columns.width;
    page.draw(canvas, {left, tops[row], columns.width, tops[row + 1] - tops[row]}, i);
  }
  canvas.save(path, PictureKind::figure);
}

}  // namespace surefoot::report
