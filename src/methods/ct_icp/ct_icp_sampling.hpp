// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <random>
#include <vector>

#include "core/preprocess.hpp"
#include "methods/ct_icp/ct_icp_parameters.hpp"
#include "methods/shared/cell_index.hpp"

namespace surefoot {

/// A point of a scan: in the LiDAR frame [m], measured at `alpha` of the way from the scan's first
/// pose to its last.
struct CtIcpPoint {
  Eigen::Vector3d point;
  double alpha;
};

[[nodiscard]] CellRounding cell_rounding(const CtIcpParameters& config);

/// CT-ICP's thinning. Its one source of chance is a generator that begins alike in every run.
class CtIcpSampler {
 public:
  explicit CtIcpSampler(const CtIcpParameters& config) : config_(config) {}

  /// One point, by chance, of every cell of `size` [m], in an order by chance. All as if measured
  /// at the scan's last instant if `rigid`, or if the scan has no times.
  [[nodiscard]] std::vector<CtIcpPoint> thin(const PreparedScan& scan, bool rigid, double size);

  /// What is registered of these: ct_icp.sampling, with cells of `size` [m] if by a grid; no more
  /// than ct_icp.max_num_keypoints, by chance, if `limited`.
  [[nodiscard]] std::vector<CtIcpPoint> keypoints(const std::vector<CtIcpPoint>& points,
                                                  double size, bool limited);

 private:
  const CtIcpParameters& config_;
  std::mt19937_64 random_;
};

/// The first point of every cell, by its index; cells grow with the distance from the sensor, and
/// points nearer than 0.5 m or 200 m away and farther are left out.
[[nodiscard]] std::vector<std::size_t> adaptive_sample(const std::vector<CtIcpPoint>& points,
                                                       CellRounding rounding);

}  // namespace surefoot
