// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scanner.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "simulation/rounding.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeBeam = 121;
constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr std::int64_t kTruthStepNs = 2'500'000;  // 400 Hz
constexpr std::size_t kBlockSequences = 16;

/// Trunk and head of a Go2-sized robot, in the body's frame.
Scene robot_body() {
  Scene scene;
  scene.name = "robot body";
  scene.mesh.add_box({-0.35, -0.09, -0.09}, {0.35, 0.09, 0.075}, Material::painted_metal);
  scene.mesh.add_box({0.35, -0.05, -0.04}, {0.52, 0.05, 0.085}, Material::painted_metal);
  return scene;
}

PointLabel label_of(const BeamReturn& value) {
  if (value.met == Met::robot) return kLabelRobot;
  if (value.met == Met::air) return kLabelAir;
  if (value.met == Met::mirrored) return kLabelMirrored;
  if (value.mixed) return kLabelMixed;
  return value.met == Met::moving ? kLabelMoving : kLabelStatic;
}

std::uint64_t first_at_or_after(double time_ns, double sequence_ns) {
  // A turn that is a whole number of sequences must not lose one to rounding.
  return static_cast<std::uint64_t>(std::ceil(time_ns / sequence_ns - 1e-9));
}

/// Unit vector of a clockwise azimuth and an elevation.
Eigen::Vector3d direction_of(double azimuth, double elevation) {
  const double horizontal = std::cos(elevation);
  return {horizontal * std::cos(azimuth), -horizontal * std::sin(azimuth), std::sin(elevation)};
}

void reserve(SimulatedScan& scan, std::size_t points) {
  scan.scan.points.reserve(points);
  scan.scan.intensities.reserve(points);
  scan.scan.times_ns.reserve(points);
  scan.scan.rings.reserve(points);
  scan.raw.reserve(points);
  scan.true_points.reserve(points);
  scan.labels.reserve(points);
}

}  // namespace

Scanner::Scanner(RayCaster& rays, const LidarModel& model, const Motion& motion,
                 const ScannerOptions& options)
    : rays_(&rays),
      model_(model),
      motion_(motion),
      options_(options),
      random_(options.seed, kPurposeBeam),
      air_(options.air, options.seed),
      footprint_(footprint_rays(options.footprint)) {
  for (const Laser& laser : model_.lasers) {
    RotorBeam beam;
    beam.origin = {model_.radial_origin, 0.0, laser.vertical_origin};
    beam.direction = direction_of(laser.azimuth_offset, laser.elevation);
    const Eigen::Vector3d across(-std::sin(laser.azimuth_offset), -std::cos(laser.azimuth_offset),
                                 0.0);
    const Eigen::Vector3d upward = across.cross(beam.direction);
    for (const FootprintRay& part : footprint_) {
      beam.footprint.push_back((beam.direction +
                                0.5 * model_.divergence_horizontal * part.horizontal * across +
                                0.5 * model_.divergence_vertical * part.vertical * upward)
                                   .normalized());
    }
    beam.share = laser.offset_ns / model_.sequence_ns;
    beam.turned = SineCosine(kTwoPi / model_.turn_ns * laser.offset_ns);
    beams_.push_back(std::move(beam));
  }
  if (options_.robot_body) body_ = std::make_unique<RayCaster>(robot_body());
  readings_.resize(kBlockSequences);
  paths_.resize(kBlockSequences);
  azimuths_.resize(kBlockSequences);
  firings_.resize(model_.lasers.size() * kBlockSequences);
  aimed_.resize(firings_.size() * footprint_.size());
  hits_.resize(aimed_.size());
  if (body_) body_hits_.resize(aimed_.size());
}

std::uint64_t Scanner::first_sequence(std::uint64_t index) const {
  return first_at_or_after(static_cast<double>(index) * model_.turn_ns, model_.sequence_ns);
}

