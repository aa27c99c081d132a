// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "core/morton_order.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace surefoot {

namespace {

constexpr int kBits = 10;  // of a coordinate, and of a pass of the sort
constexpr std::uint32_t kCells = 1U << kBits;

/// Two zeros before each of ten bits.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16) & 0x030000ff;
  x = (x | x << 8) & 0x0300f00f;
  x = (x | x << 4) & 0x030c30c3;
  return (x | x << 2) & 0x09249249;
}

struct Entry {
  std::uint32_t key, index;
};

std::vector<Entry> entries_of(const std::vector<Eigen::Vector3f>& points,
                              const std::vector<std::uint32_t>& indices) {
  Eigen::AlignedBox3f box;
  for (const std::uint32_t i : indices) box.extend(points[i]);
  const float widest = std::max(box.sizes().maxCoeff(), 1e-6F);
  const float cells_per_metre = 0.999F * static_cast<float>(kCells) / widest;
  std::vector<Entry> entries;
  entries.reserve(indices.size());
  for (const std::uint32_t i : indices) {
    const Eigen::Vector3f cell = (points[i] - box.min()) * cells_per_metre;
    const auto bits = [&](int axis) { return spread(static_cast<std::uint32_t>(cell[axis])); };
    entries.push_back({bits(0) | bits(1) << 1 | bits(2) << 2, i});
  }
  return entries;
}

/// By ten bits of the key from `shift` on; equal ones stay as they are.
void sort_by_bits(int shift, const std::vector<Entry>& from, std::vector<Entry>& to) {
  const auto digit = [shift](const Entry& entry) { return entry.key >> shift & (kCells - 1); };
  std::array<std::uint32_t, kCells> places{};
  for (const Entry& entry : from) ++places[digit(entry)];
  std::uint32_t sum = 0;
  for (std::uint32_t& place : places) {
    sum += place;
    place = sum - place;
  }
  for (const Entry& entry : from) to[places[digit(entry)]++] = entry;
}

}  // namespace

void sort_along_morton_curve(const std::vector<Eigen::Vector3f>& points,
                             std::vector<std::uint32_t>& indices) {
  if (indices.empty()) return;
  std::vector<Entry> entries = entries_of(points, indices);
  std::vector<Entry> sorted(entries.size());
  for (int pass = 0; pass < 3; ++pass) {
    sort_by_bits(pass * kBits, entries, sorted);
    entries.swap(sorted);
  }
  for (std::size_t i = 0; i < entries.size(); ++i) indices[i] = entries[i].index;
}

}  // namespace surefoot
