// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/scan_fields.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstring>
#include <stdexcept>

namespace surefoot::io {
namespace {

std::size_t element_bytes(const Column& column) { return column.count * size_of(column.type); }

template <typename T>
Column column_of(const char* name, ScalarType type, const std::vector<T>& values) {
  return {name, type, reinterpret_cast<const std::byte*>(values.data()), sizeof(T)};
}

bool has_name(std::span<const Column> columns, const std::string& name) {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const Column& column) { return column.name == name; });
}

// Headers of text put names between blanks, and "_" is PCD's word for padding.
std::string free_word(std::string name, std::span<const Column> taken) {
  for (char& c : name) {
    if (std::isgraph(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  if (name.empty() || name == "_") name = "field";
  std::string free = name;
  for (int number = 2; has_name(taken, free); ++number) free = name + '_' + std::to_string(number);
  return free;
}

bool share_bytes(const Column& a, const Column& b) {
  return a.first < b.first + element_bytes(b) && b.first < a.first + element_bytes(a);
}

std::vector<std::byte> values_of(const Column& column, std::size_t points,
                                 const std::vector<std::size_t>& kept) {
  const std::size_t size = element_bytes(column);
  const std::size_t count = kept.empty() ? points : kept.size();
  std::vector<std::byte> values(count * size);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t point = kept.empty() ? i : kept[i];
    std::memcpy(values.data() + i * size, column.first + point * column.stride, size);
  }
  if (column.swapped) {
    for (auto at = values.begin(); at != values.end();
         at += static_cast<long>(size_of(column.type))) {
      std::reverse(at, at + static_cast<long>(size_of(column.type)));
    }
  }
  return values;
}

}  // namespace

std::vector<FurtherField> further_fields(const PointTable& table,
                                         std::span<const Column* const> used,
                                         const std::vector<std::size_t>& kept,
                                         std::vector<std::string>* left_out) {
  std::vector<FurtherField> fields;
  std::vector<const Column*> taken;
  constexpr std::size_t kMostFields = 1000;  // as many as PCD's reader takes
  for (const Column& column : table.columns) {
    if (fields.size() == kMostFields) break;
    if (std::find(used.begin(), used.end(), &column) != used.end()) continue;
    const auto shares = [&](const Column* other) { return share_bytes(column, *other); };
    if (table.size > 0 && std::any_of(taken.begin(), taken.end(), shares)) {
      if (left_out != nullptr) left_out->push_back(column.name);
      continue;
    }
    taken.push_back(&column);
    fields.push_back({column.name, column.type, column.count, values_of(column, table.size, kept)});
  }
  return fields;
}

std::vector<Column> coordinate_columns(std::span<const Eigen::Vector3f> points) {
  const auto* const first = reinterpret_cast<const std::byte*>(points.data());
  constexpr std::size_t kStride = sizeof(Eigen::Vector3f);
  return {{"x", ScalarType::f32, first, kStride},
          {"y", ScalarType::f32, points.empty() ? nullptr : first + sizeof(float), kStride},
          {"z", ScalarType::f32, points.empty() ? nullptr : first + 2 * sizeof(float), kStride}};
}

std::vector<Column> written_columns(const Scan& scan, std::span<const FurtherField> further) {
  const std::size_t points = scan.points.size();
  const auto fits = [points](const auto& values) {
    return values.empty() || values.size() == points;
  };
  if (!fits(scan.intensities) || !fits(scan.times_ns) || !fits(scan.rings)) {
    throw std::invalid_argument("a scan's arrays must be empty or as long as its points");
  }
  std::vector<Column> columns = coordinate_columns(scan.points);
  if (!scan.intensities.empty()) {
    columns.push_back(column_of("intensity", ScalarType::f32, scan.intensities));
  }
  if (!scan.times_ns.empty()) {
    const bool negative =
        std::any_of(scan.times_ns.begin(), scan.times_ns.end(), [](auto t) { return t < 0; });
    columns.push_back(column_of("t", negative ? ScalarType::i32 : ScalarType::u32, scan.times_ns));
  }
  if (!scan.rings.empty()) columns.push_back(column_of("ring", ScalarType::u16, scan.rings));
  for (const FurtherField& field : further) {
    const std::size_t stride = field.count * size_of(field.type);
    if (field.values.size() != points * stride) {
      throw std::invalid_argument(field.name + " does not have a value for each of the points");
    }
    columns.push_back({free_word(field.name, columns), field.type, field.values.data(), stride,
                       false, field.count});
  }
  return columns;
}

std::size_t point_bytes(std::span<const Column> columns) {
  std::size_t bytes = 0;
  for (const Column& column : columns) bytes += element_bytes(column);
  return bytes;
}

void append_points(std::string& out, std::span<const Column> columns, std::size_t points) {
  const std::size_t step = point_bytes(columns);
  const std::size_t begin = out.size();
  out.resize(begin + points * step);
  char* first = out.data() + begin;
  for (const Column& column : columns) {
    const std::size_t size = element_bytes(column);
    for (std::size_t i = 0; i < points; ++i) {
      std::memcpy(first + i * step, column.first + i * column.stride, size);
    }
    first += size;
  }
}

void append_rows_of_text(std::string& out, std::span<const Column> columns, std::size_t points) {
  const auto append = [&](std::size_t, auto value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    out.append(text.data(), end) += ' ';
  };
  for (std::size_t i = 0; i < points; ++i) {
    for (Column column : columns) {
      column.first += i * column.stride;
      column.stride = size_of(column.type);
      for_each_value(column, column.count, append);
    }
    out.back() = '\n';
  }
}

}  // namespace surefoot::io
