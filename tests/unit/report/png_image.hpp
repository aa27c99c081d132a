// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A PNG file's pixels, for tests that look at what was drawn.
#pragma once

#include <cairo.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>

namespace surefoot::report {

class PngImage {
 public:
  explicit PngImage(const std::filesystem::path& path)
      : surface_(cairo_image_surface_create_from_png(path.c_str())) {}
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { cairo_surface_destroy(surface_); }

  [[nodiscard]] bool valid() const {
    return cairo_surface_status(surface_) == CAIRO_STATUS_SUCCESS;
  }
  [[nodiscard]] int width() const { return cairo_image_surface_get_width(surface_); }
  [[nodiscard]] int height() const { return cairo_image_surface_get_height(surface_); }
  [[nodiscard]] std::uint32_t at(int x, int y) const {
    const unsigned char* row = cairo_image_surface_get_data(surface_) +
                               std::ptrdiff_t{y} * cairo_image_surface_get_stride(surface_);
    return reinterpret_cast<const std::uint32_t*>(row)[x] & 0xFFFFFFU;
  }
  /// Pixels of this colour, 0xRRGGBB, or one that the eye cannot tell from it.
  [[nodiscard]] int count(std::uint32_t rgb) const {
    int found = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) found += is_near(at(x, y), rgb) ? 1 : 0;
    }
    return found;
  }

 private:
  static bool is_near(std::uint32_t a, std::uint32_t b) {
    for (const int shift : {0, 8, 16}) {
      const int difference =
          static_cast<int>(a >> shift & 0xFFU) - static_cast<int>(b >> shift & 0xFFU);
      if (difference < -2 || difference > 2) return false;
    }
    return true;
  }

  cairo_surface_t* surface_;
};

}  // namespace surefoot::report
