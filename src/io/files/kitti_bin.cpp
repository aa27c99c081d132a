// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/kitti_bin.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "io/recording.hpp"

namespace surefoot::io {

PointTable parse_kitti_bin(std::span<const std::byte> file) {
  constexpr std::size_t kPointBytes = 16;
  if (file.size() % kPointBytes != 0) {
    throw ReadError("KITTI .bin: " + std::to_string(file.size()) +
                    " bytes; expected a multiple of 16 (float32 x y z intensity)");
  }
  PointTable table;
  table.format = "KITTI .bin";
  table.size = file.size() / kPointBytes;
  const bool swapped = std::endian::native != std::endian::little;
  std::size_t offset = 0;
  for (const char* name : {"x", "y", "z", "intensity"}) {
    table.columns.push_back({name, ScalarType::f32, file.data() + offset, kPointBytes, swapped});
    offset += sizeof(float);
  }
  return table;
}

void correct_kitti_hdl64(std::vector<Eigen::Vector3f>& points) {
  constexpr double kAngle = 0.205 * std::numbers::pi / 180.0;
  const double cosine = std::cos(kAngle);
  const double sine = std::sin(kAngle);
  for (Eigen::Vector3f& point : points) {
    const double horizontal = std::hypot(point.x(), point.y());
    if (!(horizontal > 0.0)) {
      continue;
    }
    const double height = point.z();
    const double scale = (horizontal * cosine - height * sine) / horizontal;
    point.x() = static_cast<float>(point.x() * scale);
    point.y() = static_cast<float>(point.y() * scale);
    point.z() = static_cast<float>(horizontal * sine + height * cosine);
  }
}

}  // namespace surefoot::io
