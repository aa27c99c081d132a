// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/map_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <istream>
#include <ostream>
#include <sstream>

#include "mapping/submap.hpp"

namespace surefoot::mapping {

namespace {

constexpr std::string_view kMagic = "SUREFOOT-MAP\n";
constexpr std::uint32_t kVersion = kMapVersion;
constexpr std::uint32_t kUnpacked = 1;  ///< the version whose points were not packed yet
constexpr float kUnpackedPerMetre = 512.0F;
constexpr double kFarthest = 1e8;  // [m] cubes of a submap can still be counted
constexpr std::size_t kHead = 25;  // bytes: magic, version, checksum

/// FNV-1a, 64 bits: enough to find what went wrong on a disk.
class Checksum {
 public:
  void add(std::string_view bytes) {
    for (const char c : bytes) {
      hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
    }
  }
  [[nodiscard]] std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}

  template <typename T>
  void put(T value) {
    put_bytes({reinterpret_cast<const char*>(&value), sizeof(T)});
  }
  void put_bytes(std::string_view bytes) {
    out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    checksum_.add(bytes);
  }
  void put_pose(const Pose& pose) {
    for (int i = 0; i < 3; ++i) put(pose.translation[i]);
    for (int i = 0; i < 4; ++i) put(pose.rotation.coeffs()[i]);
  }
  void put_matrix(const Matrix6& matrix) {
    for (int i = 0; i < 36; ++i) put(matrix.data()[i]);
  }
  [[nodiscard]] std::uint64_t checksum() const { return checksum_.value(); }

 private:
  std::ostream& out_;
  Checksum checksum_;
};

std::string head_of(std::uint32_t version, std::uint64_t checksum) {
  std::string head(kMagic);
  head.append(reinterpret_cast<const char*>(&version), sizeof(version));
  head.append(reinterpret_cast<const char*>(&checksum), sizeof(checksum));
  return head;
}

/// A map's content, from the stream's place on.
class Reader {
 public:
  /// @param clouds the file that the stream reads, for clouds to stay there; none: into memory.
  Reader(std::istream& in, std::uint64_t size, std::shared_ptr<CloudFile> clouds)
      : in_(in), left_(size), clouds_(std::move(clouds)) {}

