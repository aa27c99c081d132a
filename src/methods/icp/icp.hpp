// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "core/parallel.hpp"
#include "methods/icp/icp_parameters.hpp"
#include "methods/shared/alignment.hpp"

namespace surefoot {

/// Sums over matched pairs from which the rigid motion between them follows in closed form.
struct PairSum {
  int count = 0;
  Eigen::Vector3d source = Eigen::Vector3d::Zero();
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
  Eigen::Matrix3d target_source = Eigen::Matrix3d::Zero();  // sum of q s^T
  double squares = 0.0;                                     // sum of |s - q|^2

  void add(const Eigen::Vector3d& s, const Eigen::Vector3d& q);
  PairSum& operator+=(const PairSum& other);
  /// The motion that takes the sources nearest to their targets, by SVD (Arun, Umeyama).
  [[nodiscard]] Pose motion() const;
};

/// The nearest target to a point that is closer than a distance [m]; null if there is none.
using NearestTarget = std::function<const Eigen::Vector3d*(const Eigen::Vector3d&, double)>;

/// Point-to-point ICP (Besl and McKay, PAMI 1992) in the form of Open3D's registration_icp: match
/// every point with its nearest target, move by the closed form, until neither the share of matched
/// points nor their RMS distance changes.
[[nodiscard]] Alignment icp(const std::vector<Eigen::Vector3d>& points,
                            const NearestTarget& nearest, const Pose& initial_guess,
                            const IcpParameters& config, const Workers& workers);

}  // namespace surefoot
