// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace surefoot::io {

/// Layers of numbers over one square, in some frame in metres.
struct GeoTiffRaster {
  struct Band {
    std::string name;               ///< letters, digits and underscores
    std::span<const float> values;  ///< row by row, the lowest y first; NaN: none
  };
  int width = 0, height = 0;  ///< cells
  double cell = 1.0;          ///< [m]
  double low_x = 0.0;         ///< outer corner of the first cell [m]
  double low_y = 0.0;
  std::vector<Band> bands;
};

/// As GeoTIFF (OGC 19-008r4) of 32-bit floats, band by band, deflated; names and the missing value
/// as GDAL writes them. Throws std::invalid_argument where there is no cell, or more than a TIFF of
/// 4 GB holds.
[[nodiscard]] std::string format_geotiff(const GeoTiffRaster& raster);

}  // namespace surefoot::io
