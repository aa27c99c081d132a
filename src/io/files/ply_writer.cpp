// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/ply_writer.hpp"

#include <stdexcept>
#include <vector>

#include "io/file_writer.hpp"

namespace surefoot::io {

namespace {

// PLY 1.0's word for a type; null: it has none.
const char* type_word(ScalarType type) {
  switch (type) {
    case ScalarType::i8:
      return "char";
    case ScalarType::u8:
      return "uchar";
    case ScalarType::i16:
      return "short";
    case ScalarType::u16:
      return "ushort";
    case ScalarType::i32:
      return "int";
    case ScalarType::u32:
      return "uint";
    case ScalarType::f32:
      return "float";
    case ScalarType::f64:
      return "double";
    default:
      return nullptr;
  }
}

std::string header(std::span<const Column> columns, std::size_t points, bool ascii) {
  std::string out = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") +
                    " 1.0\ncomment Surefoot\nelement vertex " + std::to_string(points) + '\n';
  for (const Column& column : columns) {
    out += std::string("property ") + type_word(column.type) + ' ' + column.name + '\n';
  }
  return out + "end_header\n";
}

}  // namespace

bool fits_ply(const Column& column) {
  return type_word(column.type) != nullptr && column.count == 1;
}

std::string format_ply(std::span<const Column> columns, std::size_t points, PlyFlavour flavour) {
  const bool ascii = flavour == PlyFlavour::ascii;
  std::string out = header(columns, points, ascii);
  if (ascii) {
    append_rows_of_text(out, columns, points);
  } else {
    append_points(out, columns, points);
  }
  return out;
}

std::string format_ply(std::span<const Eigen::Vector3f> points, std::span<const PlyColumn> columns,
                       PlyFlavour flavour) {
  std::vector<Column> all = coordinate_columns(points);
  for (const PlyColumn& column : columns) {
    if (column.values.empty() && !points.empty()) continue;
    if (column.values.size() != points.size()) {
      throw std::invalid_argument(column.name + ": " + std::to_string(column.values.size()) +
                                  " values for " + std::to_string(points.size()) + " points");
    }
    all.push_back({column.name, ScalarType::f32,
                   reinterpret_cast<const std::byte*>(column.values.data()), sizeof(float)});
  }
  return format_ply(all, points.size(), flavour);
}

std::string format_ply(std::span<const Eigen::Vector3f> points, std::span<const float> intensities,
                       PlyFlavour flavour) {
  const PlyColumn column{"intensity", intensities};
  return format_ply(points, std::span(&column, intensities.empty() ? 0 : 1), flavour);
}

void write_ply(const std::filesystem::path& file, std::span<const Eigen::Vector3f> points,
               std::span<const PlyColumn> columns) {
  write_whole_file(file, format_ply(points, columns, PlyFlavour::binary));
}

void write_ply(const std::filesystem::path& file, std::span<const Eigen::Vector3f> points,
               std::span<const float> intensities, PlyFlavour flavour) {
  write_whole_file(file, format_ply(points, intensities, flavour));
}

}  // namespace surefoot::io
