// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/ply_writer.hpp"

#include <stdexcept>
#include <vector>

#include "io/file_writer.hpp"

namespace surefoot::io {

namespace {

std::string header(std::size_t points, const std::vector<PlyColumn>& columns, bool ascii) {
  std::string out = std::string("ply\nformat ") + (ascii ? "ascii" : "binary_little_endian") +
                    " 1.0\ncomment Surefoot\nelement vertex " + std::to_string(points) +
                    "\nproperty float x\nproperty float y\nproperty float z\n";
  for (const PlyColumn& column : columns) out += "property float " + column.name + '\n';
  return out + "end_header\n";
}

/// Those with values. Throws where these are not as many as the points.
std::vector<PlyColumn> filled(std::span<const PlyColumn> columns, std::size_t points) {
  std::vector<PlyColumn> result;
  for (const PlyColumn& column : columns) {
    if (column.values.empty()) continue;
    if (column.values.size() != points) {
      throw std::invalid_argument(column.name + ": " + std::to_string(column.values.size()) +
                                  " values for " + std::to_string(points) + " points");
    }
    result.push_back(column);
  }
  return result;
}

}  // namespace

std::string format_ply(std::span<const Eigen::Vector3f> points, std::span<const PlyColumn> columns,
                       PlyFlavour flavour) {
  const bool ascii = flavour == PlyFlavour::ascii;
  const std::vector<PlyColumn> extra = filled(columns, points.size());
  std::string out = header(points.size(), extra, ascii);
  out.reserve(out.size() + (ascii ? 10 : 4) * (3 + extra.size()) * points.size());
  const auto append = [&](float value) {
    if (ascii) {
      append_text(out, value);
      out += ' ';
    } else {
      append_bytes(out, value);
    }
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const float coordinate : points[i]) append(coordinate);
    for (const PlyColumn& column : extra) append(column.values[i]);
    if (ascii) out.back() = '\n';
  }
  return out;
}

std::string format_ply(std::span<const Eigen::Vector3f> points, std::span<const float> intensities,
                       PlyFlavour flavour) {
  const PlyColumn column{"intensity", intensities};
  return format_ply(points, std::span(&column, 1), flavour);
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
