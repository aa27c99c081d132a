// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/return_model.hpp"

#include <algorithm>
#include <cmath>

#include "simulation/rounding.hpp"

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

/// Which hits met something, nearest first.
class NearestFirst {
 public:
  explicit NearestFirst(std::span<const Hit> hits) {
    for (std::size_t i = 0; i < std::min(hits.size(), order_.size()); ++i) {
      if (!hits[i].valid()) continue;
      std::size_t place = count_++;
      for (; place > 0 && hits[order_[place - 1]].distance > hits[i].distance; --place) {
        order_[place] = order_[place - 1];
      }
      order_[place] = i;
    }
  }
  [[nodiscard]] bool empty() const { return next_ == count_; }
  [[nodiscard]] std::size_t front() const { return order_[next_]; }
  void pop_front() { ++next_; }

 private:
  std::array<std::size_t, kCross.size()> order_{};
  std::size_t count_ = 0;
  std::size_t next_ = 0;
};

/// Takes the nearest hit and those near enough to it or to each other.
Echo take_echo(const LidarModel& model, std::span<const FootprintRay> footprint,
               std::span<const Hit> hits, NearestFirst& left) {
  Echo echo;
  do {
    const Hit& hit = hits[left.front()];
    add_hit(echo, model, hit, static_cast<double>(footprint[left.front()].share));
    left.pop_front();
  } while (!left.empty() &&
           static_cast<double>(hits[left.front()].distance) <= echo.farthest + model.pulse_length);
  return echo;
}

/// Compares chance with odds / (1 + odds).
bool detected(const Echo& echo, double chance) {
  constexpr double kCertain = 20.0;  // odds of 20^(1/0.15): 5e8 to 1
  constexpr double kKept = 1.0 - kRandomLoss;
  if (echo.power > kCertain) return chance < kKept;
  // The exponent lies between 6 and 7, and nearly all chances beyond both: no power is needed.
  static_assert(1.0 / kDetectionWidth > 6.0 && 1.0 / kDetectionWidth < 7.0);
  constexpr double kRounding = 1e-9;
  const double cube = echo.power * echo.power * echo.power;
  const double sixth = cube * cube;
  const double seventh = sixth * echo.power;
  const auto [low, high] = std::minmax(sixth, seventh);
  if (chance * (1.0 + low) < (1.0 - kRounding) * kKept * low) return true;
  if (chance * (1.0 + high) > (1.0 + kRounding) * kKept * high) return false;
  const double odds = std::pow(echo.power, 1.0 / kDetectionWidth);
  return chance < odds / (1.0 + odds) * kKept;
}

BeamReturn measure(const LidarModel& model, const Echo& echo, double standard_normal) {
  // Slanted surfaces stretch the echo as well; only a step of more than this is an edge.
  constexpr double kEdge = 0.1;
  BeamReturn result;
  result.true_range = echo.range();
  const double sigma = model.range_sigma * (1.0 + 1.0 / echo.power);
  const double noisy = result.true_range + sigma * standard_normal;
  result.range = rounded_to(model.range_unit, noisy);
  result.intensity = static_cast<std::uint8_t>(
      std::clamp<std::int64_t>(rounded(100.0 * echo.weighted_reflectivity / echo.power), 1, 255));
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
  NearestFirst left(hits);
  BeamReturns returns;
  std::array<double, 2> powers{};
  for (std::uint64_t i = 0; !left.empty(); ++i) {
    const Echo echo = take_echo(model, footprint, hits, left);
    const std::uint64_t draw =
        counter * kDrawsPerBeam + std::min<std::uint64_t>(i, 1) * kDrawsPerReturn;
    if (!detected(echo, random.uniform(draw))) continue;
    const BeamReturn value = measure(model, echo, random.normal(draw + 1));
    if (value.range < model.min_range || value.range > model.max_range) continue;
    // The strongest goes first; of the others the last, that is the farthest, is kept.
    if (returns.count == 0 || echo.power <= powers[0]) {
      const int slot = std::min(returns.count, 1);
      returns.values[static_cast<std::size_t>(slot)] = value;
      powers[static_cast<std::size_t>(slot)] = echo.power;
    } else {
      returns.values[1] = returns.values[0];
      returns.values[0] = value;
      powers[0] = echo.power;
    }
    returns.count = std::min(returns.count + 1, 2);
  }
  return returns;
}

}  // namespace surefoot::simulation
