// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/companions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "simulation/ground_path.hpp"
#include "simulation/scenes/furniture.hpp"
#include "simulation/walk_plan.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeCompanion = 141;
constexpr double kStep = 0.1;          // of a person's track [s]
constexpr double kChangeEvery = 12.0;  // a place beside the robot is kept about this long [s]
constexpr double kChangeTakes = 3.0;   // [s]
constexpr double kReach = 0.9;         // nobody comes nearer to the sensor [m]
constexpr double kBodyRadius = 0.35;   // [m]

/// Where a person is as seen from the robot's support.
struct Place {
  double angle = 0.0;   ///< to the left of ahead [rad]
  double radius = 0.0;  ///< [m]

  [[nodiscard]] Eigen::Vector2d in_map(double yaw) const {
    return radius * Eigen::Vector2d(std::cos(yaw + angle), std::sin(yaw + angle));
  }
};

double turn_between(double from, double to) {
  return std::remainder(to - from, 2.0 * std::numbers::pi);
}

/// The place that is kept during period `index`: in front, at either side, or behind.
Place kept_place(const CounterRandom& random, std::uint64_t index) {
  constexpr std::array<double, 4> kAngles = {0.0, 1.5, -1.5, 2.6};  // [rad]
  const std::uint64_t draw = 8 * index;
  const auto which = static_cast<std::size_t>(random.bits(draw) % kAngles.size());
  return {kAngles.at(which) + random.uniform(draw + 1, -0.25, 0.25),
          random.uniform(draw + 2, 1.0, 1.5)};
}

/// Walks round the robot from one place to the next, never through it.
Place wanted_place(const CounterRandom& random, double time) {
  const double period = std::floor(time / kChangeEvery);
  const auto index = static_cast<std::uint64_t>(period);
  const double since = time - period * kChangeEvery;
  const double x = std::clamp(since / kChangeTakes, 0.0, 1.0);
  const double part = x * x * (3.0 - 2.0 * x);
  const Place to = kept_place(random, index);
  const Place from = index == 0 ? to : kept_place(random, index - 1);
  return {from.angle + part * turn_between(from.angle, to.angle),
          from.radius + part * (to.radius - from.radius)};
}

/// How far walls let somebody go to a place [m].
double room_to(const Place& place, const Eigen::Vector3d& support, double yaw,
               const RayCaster& rays) {
  constexpr double kChest = 1.0;  // [m]
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  direction.head<2>() = place.in_map(yaw).normalized();
  const Ray ray{(support + Eigen::Vector3d(0.0, 0.0, kChest)).cast<float>(),
                direction.cast<float>(), 0.0F};
  Hit hit;
  rays.cast({&ray, 1}, static_cast<float>(place.radius + kBodyRadius), {&hit, 1});
  const bool blocked = hit.valid() && !is_soft(hit.material);
  return blocked ? static_cast<double>(hit.distance) - kBodyRadius : place.radius;
}

/// Where a person is when the walk begins: on the robot's way where there is no room else.
template <typename Room>
Place first_place(const Place& wanted, const Room& room) {
  return room(wanted) < kReach ? Place{0.0, 1.2} : Place{wanted.angle, room(wanted)};
}

/// Where a person goes from `at` within a step: round the robot towards the wanted place as far as
/// there is room, or else to the robot's own way before or behind it.
template <typename Room>
Place next_place(const Place& at, const Place& wanted, const Room& room) {
  constexpr double kMostTurn = 0.2;    // [rad]
  constexpr double kMostNearer = 0.2;  // [m]
  const auto turned_to = [&](double angle) {
    const double turn = std::clamp(turn_between(at.angle, angle), -kMostTurn, kMostTurn);
    return Place{at.angle + turn, wanted.radius};
  };
  Place next = turned_to(wanted.angle);
  if (room(next) < kReach) next.angle = at.angle;
  if (room(next) < kReach) next = turned_to(std::cos(at.angle) > 0.0 ? 0.0 : std::numbers::pi);
  next.radius =
      std::clamp(std::max(kReach, room(next)), at.radius - kMostNearer, at.radius + kMostNearer);
  return next;
}

}  // namespace

std::vector<MovingObject> make_companions(int count, const Scene& scene, const RayCaster& rays,
                                          const GaitModel& gait, double duration,
                                          std::uint64_t seed) {
  std::vector<MovingObject> people;
  if (count <= 0) return people;
  const std::vector<WalkState> states = plan_walk(gait, duration, seed);
  const GroundPath path(scene, rays, Stance{}, states.back().distance);
  for (int person = 0; person < count; ++person) {
    const CounterRandom random(seed, kPurposeCompanion + static_cast<std::uint64_t>(person) * 1000);
    auto track = std::make_shared<std::vector<Pose>>();
    Place place;
    for (double time = 0.0; time < duration + kStep; time += kStep) {
      const auto k = std::min(states.size() - 1, static_cast<std::size_t>(time / kMotionStep) + 1);
      const PoseAngles support = path.at(states[k].distance);
      const double yaw = support(5);
      const auto room = [&](const Place& to) { return room_to(to, support.head<3>(), yaw, rays); };
      const Place wanted = wanted_place(random, time);
      place = track->empty() ? first_place(wanted, room) : next_place(place, wanted, room);
      Eigen::Vector3d feet = support.head<3>();
      feet.head<2>() += place.in_map(yaw);
      feet.z() =
          rays.ground_below(feet + Eigen::Vector3d(0.0, 0.0, 1.0), 3.0).value_or(support.z());
      track->push_back({from_roll_pitch_yaw({0.0, 0.0, yaw}), feet});
    }
    people.push_back({make_person(), [track](double time) {
                        const double at = std::clamp(time / kStep, 0.0,
                                                     static_cast<double>(track->size() - 1) - 1e-9);
                        const auto i = static_cast<std::size_t>(at);
                        const double part = at - static_cast<double>(i);
                        const Pose& a = (*track)[i];
                        const Pose& b = (*track)[i + 1];
                        return Pose{a.rotation.slerp(part, b.rotation),
                                    a.translation + part * (b.translation - a.translation)};
                      }});
  }
  return people;
}

}  // namespace surefoot::simulation
