// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/segment_sum.hpp"

#include <array>

#include "core/segment_motion.hpp"

namespace surefoot {

namespace {

/// The residual of a point [m] across one of the directions of a surfel. Neighbouring points share
/// the error of their surfel and of their instant, so that many count as few; within a cloud, fewer
/// yet.
SurfelResidual residual_of(const Eigen::Vector3d& place, const Surfel& surfel, int direction,
                           const Look& look, const Config::Knots& config) {
  SurfelResidual residual;
  residual.normal = surfel.across(direction);
  residual.value = residual.normal.dot(place - surfel.mean);  // [K2]
  residual.variance = look.inflation * (config.noise * config.noise + surfel.variance(direction));
  residual.weight = static_cast<double>(look.stride) * config.independence *
                    (surfel.cloud() ? config.cloud_weight : 1.0);
  residual.part = 1.0 / surfel.directions;
  return residual;
}

/// A segment's points, moved and looked up some at a time.
template <typename Function>
void for_surfels(KnotPoints& points, std::size_t segment, const SurfelMap& map,
                 const KnotWindow& window, const Look& look, const Function& f) {
  const Pose& T_first = window.knots[segment + 1];
  const Pose& T_last = window.knots[segment + 2];
  const SegmentMotion motion(T_first, se3_log(T_first.inverse() * T_last));  // [K1]
  const Eigen::Vector3d way = T_last.translation - T_first.translation;
  std::array<SurfelMap::Question, SurfelMap::kAtOnce> questions;
  std::array<double, SurfelMap::kAtOnce> shares;
  const std::size_t end = points.begins[segment + 1];
  for (std::size_t i = points.begins[segment]; i < end;) {
    std::size_t n = 0;
    for (; n < questions.size() && i < end; ++n, i += look.stride) {
      KnotPoints::Point& point = points.points[i];
      const Eigen::Vector3d place = motion(point.share, point.position);
      const Eigen::Vector3d sensor = T_first.translation + point.share * way;
      questions[n] = {place, place - sensor, &point.place};
      shares[n] = point.share;
    }
    map.find_all({questions.data(), n}, look.finest);
    for (std::size_t k = 0; k < n; ++k) f(questions[k], shares[k]);
  }
}

}  // namespace

SegmentSum sum_segment(KnotPoints& points, std::size_t segment, const SurfelMap& map,
                       const KnotWindow& window, const Look& look, const Config::Knots& config) {
  SegmentSum sum;
  SegmentRows rows(look.last), doubtful(false);
  for_surfels(points, segment, map, window, look, [&](const SurfelMap::Question& point, double u) {
    const Surfel* const surfel = point.last->surfel;
    ++(surfel == nullptr ? sum.unseen : sum.matches);
    if (surfel != nullptr && surfel->cloud()) ++sum.clouds;
    for (int d = 0; surfel != nullptr && d < surfel->directions; ++d) {
      SurfelResidual residual = residual_of(point.place, *surfel, d, look, config);
      residual.arm = point.ray;
      residual.u = u;
      rows.add(residual);
      if (!look.last || surfel->worth(d) >= 1.0) continue;
      residual.weight *= 1.0 - surfel->worth(d);
      doubtful.add(residual);
    }
  });
  sum.surfels = rows.sums();
  sum.doubtful = doubtful.sums();
  return sum;
}

}  // namespace surefoot
