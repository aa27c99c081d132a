// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/point_cloud2_writer.hpp"

#include <algorithm>

namespace surefoot::io {
namespace {

// sensor_msgs/PointField's number of a type; 0: it has none.
std::uint8_t datatype_of(ScalarType type) {
  switch (type) {
    case ScalarType::i8:
      return 1;
    case ScalarType::u8:
      return 2;
    case ScalarType::i16:
      return 3;
    case ScalarType::u16:
      return 4;
    case ScalarType::i32:
      return 5;
    case ScalarType::u32:
      return 6;
    case ScalarType::f32:
      return 7;
    case ScalarType::f64:
      return 8;
    default:
      return 0;
  }
}

}  // namespace

bool fits_point_cloud2(const Column& column) { return datatype_of(column.type) != 0; }

std::string format_point_cloud2(const CloudHead& head, std::span<const Column> columns,
                                std::size_t points, MessageWriter::Flavour flavour) {
  const auto width = static_cast<std::uint32_t>(points);
  const auto step = static_cast<std::uint32_t>(point_bytes(columns));
  MessageWriter message(flavour);
  message.header(head.stamp_ns, head.frame).number(std::uint32_t{1}).number(width);
  message.count(columns.size());
  std::uint32_t offset = 0;
  for (const Column& column : columns) {
    message.string(column.name).number(offset);
    message.number(datatype_of(column.type)).number(static_cast<std::uint32_t>(column.count));
    offset += static_cast<std::uint32_t>(point_bytes({&column, 1}));
  }
  message.number(std::uint8_t{0}).number(step).number(step * width);
  std::string rows;
  append_points(rows, columns, points);
  message.count(rows.size()).raw(rows);
  return message.number(static_cast<std::uint8_t>(head.dense ? 1 : 0)).take();
}

std::string format_point_cloud2(const Scan& scan, std::string_view frame,
                                MessageWriter::Flavour flavour) {
  return format_point_cloud2({scan.stamp_ns, frame, is_dense(scan)}, written_columns(scan),
                             scan.points.size(), flavour);
}

bool is_dense(const Scan& scan) {
  return std::all_of(scan.points.begin(), scan.points.end(),
                     [](const Eigen::Vector3f& point) { return point.allFinite(); });
}

}  // namespace surefoot::io
