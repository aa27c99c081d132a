// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/preprocess.hpp"
#include "methods/floam/floam_parameters.hpp"

namespace surefoot {

/// The features of a scan, as indices of its points.
struct FloamFeatures {
  std::vector<std::uint32_t> edges;
  std::vector<std::uint32_t> surfaces;
};

/// Edges are the points of largest curvature in each sixth of each line, kept apart from one
/// another; surfaces are what is left.
[[nodiscard]] FloamFeatures extract_features(const PreparedScan& scan,
                                             const FloamParameters& config);

/// LOAM's curvature of the point at `i` of a line: |sum of five neighbours on each side minus ten
/// times the point|^2 [m^2]. `i` is at least five from both ends.
[[nodiscard]] double curvature(const std::vector<Eigen::Vector3f>& line, std::size_t i);

/// The line that F-LOAM takes a point for, from its elevation; none if not in [0, scan_line).
[[nodiscard]] int line_of(const Eigen::Vector3f& point, int scan_line);

}  // namespace surefoot
