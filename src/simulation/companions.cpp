// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/companions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
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

/// Where a person is as seen from the robot's support: ahead and to the left [m].
using Place = Eigen::Vector2d;

/// The place that is kept during period `index`: in front, at either side, or behind.
Place kept_place(const CounterRandom& random, std::uint64_t index) {
  constexpr std::array<double, 4> kAngles = {0.0, 1.5, -1.5, 2.6};  // [rad]
  const std::uint64_t draw = 8 * index;
  const auto which = static_cast<std::size_t>(random.bits(draw) % kAngles.size());
  const double angle = kAngles.at(which) + random.uniform(draw + 1, -0.25, 0.25);
  return random.uniform(draw + 2, 1.0, 1.5) * Place(std::cos(angle), std::sin(angle));
}

/// Walks round the robot from one place to the next, never through it.
Place place_at(const CounterRandom& random, double time) {
  const double period = std::floor(time / kChangeEvery);
  const auto index = static_cast<std::uint64_t>(period);
  const double since = time - period * kChangeEvery;
  const double x = std::clamp(since / kChangeTakes, 0.0, 1.0);
  const double part = x * x * (3.0 - 2.0 * x);
  const Place to = kept_place(random, index);
  const Place from = index == 0 ? to : kept_place(random, index - 1);
  const double from_angle = std::atan2(from.y(), from.x());
  const double turn = std::remainder(std::atan2(to.y(), to.x()) - from_angle, 2.0 * 3.14159265);
  const double angle = from_angle + part * turn;
  return (from.norm() + part * (to.norm() - from.norm())) * Place(std::cos(angle), std::sin(angle));
}

/// The place as far as walls allow; on the robot's way in front of it where there is no room.
Place within_walls(const Place& wanted, const Eigen::Vector3d& support, double yaw,
                   const RayCaster& rays) {
  constexpr double kChest = 1.0;  // [m]
  const Eigen::Vector3d direction(std::cos(yaw) * wanted.x() - std::sin(yaw) * wanted.y(),
                                  std::sin(yaw) * wanted.x() + std::cos(yaw) * wanted.y(), 0.0);
  const Ray ray{(support + Eigen::Vector3d(0.0, 0.0, kChest)).cast<float>(),
                direction.normalized().cast<float>(), 0.0F};
  Hit hit;
  rays.cast({&ray, 1}, static_cast<float>(wanted.norm() + kBodyRadius), {&hit, 1});
  const bool blocked = hit.valid() && !is_soft(hit.material);
  const double room = blocked ? static_cast<double>(hit.distance) - kBodyRadius : wanted.norm();
  if (room >= kReach) return std::min(1.0, room / wanted.norm()) * wanted;
  return {1.2, 0.0};
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
    for (double time = 0.0; time < duration + kStep; time += kStep) {
      const auto k = std::min(states.size() - 1, static_cast<std::size_t>(time / kMotionStep) + 1);
      const PoseAngles support = path.at(states[k].distance);
      const double yaw = support(5);
      const Place place = within_walls(place_at(random, time), support.head<3>(), yaw, rays);
      Eigen::Vector3d feet = support.head<3>();
      feet.x() += std::cos(yaw) * place.x() - std::sin(yaw) * place.y();
      feet.y() += std::sin(yaw) * place.x() + std::cos(yaw) * place.y();
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