std::uint64_t Scanner::scan_count() const {
  return static_cast<std::uint64_t>(std::floor(motion_.duration() * 1e9 / model_.turn_ns + 1e-9));
}

double Scanner::firing_ns(std::uint64_t sequence, std::size_t laser) const {
  return static_cast<double>(sequence) * model_.sequence_ns + model_.lasers[laser].offset_ns;
}

double Scanner::true_azimuth(double time_ns) const {
  return kTwoPi / model_.turn_ns * within_turn(time_ns, model_.turn_ns);
}

Scanner::AzimuthReading Scanner::azimuth_reading(std::uint64_t sequence) const {
  const auto per_reading = static_cast<std::uint64_t>(model_.sequences_per_azimuth);
  AzimuthReading reading;
  reading.time_ns = static_cast<double>(sequence - sequence % per_reading) * model_.sequence_ns;
  reading.azimuth = true_azimuth(reading.time_ns);
  if (model_.azimuth_unit > 0.0) {
    reading.azimuth = rounded_to(model_.azimuth_unit, reading.azimuth);
  }
  return reading;
}

double Scanner::azimuth_after(const AzimuthReading& reading, double time_ns) const {
  const double azimuth = reading.azimuth + kTwoPi / model_.turn_ns * (time_ns - reading.time_ns);
  return azimuth < kTwoPi ? azimuth : azimuth - kTwoPi;
}

double Scanner::reported_azimuth(std::uint64_t sequence, std::size_t laser) const {
  return azimuth_after(azimuth_reading(sequence), firing_ns(sequence, laser));
}

std::size_t Scanner::slot(std::size_t laser, std::size_t sequence) const {
  return laser * kBlockSequences + sequence;
}

/// What the sequences' lasers share.
void Scanner::follow(const Block& block) {
  std::array<double, 2 * kBlockSequences + 1> times{};
  std::array<Pose, times.size()> T_map_lidar;
  const std::size_t ends = 2 * block.sequences + 1;
  const auto begin_ns = [&](double sequence) {
    return (static_cast<double>(block.first) + sequence) * model_.sequence_ns;
  };
  for (std::size_t k = 0; k < ends; ++k) times[k] = 1e-9 * begin_ns(0.5 * static_cast<double>(k));
  motion_.T_map_lidar({times.data(), ends}, {T_map_lidar.data(), ends});
  const SineCosineNear azimuth(true_azimuth(begin_ns(0.0)));
  for (std::size_t i = 0; i < block.sequences; ++i) {
    readings_[i] = azimuth_reading(block.first + i);
    paths_[i] = {T_map_lidar[2 * i], T_map_lidar[2 * i + 1], T_map_lidar[2 * i + 2]};
    azimuths_[i] = azimuth(true_azimuth(begin_ns(static_cast<double>(i))));
  }
}

void Scanner::fire(const Block& block) {
  follow(block);
  for (std::size_t laser = 0; laser < model_.lasers.size(); ++laser) {
    if (laser > 0 && model_.lasers[laser].offset_ns == model_.lasers[laser - 1].offset_ns) {
      std::copy_n(&firings_[slot(laser - 1, 0)], block.sequences, &firings_[slot(laser, 0)]);
    } else {
      fire(block, laser);
    }
  }
}

void Scanner::fire(const Block& block, std::size_t laser) {
  const RotorBeam& beam = beams_[laser];
  Firing* const firings = &firings_[slot(laser, 0)];
  for (std::size_t i = 0; i < block.sequences; ++i) {
    Firing& firing = firings[i];
    firing.sequence = block.first + i;
    firing.time_ns = firing_ns(firing.sequence, laser);
    firing.reported_azimuth = azimuth_after(readings_[i], firing.time_ns);
    firing.rotor = Rotor(azimuths_[i] + beam.turned);
    const Eigen::Matrix<double, 3, 4> T_map_lidar = paths_[i].at(beam.share);
    firing.R_map_rotor = firing.rotor.after(T_map_lidar.leftCols<3>());
    firing.position = T_map_lidar.col(3);
  }
}

