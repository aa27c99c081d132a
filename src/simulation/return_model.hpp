// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// From what the rays of one beam met to what the sensor reports: power, mixed pixels, dropouts,
// noise, quantisation.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulation/lidar_model.hpp"
#include "simulation/random.hpp"
#include "simulation/ray_caster.hpp"

namespace surefoot::simulation {

/// Rays over a beam's footprint: offsets in units of half the divergence, and shares of the power.
struct FootprintRay {
  double horizontal = 0.0;
  double vertical = 0.0;
  float share = 1.0F;
};
/// The beam's axis alone, or the axis and four points round it.
[[nodiscard]] std::span<const FootprintRay> footprint_rays(bool several);

struct BeamReturn {
  double range = 0.0;          ///< as reported: noise and quantisation included [m]
  double true_range = 0.0;     ///< what was reported without noise and quantisation [m]
  std::uint8_t intensity = 0;  ///< calibrated reflectivity [%]
  bool mixed = false;          ///< of surfaces at different distances
  Met met = Met::still;
};

/// What one beam reports: none, one or two returns, the strongest first.
struct BeamReturns {
  std::array<BeamReturn, 2> values;
  int count = 0;
};

/// @param hits one a footprint ray, in the order of footprint_rays().
/// @param counter the beam's own number: the random draws hang on it alone.
[[nodiscard]] BeamReturns detect(const LidarModel& model, std::span<const FootprintRay> footprint,
                                 std::span<const Hit> hits, const CounterRandom& random,
                                 std::uint64_t counter);

}  // namespace surefoot::simulation
