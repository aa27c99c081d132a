// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "simulation/scanner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace surefoot::simulation {

namespace {

constexpr std::uint64_t kPurposeBeam = 121;
constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr std::int64_t kTruthStepNs = 2'500'000;  // 400 Hz

/// Trunk and head of a Go2-sized robot, in the LiDAR's frame: the sensor stands on its back.
Scene robot_body() {
  Scene scene;
  scene.name = "robot body";
  scene.mesh.add_box({-0.35, -0.09, -0.25}, {0.25, 0.09, -0.085}, Material::kPaintedMetal);
  scene.mesh.add_box({0.25, -0.05, -0.20}, {0.42, 0.05, -0.075}, Material::kPaintedMetal);
  return scene;
}

std::uint64_t first_at_or_after(double time_ns, double sequence_ns) {
  // A turn that is a whole number of sequences must not lose one to rounding.
  return static_cast<std::uint64_t>(std::ceil(time_ns / sequence_ns - 1e-9));
}

}  // namespace

/// One firing: where it leaves from and where it goes, in the LiDAR's frame and in the map's.
struct Scanner::Beam {
  Pose T_map_lidar;
  Eigen::Vector3d origin_lidar;
  Eigen::Vector3d direction_lidar;  ///< as the rotor really stands
};

Scanner::Scanner(RayCaster& rays, const LidarModel& model, const Motion& motion,
                 const ScannerOptions& options)
    : rays_(&rays),
      model_(model),
      motion_(motion),
      options_(options),
      random_(options.seed, kPurposeBeam) {
  if (options_.robot_body) body_ = std::make_unique<RayCaster>(robot_body());
  const std::size_t rays_per_sequence =
      model_.lasers.size() * footprint_rays(options_.footprint).size();
  beams_.resize(model_.lasers.size());
  aimed_.resize(rays_per_sequence);
  hits_.resize(rays_per_sequence);
  if (body_) {
    aimed_body_.resize(rays_per_sequence);
    body_hits_.resize(rays_per_sequence);
  }
}

Scanner::~Scanner() = default;

std::uint64_t Scanner::first_sequence(std::uint64_t index) const {
  return first_at_or_after(static_cast<double>(index) * model_.turn_ns, model_.sequence_ns);
}

std::uint64_t Scanner::scan_count() const {
  return static_cast<std::uint64_t>(std::floor(motion_.duration() * 1e9 / model_.turn_ns + 1e-9));
}

double Scanner::firing_ns(std::uint64_t sequence, std::size_t laser) const {
  return static_cast<double>(sequence) * model_.sequence_ns + model_.lasers[laser].offset_ns;
}

double Scanner::reported_azimuth(std::uint64_t sequence, std::size_t laser) const {
  const auto per_reading = static_cast<std::uint64_t>(model_.sequences_per_azimuth);
  const double rate = kTwoPi / model_.turn_ns;
  const double read_ns =
      static_cast<double>(sequence - sequence % per_reading) * model_.sequence_ns;
  double reading = rate * std::fmod(read_ns, model_.turn_ns);
  if (model_.azimuth_unit > 0.0) {
    reading = std::round(reading / model_.azimuth_unit) * model_.azimuth_unit;
  }
  const double azimuth =
      reading + rate * (firing_ns(sequence, laser) - read_ns) + model_.lasers[laser].azimuth_offset;
  return azimuth - kTwoPi * std::floor(azimuth / kTwoPi);
}

namespace {

/// Unit vector of a clockwise azimuth and an elevation.
Eigen::Vector3d direction_of(double azimuth, double elevation) {
  const double horizontal = std::cos(elevation);
  return {horizontal * std::cos(azimuth), -horizontal * std::sin(azimuth), std::sin(elevation)};
}

Eigen::Vector3d origin_of(const LidarModel& model, const Laser& laser, double azimuth) {
  const double rotor = azimuth - laser.azimuth_offset;
  return {model.radial_origin * std::cos(rotor), -model.radial_origin * std::sin(rotor),
          laser.vertical_origin};
}

}  // namespace

