// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/return_model.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::simulation {

namespace {

constexpr std::array<FootprintRay, 1> kAxis = {{{0.0, 0.0, 1.0F}}};
// A Gaussian beam's power within its 1/e^2 contour, gathered at the axis and at 0.65 of the radius.
constexpr std::array<FootprintRay, 5> kCross = {{{0.0, 0.0, 0.36F},
                                                 {0.65, 0.0, 0.16F},
                                                 {-0.65, 0.0, 0.16F},
                                                 {0.0, 0.65, 0.16F},
                                                 {0.0, -0.65, 0.16F}}};

/// Real surfaces are rough: at grazing incidence they send back more than Lambert's cosine.
constexpr double kRoughness = 0.05;
constexpr double kReferenceReflectivity = 0.1;
/// A beam that should return is lost now and then.
constexpr double kRandomLoss = 0.003;
/// Width of the passage from always to never detected, in the logarithm of the signal.
constexpr double kDetectionWidth = 0.15;
/// Draws of one beam: two returns, three draws each.
constexpr std::uint64_t kDrawsPerBeam = 8;
constexpr std::uint64_t kDrawsPerReturn = 3;

/// Surfaces of one beam near enough to each other to be one pulse for the sensor.
struct Echo {
  double power = 0.0;  ///< 1: detected half of the time
  double weighted_range = 0.0;
  double weighted_reflectivity = 0.0;
  double nearest = 0.0;
  double farthest = 0.0;
  Met met = Met::still;

  [[nodiscard]] double range() const { return weighted_range / power; }
};

void add_hit(Echo& echo, const LidarModel& model, const Hit& hit, double share) {
  const double range = static_cast<double>(hit.distance);
  const double cosine = (static_cast<double>(hit.cos_incidence) + kRoughness) / (1.0 + kRoughness);
  const double brightness = reflectivity(hit.material) * cosine;
  const double spread = model.half_detection_range / range;
  const double power = share * static_cast<double>(hit.passed) * brightness /
                       kReferenceReflectivity * spread * spread;
  if (echo.power == 0.0) echo.nearest = range;
  echo.farthest = range;
  echo.power += power;
  echo.weighted_range += power * range;
  echo.weighted_reflectivity += power * brightness;
  echo.met = std::max(echo.met, hit.met);
}

/// Groups hits by distance; at most one echo a hit, nearest first.
std::size_t group_hits(const LidarModel& model, std::span<const FootprintRay> footprint,
                       std::span<const Hit> hits, std::array<Echo, kCross.size()>& echoes) {
  std::array<std::size_t, kCross.size()> order{};
  std::size_t met = 0;
  for (std::size_t i = 0; i < std::min(hits.size(), order.size()); ++i) {
    if (!hits[i].valid()) continue;
    std::size_t place = met++;
    for (; place > 0 && hits[order[place - 1]].distance > hits[i].distance; --place) {
      order[place] = order[place - 1];
    }
    order[place] = i;
  }
  std::size_t count = 0;
  for (std::size_t k = 0; k < met; ++k) {
    const Hit& hit = hits[order[k]];
    const bool apart = count == 0 || static_cast<double>(hit.distance) >
                                         echoes[count - 1].farthest + model.pulse_length;
    if (apart) ++count;
    add_hit(echoes[count - 1], model, hit, static_cast<double>(footprint[order[k]].share));
  }
  return count;
}

bool detected(const Echo& echo, double chance) {
  constexpr double kCertain = 20.0;  // odds of 20^(1/0.15): 5e8 to 1
  if (echo.power > kCertain) return chance < 1.0 - kRandomLoss;
  const double odds = std::pow(echo.power, 1.0 / kDetectionWidth);
  const double probability = std::isinf(odds) ? 1.0 : odds / (1.0 + odds);
  return chance < probability * (1.0 - kRandomLoss);
}

BeamReturn measure(const LidarModel& model, const Echo& echo, double standard_normal) {
  // Slanted surfaces stretch the echo as well; only a step of more than this is an edge.
  constexpr double kEdge = 0.1;
  BeamReturn result;
  result.true_range = echo.range();
  const double sigma = model.range_sigma * (1.0 + 1.0 / echo.power);
  const double noisy = result.true_range + sigma * standard_normal;
  result.range = std::round(noisy / model.range_unit) * model.range_unit;
  result.intensity = static_cast<std::uint8_t>(
      std::clamp(std::lround(100.0 * echo.weighted_reflectivity / echo.power), 1L, 255L));
  result.mixed = echo.farthest - echo.nearest > kEdge;
  result.met = echo.met;
  return result;
}

}  // namespace

std::span<const FootprintRay> footprint_rays(bool several) {
  if (several) return kCross;
  return kAxis;
}

BeamReturns detect(const LidarModel& model, std::span<const FootprintRay> footprint,
                   std::span<const Hit> hits, const CounterRandom& random, std::uint64_t counter) {
  std::array<Echo, kCross.size()> echoes{};
  const std::size_t count = group_hits(model, footprint, hits, echoes);
  BeamReturns returns;
  std::array<double, 2> powers{};
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t draw =
        counter * kDrawsPerBeam + std::min<std::uint64_t>(i, 1) * kDrawsPerReturn;
    if (!detected(echoes[i], random.uniform(draw))) continue;
    const BeamReturn value = measure(model, echoes[i], random.normal(draw + 1));
    if (value.range < model.min_range || value.range > model.max_range) continue;
    // The strongest goes first; of the others the last, that is the farthest, is kept.
    if (returns.count == 0 || echoes[i].power <= powers[0]) {
      const int slot = std::min(returns.count, 1);
      returns.values[static_cast<std::size_t>(slot)] = value;
      powers[static_cast<std::size_t>(slot)] = echoes[i].power;
    } else {
      returns.values[1] = returns.values[0];
      returns.values[0] = value;
      powers[0] = echoes[i].power;
    }
    returns.count = std::min(returns.count + 1, 2);
  }
  return returns;
}

}  // namespace surefoot::simulation
