// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Ray casting by Embree. Nothing of Embree is seen outside ray_caster.cpp and embree.hpp.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "simulation/scene.hpp"

namespace surefoot::simulation {

struct Ray {
  Eigen::Vector3f origin;
  Eigen::Vector3f direction;  ///< unit length
  float time = 0.0F;          ///< of the instant within the span given to set_interval, in [0, 1]
};

/// What a ray can meet; of several, the greatest names a return. Mirrored: seen in a pane.
enum class Met : std::uint8_t { still, moving, robot, mirrored, air };

struct Hit {
  float distance = 0.0F;       ///< [m]; not positive: nothing was met
  float cos_incidence = 0.0F;  ///< |cos| of the angle between ray and normal
  float passed = 1.0F;         ///< share of the light that panes let there and back
  Material material = Material::asphalt;
  Met met = Met::still;
  [[nodiscard]] bool valid() const { return distance > 0.0F; }
};

/// Answers rays against a scene. Not safe for use by several threads at once.
class RayCaster {
 public:
  explicit RayCaster(const Scene& scene);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// Adds something that moves.
  void add(const MovingObject& object);
  /// Puts the moving objects where they are between two instants [s]; in between they move evenly.
  void set_interval(double begin, double end);
  /// One hit a ray. @param max_distance [m]. Rays next to each other in the span should point in
  /// similar directions: they are cast 8 at a time. Panes let a ray through or mirror it; the
  /// distance is then that along its whole way.
  void cast(std::span<const Ray> rays, float max_distance, std::span<Hit> hits) const;
  /// Height of the ground under a point [m], if there is any within `depth`: of what stands still
  /// and bears a foot.
  [[nodiscard]] std::optional<double> ground_below(const Eigen::Vector3d& point,
                                                   double depth) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace surefoot::simulation
