// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/messages/point_cloud2_writer.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "io/file_writer.hpp"

namespace surefoot::io {
namespace {

// sensor_msgs/PointField's numbers of the types.
enum Datatype : std::uint8_t { kUint16 = 4, kInt32 = 5, kUint32 = 6, kFloat32 = 7 };

struct WrittenField {
  const char* name;
  Datatype type;
  std::uint32_t offset;
};

struct Layout {
  std::vector<WrittenField> fields;
  std::uint32_t step = 0;

  void add(const char* name, Datatype type) {
    fields.push_back({name, type, step});
    step += type == kUint16 ? 2 : 4;
  }
};

Layout layout_of(const Scan& scan) {
  const auto fits = [&scan](const auto& values) {
    return values.empty() || values.size() == scan.points.size();
  };
  if (!fits(scan.intensities) || !fits(scan.times_ns) || !fits(scan.rings)) {
    throw std::invalid_argument("a scan's arrays must be empty or as long as its points");
  }
  Layout layout;
  for (const char* name : {"x", "y", "z"}) layout.add(name, kFloat32);
  if (!scan.intensities.empty()) layout.add("intensity", kFloat32);
  const bool negative = std::any_of(scan.times_ns.begin(), scan.times_ns.end(),
                                    [](std::int32_t time) { return time < 0; });
  if (!scan.times_ns.empty()) layout.add("t", negative ? kInt32 : kUint32);
  if (!scan.rings.empty()) layout.add("ring", kUint16);
  return layout;
}

std::string points_of(const Scan& scan, std::uint32_t step) {
  std::string bytes;
  bytes.reserve(scan.points.size() * step);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    bytes.append(reinterpret_cast<const char*>(scan.points[i].data()), 3 * sizeof(float));
    if (!scan.intensities.empty()) append_bytes(bytes, scan.intensities[i]);
    if (!scan.times_ns.empty()) append_bytes(bytes, scan.times_ns[i]);
    if (!scan.rings.empty()) append_bytes(bytes, scan.rings[i]);
  }
  return bytes;
}

}  // namespace

std::string format_point_cloud2(const Scan& scan, std::string_view frame,
                                MessageWriter::Flavour flavour) {
  const Layout layout = layout_of(scan);
  const auto points = static_cast<std::uint32_t>(scan.points.size());
  MessageWriter message(flavour);
  message.header(scan.stamp_ns, frame).number(std::uint32_t{1}).number(points);
  message.count(layout.fields.size());
  for (const WrittenField& field : layout.fields) {
    message.string(field.name).number(field.offset);
    message.number(static_cast<std::uint8_t>(field.type)).number(std::uint32_t{1});
  }
  message.number(std::uint8_t{0}).number(layout.step).number(layout.step * points);
  message.count(std::size_t{layout.step} * points).raw(points_of(scan, layout.step));
  const bool dense = std::all_of(scan.points.begin(), scan.points.end(),
                                 [](const Eigen::Vector3f& point) { return point.allFinite(); });
  return message.number(static_cast<std::uint8_t>(dense ? 1 : 0)).take();
}

}  // namespace surefoot::io
