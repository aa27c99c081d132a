// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/files/las_writer.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "io/file_writer.hpp"

namespace surefoot::io {

namespace {

constexpr double kMillimetre = 0.001;  // [m]
constexpr std::uint16_t kWrittenHeader = 375;
constexpr std::uint16_t kWrittenRecord = 20;
constexpr std::uint8_t kOnlyReturn = 1 | 1 << 3;  // the first of one

struct LasExtent {
  Eigen::Vector3d low = Eigen::Vector3d::Zero();
  Eigen::Vector3d high = Eigen::Vector3d::Zero();
};

LasExtent las_extent_of(std::span<const Eigen::Vector3d> points) {
  if (points.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::invalid_argument("too many points for LAS point format 0");
  }
  LasExtent extent;
  if (!points.empty()) extent.low = extent.high = points.front();
  for (const Eigen::Vector3d& point : points) {
    if (!point.allFinite()) throw std::invalid_argument("a point that is not finite, for LAS");
    extent.low = extent.low.cwiseMin(point);
    extent.high = extent.high.cwiseMax(point);
  }
  if ((extent.high - extent.low).maxCoeff() > 2e6) {
    throw std::invalid_argument("a map of more than 2,000 km, for LAS in millimetres");
  }
  return extent;
}

std::int32_t millimetres(double coordinate, double offset) {
  return static_cast<std::int32_t>(std::lround((coordinate - offset) / kMillimetre));
}
/// The coordinate that readers make of that.
double written(double coordinate, double offset) {
  return kMillimetre * millimetres(coordinate, offset) + offset;
}

/// Zero-padded.
void append_las_name(std::string& out, std::string name) {
  name.resize(32, '\0');
  out += name;
}

/// ASPRS LAS 1.4 R15, table 3. The day of creation is left out: the same map gives the same bytes.
void append_las_header(std::string& out, const LasExtent& extent, const Eigen::Vector3d& offset,
                       std::uint32_t count) {
  out = "LASF";
  out.append(20, '\0');  // source, encoding, GUID
  append_bytes(out, std::uint8_t{1});
  append_bytes(out, std::uint8_t{4});
  append_las_name(out, "LiDAR map");
  append_las_name(out, "Surefoot");
  append_bytes(out, std::uint32_t{0});  // day and year
  append_bytes(out, kWrittenHeader);
  append_bytes(out, std::uint32_t{kWrittenHeader});  // where the points begin
  append_bytes(out, std::uint32_t{0});               // variable length records
  append_bytes(out, std::uint8_t{0});                // point format
  append_bytes(out, kWrittenRecord);
  append_bytes(out, count);
  append_bytes(out, count);  // all are first returns
  out.append(4 * sizeof(std::uint32_t), '\0');
  for (int axis = 0; axis < 3; ++axis) append_bytes(out, kMillimetre);
  for (int axis = 0; axis < 3; ++axis) append_bytes(out, offset[axis]);
  for (int axis = 0; axis < 3; ++axis) {
    append_bytes(out, written(extent.high[axis], offset[axis]));
    append_bytes(out, written(extent.low[axis], offset[axis]));
  }
  out.append(8 + 8 + 4, '\0');  // waveforms, extended records
  append_bytes(out, std::uint64_t{count});
  append_bytes(out, std::uint64_t{count});
  out.append(14 * sizeof(std::uint64_t), '\0');
}

}  // namespace

std::string format_las(std::span<const Eigen::Vector3d> points) {
  const LasExtent extent = las_extent_of(points);
  const Eigen::Vector3d offset = extent.low.array().floor();
  std::string out;
  out.reserve(kWrittenHeader + kWrittenRecord * points.size());
  append_las_header(out, extent, offset, static_cast<std::uint32_t>(points.size()));
  for (const Eigen::Vector3d& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      append_bytes(out, millimetres(point[axis], offset[axis]));
    }
    append_bytes(out, std::uint16_t{0});  // intensity
    append_bytes(out, kOnlyReturn);
    out.append(5, '\0');  // class, angle, user's, source
  }
  return out;
}

void write_las(const std::filesystem::path& file, std::span<const Eigen::Vector3d> points) {
  write_whole_file(file, format_las(points));
}

}  // namespace surefoot::io
