// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include "simulation/mesh_file.hpp"

namespace surefoot::simulation {

namespace {

/// "7", "7/1", "7//3", "-1": the vertex of a corner, from 0.
std::int64_t obj_corner(const std::filesystem::path& file, std::string_view word,
                        std::size_t vertices) {
  const std::string_view digits = word.substr(0, word.find('/'));
  std::int64_t index = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (error != std::errc() || end != digits.data() + digits.size() || index == 0) {
    fail(file, "a face's corner is '" + std::string(word.substr(0, 40)) +
                   "', expected the number of a vertex");
  }
  return index > 0 ? index - 1 : static_cast<std::int64_t>(vertices) + index;
}

struct GridHeader {
  double columns = 0.0;
  double rows = 0.0;
  double cell = 0.0;
  double no_data = -9999.0;
};

/// The header's lines are "name value"; it ends where a line begins with a number.
GridHeader read_grid_header(const std::filesystem::path& file, std::string_view& rest) {
  GridHeader header;
  while (!rest.empty()) {
    const std::size_t letter = rest.find_first_not_of(" \t\r\n");
    if (letter == std::string_view::npos ||
        std::isalpha(static_cast<unsigned char>(rest[letter])) == 0) {
      break;
    }
    Words words(file, take_line(rest));
    std::string name(words.next());
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (name.empty()) continue;
    const double value = words.number("the value of '" + name + "'");
    if (name == "ncols") header.columns = value;
    if (name == "nrows") header.rows = value;
    if (name == "cellsize") header.cell = value;
    if (name == "nodata_value") header.no_data = value;
  }
  return header;
}

void check_grid(const std::filesystem::path& file, const GridHeader& header,
                std::size_t text_bytes) {
  const auto whole = [](double value) { return value >= 2.0 && value == std::floor(value); };
  if (!whole(header.columns) || !whole(header.rows) || !(header.cell > 0.0)) {
    fail(file, "an ascii grid starts with ncols and nrows (2 or more) and cellsize; seen ncols " +
                   std::to_string(header.columns) + ", nrows " + std::to_string(header.rows) +
                   ", cellsize " + std::to_string(header.cell));
  }
  // A height takes a digit and a space at least.
  if (header.columns * header.rows > static_cast<double>(text_bytes)) {
    fail(file, "ncols times nrows is " + std::to_string(header.columns * header.rows) +
                   ", more than the file's " + std::to_string(text_bytes) + " bytes can hold");
  }
}

}  // namespace

TriangleMesh read_obj(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  std::string_view rest = text;
  MeshCollector mesh(file);
  std::size_t vertices = 0;
  while (!rest.empty()) {
    Words words(file, take_line(rest));
    const std::string_view kind = words.next();
    if (kind == "v") {
      Eigen::Vector3d vertex;
      for (int axis = 0; axis < 3; ++axis) vertex(axis) = words.number("a vertex's coordinate");
      mesh.add_vertex(vertex);
      ++vertices;
    } else if (kind == "f") {
      std::vector<std::int64_t> corners;
      while (!words.at_end()) corners.push_back(obj_corner(file, words.next(), vertices));
      mesh.add_polygon(corners);
    }
  }
  return mesh.finish();
}

TriangleMesh read_ascii_grid(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  std::string_view rest = text;
  const GridHeader header = read_grid_header(file, rest);
  check_grid(file, header, text.size());
  const auto columns = static_cast<std::int64_t>(header.columns);
  const auto rows = static_cast<std::int64_t>(header.rows);
  MeshCollector mesh(file);
  std::vector<bool> known;
  Words words(file, rest);
  // Rows come from north to south; the lower left corner becomes the origin.
  for (std::int64_t row = 0; row < rows; ++row) {
    for (std::int64_t column = 0; column < columns; ++column) {
      const double height = words.number("a height");
      known.push_back(height != header.no_data);
      mesh.add_vertex({header.cell * static_cast<double>(column),
                       header.cell * static_cast<double>(rows - 1 - row),
                       known.back() ? height : 0.0});
    }
  }
  for (std::int64_t row = 0; row + 1 < rows; ++row) {
    for (std::int64_t column = 0; column + 1 < columns; ++column) {
      const std::int64_t a = row * columns + column;
      const std::array<std::int64_t, 4> corner = {a + columns, a + columns + 1, a + 1, a};
      const bool whole = std::all_of(corner.begin(), corner.end(), [&](std::int64_t i) {
        return known[static_cast<std::size_t>(i)];
      });
      if (whole) mesh.add_polygon({corner.begin(), corner.end()});
    }
  }
  return mesh.finish();
}

}  // namespace surefoot::simulation
