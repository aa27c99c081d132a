// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/alignment.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/decompositions.hpp"

namespace surefoot::evaluation {

namespace {

/// First and second moments of the positions, estimate x and reference y (Umeyama, eqs. 34-38).
struct Moments {
  Eigen::Vector3d mean_x = Eigen::Vector3d::Zero(), mean_y = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_yx = Eigen::Matrix3d::Zero();
  double variance_x = 0.0;
};

Moments moments(const AssociatedTrajectories& pairs, std::size_t count) {
  Moments result;
  const auto n = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    result.mean_x += pairs.estimate[i].pose.translation / n;
    result.mean_y += pairs.reference[i].pose.translation / n;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d x = pairs.estimate[i].pose.translation - result.mean_x;
    const Eigen::Vector3d y = pairs.reference[i].pose.translation - result.mean_y;
    result.covariance_yx += y * x.transpose() / n;
    result.variance_x += x.squaredNorm() / n;
  }
  return result;
}

/// Adds the orientations as if each pose had three more points, a metre from it along its axes:
/// |R A_i - B_i|_F^2 has its minimum where tr(R A_i B_i^T) is largest, as for positions.
void add_orientations(const AssociatedTrajectories& pairs, std::size_t count, Moments& m) {
  const auto n = static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Matrix3d x = pairs.estimate[i].pose.rotation.toRotationMatrix();
    const Eigen::Matrix3d y = pairs.reference[i].pose.rotation.toRotationMatrix();
    m.covariance_yx += y * x.transpose() / n;
  }
}

constexpr double kRankTolerance = 1e-12;  // relative to the largest singular value

/// Entries of the covariance that may come from rounding alone.
double rounding_of(const Moments& m) {
  constexpr double kRounding = 1e-14;  // of a position minus the mean, relative to the position
  return kRounding * kRounding * m.mean_x.norm() * m.mean_y.norm();
}

/// By the singular values of the covariance: two directions decide a rotation.
bool decide_rotation(const Eigen::Vector3d& d, const Moments& m) {
  return d[1] > std::max(kRankTolerance * d[0], rounding_of(m));
}

TrajectoryAlignment umeyama(const Moments& m, bool with_scale) {
  const auto [U, V, d] = svd(m.covariance_yx);
  if (!decide_rotation(d, m)) {
    throw std::runtime_error(
        "the positions lie on one line or in one place, which leaves a rotation undetermined: "
        "align by poses, by origin or by yaw and translation (--align poses, origin, yaw)");
  }
  Eigen::Vector3d s = Eigen::Vector3d::Ones();  // keeps a reflection out (eq. 43)
  if (U.determinant() * V.determinant() < 0.0) s[2] = -1.0;
  const Eigen::Matrix3d rotation = U * s.asDiagonal() * V.transpose();  // eq. 40
  const double scale = with_scale ? d.dot(s) / m.variance_x : 1.0;      // eq. 42
  return {{Eigen::Quaterniond(rotation).normalized(),
           m.mean_y - scale * (rotation * m.mean_x)},  // eq. 41
          scale};
}

TrajectoryAlignment yaw_translation(const Moments& m) {
  const Eigen::Matrix3d& c = m.covariance_yx;
  const double sine = c(1, 0) - c(0, 1), cosine = c(0, 0) + c(1, 1);
  if (!(std::hypot(sine, cosine) > rounding_of(m))) {
    throw std::runtime_error(
        "the positions lie above one place, which leaves the yaw undetermined: "
        "align by poses or by origin (--align poses, origin)");
  }
  const Eigen::Quaterniond rotation(
      Eigen::AngleAxisd(std::atan2(sine, cosine), Eigen::Vector3d::UnitZ()));
  return {{rotation, m.mean_y - rotation * m.mean_x}, 1.0};
}

/// Mean square of what is left between the positions once they are aligned, along one axis [m^2].
double left_over(const AssociatedTrajectories& pairs, std::size_t count,
                 const TrajectoryAlignment& alignment) {
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3d x = alignment.scale * pairs.estimate[i].pose.translation;
    sum += (alignment.pose * x - pairs.reference[i].pose.translation).squaredNorm();
  }
  return sum / (3.0 * static_cast<double>(count));
}

}  // namespace

TrajectoryAlignment find_alignment(const AssociatedTrajectories& pairs, AlignmentMethod method,
                                   std::size_t poses) {
  const std::size_t all = pairs.estimate.size();
  const std::size_t count = poses == 0 ? all : std::min(poses, all);
  switch (method) {
    case AlignmentMethod::none:
      return {};
    case AlignmentMethod::origin:
      return {pairs.reference.front().pose * pairs.estimate.front().pose.inverse(), 1.0};
    case AlignmentMethod::yaw_translation:
      return yaw_translation(moments(pairs, count));
    case AlignmentMethod::rigid:
      return umeyama(moments(pairs, count), false);
    case AlignmentMethod::poses: {
      Moments m = moments(pairs, count);
      add_orientations(pairs, count, m);
      return umeyama(m, false);
    }
    case AlignmentMethod::similarity:
      return umeyama(moments(pairs, count), true);
    case AlignmentMethod::scale:
      return {{}, umeyama(moments(pairs, count), true).scale};
  }
  throw std::invalid_argument("unknown alignment method");
}

bool leaves_turn_open(const AssociatedTrajectories& pairs, AlignmentMethod method,
                      std::size_t poses) {
  if (method != AlignmentMethod::rigid && method != AlignmentMethod::similarity) return false;
  constexpr double kNarrow = 0.02;  // what the way spreads sideways, of what along
  constexpr double kClear = 3.0;    // what it spreads sideways, of what is left after alignment
  const std::size_t all = pairs.estimate.size();
  const std::size_t count = poses == 0 ? all : std::min(poses, all);
  const Moments m = moments(pairs, count);
  const Eigen::Vector3d spread = svd(m.covariance_yx).values;
  if (!decide_rotation(spread, m) || spread[1] < kNarrow * kNarrow * spread[0]) return true;
  const TrajectoryAlignment found = umeyama(m, method == AlignmentMethod::similarity);
  return found.scale * spread[1] < kClear * kClear * left_over(pairs, count, found);
}

Trajectory aligned(const Trajectory& trajectory, const TrajectoryAlignment& alignment) {
  Trajectory result = trajectory;
  for (StampedPose& stamped : result) {
    stamped.pose.translation *= alignment.scale;
    stamped.pose = alignment.pose * stamped.pose;
  }
  return result;
}

}  // namespace surefoot::evaluation
