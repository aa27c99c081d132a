// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Looking at a scene from above at an angle, without perspective: pixels to rays, points to pixels.
#pragma once

#include <Eigen/Core>

#include "simulation/ray_caster.hpp"
#include "simulation/scene.hpp"

namespace surefoot::simulation {

class SceneView {
 public:
  /// The route's surroundings. @param width [pixels]; the height follows.
  SceneView(const Scene& scene, int width);
  /// The surroundings of a point. @param metres across the picture's width.
  SceneView(const Scene& scene, const Eigen::Vector3d& center, double metres, int width,
            int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  /// Where a point of the map is seen [pixels from the top left corner].
  [[nodiscard]] Eigen::Vector2d pixel(const Eigen::Vector3d& point) const;
  /// The ray through a pixel. What is above the scene's ceiling, or before its front, is passed by
  /// starting behind it.
  [[nodiscard]] Ray ray(double x, double y) const;
  /// Far enough for every ray [m].
  [[nodiscard]] static float reach();
  /// For every point of the map whether nothing of the scene is before it.
  [[nodiscard]] std::vector<bool> visible(const std::vector<Eigen::Vector3d>& points,
                                          const RayCaster& rays) const;

 private:
  SceneView(const Scene& scene, double azimuth, double elevation);

  Eigen::Vector3d right_;
  Eigen::Vector3d up_;
  Eigen::Vector3d forward_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();  ///< of the picture's plane [m]
  double scale_ = 1.0;                             ///< pixels a metre
  double ceiling_;
  double front_;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace surefoot::simulation
