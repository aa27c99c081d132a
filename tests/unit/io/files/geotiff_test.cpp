// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/geotiff_writer.hpp"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <stdexcept>

namespace surefoot::io {
namespace {

/// A second reading of TIFF 6.0: fields by their tags, strips as they lie.
class TiffReading {
 public:
  explicit TiffReading(const std::string& bytes) : bytes_(bytes) {
    EXPECT_EQ(bytes.substr(0, 4), std::string("II\x2a\0", 4));
    const auto directory = get<std::uint32_t>(4);
    EXPECT_EQ(directory % 2, 0U);
    const auto count = get<std::uint16_t>(directory);
    int last = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = directory + 2 + 12 * i;
      const int tag = get<std::uint16_t>(at);
      EXPECT_GT(tag, last);
      last = tag;
      fields_[tag] = at;
    }
  }
  template <typename T>
  T value(int tag, std::size_t index = 0) const {
    constexpr std::size_t kSizes[] = {0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8};
    const std::size_t at = fields_.at(tag);
    const std::size_t size = kSizes[get<std::uint16_t>(at + 2)];
    EXPECT_EQ(size, sizeof(T)) << tag;
    const std::size_t count = get<std::uint32_t>(at + 4);
    EXPECT_LT(index, count);
    return get<T>((size * count <= 4 ? at + 8 : get<std::uint32_t>(at + 8)) + size * index);
  }
  [[nodiscard]] std::vector<float> band(std::size_t index) const {
    const auto width = value<std::uint32_t>(256), height = value<std::uint32_t>(257);
    const auto rows = value<std::uint32_t>(278);
    const std::size_t strips = (height + rows - 1) / rows;
    std::vector<float> cells(static_cast<std::size_t>(width) * height);
    libdeflate_decompressor* inflate = libdeflate_alloc_decompressor();
    for (std::size_t strip = 0; strip < strips; ++strip) {
      const std::size_t first = strip * rows * width;
      const std::size_t expected = std::min<std::size_t>(rows * width, cells.size() - first);
      const auto offset = value<std::uint32_t>(273, index * strips + strip);
      const auto size = value<std::uint32_t>(279, index * strips + strip);
      EXPECT_EQ(libdeflate_zlib_decompress(inflate, bytes_.data() + offset, size, &cells[first],
                                           4 * expected, nullptr),
                LIBDEFLATE_SUCCESS);
    }
    libdeflate_free_decompressor(inflate);
    return cells;
  }

 private:
  template <typename T>
  T get(std::size_t at) const {
    T value{};
    if (at + sizeof(T) > bytes_.size()) throw std::out_of_range("beyond the file");
    std::memcpy(&value, bytes_.data() + at, sizeof(T));
    return value;
  }
  const std::string& bytes_;
  std::map<int, std::size_t> fields_;
};

TEST(GeoTiffTest, BandsAreReadBackFromTheNorthWestCorner) {
  constexpr int kWidth = 1000, kHeight = 700;  // several strips
  std::vector<float> heights, variances(kWidth * kHeight, 0.25F);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) heights.push_back(static_cast<float>(x + 10000 * y));
  }
  heights[3] = std::numeric_limits<float>::quiet_NaN();
  const std::string bytes = format_geotiff(
      {kWidth, kHeight, 0.5, -20.0, 30.0, {{"elevation", heights}, {"variance", variances}}});
  const TiffReading tiff(bytes);
  EXPECT_EQ(tiff.value<std::uint32_t>(256), 1000U);
  EXPECT_EQ(tiff.value<std::uint32_t>(257), 700U);
  EXPECT_EQ(tiff.value<std::uint16_t>(277), 2U);
  EXPECT_EQ(tiff.value<double>(33550, 1), 0.5);
  EXPECT_EQ(tiff.value<double>(33922, 3), -20.0);
  EXPECT_EQ(tiff.value<double>(33922, 4), 380.0);  // the image begins in the north
  const std::vector<float> read = tiff.band(0);
  EXPECT_EQ(read[5], static_cast<float>(5 + 10000 * (kHeight - 1)));
  EXPECT_EQ(read[kWidth * (kHeight - 1) + 7], 7.0F);
  EXPECT_TRUE(std::isnan(read[kWidth * (kHeight - 1) + 3]));
  EXPECT_EQ(tiff.band(1), variances);
  EXPECT_NE(bytes.find("role=\"description\">variance<"), std::string::npos);
}

TEST(GeoTiffTest, OneCellIsWrittenAndNoneRefused) {
  const std::vector<float> one = {2.5F};
  const std::string bytes = format_geotiff({1, 1, 0.2, 0.0, 0.0, {{"elevation", one}}});
  EXPECT_EQ(TiffReading(bytes).band(0), one);
  EXPECT_THROW((void)format_geotiff({0, 0, 0.2, 0.0, 0.0, {{"elevation", {}}}}),
               std::invalid_argument);
}

}  // namespace
}  // namespace surefoot::io
