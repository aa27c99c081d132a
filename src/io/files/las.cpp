// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/las.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>

#include "io/file_writer.hpp"
#include "io/recording.hpp"

namespace surefoot::io {
namespace {

constexpr std::size_t kShortestHeader = 227;  // of LAS 1.0 to 1.2
constexpr std::size_t kHeader14 = 375;
// Sensors see no farther than this from their own origin [m].
constexpr double kGridOffset = 10'000.0;
// The least size of a point's record by its format (ASPRS LAS 1.4 R15, tables 7 to 17).
constexpr std::array<std::uint16_t, 11> kRecordBytes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr bool kSwapped = std::endian::native != std::endian::little;

struct LasHeader {
  int minor = 0;
  unsigned format = 0;
  std::size_t first = 0;   // of the points [bytes]
  std::size_t record = 0;  // size of one [bytes]
  std::uint64_t count = 0;
  std::array<double, 3> scale{}, offset{};
};

template <typename T>
T at(std::span<const std::byte> file, std::size_t place) {
  return load<T>(file.data() + place, kSwapped);
}

[[noreturn]] void fail(const std::string& what) { throw ReadError("LAS: " + what); }

void check(const LasHeader& header, std::size_t bytes) {
  if (header.format & 0xc0U) {
    fail("its points are compressed (LAZ), which is not read here; laszip -i IN.laz -o OUT.las");
  }
  if (header.format >= kRecordBytes.size()) {
    fail("point format " + std::to_string(header.format) + "; expected 0 to 10");
  }
  if (header.record < kRecordBytes[header.format]) {
    fail("records of " + std::to_string(header.record) + " bytes; expected at least " +
         std::to_string(kRecordBytes[header.format]) + " of point format " +
         std::to_string(header.format));
  }
  const bool fits = header.first >= kShortestHeader && header.first <= bytes &&
                    header.count <= (bytes - header.first) / header.record;
  if (!fits) {
    fail(std::to_string(header.count) + " points of " + std::to_string(header.record) +
         " bytes from " + std::to_string(header.first) + " on; the file has " +
         std::to_string(bytes) + " bytes");
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (!(header.scale[i] > 0.0 && header.scale[i] < 1e3 && std::isfinite(header.offset[i]))) {
      fail("a scale of " + std::to_string(header.scale[i]) + " and an offset of " +
           std::to_string(header.offset[i]) + "; expected some millimetres and metres");
    }
  }
}

LasHeader read_header(std::span<const std::byte> file) {
  if (file.size() < kShortestHeader || std::memcmp(file.data(), "LASF", 4) != 0) {
    fail("no header of a LAS file (LASF)");
  }
  LasHeader header;
  header.minor = at<std::uint8_t>(file, 25);
  const int major = at<std::uint8_t>(file, 24);
  if (major != 1 || header.minor > 4) {
    fail("version " + std::to_string(major) + "." + std::to_string(header.minor) +
         "; expected 1.0 to 1.4");
  }
  header.first = at<std::uint32_t>(file, 96);
  header.format = at<std::uint8_t>(file, 104);
  header.record = at<std::uint16_t>(file, 105);
  header.count = at<std::uint32_t>(file, 107);
  if (header.minor >= 4 && file.size() >= kHeader14 && at<std::uint64_t>(file, 247) > 0) {
    header.count = at<std::uint64_t>(file, 247);
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.scale[axis] = at<double>(file, 131 + 8 * axis);
    header.offset[axis] = at<double>(file, 155 + 8 * axis);
  }
  check(header, file.size());
  return header;
}

bool is_left_out(double offset) { return std::abs(offset) >= kGridOffset; }

/// "500000 0 120 m" of the axes' offsets that are left out; empty: none is.
std::string left_out(const std::array<double, 3>& offset) {
  if (std::none_of(offset.begin(), offset.end(), is_left_out)) return {};
  std::string text;
  for (const double value : offset) {
    append_fixed(text, is_left_out(value) ? value : 0.0, 3);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    text += ' ';
  }
  return text + 'm';
}

// The coordinates, as doubles, one axis after the other.
std::vector<std::byte> coordinates(std::span<const std::byte> file, const LasHeader& header) {
  const auto count = static_cast<std::size_t>(header.count);
  std::vector<std::byte> storage(3 * count * sizeof(double));
  std::byte* out = storage.data();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double offset = is_left_out(header.offset[axis]) ? 0.0 : header.offset[axis];
    const std::byte* in = file.data() + header.first + 4 * axis;
    for (std::size_t i = 0; i < count; ++i, in += header.record, out += sizeof(double)) {
      const double value = header.scale[axis] * load<std::int32_t>(in, kSwapped) + offset;
      std::memcpy(out, &value, sizeof(value));
    }
  }
  return storage;
}

}  // namespace

PointTable parse_las(std::span<const std::byte> file) {
  const LasHeader header = read_header(file);
  PointTable table;
  table.format =
      "LAS 1." + std::to_string(header.minor) + ", point format " + std::to_string(header.format);
  if (const std::string offset = left_out(header.offset); !offset.empty()) {
    table.format += ", without the offset " + offset;
    // Without the numbers, which each of many files has of its own.
    table.lost = "the offset of a file's grid (10 km or more): its points are moved by it";
  }
  table.size = static_cast<std::size_t>(header.count);
  table.storage = coordinates(file, header);
  const std::array<const char*, 3> names = {"x", "y", "z"};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    table.columns.push_back({names[axis], ScalarType::f64,
                             table.storage.data() + axis * table.size * sizeof(double),
                             sizeof(double), false});
  }
  const std::byte* first = file.data() + header.first;
  table.columns.push_back({"intensity", ScalarType::u16, first + 12, header.record, kSwapped});
  const bool timed = header.format != 0 && header.format != 2;
  const std::size_t place = header.format < 6 ? 20 : 22;
  if (timed) {
    table.columns.push_back({"time", ScalarType::f64, first + place, header.record, kSwapped});
  }
  return table;
}

}  // namespace surefoot::io
