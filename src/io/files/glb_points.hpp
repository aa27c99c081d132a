// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <string>

namespace surefoot::io {

/// Points within a cube, in 65 536 steps an axis (KHR_mesh_quantization), coloured by height.
struct GlbPoints {
  std::span<const Eigen::Vector3f> points;  ///< [m] z up; what is outside is moved to the side
  Eigen::Vector3f low = Eigen::Vector3f::Zero();  ///< the cube's lowest corner [m]
  float edge = 1.0F;                              ///< of the cube [m]
  std::array<float, 2> heights = {0.0F, 1.0F};    ///< where the colours begin and end [m]
};

/// As binary glTF 2.0, whose y is up as glTF demands: x, z, -y. Of a point the record takes 12
/// bytes.
[[nodiscard]] std::string format_glb(const GlbPoints& tile);

}  // namespace surefoot::io
