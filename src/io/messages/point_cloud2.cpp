// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/point_cloud2.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "io/recording.hpp"

namespace surefoot::io {
namespace {

// sensor_msgs/PointField: INT8 = 1 ... FLOAT64 = 8.
constexpr std::array<ScalarType, 8> kDatatypes = {ScalarType::i8,  ScalarType::u8,  ScalarType::i16,
                                                  ScalarType::u16, ScalarType::i32, ScalarType::u32,
                                                  ScalarType::f32, ScalarType::f64};

// A name, and three numbers.
constexpr std::size_t kLeastFieldBytes = 13;
constexpr std::uint64_t kMostFields = 1000;

struct Shape {
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::uint32_t point_step = 0;
  std::uint32_t row_step = 0;
};

struct ReadField {
  Column column;
  std::uint32_t offset = 0;
};

std::optional<ReadField> read_field(MessageReader& reader) {
  ReadField field;
  reader.begin_structure();
  field.column.name = reader.string("field's name");
  field.offset = reader.number<std::uint32_t>("field's offset");
  const auto datatype = reader.number<std::uint8_t>("field's type");
  // Drivers write 0 where they mean 1.
  field.column.count = std::max(1U, reader.number<std::uint32_t>("field's count"));
  if (datatype < 1 || datatype > kDatatypes.size()) return std::nullopt;  // a driver's own
  field.column.type = kDatatypes[datatype - 1U];
  return field;
}

// The points without what rows are padded with. Data that is no larger than its points has no
// padding, whatever the row step says: drivers write the size of all data there.
std::span<const std::byte> without_row_padding(std::span<const std::byte> data, const Shape& shape,
                                               std::vector<std::byte>& storage) {
  const std::uint64_t row_bytes = std::uint64_t{shape.width} * shape.point_step;
  if (shape.height <= 1 || shape.row_step <= row_bytes) return data;
  if (data.size() == shape.height * row_bytes) return data;
  for (std::uint32_t row = 0; row < shape.height; ++row) {
    const std::uint64_t begin = std::uint64_t{row} * shape.row_step;
    if (begin + row_bytes > data.size()) break;
    const auto bytes = data.subspan(begin, row_bytes);
    storage.insert(storage.end(), bytes.begin(), bytes.end());
  }
  return storage;
}

}  // namespace

CloudMessage read_point_cloud2(MessageReader& reader) {
  CloudMessage cloud;
  reader.begin_structure();
  const MessageHeader header = read_header(reader);
  cloud.stamp_ns = header.stamp_ns;
  cloud.frame = header.frame;
  Shape shape;
  shape.height = reader.number<std::uint32_t>("height");
  shape.width = reader.number<std::uint32_t>("width");
  std::vector<ReadField> fields;
  const std::uint64_t count = reader.structures("fields", kLeastFieldBytes);
  if (count > kMostFields) {
    throw ReadError(std::to_string(count) + " fields; expected at most " +
                    std::to_string(kMostFields));
  }
  for (std::uint64_t left = count; left > 0; --left) {
    if (auto field = read_field(reader)) fields.push_back(std::move(*field));
  }
  const bool big_endian = reader.number<std::uint8_t>("byte order") != 0;
  shape.point_step = reader.number<std::uint32_t>("point step");
  shape.row_step = reader.number<std::uint32_t>("row step");
  const auto size = reader.count("bytes of points", 1);
  const std::span<const std::byte> data =
      without_row_padding(reader.take(size, "points"), shape, cloud.table.storage);
  if (big_endian) {
    throw ReadError("the points are big-endian (is_bigendian is set); expected little-endian");
  }
  const std::uint64_t points = std::uint64_t{shape.height} * shape.width;
  if (points > 0 && (shape.point_step == 0 || data.size() / shape.point_step < points)) {
    throw ReadError(std::to_string(shape.height) + " x " + std::to_string(shape.width) +
                    " points of " + std::to_string(shape.point_step) + " bytes do not fit into " +
                    std::to_string(data.size()) + " bytes");
  }
  cloud.table.format = "PointCloud2";
  cloud.table.size = static_cast<std::size_t>(points);
  for (ReadField& field : fields) {
    const std::size_t element = size_of(field.column.type);
    // Of no points drivers write no step.
    if (points > 0 && std::uint64_t{field.offset} + element > shape.point_step) {
      throw ReadError("field '" + field.column.name + "' at byte " + std::to_string(field.offset) +
                      " of points of " + std::to_string(shape.point_step) + " bytes");
    }
    const std::uint32_t room = std::max(shape.point_step, field.offset) - field.offset;
    if (field.column.count > room / element) field.column.count = 1;
    field.column.first = points > 0 ? data.data() + field.offset : nullptr;
    field.column.stride = shape.point_step;
    cloud.table.columns.push_back(std::move(field.column));
  }
  return cloud;
}

}  // namespace surefoot::io
