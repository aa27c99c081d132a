// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

namespace surefoot {

/// A k-d tree over a fixed cloud: exact nearest neighbours.
class KdTree {
 public:
  struct Neighbour {
    double distance2;     ///< [m^2]
    std::uint32_t index;  ///< into points()
  };

  KdTree() = default;
  explicit KdTree(std::vector<Eigen::Vector3d> points);

  /// In the tree's own order.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& points() const { return points_; }

  /// The nearest points closer than max_distance [m], as many as `found` has room for, nearest
  /// first; returns how many there are.
  std::size_t nearest(const Eigen::Vector3d& query, double max_distance,
                      std::span<Neighbour> found) const;
  /// The nearest one; null if there is none.
  [[nodiscard]] const Eigen::Vector3d* nearest(const Eigen::Vector3d& query,
                                               double max_distance) const;

 private:
  struct Node {
    std::uint32_t begin, end;  // points of the node
    std::uint32_t right = 0;   // its second child; the first follows it; 0: a leaf
    int axis = 0;
    double low = 0.0, high = 0.0;  // end of the first child's points and begin of the second's
  };
  struct Search;

  void build(std::uint32_t begin, std::uint32_t end);
  void descend(std::uint32_t node, Eigen::Vector3d gaps, Search& search) const;

  std::vector<Eigen::Vector3d> points_;
  std::vector<Node> nodes_;
};

}  // namespace surefoot
