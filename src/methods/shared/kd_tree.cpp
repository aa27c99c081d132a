// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/shared/kd_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

namespace surefoot {

namespace {
constexpr std::uint32_t kLeaf = 12;  // points that are cheaper to look at than to split
}

struct KdTree::Search {
  Eigen::Vector3d query;
  double limit2;  // what is not nearer does not matter
  std::span<Neighbour> found;
  std::size_t count = 0;

  void offer(double distance2, std::uint32_t index) {
    std::size_t place = count < found.size() ? count++ : count - 1;
    for (; place > 0 && found[place - 1].distance2 > distance2; --place) {
      found[place] = found[place - 1];
    }
    found[place] = {distance2, index};
    if (count == found.size()) limit2 = found[count - 1].distance2;
  }
};

KdTree::KdTree(std::vector<Eigen::Vector3d> points) : points_(std::move(points)) {
  if (points_.empty()) return;
  nodes_.reserve(4 * points_.size() / kLeaf + 1);
  build(0, static_cast<std::uint32_t>(points_.size()));
}

/// Splits at the median of the longest side.
void KdTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t node = nodes_.size();
  nodes_.push_back({begin, end});
  if (end - begin <= kLeaf) return;
  Eigen::AlignedBox3d box;
  for (std::uint32_t i = begin; i < end; ++i) box.extend(points_[i]);
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto at = [&](std::uint32_t i) { return points_.begin() + i; };
  const auto by_axis = [axis](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return a[axis] < b[axis];
  };
  std::nth_element(at(begin), at(middle), at(end), by_axis);
  nodes_[node].axis = axis;
  nodes_[node].low = (*std::max_element(at(begin), at(middle), by_axis))[axis];
  nodes_[node].high = points_[middle][axis];
  build(begin, middle);
  nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
  build(middle, end);
}

/// `gaps`: per axis, how far the query lies outside of the node's points at least.
void KdTree::descend(std::uint32_t node, Eigen::Vector3d gaps, Search& search) const {
  const Node& here = nodes_[node];
  if (here.right == 0) {
    for (std::uint32_t i = here.begin; i < here.end; ++i) {
      const double distance2 = (points_[i] - search.query).squaredNorm();
      if (distance2 < search.limit2) search.offer(distance2, i);
    }
    return;
  }
  const double value = search.query[here.axis];
  const bool first = value - here.low < here.high - value;  // the nearer side comes first
  descend(first ? node + 1 : here.right, gaps, search);
  gaps[here.axis] = std::max(gaps[here.axis], first ? here.high - value : value - here.low);
  if (gaps.squaredNorm() < search.limit2) descend(first ? here.right : node + 1, gaps, search);
}

std::size_t KdTree::nearest(const Eigen::Vector3d& query, double max_distance,
                            std::span<Neighbour> found) const {
  if (nodes_.empty() || found.empty()) return 0;
  Search search{query, max_distance * max_distance, found};
  descend(0, Eigen::Vector3d::Zero(), search);
  return search.count;
}

const Eigen::Vector3d* KdTree::nearest(const Eigen::Vector3d& query, double max_distance) const {
  Neighbour found;
  return nearest(query, max_distance, {&found, 1}) == 0 ? nullptr : &points_[found.index];
}

}  // namespace surefoot
