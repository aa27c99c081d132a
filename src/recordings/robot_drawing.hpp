// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "report/canvas.hpp"
#include "simulation/leg_sketch.hpp"

namespace surefoot::recordings {

/// From the map to the page.
using Projection = std::function<report::Pixel(const Eigen::Vector3d&)>;

/// Trunk, head, legs and the LiDAR on top, in the style of a Go2. @param metre pixels a metre.
void draw_robot(report::Canvas& canvas, const Projection& pixel, const Pose& T_map_body,
                const Pose& T_body_lidar, const std::vector<simulation::Leg>& legs, double metre);

}  // namespace surefoot::recordings
