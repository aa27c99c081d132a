// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A page to draw on, kept in memory until it is saved as PNG, SVG or PDF. Pixels, y down.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace surefoot::report {

using Pixel = Eigen::Vector2d;

struct Color {
  double red = 0.0, green = 0.0, blue = 0.0, alpha = 1.0;  // [0, 1]
  [[nodiscard]] Color with_alpha(double value) const { return {red, green, blue, value}; }
};

struct Rect {
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
  [[nodiscard]] Pixel center() const { return {x + 0.5 * width, y + 0.5 * height}; }
};

enum class LineStyle { solid, dashed, dotted, dash_dotted, long_dashed };

struct Stroke {
  Color color;
  double width = 1.0;
  LineStyle style = LineStyle::solid;
};

/// Colours of an image's pixels, premultiplied ARGB, row by row from the top.
struct Raster {
  int width = 0, height = 0;
  std::vector<std::uint32_t> argb;
};

enum class Anchor { left, center, right };

struct TextStyle {
  double size = 22.0;
  Color color{0.13, 0.15, 0.19};
  Anchor anchor = Anchor::left;
  bool bold = false;
  bool upward = false;  ///< turned by 90 degrees, read from below to above
};

enum class PageFormat { png, svg, pdf };
/// By the extension of a picture's name, in any case. Throws std::runtime_error if it is none of
/// .png, .svg and .pdf.
[[nodiscard]] PageFormat page_format_of(const std::filesystem::path& path);

/// What a picture shows, by which an earlier one is known (picture_mark.hpp): a run, trajectories
/// and methods beside each other, a simulated scene.
enum class PictureKind { run, figure, scene };

class Canvas {
 public:
  /// `scale`: dots of a PNG for each pixel; SVG and PDF have no dots.
  Canvas(int width, int height, PageFormat format, int scale = 1);
  ~Canvas();

  void fill(const Rect& rect, const Color& color);
  void outline(const Rect& rect, const Stroke& stroke);
  void line(std::span<const Pixel> points, const Stroke& stroke);
  void polygon(std::span<const Pixel> corners, const Color& fill, const Stroke& edge);
  void circle(const Pixel& center, double radius, const Color& fill, const Stroke& edge);
  /// A triangle that points up, its circumcircle of the given radius.
  void triangle(const Pixel& center, double radius, const Color& fill, const Stroke& edge);
  /// The raster scaled into `rect`; `opacity` in [0, 1].
  void image(const Raster& raster, const Rect& rect, double opacity = 1.0);
  /// Text on the base line `at`. Bytes that are not UTF-8, and control characters, become '?'.
  void text(const std::string& text, const Pixel& at, const TextStyle& style);
  [[nodiscard]] double text_width(const std::string& text, const TextStyle& style);

  /// Draws only inside `rect` until unclip().
  void clip(const Rect& rect);
  void unclip();

  /// What is drawn so far. Only of a page that becomes a PNG.
  [[nodiscard]] Raster raster() const;
  /// Ends the page and writes it. Throws std::runtime_error naming the path.
  void save(const std::filesystem::path& path, PictureKind kind);

 private:
  struct Page;
  std::unique_ptr<Page> page_;
};

}  // namespace surefoot::report
