// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/airborne.hpp"

#include <cmath>
#include <numbers>

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeAir = 131;
constexpr std::uint64_t kDraws = 4;
// A drop sends back little: seen near the sensor only. Judgement, as the shares are the caller's.
constexpr double kNearest = 0.5;   // [m]
constexpr double kRainMean = 3.5;  // beyond the nearest [m]
constexpr double kDustMean = 1.5;
constexpr double kDriftHz = 0.03;  // turns of the cloud round the robot

}  // namespace

Airborne::Airborne(const AirOptions& options, std::uint64_t seed)
    : options_(options), random_(seed, kPurposeAir) {}

std::optional<double> Airborne::range(std::uint64_t beam, double azimuth, double seconds,
                                      double surface) const {
  const std::uint64_t draw = kDraws * beam;
  const double chance = random_.uniform(draw);
  // (1 + cos)^2 has a mean of 1.5 over a turn.
  const double facing = 1.0 + std::cos(azimuth - 2.0 * std::numbers::pi * kDriftHz * seconds);
  const double dust = options_.dust * facing * facing / 1.5;
  if (chance >= options_.rain + dust) return std::nullopt;
  const double mean = chance < options_.rain ? kRainMean : kDustMean;
  const double range = kNearest - mean * std::log(1.0 - random_.uniform(draw + 1));
  if (range >= surface) return std::nullopt;
  return range;
}

}  // namespace surefoot::simulation