void Scanner::aim(const Block& block, double begin_ns, double end_ns) {
  for (std::size_t laser = 0; laser < model_.lasers.size(); ++laser) {
    const RotorBeam& beam = beams_[laser];
    for (std::size_t i = 0; i < block.sequences; ++i) {
      const Firing& firing = firings_[slot(laser, i)];
      const Eigen::Vector3f origin =
          (firing.R_map_rotor * beam.origin + firing.position).cast<float>();
      const double within = (firing.time_ns - begin_ns) / (end_ns - begin_ns);
      Ray* rays = &aimed_[slot(laser, i) * footprint_.size()];
      for (std::size_t part = 0; part < footprint_.size(); ++part) {
        rays[part] = {origin, (firing.R_map_rotor * beam.footprint[part]).cast<float>(),
                      static_cast<float>(std::clamp(within, 0.0, 1.0))};
      }
    }
  }
}

void Scanner::aim_at_body(const Block& block) {
  const Pose& T_body_lidar = motion_.T_body_lidar();
  const Eigen::Matrix3d R_body_lidar = T_body_lidar.rotation.toRotationMatrix();
  for (std::size_t laser = 0; laser < model_.lasers.size(); ++laser) {
    const RotorBeam& beam = beams_[laser];
    for (std::size_t i = 0; i < block.sequences; ++i) {
      const Rotor& rotor = firings_[slot(laser, i)].rotor;
      Ray* rays = &aimed_[slot(laser, i) * footprint_.size()];
      for (std::size_t part = 0; part < footprint_.size(); ++part) {
        rays[part] = {(T_body_lidar * (rotor * beam.origin)).cast<float>(),
                      (R_body_lidar * (rotor * beam.footprint[part])).cast<float>(), 0.0F};
      }
    }
  }
}

void Scanner::hide_behind_body() {
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (!body_hits_[i].valid()) continue;
    hits_[i] = body_hits_[i];
    hits_[i].met = Met::robot;
  }
}

void Scanner::report(const Firing& firing, std::size_t laser, const BeamReturn& value, bool last,
                     SimulatedScan& result) const {
  const RotorBeam& beam = beams_[laser];
  // Not from angles nearby: a coordinate of 1e-16 m would change by more than its float's rounding.
  const Rotor reported(firing.reported_azimuth);
  const std::int64_t time_ns = rounded(firing.time_ns) + options_.start_ns;
  result.scan.points.push_back(
      (reported * (beam.origin + value.range * beam.direction)).cast<float>());
  result.scan.intensities.push_back(static_cast<float>(value.intensity));
  result.scan.times_ns.push_back(static_cast<std::int32_t>(time_ns - result.scan.stamp_ns));
  result.scan.rings.push_back(model_.lasers[laser].ring);
  result.raw.push_back(
      {firing.sequence, static_cast<std::uint16_t>(laser), last, value.range, value.intensity});
  result.true_points.push_back(
      firing.R_map_rotor * (beam.origin + value.true_range * beam.direction) + firing.position);
  result.labels.push_back(label_of(value));
}

void Scanner::add_airborne(const Firing& firing, std::size_t laser, BeamReturns& returns) const {
  double surface = model_.max_range;
  for (int k = 0; k < returns.count; ++k) {
    surface = std::min(surface, returns.values[static_cast<std::size_t>(k)].true_range);
  }
  const std::optional<double> range =
      air_.range(firing.sequence * model_.lasers.size() + laser,
                 firing.reported_azimuth + model_.lasers[laser].azimuth_offset,
                 1e-9 * firing.time_ns, surface);
  if (!range || *range < model_.min_range) return;
  // It hides what is behind it from a sensor that reports one return a beam.
  returns.values[1] = returns.values[0];
  returns.values[0] = BeamReturn{};
  returns.values[0].true_range = *range;
  returns.values[0].range = rounded_to(model_.range_unit, *range);
  returns.values[0].intensity = 1;
  returns.values[0].met = Met::air;
  returns.count = std::min(returns.count + 1, 2);
}

