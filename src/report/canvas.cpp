// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/canvas.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "report/picture_mark.hpp"
#include "text/printable.hpp"

namespace surefoot::report {

namespace {

cairo_status_t append(void* sink, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void set_source(cairo_t* cairo, const Color& color) {
  cairo_set_source_rgba(cairo, color.red, color.green, color.blue, color.alpha);
}

/// Lengths of strokes and gaps, in line widths.
std::vector<double> dashes_of(LineStyle style) {
  switch (style) {
    case LineStyle::dashed:
      return {3.5, 2.5};
    case LineStyle::dotted:
      return {1.2, 1.6};
    case LineStyle::dash_dotted:
      return {5.0, 1.8, 1.2, 1.8};
    case LineStyle::long_dashed:
      return {8.0, 2.5};
    case LineStyle::solid:
      break;
  }
  return {};
}

void stroke_path(cairo_t* cairo, const Stroke& stroke) {
  set_source(cairo, stroke.color);
  cairo_set_line_width(cairo, stroke.width);
  std::vector<double> dashes = dashes_of(stroke.style);
  for (double& dash : dashes) dash *= stroke.width;
  cairo_set_dash(cairo, dashes.data(), static_cast<int>(dashes.size()), 0.0);
  cairo_stroke(cairo);
}

void set_font(cairo_t* cairo, const TextStyle& style) {
  cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo, style.size);
}

cairo_surface_t* make_surface(PageFormat format, std::string& bytes, int width, int height,
                              int scale) {
  switch (format) {
    case PageFormat::svg:
      return cairo_svg_surface_create_for_stream(append, &bytes, width, height);
    case PageFormat::pdf:
      return cairo_pdf_surface_create_for_stream(append, &bytes, width, height);
    case PageFormat::png:
      break;
  }
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, scale * width, scale * height);
}

}  // namespace

struct Canvas::Page {
  std::string bytes;  // filled by cairo when an SVG or PDF page is finished
  cairo_surface_t* surface = nullptr;
  cairo_t* cairo = nullptr;
  PageFormat format;

  Page(int width, int height, PageFormat page_format, int scale)
      : surface(make_surface(page_format, bytes, width, height, scale)),
        cairo(cairo_create(surface)),
        format(page_format) {
    if (format == PageFormat::png) cairo_scale(cairo, scale, scale);
  }
  Page(const Page&) = delete;
  Page& operator=(const Page&) = delete;
  ~Page() {
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
  }
};

PageFormat page_format_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  if (extension == ".png") return PageFormat::png;
  if (extension == ".svg") return PageFormat::svg;
  if (extension == ".pdf") return PageFormat::pdf;
  throw std::runtime_error(path.string() +
                           ": a picture's name ends in .png, .svg or .pdf, not in \"" + extension +
                           "\"");
}

Canvas::Canvas(int width, int height, PageFormat format, int scale)
    : page_(std::make_unique<Page>(width, height, format, scale)) {
  cairo_set_line_join(page_->cairo, CAIRO_LINE_JOIN_ROUND);
  fill({0.0, 0.0, static_cast<double>(width), static_cast<double>(height)}, {1.0, 1.0, 1.0});
}

Canvas::~Canvas() = default;

void Canvas::fill(const Rect& rect, const Color& color) {
  cairo_rectangle(page_->cairo, rect.x, rect.y, rect.width, rect.height);
  set_source(page_->cairo, color);
  cairo_fill(page_->cairo);
}

void Canvas::outline(const Rect& rect, const Stroke& stroke) {
  cairo_rectangle(page_->cairo, rect.x, rect.y, rect.width, rect.height);
  stroke_path(page_->cairo, stroke);
}

void Canvas::line(std::span<const Pixel> points, const Stroke& stroke) {
  for (const Pixel& point : points) cairo_line_to(page_->cairo, point.x(), point.y());
  stroke_path(page_->cairo, stroke);
}

void Canvas::polygon(std::span<const Pixel> corners, const Color& fill, const Stroke& edge) {
  for (const Pixel& point : corners) cairo_line_to(page_->cairo, point.x(), point.y());
  cairo_close_path(page_->cairo);
  set_source(page_->cairo, fill);
  cairo_fill_preserve(page_->cairo);
  stroke_path(page_->cairo, edge);
}

void Canvas::circle(const Pixel& center, double radius, const Color& fill, const Stroke& edge) {
  cairo_new_path(page_->cairo);
  cairo_arc(page_->cairo, center.x(), center.y(), radius, 0.0, 2.0 * std::numbers::pi);
  set_source(page_->cairo, fill);
  cairo_fill_preserve(page_->cairo);
  stroke_path(page_->cairo, edge);
}

