// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where one submap lies in another's frame.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mapping/gaussian_grid.hpp"
#include "mapping/submap.hpp"

namespace surefoot::mapping {

struct SubmapPoint {
  Eigen::Vector3d at;
  Eigen::Vector3d to_eye;  ///< unit, to where it was seen from
  /// [m^2] How far it lies off what its own submap has there; none where that is sparse.
  std::optional<double> off2;
};

/// A submap made ready: grids to be registered with, and the points that are registered.
class RegistrationSubmap {
 public:
  explicit RegistrationSubmap(const Submap& submap);

  /// Coarse to fine.
  static constexpr std::array<double, 3> kSizes = {2.0, 1.0, 0.5};  // [m]
  [[nodiscard]] const GaussianGrid& grid(std::size_t level) const { return grids_[level]; }
  /// Evenly picked points; half of them stand (walls, poles, leaves), as far as there are any.
  [[nodiscard]] const std::vector<SubmapPoint>& points() const { return points_; }
  /// Of the points that do not lie on ground or ceiling, which tell one place from another: some
  /// thousands, evenly picked.
  [[nodiscard]] const std::vector<SubmapPoint>& standing() const { return standing_; }
  /// Of those that do: floors and ceilings hold the height.
  [[nodiscard]] const std::vector<SubmapPoint>& lying() const { return lying_; }
  /// How many points stand.
  [[nodiscard]] std::size_t standing_count() const { return standing_count_; }

 private:
  std::vector<GaussianGrid> grids_;
  std::vector<SubmapPoint> points_;
  std::vector<SubmapPoint> standing_;
  std::vector<SubmapPoint> lying_;
  std::size_t standing_count_ = 0;
};

/// What a registration ended with.
struct SubmapAlignment {
  Pose T_target_source;
  double matched =
      0.0;  ///< share of the source's standing points that lie on something of the target
  /// [m] How much farther these lie off the target's surfaces than off their own submap's, RMS:
  /// noise, leaves and deskewing are in both.
  double misfit = 0.0;
  double level = 0.0;  ///< share of those that lie likewise; of align_submaps alone
  /// Of small motions in the source's frame; what nothing holds has none.
  Matrix6 information = Matrix6::Zero();
  /// Unit columns, the first `held` of them hold: motions in the source's frame whose rotations are
  /// scaled by kLever.
  Matrix6 axes = Matrix6::Identity();
  int held = 0;
};
/// On the coarsest grid alone and with some of the points: enough to see which start is worth more.
/// Without information and axes.
[[nodiscard]] SubmapAlignment align_roughly(const RegistrationSubmap& target,
                                            const RegistrationSubmap& source, const Pose& start);
/// From a grid to the finest.
[[nodiscard]] SubmapAlignment align_submaps(const RegistrationSubmap& target,
                                            const RegistrationSubmap& source, const Pose& start,
                                            std::size_t first_level = 0);

/// Share of the standing points of one that lie on something of the other; the smaller one of both
/// directions.
[[nodiscard]] double overlap_between(const RegistrationSubmap& one, const RegistrationSubmap& other,
                                     const Pose& T_one_other);

/// How far two alignments of the same submaps lie apart, in what the first one holds.
struct AlignmentGap {
  double metres = 0.0;
  double degrees = 0.0;
};
[[nodiscard]] AlignmentGap gap_between(const SubmapAlignment& alignment, const Pose& other);

}  // namespace surefoot::mapping