void Scanner::collect(const Block& block, SimulatedScan& result) const {
  for (std::size_t i = 0; i < block.sequences; ++i) {
    for (std::size_t laser = 0; laser < model_.lasers.size(); ++laser) {
      const Firing& firing = firings_[slot(laser, i)];
      const std::span hits =
          std::span(hits_).subspan(slot(laser, i) * footprint_.size(), footprint_.size());
      BeamReturns returns =
          detect(model_, footprint_, hits, random_, firing.sequence * model_.lasers.size() + laser);
      if (!options_.air.clear()) add_airborne(firing, laser, returns);
      const int wanted = std::min(returns.count, options_.dual_return ? 2 : 1);
      for (int k = 0; k < wanted; ++k) {
        const BeamReturn& value = returns.values[static_cast<std::size_t>(k)];
        const bool last =
            wanted == 2 &&
            value.true_range > returns.values[static_cast<std::size_t>(1 - k)].true_range;
        report(firing, laser, value, last, result);
      }
    }
  }
}

SimulatedScan Scanner::scan(std::uint64_t index) {
  SimulatedScan result;
  result.first_sequence = first_sequence(index);
  result.end_sequence = first_sequence(index + 1);
  reserve(result, (result.end_sequence - result.first_sequence) * model_.lasers.size());
  const double begin_ns = static_cast<double>(result.first_sequence) * model_.sequence_ns;
  const double end_ns = static_cast<double>(result.end_sequence) * model_.sequence_ns;
  result.scan.stamp_ns = options_.start_ns + std::llround(begin_ns);
  result.end_ns = options_.start_ns + std::llround(end_ns);
  rays_->set_interval(1e-9 * begin_ns, 1e-9 * end_ns);
  const auto max_distance = static_cast<float>(model_.max_range);
  for (std::uint64_t first = result.first_sequence; first < result.end_sequence;
       first += kBlockSequences) {
    const Block block{first, std::min<std::size_t>(kBlockSequences, result.end_sequence - first)};
    fire(block);
    if (body_) {
      aim_at_body(block);
      body_->cast(aimed_, max_distance, body_hits_);
    }
    aim(block, begin_ns, end_ns);
    rays_->cast(aimed_, max_distance, hits_);
    if (body_) hide_behind_body();
    collect(block, result);
  }
  return result;
}

Trajectory true_trajectory(const Scanner& scanner, std::uint64_t scans) {
  std::vector<std::int64_t> stamps_ns;
  const double sequence_ns = scanner.model().sequence_ns;
  const auto start_of = [&](std::uint64_t scan) {
    return std::llround(static_cast<double>(scanner.first_sequence(scan)) * sequence_ns);
  };
  for (std::uint64_t scan = 0; scan < scans; ++scan) {
    stamps_ns.push_back(start_of(scan));
    stamps_ns.push_back((start_of(scan) + start_of(scan + 1)) / 2);
  }
  stamps_ns.push_back(start_of(scans));
  for (std::int64_t stamp = 0; stamp <= start_of(scans); stamp += kTruthStepNs) {
    stamps_ns.push_back(stamp);
  }
  std::sort(stamps_ns.begin(), stamps_ns.end());
  stamps_ns.erase(std::unique(stamps_ns.begin(), stamps_ns.end()), stamps_ns.end());
  Trajectory truth;
  truth.reserve(stamps_ns.size());
  for (const std::int64_t stamp : stamps_ns) {
    truth.push_back(
        {stamp + scanner.options().start_ns, scanner.motion().T_map_lidar(seconds(stamp))});
  }
  return truth;
}

}  // namespace surefoot::simulation
