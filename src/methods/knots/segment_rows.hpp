// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>

#include "surefoot/pose.hpp"

namespace surefoot {

/// A point's residual across its surfel.
struct SurfelResidual {
  Eigen::Vector3d normal;
  Eigen::Vector3d arm;  ///< from the sensor to the point [m]
  double value;         ///< [m]
  double u;             ///< the point's share of the segment
  double variance;      ///< that is expected of it [m^2]
  double weight;        ///< how much it counts, whatever its value
  double part;          ///< of the point's misfit
};

/// Sums over a segment's residuals; w is their weight under the robust kernel.
struct SegmentSums {
  Matrix6 first = Matrix6::Zero();    ///< sum (1 - u)^2 w J^T J
  Matrix6 between = Matrix6::Zero();  ///< sum u (1 - u) w J^T J
  Matrix6 last = Matrix6::Zero();     ///< sum u^2 w J^T J
  Twist first_gradient = Twist::Zero();
  Twist last_gradient = Twist::Zero();
  double weight = 0.0;
  double weighted_squares = 0.0;
  double squared_distance = 0.0;  ///< sum w |arm|^2
  double misfit = 0.0;            ///< of their points, each 0 to 1
  int count = 0;
  /// Gradients of neighbours: of the segment's surfels that face along x, y and z.
  std::array<Twist, 3> neighbours = {Twist::Zero(), Twist::Zero(), Twist::Zero()};

  /// H of both knots moved as one.
  [[nodiscard]] Matrix6 rigid() const { return first + 2.0 * between + last; }
};

/// A segment's residuals, weighed and summed up a block at a time. What is known of them stands in
/// columns of floats, so that a processor works on several at once: Eigen sees to that, whatever
/// the processor. Blocks are added up in double.
class SegmentRows {
 public:
  /// `neighbours`: whether the sums are to hold those.
  explicit SegmentRows(bool neighbours) : neighbours_(neighbours) {}

  /// Here, so that a residual goes into its columns without being put together first.
  void add(const SurfelResidual& residual) {
    const Eigen::Vector3d turn = residual.arm.cross(residual.normal);
    for (int i = 0; i < 3; ++i) {
      columns_(rows_, i) = static_cast<float>(residual.normal[i]);
      columns_(rows_, i + 3) = static_cast<float>(turn[i]);
    }
    columns_(rows_, kValue) = static_cast<float>(residual.value);
    u_[rows_] = static_cast<float>(residual.u);
    variance_[rows_] = static_cast<float>(residual.variance);
    weight_[rows_] = static_cast<float>(residual.weight);
    part_[rows_] = static_cast<float>(residual.part);
    squared_distance_[rows_] = static_cast<float>(residual.arm.squaredNorm());
    if (++rows_ == kRows) sum_up();
  }
  [[nodiscard]] const SegmentSums& sums();

 private:
  static constexpr int kRows = 32;  // of a block: it stays in the nearest cache
  static constexpr int kValue = 6;  // the column after J's
  using Column = Eigen::Array<float, kRows, 1>;

  void sum_up();
  void add_products(const Column& w);
  void add_neighbours(const Column& w);

  bool neighbours_;
  int rows_ = 0;
  Eigen::Array<float, kRows, 7> columns_ = Eigen::Array<float, kRows, 7>::Zero();  // J, value
  Column u_ = Column::Zero();
  Column variance_ = Column::Ones();
  Column weight_ = Column::Zero();
  Column part_ = Column::Zero();
  Column squared_distance_ = Column::Zero();
  SegmentSums sums_;
};

}  // namespace surefoot