void Scanner::aim(std::uint64_t sequence, double begin_ns, double end_ns) {
  const auto footprint = footprint_rays(options_.footprint);
  const std::size_t lasers = model_.lasers.size();
  for (std::size_t laser = 0; laser < lasers; ++laser) {
    const double time_ns = firing_ns(sequence, laser);
    const double azimuth = kTwoPi / model_.turn_ns * std::fmod(time_ns, model_.turn_ns) +
                           model_.lasers[laser].azimuth_offset;
    Beam& beam = beams_[laser];
    beam.T_map_lidar = motion_.T_map_lidar(1e-9 * time_ns);
    beam.direction_lidar = direction_of(azimuth, model_.lasers[laser].elevation);
    beam.origin_lidar = origin_of(model_, model_.lasers[laser], azimuth);
    const Eigen::Vector3d across(-std::sin(azimuth), -std::cos(azimuth), 0.0);
    const Eigen::Vector3d upward = across.cross(beam.direction_lidar);
    const Eigen::Matrix3d R_map_lidar = beam.T_map_lidar.rotation.toRotationMatrix();
    const Eigen::Vector3f origin =
        (R_map_lidar * beam.origin_lidar + beam.T_map_lidar.translation).cast<float>();
    const auto within = static_cast<float>((time_ns - begin_ns) / (end_ns - begin_ns));
    for (std::size_t part = 0; part < footprint.size(); ++part) {
      const Eigen::Vector3d direction =
          (beam.direction_lidar +
           0.5 * model_.divergence_horizontal * footprint[part].horizontal * across +
           0.5 * model_.divergence_vertical * footprint[part].vertical * upward)
              .normalized();
      // Rays of one footprint position lie together: 16 lasers make one coherent packet.
      const std::size_t slot = part * lasers + laser;
      aimed_[slot] = {origin, (R_map_lidar * direction).cast<float>(),
                      std::clamp(within, 0.0F, 1.0F)};
      if (body_) {
        aimed_body_[slot] = {beam.origin_lidar.cast<float>(), direction.cast<float>(), 0.0F};
      }
    }
  }
}

void Scanner::collect(std::uint64_t sequence, SimulatedScan& result) {
  const auto footprint = footprint_rays(options_.footprint);
  const std::size_t lasers = model_.lasers.size();
  std::array<Hit, 8> beam_hits;
  for (std::size_t laser = 0; laser < lasers; ++laser) {
    bool own_body = false;
    for (std::size_t part = 0; part < footprint.size(); ++part) {
      const std::size_t slot = part * lasers + laser;
      beam_hits[part] = hits_[slot];
      if (body_ && body_hits_[slot].valid()) {
        beam_hits[part] = body_hits_[slot];
        own_body = true;
      }
    }
    const BeamReturns returns = detect(model_, footprint, {beam_hits.data(), footprint.size()},
                                       random_, sequence * lasers + laser);
    const Beam& beam = beams_[laser];
    const double reported = reported_azimuth(sequence, laser);
    const Eigen::Vector3d origin = origin_of(model_, model_.lasers[laser], reported);
    const Eigen::Vector3d direction = direction_of(reported, model_.lasers[laser].elevation);
    const int wanted = std::min(returns.count, options_.dual_return ? 2 : 1);
    for (int i = 0; i < wanted; ++i) {
      const BeamReturn& value = returns.values[static_cast<std::size_t>(i)];
      const std::int64_t time_ns = std::llround(firing_ns(sequence, laser)) + options_.start_ns;
      result.scan.points.push_back((origin + value.range * direction).cast<float>());
      result.scan.intensities.push_back(static_cast<float>(value.intensity));
      result.scan.times_ns.push_back(static_cast<std::int32_t>(time_ns - result.scan.stamp_ns));
      result.scan.rings.push_back(model_.lasers[laser].ring);
      result.raw.push_back(
          {sequence, static_cast<std::uint16_t>(laser), i == 1, value.range, value.intensity});
      result.true_points.push_back(beam.T_map_lidar *
                                   (beam.origin_lidar + value.true_range * beam.direction_lidar));
      result.labels.push_back(own_body       ? kLabelRobot
                              : value.mixed  ? kLabelMixed
                              : value.moving ? kLabelMoving
                                             : kLabelStatic);
    }
  }
}

SimulatedScan Scanner::scan(std::uint64_t index) {
  SimulatedScan result;
  result.first_sequence = first_sequence(index);
  result.end_sequence = first_sequence(index + 1);
  const double begin_ns = static_cast<double>(result.first_sequence) * model_.sequence_ns;
  const double end_ns = static_cast<double>(result.end_sequence) * model_.sequence_ns;
  result.scan.stamp_ns = options_.start_ns + std::llround(begin_ns);
  result.end_ns = options_.start_ns + std::llround(end_ns);
  rays_->set_interval(1e-9 * begin_ns, 1e-9 * end_ns);
  const auto max_distance = static_cast<float>(model_.max_range);
  for (std::uint64_t sequence = result.first_sequence; sequence < result.end_sequence; ++sequence) {
    aim(sequence, begin_ns, end_ns);
    rays_->cast(aimed_, max_distance, hits_);
    if (body_) body_->cast(aimed_body_, max_distance, body_hits_);
    collect(sequence, result);
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
    truth.push_back({stamp + scanner.options().start_ns,
                     scanner.motion().T_map_lidar(1e-9 * static_cast<double>(stamp))});
  }
  return truth;
}

}  // namespace surefoot::simulation
