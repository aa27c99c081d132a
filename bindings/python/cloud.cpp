// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "cloud.hpp"

#include <pybind11/stl.h>

#include <stdexcept>

#include "arrays.hpp"
#include "io/point_table.hpp"
#include "io/point_time.hpp"
#include "io/scan_builder.hpp"
#include "reading.hpp"

namespace surefoot::python {

namespace {

std::optional<io::ScalarType> scalar_type(const py::dtype& type) {
  using io::ScalarType;
  const bool is_signed = type.kind() == 'i';
  if (type.kind() == 'f') {
    if (type.itemsize() == 4) return ScalarType::f32;
    if (type.itemsize() == 8) return ScalarType::f64;
  } else if (type.kind() == 'i' || type.kind() == 'u') {
    switch (type.itemsize()) {
      case 1:
        return is_signed ? ScalarType::i8 : ScalarType::u8;
      case 2:
        return is_signed ? ScalarType::i16 : ScalarType::u16;
      case 4:
        return is_signed ? ScalarType::i32 : ScalarType::u32;
      case 8:
        return is_signed ? ScalarType::i64 : ScalarType::u64;
      default:
        break;
    }
  }
  return std::nullopt;
}

/// The array's fields as columns that look into it.
io::PointTable table_of(const py::array& cloud) {
  const py::object names = cloud.dtype().attr("names");
  if (names.is_none() || cloud.ndim() != 1) {
    throw std::invalid_argument("cloud: got an array " + shape_of(cloud) +
                                ", expected a structured one (N,) with fields x, y, z");
  }
  io::PointTable table;
  table.size = static_cast<std::size_t>(cloud.shape(0));
  table.format = "array";
  const py::object fields = cloud.dtype().attr("fields");
  for (const py::handle& name : names) {
    const py::tuple field = fields[name];
    const py::dtype type = field[0];
    const std::optional<io::ScalarType> scalar = scalar_type(type);
    if (!scalar) continue;  // padding, or no number: of no use here
    io::Column column;
    column.name = py::str(name);
    column.type = *scalar;
    column.first = static_cast<const std::byte*>(cloud.data()) + field[1].cast<std::size_t>();
    column.stride = static_cast<std::size_t>(cloud.strides(0));
    column.swapped = type.byteorder() == '>';
    table.columns.push_back(column);
  }
  return table;
}

bool is_plain(const io::Column* column, io::ScalarType type) {
  return column != nullptr && column->type == type && !column->swapped;
}

/// Rings that numpy converts as build_scan() does.
bool are_ring_numbers(const io::Column* column) {
  return column == nullptr || column->type == io::ScalarType::u8 ||
         column->type == io::ScalarType::u16;
}

bool are_beside(const io::ScanColumns& columns) {
  const auto follows = [](const io::Column* a, const io::Column* b) {
    return b->first - a->first == static_cast<std::ptrdiff_t>(sizeof(float));
  };
  return is_plain(columns.x, io::ScalarType::f32) && is_plain(columns.y, io::ScalarType::f32) &&
         is_plain(columns.z, io::ScalarType::f32) && follows(columns.x, columns.y) &&
         follows(columns.y, columns.z);
}

/// An array that looks into the cloud's column, converted if it is of another type.
template <typename Number>
py::array look_into(const py::array& cloud, const io::Column* column) {
  if (column == nullptr) return py::array_t<Number>(0);
  const py::object field = cloud[py::str(column->name)];
  return py::array_t<Number, py::array::forcecast>::ensure(field);
}

/// `stray`: how many of them are none, whose points build_scan() drops.
bool holds_nanoseconds(const io::ScanColumns& columns, const std::optional<io::PointTimeRule>& rule,
                       std::size_t stray, io::StampAt stamp_at) {
  if (columns.time == nullptr) return true;
  return stray == 0 && is_plain(columns.time, io::ScalarType::i32) &&
         rule->unit == io::TimeUnit::nanoseconds &&
         rule->reference == io::TimeReference::relative && stamp_at == io::StampAt::start;
}

ArrayScan looking_into(const py::array& cloud, const io::ScanColumns& columns,
                       std::int64_t stamp_ns) {
  ArrayScan scan;
  scan.stamp_ns = stamp_ns;
  scan.points = py::array_t<float>({cloud.shape(0), py::ssize_t{3}},
                                   {cloud.strides(0), static_cast<py::ssize_t>(sizeof(float))},
                                   reinterpret_cast<const float*>(columns.x->first), cloud);
  scan.times_ns = look_into<std::int32_t>(cloud, columns.time);
  scan.intensities = look_into<float>(cloud, columns.intensity);
  scan.rings = look_into<std::uint16_t>(cloud, columns.ring);
  return scan;
}

}  // namespace

ArrayScan scan_of_cloud(const py::array& cloud, std::optional<std::int64_t> stamp_ns,
                        const std::string& time_field, const std::string& time_unit,
                        const std::string& time_reference, const std::string& stamp_at) {
  io::OpenOptions options;
  options.time_field = time_field;
  options.time_unit = time_unit_named(time_unit);
  options.time_reference = time_reference_named(time_reference);
  options.stamp_at = stamp_at_named(stamp_at);
  if (cloud.ndim() == 1 && cloud.size() > 1 && cloud.strides(0) < 0) {
    throw std::invalid_argument("cloud: got an array that runs backwards; copy it first");
  }
  const io::PointTable table = table_of(cloud);
  const io::ScanColumns columns = io::find_scan_columns(table, options);
  std::optional<io::PointTimeRule> rule;
  std::size_t stray = 0;
  if (columns.time != nullptr && table.size > 0) {
    const io::TimeExtents extents = io::time_extents(table, columns);
    stray = extents.stray;
    rule = io::decide_point_time(extents, columns.time->type, stamp_ns, options);
  }
  if (are_beside(columns) && are_ring_numbers(columns.ring) &&
      holds_nanoseconds(columns, rule, stray, options.stamp_at)) {
    return looking_into(cloud, columns, stamp_ns.value_or(0));
  }
  return array_scan(io::build_scan(table, columns, rule, stamp_ns, options.stamp_at).scan);
}

}  // namespace surefoot::python
