// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/pcd_writer.hpp"

#include <lzf.h>

#include <limits>
#include <stdexcept>

#include "io/file_writer.hpp"

namespace surefoot::io {
namespace {

char type_letter(ScalarType type) {
  if (is_float(type)) return 'F';
  return name_of(type)[0] == 'i' ? 'I' : 'U';
}

std::string header_of(std::span<const Column> columns, std::size_t points, const char* data) {
  std::string fields, sizes, types, counts;
  for (const Column& column : columns) {
    fields += ' ' + column.name;
    sizes += ' ' + std::to_string(size_of(column.type));
    types += std::string(" ") + type_letter(column.type);
    counts += ' ' + std::to_string(column.count);
  }
  const std::string number = std::to_string(points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS" + fields + "\nSIZE" +
         sizes + "\nTYPE" + types + "\nCOUNT" + counts + "\nWIDTH " + number +
         "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number + "\nDATA " + data + "\n";
}

// Fields one after the other, each for all points.
void append_compressed(std::string& out, std::span<const Column> columns, std::size_t points) {
  std::string plain;
  for (const Column& column : columns) append_points(plain, {&column, 1}, points);
  if (plain.size() > std::numeric_limits<std::uint32_t>::max() / 2) {
    throw std::invalid_argument("too many points for PCD binary_compressed");
  }
  const auto size = static_cast<std::uint32_t>(plain.size());
  // LZF grows what it cannot compress by less than 4 %.
  std::string packed(plain.size() + plain.size() / 16 + 64, '\0');
  const std::uint32_t packed_size = size == 0
                                        ? 0
                                        : lzf_compress(plain.data(), size, packed.data(),
                                                       static_cast<std::uint32_t>(packed.size()));
  append_bytes(out, packed_size);
  append_bytes(out, size);
  out.append(packed, 0, packed_size);
}

}  // namespace

std::string format_pcd(std::span<const Column> columns, std::size_t points, PcdData flavour) {
  std::string out;
  switch (flavour) {
    case PcdData::ascii:
      out = header_of(columns, points, "ascii");
      append_rows_of_text(out, columns, points);
      break;
    case PcdData::binary:
      out = header_of(columns, points, "binary");
      append_points(out, columns, points);
      break;
    case PcdData::binary_compressed:
      out = header_of(columns, points, "binary_compressed");
      append_compressed(out, columns, points);
      break;
  }
  return out;
}

std::string format_pcd(const Scan& scan, PcdData flavour) {
  return format_pcd(written_columns(scan), scan.points.size(), flavour);
}

void write_pcd(const std::filesystem::path& file, const Scan& scan, PcdData flavour) {
  write_whole_file(file, format_pcd(scan, flavour));
}

}  // namespace surefoot::io