void Canvas::triangle(const Pixel& center, double radius, const Color& fill, const Stroke& edge) {
  const double half_side = radius * std::numbers::sqrt3 / 2.0;
  cairo_move_to(page_->cairo, center.x(), center.y() - radius);
  cairo_line_to(page_->cairo, center.x() + half_side, center.y() + 0.5 * radius);
  cairo_line_to(page_->cairo, center.x() - half_side, center.y() + 0.5 * radius);
  cairo_close_path(page_->cairo);
  set_source(page_->cairo, fill);
  cairo_fill_preserve(page_->cairo);
  stroke_path(page_->cairo, edge);
}

void Canvas::image(const Raster& raster, const Rect& rect, double opacity) {
  cairo_surface_t* picture =
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, raster.width, raster.height);
  const int stride = cairo_image_surface_get_stride(picture);
  unsigned char* rows = cairo_image_surface_get_data(picture);
  for (int row = 0; rows != nullptr && row < raster.height; ++row) {
    const std::uint32_t* from = raster.argb.data() + std::ptrdiff_t{row} * raster.width;
    std::copy(from, from + raster.width,
              reinterpret_cast<std::uint32_t*>(rows + std::ptrdiff_t{row} * stride));
  }
  cairo_surface_mark_dirty(picture);
  cairo_save(page_->cairo);
  cairo_translate(page_->cairo, rect.x, rect.y);
  cairo_scale(page_->cairo, rect.width / raster.width, rect.height / raster.height);
  cairo_set_source_surface(page_->cairo, picture, 0.0, 0.0);
  // Enlarged pixels keep their colour up to the rectangle's border.
  cairo_pattern_set_extend(cairo_get_source(page_->cairo), CAIRO_EXTEND_PAD);
  cairo_rectangle(page_->cairo, 0.0, 0.0, raster.width, raster.height);
  cairo_clip(page_->cairo);
  cairo_paint_with_alpha(page_->cairo, opacity);
  cairo_restore(page_->cairo);
  cairo_surface_destroy(picture);
}

void Canvas::text(const std::string& text, const Pixel& at, const TextStyle& style) {
  const double width = text_width(text, style);
  const double shift = style.anchor == Anchor::left     ? 0.0
                       : style.anchor == Anchor::center ? -0.5 * width
                                                        : -width;
  cairo_save(page_->cairo);
  cairo_translate(page_->cairo, at.x(), at.y());
  if (style.upward) cairo_rotate(page_->cairo, -0.5 * std::numbers::pi);
  cairo_move_to(page_->cairo, shift, 0.0);
  set_source(page_->cairo, style.color);
  // cairo drops everything drawn after text that is not UTF-8.
  cairo_show_text(page_->cairo, text::printable(text).c_str());
  cairo_new_path(page_->cairo);
  cairo_restore(page_->cairo);
}

double Canvas::text_width(const std::string& text, const TextStyle& style) {
  set_font(page_->cairo, style);
  cairo_text_extents_t extents;
  cairo_text_extents(page_->cairo, text::printable(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::clip(const Rect& rect) {
  cairo_save(page_->cairo);
  cairo_rectangle(page_->cairo, rect.x, rect.y, rect.width, rect.height);
  cairo_clip(page_->cairo);
}

void Canvas::unclip() { cairo_restore(page_->cairo); }

Raster Canvas::raster() const {
  cairo_surface_flush(page_->surface);
  const int width = cairo_image_surface_get_width(page_->surface);
  const int height = cairo_image_surface_get_height(page_->surface);
  const int stride = cairo_image_surface_get_stride(page_->surface);
  const unsigned char* rows = cairo_image_surface_get_data(page_->surface);
  Raster raster{width, height, {}};
  raster.argb.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; rows != nullptr && row < height; ++row) {
    const auto* from = reinterpret_cast<const std::uint32_t*>(rows + std::ptrdiff_t{row} * stride);
    std::transform(from, from + width, std::back_inserter(raster.argb),
                   [](std::uint32_t pixel) { return pixel | 0xff000000U; });
  }
  return raster;
}

void Canvas::save(const std::filesystem::path& path, PictureKind kind) {
  std::string bytes;
  cairo_status_t status = cairo_status(page_->cairo);
  if (status == CAIRO_STATUS_SUCCESS) {
    if (cairo_surface_get_type(page_->surface) != CAIRO_SURFACE_TYPE_IMAGE) {
      cairo_surface_finish(page_->surface);
      status = cairo_surface_status(page_->surface);
      bytes = std::move(page_->bytes);
    } else {
      status = cairo_surface_write_to_png_stream(page_->surface, append, &bytes);
    }
  }
  if (status != CAIRO_STATUS_SUCCESS) {
    throw std::runtime_error(path.string() +
                             ": cannot draw the picture: " + cairo_status_to_string(status));
  }
  bytes = with_mark(std::move(bytes), page_->format, kind);
  write_picture(path, bytes);
}

}  // namespace surefoot::report
