// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/geotiff_writer.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

#include "io/file_writer.hpp"

namespace surefoot::io {

namespace {

constexpr std::uint16_t kShort = 3, kLong = 4, kText = 2, kDouble = 12;  // TIFF 6.0, section 2
constexpr std::size_t kTiffHeader = 8;
constexpr int kStripCells = 1 << 18;  // about a megabyte of floats

/// The numbers of one field, however many.
struct TiffField {
  std::uint16_t tag = 0, type = 0;
  std::uint32_t count = 0;
  std::string bytes;
};

template <typename T>
TiffField tiff_field(std::uint16_t tag, std::uint16_t type, const std::vector<T>& values) {
  TiffField field{tag, type, static_cast<std::uint32_t>(values.size()), {}};
  for (const T value : values) append_bytes(field.bytes, value);
  return field;
}
TiffField tiff_text(std::uint16_t tag, const std::string& text) {
  return {tag, kText, static_cast<std::uint32_t>(text.size() + 1), text + '\0'};
}

/// Rows from the highest y on, as images begin.
class StripWriter {
 public:
  StripWriter(const GeoTiffRaster& raster, std::string& out)
      : raster_(raster),
        out_(out),
        deflate_(libdeflate_alloc_compressor(6), &libdeflate_free_compressor),
        rows_(std::clamp(kStripCells / raster.width, 1, raster.height)) {
    if (!deflate_) throw std::bad_alloc();
  }

  void write(const GeoTiffRaster::Band& band) {
    const auto width = static_cast<std::size_t>(raster_.width);
    for (int first = 0; first < raster_.height; first += rows_) {
      std::vector<float> cells;
      const int last = std::min(first + rows_, raster_.height);
      for (int row = first; row < last; ++row) {
        const auto from =
            band.values.subspan(static_cast<std::size_t>(raster_.height - 1 - row) * width, width);
        cells.insert(cells.end(), from.begin(), from.end());
      }
      append_strip(cells);
    }
  }
  [[nodiscard]] int rows() const { return rows_; }
  [[nodiscard]] const std::vector<std::uint32_t>& offsets() const { return offsets_; }
  [[nodiscard]] const std::vector<std::uint32_t>& sizes() const { return sizes_; }

 private:
  void append_strip(const std::vector<float>& cells) {
    const std::size_t bytes = cells.size() * sizeof(float);
    std::string packed(libdeflate_zlib_compress_bound(deflate_.get(), bytes), '\0');
    packed.resize(libdeflate_zlib_compress(deflate_.get(), cells.data(), bytes, packed.data(),
                                           packed.size()));
    if (packed.size() + out_.size() > std::numeric_limits<std::uint32_t>::max() - (1U << 20U)) {
      throw std::invalid_argument("a GeoTIFF of more than 4 GB: expected larger cells");
    }
    offsets_.push_back(static_cast<std::uint32_t>(out_.size()));
    sizes_.push_back(static_cast<std::uint32_t>(packed.size()));
    out_ += packed;
  }

  const GeoTiffRaster& raster_;
  std::string& out_;
  std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> deflate_;
  int rows_;
  std::vector<std::uint32_t> offsets_, sizes_;
};

std::string gdal_metadata(const GeoTiffRaster& raster) {
  std::string text = "<GDALMetadata>\n";
  for (std::size_t i = 0; i < raster.bands.size(); ++i) {
    text += "  <Item name=\"DESCRIPTION\" sample=\"" + std::to_string(i) +
            "\" role=\"description\">" + raster.bands[i].name + "</Item>\n";
  }
  return text + "</GDALMetadata>\n";
}

/// By rising tag, as TIFF demands.
std::vector<TiffField> fields_of(const GeoTiffRaster& raster, const StripWriter& strips) {
  const auto count = static_cast<std::uint16_t>(raster.bands.size());
  const double high_y = raster.low_y + raster.cell * raster.height;
  const std::vector<std::uint16_t> keys = {
      1,    1, 0, 4,      // version 1.1, four keys:
      1024, 0, 1, 1,      // the model is a projection,
      1025, 0, 1, 1,      // a value is that of an area,
      3072, 0, 1, 32767,  // the projection is the user's own: a map's frame,
      3076, 0, 1, 9001};  // in metres
  return {
      tiff_field(256, kLong, std::vector{static_cast<std::uint32_t>(raster.width)}),
      tiff_field(257, kLong, std::vector{static_cast<std::uint32_t>(raster.height)}),
      tiff_field(258, kShort, std::vector<std::uint16_t>(count, 32)),
      tiff_field(259, kShort, std::vector<std::uint16_t>{8}),  // deflate
      tiff_field(262, kShort, std::vector<std::uint16_t>{1}),  // more is brighter
      tiff_field(273, kLong, strips.offsets()),
      tiff_field(277, kShort, std::vector{count}),
      tiff_field(278, kLong, std::vector{static_cast<std::uint32_t>(strips.rows())}),
      tiff_field(279, kLong, strips.sizes()),
      tiff_field(284, kShort, std::vector<std::uint16_t>{2}),  // band by band
      tiff_field(338, kShort, std::vector<std::uint16_t>(count - 1U, 0)),
      tiff_field(339, kShort, std::vector<std::uint16_t>(count, 3)),  // floats
      tiff_field(33550, kDouble, std::vector{raster.cell, raster.cell, 0.0}),
      tiff_field(33922, kDouble, std::vector{0.0, 0.0, 0.0, raster.low_x, high_y, 0.0}),
      tiff_field(34735, kShort, keys),
      tiff_text(42112, gdal_metadata(raster)),
      tiff_text(42113, "nan"),
  };
}

void append_directory(std::string& out, std::vector<TiffField> fields) {
  std::erase_if(fields, [](const TiffField& field) { return field.count == 0; });
  if (out.size() % 2 == 1) out += '\0';
  const auto begin = static_cast<std::uint32_t>(out.size());
  out.replace(4, 4, std::string(reinterpret_cast<const char*>(&begin), 4));
  std::string behind;
  const std::size_t behind_at = begin + 2 + 12 * fields.size() + 4;
  append_bytes(out, static_cast<std::uint16_t>(fields.size()));
  for (TiffField& field : fields) {
    append_bytes(out, field.tag);
    append_bytes(out, field.type);
    append_bytes(out, field.count);
    if (field.bytes.size() <= 4) {
      field.bytes.resize(4, '\0');
      out += field.bytes;
    } else {
      append_bytes(out, static_cast<std::uint32_t>(behind_at + behind.size()));
      behind += field.bytes;
      if (behind.size() % 2 == 1) behind += '\0';
    }
  }
  append_bytes(out, std::uint32_t{0});  // no other directory
  out += behind;
}

}  // namespace

std::string format_geotiff(const GeoTiffRaster& raster) {
  if (raster.width <= 0 || raster.height <= 0 || raster.bands.empty()) {
    throw std::invalid_argument("no cell to write, for GeoTIFF");
  }
  std::string out("II\x2a\0", 4);
  out.resize(kTiffHeader, '\0');  // where the directory is: filled in when it is known
  StripWriter strips(raster, out);
  for (const GeoTiffRaster::Band& band : raster.bands) strips.write(band);
  append_directory(out, fields_of(raster, strips));
  return out;
}

}  // namespace surefoot::io
