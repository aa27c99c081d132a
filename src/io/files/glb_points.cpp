// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/glb_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "io/file_writer.hpp"

namespace surefoot::io {

namespace {

constexpr float kSteps = 65535.0F;
constexpr std::size_t kPositionBytes = 8;  // three numbers of 16 bits; records begin at fours
constexpr std::size_t kColorBytes = 4;

using Steps = std::array<std::uint16_t, 3>;

/// In glTF's axes, whose origin is the cube's corner of lowest x and z and highest y.
Steps steps_of(const Eigen::Vector3f& point, const GlbPoints& tile) {
  const Eigen::Vector3f share =
      ((point - tile.low) / tile.edge).cwiseMax(0.0F).cwiseMin(1.0F) * kSteps;
  const auto step = [&](int axis) { return static_cast<std::uint16_t>(std::lround(share[axis])); };
  return {step(0), step(2), static_cast<std::uint16_t>(65535 - step(1))};
}

/// Dark blue by green to yellow, near to viridis; linear, as glTF's colours of points are.
std::array<std::uint8_t, 4> color_at(float share) {
  constexpr std::array<std::array<float, 3>, 5> kStops = {
      {{68, 1, 84}, {59, 82, 139}, {33, 145, 140}, {94, 201, 98}, {253, 231, 37}}};
  const float along = std::clamp(share, 0.0F, 1.0F) * 4.0F;
  const auto stop = std::min<std::size_t>(static_cast<std::size_t>(along), 3);
  const float part = along - static_cast<float>(stop);
  std::array<std::uint8_t, 4> color = {0, 0, 0, 255};
  for (std::size_t i = 0; i < 3; ++i) {
    const float shown = (kStops[stop][i] * (1.0F - part) + kStops[stop + 1][i] * part) / 255.0F;
    color[i] = static_cast<std::uint8_t>(std::lround(255.0F * std::pow(shown, 2.2F)));
  }
  return color;
}

template <typename T>
std::string json_triple(const std::array<T, 3>& values) {
  std::string text = "[";
  for (std::size_t i = 0; i < 3; ++i) {
    if (i > 0) text += ',';
    if constexpr (std::is_integral_v<T>) {
      text += std::to_string(values[i]);
    } else {
      append_fixed(text, static_cast<double>(values[i]), 9);
    }
  }
  return text + "]";
}

std::string glb_json(const GlbPoints& tile, const Steps& least, const Steps& most) {
  const std::size_t count = tile.points.size();
  const std::string number = std::to_string(count);
  const std::string positions = std::to_string(kPositionBytes * count);
  const std::string colors = std::to_string(kColorBytes * count);
  const double step = static_cast<double>(tile.edge) / static_cast<double>(kSteps);
  std::string json = R"({"asset":{"version":"2.0","generator":"Surefoot"},)"
                     R"("extensionsUsed":["KHR_materials_unlit","KHR_mesh_quantization"],)"
                     R"("extensionsRequired":["KHR_mesh_quantization"],)"
                     R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":)";
  json += json_triple<float>({tile.low.x(), tile.low.z(), -(tile.low.y() + tile.edge)});
  json += R"(,"scale":)" + json_triple<double>({step, step, step}) + "}],";
  json +=
      R"("meshes":[{"primitives":[{"mode":0,"material":0,"attributes":{"POSITION":0,"COLOR_0":1}}]}],)"
      R"("materials":[{"extensions":{"KHR_materials_unlit":{}}}],)"
      R"("accessors":[{"bufferView":0,"componentType":5123,"type":"VEC3","count":)";
  json += number + R"(,"min":)" + json_triple(least) + R"(,"max":)" + json_triple(most);
  json +=
      R"(},{"bufferView":1,"componentType":5121,"normalized":true,"type":"VEC4","count":)" + number;
  json +=
      R"(}],"bufferViews":[{"buffer":0,"byteStride":8,"target":34962,"byteLength":)" + positions;
  json += R"(},{"buffer":0,"byteStride":4,"target":34962,"byteOffset":)" + positions +
          R"(,"byteLength":)" + colors;
  json += R"(}],"buffers":[{"byteLength":)" +
          std::to_string((kPositionBytes + kColorBytes) * count) + "}]}";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  return json;
}

}  // namespace

std::string format_glb(const GlbPoints& tile) {
  static_assert(std::endian::native == std::endian::little);
  const std::size_t count = tile.points.size();
  std::string bytes;
  bytes.reserve((kPositionBytes + kColorBytes) * count);
  Steps least = {65535, 65535, 65535}, most = {0, 0, 0};
  for (const Eigen::Vector3f& point : tile.points) {
    const Steps steps = steps_of(point, tile);
    for (std::size_t i = 0; i < 3; ++i) {
      least[i] = std::min(least[i], steps[i]);
      most[i] = std::max(most[i], steps[i]);
      append_bytes(bytes, steps[i]);
    }
    append_bytes(bytes, std::uint16_t{0});
  }
  const float span = std::max(tile.heights[1] - tile.heights[0], 1e-3F);
  for (const Eigen::Vector3f& point : tile.points) {
    for (const std::uint8_t value : color_at((point.z() - tile.heights[0]) / span)) {
      append_bytes(bytes, value);
    }
  }
  const std::string json = glb_json(tile, least, most);
  std::string glb = "glTF";
  glb.reserve(28 + json.size() + bytes.size());
  append_bytes(glb, std::uint32_t{2});
  append_bytes(glb, static_cast<std::uint32_t>(28 + json.size() + bytes.size()));
  append_bytes(glb, static_cast<std::uint32_t>(json.size()));
  glb += "JSON" + json;
  append_bytes(glb, static_cast<std::uint32_t>(bytes.size()));
  glb.append("BIN\0", 4);
  return glb + bytes;
}

}  // namespace surefoot::io