  template <typename T>
  T get() {
    T value;
    take(reinterpret_cast<char*>(&value), sizeof(T));
    return value;
  }
  /// A number of things of at least `size` bytes each: no more than there are bytes for.
  std::size_t count(std::size_t size) {
    const auto value = get<std::uint32_t>();
    if (value > left_ / size) {
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
  /// Of version 1, in whole numbers.
  Eigen::Vector3f unpacked_point() {
    Eigen::Vector3f result;
    for (int i = 0; i < 3; ++i) {
      result[i] = static_cast<float>(get<std::int16_t>()) / kUnpackedPerMetre;
    }
    return result;
  }
  std::shared_ptr<const StoredCloud> cloud() {
    const std::size_t size = count(1);
    const auto at = static_cast<std::uint64_t>(in_.tellg());
    std::string bytes(size, '\0');
    take(bytes.data(), size);
    try {
      (void)unpack(bytes);
    } catch (const std::invalid_argument& error) {
      throw MapFileError(std::string("holds ") + error.what());
    }
    if (clouds_) return std::make_shared<const StoredCloud>(clouds_, at, size);
    return std::make_shared<const StoredCloud>(std::move(bytes));
  }
  [[nodiscard]] bool done() const { return left_ == 0; }

 private:
  void take(char* to, std::size_t size) {
    if (left_ < size || !in_.read(to, static_cast<std::streamsize>(size))) {
      throw MapFileError("cut short");
    }
    left_ -= size;
  }

  std::istream& in_;
  std::uint64_t left_;
  std::shared_ptr<CloudFile> clouds_;
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
  const std::string cloud = piece.stored ? piece.stored->packed() : pack(piece);
  out.put(static_cast<std::uint32_t>(cloud.size()));
  out.put_bytes(cloud);
}

std::shared_ptr<const StoredCloud> read_unpacked(Reader& in) {
  PieceCloud cloud;
  cloud.eyes.resize(in.count(6));
  for (Eigen::Vector3f& eye : cloud.eyes) eye = in.unpacked_point();
  const std::size_t points = in.count(8);
  cloud.points.resize(points);
  cloud.seen_from.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    cloud.points[i] = in.unpacked_point();
    cloud.seen_from[i] = in.get<std::uint16_t>();
    if (cloud.seen_from[i] >= cloud.eyes.size()) {
      throw MapFileError("holds a point that was seen from nowhere");
    }
  }
  return store(cloud, nullptr);
}

Piece read_piece(Reader& in, std::uint32_t version) {
  Piece piece;
  piece.begin_ns = in.get<std::int64_t>();
  piece.stamp_ns = piece.time_ns = in.get<std::int64_t>();
  piece.T_world_piece = in.pose();
  piece.T_piece_lidar = in.pose();
  piece.way = in.number();
  piece.length = in.number();
  piece.covariance = in.matrix();
  piece.restarted = in.get<std::uint8_t>() != 0;
  piece.stored = version == kUnpacked ? read_unpacked(in) : in.cloud();
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

SavedMap read_content(Reader& in, std::uint32_t version) {
  SavedMap map;
  const std::size_t pieces = in.count(400);
  for (std::size_t i = 0; i < pieces; ++i) map.pieces.push_back(read_piece(in, version));
  for (std::size_t i = 0; i < pieces; ++i) map.places.push_back(read_place(in));
  // Version 1 knew nothing of slopes: its places are described as this version does.
  for (std::size_t i = 0; version == kUnpacked && i < pieces; ++i) {
    map.places[i] = describe_place(make_submap(map.pieces, i));
  }
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

/// What a map's file begins with.
struct Head {
  std::uint32_t version = 0;
  std::uint64_t checksum = 0;
};

Head read_head(std::istream& in) {
  std::string bytes(kHead, '\0');
  in.read(bytes.data(), kHead);
  const auto got = static_cast<std::size_t>(in.gcount());
  if (bytes.substr(0, std::min(got, kMagic.size())) != kMagic) {
    throw MapFileError("is no map: it does not begin with SUREFOOT-MAP");
  }
  if (got < kHead) throw MapFileError("cut short");
  Head head;
  std::memcpy(&head.version, bytes.data() + kMagic.size(), sizeof(head.version));
  std::memcpy(&head.checksum, bytes.data() + kMagic.size() + sizeof(head.version),
              sizeof(head.checksum));
  if (head.version != kVersion && head.version != kUnpacked) {
    throw MapFileError("is a map of version " + std::to_string(head.version) +
                       ", expected version 1 or " + std::to_string(kVersion));
  }
  return head;
}

/// Reads on to the end; returns how many bytes there were.
std::uint64_t check_content(std::istream& in, std::uint64_t expected) {
  Checksum checksum;
  std::string block(std::size_t{1} << 20U, '\0');
  std::uint64_t size = 0;
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    const auto got = static_cast<std::size_t>(in.gcount());
    checksum.add(std::string_view(block).substr(0, got));
    size += got;
  }
  if (checksum.value() != expected) {
    throw MapFileError("does not have the checksum that it was written with: cut short or changed");
  }
  return size;
}

}  // namespace

void write_map(std::ostream& out, const SavedMap& map) {
  const auto begin = out.tellp();
  out << head_of(kVersion, 0);
  Writer content(out);
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
  const auto end = out.tellp();
  out.seekp(begin);
  out << head_of(kVersion, content.checksum());
  out.seekp(end);
}

std::string format_map(const SavedMap& map) {
  std::ostringstream out;
  write_map(out, map);
  return out.str();
}

std::string sealed(std::string_view content, std::uint32_t version) {
  Checksum checksum;
  checksum.add(content);
  return head_of(version, checksum.value()) + std::string(content);
}

SavedMap read_map(std::istream& in, const std::shared_ptr<CloudFile>& clouds) {
  const Head head = read_head(in);
  const std::uint64_t size = check_content(in, head.checksum);
  in.clear();
  in.seekg(kHead);
  Reader content(in, size, clouds);
  return read_content(content, head.version);
}

SavedMap parse_map(std::string_view bytes) {
  std::istringstream in{std::string(bytes)};
  return read_map(in, nullptr);
}

PoseGraph graph_of(const SavedMap& map) {
  PoseGraph graph;
  for (const Piece& piece : map.pieces) graph.poses.push_back(piece.T_world_piece);
  graph.edges = map.edges;
  return graph;
}

}  // namespace surefoot::mapping
