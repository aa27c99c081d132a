// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace surefoot::mapping {

namespace {

constexpr std::string_view kMagic = "SUREFOOT-MAP\n";
constexpr std::uint32_t kVersion = 1;
constexpr float kPerMetre = 512.0F;
constexpr double kFarthest = 1e8;  // [m] cubes of a submap can still be counted

/// FNV-1a, 64 bits: enough to find what went wrong on a disk.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : bytes) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }
  return hash;
}

class Writer {
 public:
  template <typename T>
  void put(T value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  void put_pose(const Pose& pose) {
    for (int i = 0; i < 3; ++i) put(pose.translation[i]);
    for (int i = 0; i < 4; ++i) put(pose.rotation.coeffs()[i]);
  }
  void put_matrix(const Matrix6& matrix) {
    for (int i = 0; i < 36; ++i) put(matrix.data()[i]);
  }
  void put_point(const Eigen::Vector3f& point) {
    for (int i = 0; i < 3; ++i) {
      constexpr float kMost = std::numeric_limits<std::int16_t>::max();
      put(static_cast<std::int16_t>(std::clamp(std::round(point[i] * kPerMetre), -kMost, kMost)));
    }
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  T get() {
    if (bytes_.size() - at_ < sizeof(T)) throw MapFileError("cut short");
    T value;
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  /// A number of things of at least `size` bytes each: no more than there are bytes for.
  std::size_t count(std::size_t size) {
    const auto value = get<std::uint32_t>();
    if (value > (bytes_.size() - at_) / size) {
      throw MapFileError("announces " + std::to_string(value) +
                         " entries, more than it has bytes for");
    }
    return value;
  }
  double number() {
    const auto value = get<double>();
    if (!std::isfinite(value)) throw MapFileError("holds a number that is not finite");
    return value;
  }
  Pose pose() {
    Pose result;
    for (int i = 0; i < 3; ++i) result.translation[i] = number();
    if (result.translation.cwiseAbs().maxCoeff() > kFarthest) {
      throw MapFileError("holds a pose more than 100,000 km from the origin");
    }
    for (int i = 0; i < 4; ++i) result.rotation.coeffs()[i] = number();
    if (std::abs(result.rotation.norm() - 1.0) > 1e-6) {
      throw MapFileError("holds a pose whose quaternion is not of unit length");
    }
    return result;
  }
  Matrix6 matrix() {
    Matrix6 result;
    for (int i = 0; i < 36; ++i) result.data()[i] = number();
    return result;
  }
  Eigen::Vector3f point() {
    Eigen::Vector3f result;
    for (int i = 0; i < 3; ++i) result[i] = static_cast<float>(get<std::int16_t>()) / kPerMetre;
    return result;
  }
  [[nodiscard]] bool done() const { return at_ == bytes_.size(); }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

void write_piece(const Piece& piece, Writer& out) {
  out.put(piece.begin_ns);
  out.put(piece.stamp_ns);
  out.put_pose(piece.T_world_piece);
  out.put_pose(piece.T_piece_lidar);
  out.put(piece.way);
  out.put(piece.length);
  out.put_matrix(piece.covariance);
  out.put(static_cast<std::uint8_t>(piece.restarted ? 1 : 0));
  out.put(static_cast<std::uint32_t>(piece.eyes.size()));
  for (const Eigen::Vector3f& eye : piece.eyes) out.put_point(eye);
  out.put(static_cast<std::uint32_t>(piece.points.size()));
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    out.put_point(piece.points[i]);
    out.put(piece.seen_from[i]);
  }
}

Piece read_piece(Reader& in) {
  Piece piece;
  piece.begin_ns = in.get<std::int64_t>();
  piece.stamp_ns = in.get<std::int64_t>();
  piece.T_world_piece = in.pose();
  piece.T_piece_lidar = in.pose();
  piece.way = in.number();
  piece.length = in.number();
  piece.covariance = in.matrix();
  piece.restarted = in.get<std::uint8_t>() != 0;
  piece.eyes.resize(in.count(6));
  for (Eigen::Vector3f& eye : piece.eyes) eye = in.point();
  const std::size_t points = in.count(8);
  piece.points.resize(points);
  piece.seen_from.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    piece.points[i] = in.point();
    piece.seen_from[i] = in.get<std::uint16_t>();
    if (piece.seen_from[i] >= piece.eyes.size()) {
      throw MapFileError("holds a point that was seen from nowhere");
    }
  }
  return piece;
}

void write_place(const PlaceDescriptor& place, Writer& out) {
  for (int i = 0; i < place.bins.size(); ++i) {
    out.put(static_cast<std::uint8_t>(place.bins.data()[i]));
  }
}

PlaceDescriptor read_place(Reader& in) {
  PlaceDescriptor place;
  for (int i = 0; i < place.bins.size(); ++i) {
    place.bins.data()[i] = static_cast<float>(in.get<std::uint8_t>());
  }
  for (int ring = 0; ring < PlaceDescriptor::kRings; ++ring) {
    place.key[ring] = static_cast<float>((place.bins.row(ring).array() > 0.0F).count()) /
                      static_cast<float>(PlaceDescriptor::kSectors);
  }
  return place;
}

SavedMap read_content(Reader& in) {
  SavedMap map;
  const std::size_t pieces = in.count(400);
  for (std::size_t i = 0; i < pieces; ++i) map.pieces.push_back(read_piece(in));
  for (std::size_t i = 0; i < pieces; ++i) map.places.push_back(read_place(in));
  const std::size_t edges = in.count(353);
  for (std::size_t i = 0; i < edges; ++i) {
    PoseEdge edge;
    edge.from = in.get<std::uint32_t>();
    edge.to = in.get<std::uint32_t>();
    if (std::max(edge.from, edge.to) >= pieces) {
      throw MapFileError("holds an edge to a piece that is not there");
    }
    edge.T_from_to = in.pose();
    edge.information = in.matrix();
    edge.inlier = in.get<std::uint8_t>() != 0;
    map.edges.push_back(edge);
  }
  if (!in.done()) throw MapFileError("has more bytes than its content");
  return map;
}

}  // namespace

std::string format_map(const SavedMap& map) {
  Writer content;
  content.put(static_cast<std::uint32_t>(map.pieces.size()));
  for (const Piece& piece : map.pieces) write_piece(piece, content);
  for (const PlaceDescriptor& place : map.places) write_place(place, content);
  content.put(static_cast<std::uint32_t>(map.edges.size()));
  for (const PoseEdge& edge : map.edges) {
    content.put(static_cast<std::uint32_t>(edge.from));
    content.put(static_cast<std::uint32_t>(edge.to));
    content.put_pose(edge.T_from_to);
    content.put_matrix(edge.information);
    content.put(static_cast<std::uint8_t>(edge.inlier ? 1 : 0));
  }
  return sealed(content.take());
}

std::string sealed(std::string_view content) {
  Writer head;
  head.put(kVersion);
  head.put(checksum(content));
  return std::string(kMagic) + head.take() + std::string(content);
}

SavedMap parse_map(std::string_view bytes) {
  if (bytes.substr(0, kMagic.size()) != kMagic) {
    throw MapFileError("is no map: it does not begin with SUREFOOT-MAP");
  }
  bytes.remove_prefix(kMagic.size());
  Reader head(bytes);
  const auto version = head.get<std::uint32_t>();
  if (version != kVersion) {
    throw MapFileError("is a map of version " + std::to_string(version) + ", expected version " +
                       std::to_string(kVersion));
  }
  const auto expected = head.get<std::uint64_t>();
  const std::string_view content = bytes.substr(sizeof(version) + sizeof(expected));
  if (checksum(content) != expected) {
    throw MapFileError("does not have the checksum that it was written with: cut short or changed");
  }
  Reader in(content);
  return read_content(in);
}

}  // namespace surefoot::mapping
