// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Drops and dust in the air: beams that return from nearer than any surface.
#pragma once

#include <cstdint>
#include <optional>

#include "simulation/random.hpp"

namespace surefoot::simulation {

/// Shares of the beams that end in the air, over all directions.
struct AirOptions {
  double rain = 0.0;  ///< drops, the same all round
  double dust = 0.0;  ///< a cloud that drifts round the robot: dense on one side, thin on the other
  [[nodiscard]] bool clear() const { return rain <= 0.0 && dust <= 0.0; }
};

class Airborne {
 public:
  Airborne(const AirOptions& options, std::uint64_t seed);

  /// Where a beam ends in the air [m], if it does and no surface is nearer.
  /// @param beam its number: the draws hang on it alone. @param azimuth of the beam [rad].
  /// @param seconds since the recording's start. @param surface distance of what it meets [m].
  [[nodiscard]] std::optional<double> range(std::uint64_t beam, double azimuth, double seconds,
                                            double surface) const;

 private:
  AirOptions options_;
  CounterRandom random_;
};

}  // namespace surefoot::simulation
