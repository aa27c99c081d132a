// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/paper/registration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/float_sums.hpp"
#include "methods/paper/coupled.hpp"
#include "methods/paper/horizontal.hpp"
#include "methods/paper/vertical.hpp"

namespace surefoot {

namespace {

/// d_max(t), eq. (20); iterations count from 1.
double correspondence_distance(int t, const PaperParameters::Registration& config) {
  return t <= config.early_iterations ? config.relaxed_distance : config.max_distance;  // [Eq 20]
}

/// A search looks this much farther than it must, so that its answer stays known for longer [m].
constexpr double kSearchMargin = 0.3;

/// The nearest point that the last search knows for a point that meanwhile `moved` [m].
struct KnownNearest {
  const Eigen::Vector3f* offset = nullptr;  ///< from where that search was made; null: none
  float distance = std::numeric_limits<float>::infinity();  ///< from the point now [m]
};

KnownNearest nearest_known(const Nearby& nearby, const Eigen::Vector3f& moved) {
  KnownNearest best;
  for (int i = 0; i < nearby.count; ++i) {
    const float squared = squared_norm(nearby.offsets[i] - moved);
    if (squared < best.distance) best = {&nearby.offsets[i], squared};
  }
  best.distance = std::sqrt(best.distance);
  return best;
}

/// Algorithm 1, line 16, for one point. The map does not change meanwhile: after a move of m, what
/// the last search did not name is at least clearance - m away. Whatever is nearer than that, or
/// nothing within max_distance if that is, is the exact answer without a new search.
Match find_match(const LocalMap& map, const Eigen::Vector3d& place, double max_distance,
                 CachedSearch& search) {
  const auto limit = static_cast<float>(max_distance);
  Eigen::Vector3f moved = (place - search.place).cast<float>();
  KnownNearest nearest = nearest_known(search.nearby, moved);
  const float wanted = std::min(nearest.distance, limit);
  if (!(wanted <= search.nearby.clearance - norm(moved))) {
    search = {place, map.nearby(place, static_cast<double>(wanted) + kSearchMargin)};
    moved.setZero();
    nearest = nearest_known(search.nearby, moved);
  }
  if (!(nearest.distance <= limit)) return {};
  return {true, search.place + nearest.offset->cast<double>()};
}

/// Moves q_i along the surface towards s_i, the farther the flatter the surface is there.
///
/// Map points are samples of surfaces, and the LiDAR's rings sample a floor or a long wall alike
/// from everywhere: the nearest sample holds a smoothly walking sensor back, the surface does not.
/// The square leaves bushes and rubble, where no plane stands for the points, to the nearest point.
void slide_on_surface(const Eigen::Vector3d& place, const Surface& surface,
                      Eigen::Vector3d& target) {
  const Eigen::Vector3d apart = place - target;
  const Eigen::Vector3d along = apart - surface.normal * surface.normal.dot(apart);
  target += surface.flatness * surface.flatness * along;
}

/// Algorithm 1, line 16. Returns the number of matches.
int find_correspondences(Source& source, const LocalMap& map, const Pose& T_map_lidar,
                         double max_distance, const PaperParameters& config,
                         const Workers& workers) {
  const bool on_surface = config.registration.target == TargetKind::surface;
  const Eigen::Matrix3d R = T_map_lidar.rotation.toRotationMatrix();
  return workers.sum<int>(source.points.size(), [&](std::size_t begin, std::size_t end) {
    int found = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const Eigen::Vector3d place = R * source.points[i].cast<double>() + T_map_lidar.translation;
      Match& match = source.matches[i];
      match = find_match(map, place, max_distance, source.searches[i]);
      if (!match.found) continue;
      ++found;
      if (!on_surface) continue;
      const Surface& surface = surface_at(map, place, source.surfaces[i]);
      if (surface.neighbours < config.vertical.min_neighbours) continue;
      slide_on_surface(place, surface, match.target);
    }
    return found;
  });
}

template <int Size>
void report(const NormalEquations<Size>& equations, StageReport& stage) {
  ++stage.iterations;
  stage.matches = equations.count;
  stage.residual = equations.rms();
}

/// Lines 17-28: one horizontal update, then U_V vertical ones. Returns the whole update.
Twist update_decoupled(Source& source, const LocalMap& map, const PaperParameters& config,
                       const Workers& workers, const StepObserver& begin_step,
                       Registration& result) {
  begin_step(Step::solve);
  const NormalEquations<3> horizontal =
      horizontal_equations(source, result.T_map_lidar, config.horizontal, workers);
  Twist whole = full_horizontal_update(horizontal.solve());
  result.T_map_lidar = apply_update(result.T_map_lidar, whole);
  report(horizontal, result.horizontal);

  for (int u = 0; u < config.vertical.sub_iterations; ++u) {
    const VerticalEquations vertical =
        vertical_equations(source, map, result.T_map_lidar, config.vertical, workers);
    const Twist delta =
        full_vertical_update(limit_to_trust_region(vertical.solve(), config.vertical.trust_region));
    result.T_map_lidar = apply_update(result.T_map_lidar, delta);
    report(vertical, result.vertical);
    result.vertical.observability =
        vertical.count > 0 ? vertical.observability / vertical.count : 0.0;
    whole += delta;
  }
  return whole;
}

/// The coupled problem, to compare with: one 6-DoF update.
Twist update_coupled(Source& source, const LocalMap& map, const PaperParameters& config,
                     const Workers& workers, const StepObserver& begin_step, Registration& result) {
  begin_step(Step::solve);
  const NormalEquations<6> equations =
      coupled_equations(source, map, result.T_map_lidar, config, workers);
  const Twist delta = equations.solve();
  result.T_map_lidar = apply_update(result.T_map_lidar, delta);
  report(equations, result.coupled);
  return delta;
}

}  // namespace

double max_search_radius(const PaperParameters::Registration& config) {
  return std::max(config.max_distance, config.relaxed_distance) + kSearchMargin;
}

Registration register_scan(Source& source, const LocalMap& map, const Pose& T_0,
                           const PaperParameters& config, int min_matches, const Workers& workers,
                           const StepObserver& begin_step) {
  Registration result;
  // Lines 8-9. T_map_lidar is T_icp * T_0 throughout: updates are applied to it from the left.
  result.T_map_lidar = T_0;
  source.matches.assign(source.points.size(), Match{});
  source.searches.assign(source.points.size(), CachedSearch{});
  source.surfaces.assign(source.points.size(), CachedSurface{});
  const bool coupled = config.registration.mode == RegistrationMode::coupled;

  for (int t = 1; t <= config.registration.max_iterations; ++t) {  // line 10
    begin_step(Step::search);
    const double d_corr = correspondence_distance(t, config.registration);  // lines 11-15
    result.matches = find_correspondences(source, map, result.T_map_lidar, d_corr, config, workers);
    if (result.matches < min_matches) break;  // too little to solve with
    const Twist update = (coupled ? update_coupled : update_decoupled)(source, map, config, workers,
                                                                       begin_step, result);
    result.converged = update.norm() < config.registration.convergence;
    if (!update.allFinite()) break;
    if (result.converged && t > config.registration.early_iterations) break;
  }
  return result;  // line 30
}

}  // namespace surefoot
