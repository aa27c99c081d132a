// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/mesh_file.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace surefoot::simulation {

namespace {
constexpr double kFarthest = 1e5;  // [m]
constexpr std::string_view kSpace = " \t\r\n\f\v";
}  // namespace

void fail(const std::filesystem::path& file, const std::string& what) {
  throw std::runtime_error(file.string() + ": " + what);
}

std::string read_text(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (error) fail(file, error.message());
  if (!std::filesystem::is_regular_file(status)) {  // opening a pipe may wait for ever
    fail(file, std::filesystem::is_directory(status) ? "it is a folder; expected a regular file"
                                                     : "it is a pipe, a socket or a device; "
                                                       "expected a regular file");
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream content;
  content << stream.rdbuf();
  if (!stream) fail(file, "cannot be read");
  return std::move(content).str();
}

void Words::skip_space() {
  const std::size_t first = rest_.find_first_not_of(kSpace);
  rest_.remove_prefix(first == std::string_view::npos ? rest_.size() : first);
}

std::string_view Words::next() {
  skip_space();
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kSpace));
  rest_.remove_prefix(word.size());
  return word;
}

double Words::number(const std::string& what) {
  const std::string_view word = next();
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) {
    fail(file_,
         "expected " + what + ", a number, but there is '" + std::string(word.substr(0, 40)) + "'");
  }
  return value;
}

bool Words::at_end() {
  skip_space();
  return rest_.empty();
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

void MeshCollector::add_vertex(const Eigen::Vector3d& vertex) {
  if (!vertex.allFinite() || vertex.cwiseAbs().maxCoeff() > kFarthest) {
    std::ostringstream message;
    message << "vertex " << mesh_.vertices.size() << " is at (" << vertex.transpose()
            << "); coordinates must be within 100 km of the origin";
    fail(file_, message.str());
  }
  mesh_.vertices.push_back(vertex.cast<float>());
}

void MeshCollector::add_polygon(const std::vector<std::int64_t>& corners) {
  const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
  for (const std::int64_t corner : corners) {
    if (corner < 0 || corner >= count) {
      fail(file_, "face " + std::to_string(mesh_.triangles.size()) + " names vertex " +
                      std::to_string(corner) + " of " + std::to_string(count));
    }
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    mesh_.triangles.emplace_back(static_cast<std::uint32_t>(corners[0]),
                                 static_cast<std::uint32_t>(corners[i - 1]),
                                 static_cast<std::uint32_t>(corners[i]));
    mesh_.materials.push_back(Material::concrete);
  }
}

TriangleMesh MeshCollector::finish() {
  if (mesh_.triangles.empty()) fail(file_, "there is no face in it, only points at most");
  return std::move(mesh_);
}

}  // namespace surefoot::simulation
