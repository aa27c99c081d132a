// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "simulation/mesh_file.hpp"

namespace surefoot::simulation {

namespace {

struct PlyProperty {
  std::string name;
  std::string type;
  std::string count_type;  ///< empty: not a list
};

struct PlyElement {
  std::string name;
  double count = 0.0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  bool binary = false;
  std::vector<PlyElement> elements;
};

PlyHeader read_header(const std::filesystem::path& file, std::string_view& rest) {
  PlyHeader header;
  if (take_line(rest) != "ply") fail(file, "does not begin with 'ply'");
  for (;;) {
    if (rest.empty()) fail(file, "the header has no 'end_header'");
    Words words(file, take_line(rest));
    const std::string_view key = words.next();
    if (key == "end_header") return header;
    if (key == "format") {
      const std::string format(words.next());
      header.binary = format == "binary_little_endian";
      if (!header.binary && format != "ascii") {
        fail(file, "format '" + format + "', expected ascii or binary_little_endian");
      }
    } else if (key == "element") {
      PlyElement element{std::string(words.next()), 0.0, {}};
      element.count = words.number("the count of '" + element.name + "'");
      header.elements.push_back(std::move(element));
    } else if (key == "property") {
      if (header.elements.empty()) fail(file, "a property stands before the first element");
      PlyProperty property;
      property.type = words.next();
      if (property.type == "list") {
        property.count_type = words.next();
        property.type = words.next();
      }
      property.name = words.next();
      header.elements.back().properties.push_back(std::move(property));
    }
  }
}

/// Values one after the other, from text or from bytes.
class PlyValues {
 public:
  PlyValues(const std::filesystem::path& file, std::string_view data, bool binary)
      : file_(file), data_(data), words_(file, data), binary_(binary) {}

  double next(const std::string& type) {
    if (!binary_) return words_.number("a value of type " + type);
    if (type == "float" || type == "float32") return take<float>();
    if (type == "double" || type == "float64") return take<double>();
    if (type == "int" || type == "int32") return take<std::int32_t>();
    if (type == "uint" || type == "uint32") return take<std::uint32_t>();
    if (type == "short" || type == "int16") return take<std::int16_t>();
    if (type == "ushort" || type == "uint16") return take<std::uint16_t>();
    if (type == "char" || type == "int8") return take<std::int8_t>();
    if (type == "uchar" || type == "uint8") return take<std::uint8_t>();
    fail(file_, "property type '" + type + "' is not one of PLY's");
  }

 private:
  template <typename Value>
  double take() {
    if (data_.size() < sizeof(Value)) fail(file_, "ends before all of its elements are there");
    Value value;
    std::memcpy(&value, data_.data(), sizeof(Value));
    data_.remove_prefix(sizeof(Value));
    return static_cast<double>(value);
  }

  std::filesystem::path file_;
  std::string_view data_;
  Words words_;
  bool binary_;
};

std::vector<std::int64_t> read_list(const std::filesystem::path& file, const PlyProperty& property,
                                    PlyValues& values) {
  constexpr double kMostCorners = 1000.0;
  const double count = values.next(property.count_type);
  if (!(count >= 0.0 && count <= kMostCorners)) {
    fail(file, "a list of " + std::to_string(count) + " values, expected 0 to 1000");
  }
  std::vector<std::int64_t> corners;
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double value = values.next(property.type);
    // Out of any mesh's range, and so refused with its face.
    corners.push_back(std::abs(value) < 1e15 ? static_cast<std::int64_t>(value) : -1);
  }
  return corners;
}

void read_row(const std::filesystem::path& file, const PlyElement& element, PlyValues& values,
              MeshCollector& mesh) {
  Eigen::Vector3d vertex = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
  for (const PlyProperty& property : element.properties) {
    if (!property.count_type.empty()) {
      const std::vector<std::int64_t> list = read_list(file, property, values);
      const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
      if (element.name == "face" && corners) mesh.add_polygon(list);
      continue;
    }
    const double value = values.next(property.type);
    if (property.name == "x") vertex.x() = value;
    if (property.name == "y") vertex.y() = value;
    if (property.name == "z") vertex.z() = value;
  }
  if (element.name == "vertex") mesh.add_vertex(vertex);
}

}  // namespace

TriangleMesh read_ply(const std::filesystem::path& file) {
  const std::string text = read_text(file);
  std::string_view rest = text;
  const PlyHeader header = read_header(file, rest);
  MeshCollector mesh(file);
  PlyValues values(file, rest, header.binary);
  for (const PlyElement& element : header.elements) {
    // Every property takes a byte at least.
    const auto least = static_cast<double>(element.properties.size());
    if (!(element.count >= 0.0) || element.count * least > static_cast<double>(text.size()) ||
        (element.properties.empty() && element.count > 0.0)) {
      fail(file, "element '" + element.name + "' claims " + std::to_string(element.count) +
                     " rows, more than the file's " + std::to_string(text.size()) +
                     " bytes can hold");
    }
    for (double row = 0.0; row < element.count; row += 1.0) read_row(file, element, values, mesh);
  }
  return mesh.finish();
}

}  // namespace surefoot::simulation
