// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/packed_cloud.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "mapping/bit_stream.hpp"

namespace surefoot::mapping {

namespace {

// 256 steps a metre. Cubes of 64 steps, 0.25 m, are numbered row by row, upwards first, since most
// of what stands stands upright; what lies between two cubes with points is written, and of each
// point where in its cube it is.
constexpr float kPerMetre = 256.0F;
constexpr int kWithin = 6;                           // bits of a coordinate within its cube
constexpr int kAcross = 9;                           // bits of a cube's number along an axis
constexpr int kHalf = 1 << (kWithin + kAcross - 1);  // steps to either side of the origin
constexpr std::uint32_t kMask = (1U << kWithin) - 1U;

struct Entry {
  std::uint32_t cube;
  std::uint32_t within;
  std::uint16_t eye;
};

std::uint32_t steps(float metres) {
  const float scaled = std::round(metres * kPerMetre);
  const auto clamped =
      std::clamp(scaled, static_cast<float>(-kHalf), static_cast<float>(kHalf - 1));
  return static_cast<std::uint32_t>(static_cast<int>(std::isnan(clamped) ? 0.0F : clamped) + kHalf);
}

float metres(std::uint32_t steps) {
  return static_cast<float>(static_cast<int>(steps) - kHalf) / kPerMetre;
}

Entry entry_of(const Eigen::Vector3f& point, std::uint16_t eye) {
  Entry entry{0, 0, eye};
  for (int i = 0; i < 3; ++i) {
    const std::uint32_t at = steps(point[i]);
    entry.cube = entry.cube << kAcross | at >> kWithin;
    entry.within = entry.within << kWithin | (at & kMask);
  }
  return entry;
}

Eigen::Vector3f point_of(std::uint32_t cube, std::uint32_t within) {
  Eigen::Vector3f point;
  for (int i = 2; i >= 0; --i) {
    point[i] = metres((cube & ((1U << kAcross) - 1U)) << kWithin | (within & kMask));
    cube >>= kAcross;
    within >>= kWithin;
  }
  return point;
}

int bits_for(std::size_t eyes) { return eyes > 1 ? static_cast<int>(std::bit_width(eyes - 1)) : 0; }

}  // namespace

std::string pack(const PieceCloud& cloud) {
  std::vector<Entry> entries;
  entries.reserve(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    entries.push_back(entry_of(cloud.points[i], cloud.seen_from[i]));
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.cube < b.cube; });
  BitWriter out;
  out.put(static_cast<std::uint32_t>(cloud.eyes.size()), 32);
  out.put(static_cast<std::uint32_t>(entries.size()), 32);
  for (const Eigen::Vector3f& eye : cloud.eyes) {
    for (int i = 0; i < 3; ++i) out.put(steps(eye[i]), 16);
  }
  const int eye_bits = bits_for(cloud.eyes.size());
  std::uint32_t cube = 0;
  for (const Entry& entry : entries) {
    out.put_gamma(entry.cube - cube);
    out.put(entry.within, 3 * kWithin);
    out.put(entry.eye, eye_bits);
    cube = entry.cube;
  }
  return out.take();
}

PieceCloud unpack(std::string_view bytes) {
  BitReader in(bytes);
  const std::size_t eyes = in.get(32);
  const std::size_t points = in.get(32);
  const int eye_bits = bits_for(eyes);
  // No more are there than there are bits for.
  const std::size_t bits =
      48 * eyes + points * static_cast<std::size_t>(3 * kWithin + 1 + eye_bits);
  if (eyes > 0xFFFF || points > 8 * bytes.size() || bits > 8 * bytes.size()) {
    throw std::invalid_argument("more points than there are bytes for");
  }
  if (points > 0 && eyes == 0) throw std::invalid_argument("a point that was seen from nowhere");
  PieceCloud cloud;
  cloud.eyes.reserve(eyes);
  for (std::size_t i = 0; i < eyes; ++i) {
    Eigen::Vector3f eye;
    for (int k = 0; k < 3; ++k) eye[k] = metres(in.get(16));
    cloud.eyes.push_back(eye);
  }
  cloud.points.reserve(points);
  cloud.seen_from.reserve(points);
  std::uint32_t cube = 0;
  for (std::size_t i = 0; i < points; ++i) {
    cube += in.get_gamma();
    if (cube >= 1U << (3 * kAcross)) throw std::invalid_argument("a cube that is too far away");
    cloud.points.push_back(point_of(cube, in.get(3 * kWithin)));
    cloud.seen_from.push_back(static_cast<std::uint16_t>(in.get(eye_bits)));
    if (cloud.seen_from.back() >= eyes) {
      throw std::invalid_argument("a point that was seen from nowhere");
    }
  }
  return cloud;
}

}  // namespace surefoot::mapping
