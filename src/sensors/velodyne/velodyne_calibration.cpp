// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/velodyne/velodyne_calibration.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <numbers>
#include <set>

#include "sensors/packet_decoder.hpp"

namespace surefoot::sensors {
namespace {

double number(const YAML::Node& laser, const char* key, bool required) {
  const YAML::Node node = laser[key];
  if (!node) {
    if (required) {
      throw CalibrationError(std::string("a laser without '") + key + "'");
    }
    return 0.0;
  }
  const auto value = node.as<double>();
  if (!std::isfinite(value) || std::abs(value) > 100.0) {
    throw CalibrationError(std::string("'") + key + "' of a laser is out of range");
  }
  return value;
}

std::size_t laser_id(const YAML::Node& laser, std::size_t lasers) {
  const double id = number(laser, "laser_id", true);
  if (!(id >= 0.0 && id < static_cast<double>(lasers)) || id != std::floor(id)) {
    throw CalibrationError("a laser's id is " + laser["laser_id"].as<std::string>() +
                           "; expected whole ones from 0 to " + std::to_string(lasers - 1));
  }
  return static_cast<std::size_t>(id);
}

void apply(const YAML::Node& root, VelodyneModel& model) {
  if (!root.IsMap()) {
    throw CalibrationError("no YAML calibration of a Velodyne: expected a list 'lasers' in it");
  }
  const YAML::Node lasers = root["lasers"];
  if (!lasers || !lasers.IsSequence() || lasers.size() != model.lasers.size()) {
    throw CalibrationError("it has " + std::to_string(lasers ? lasers.size() : 0) +
                           " lasers; expected a list 'lasers' of " +
                           std::to_string(model.lasers.size()) + " for the " + model.name);
  }
  constexpr double kDegree = 180.0 / std::numbers::pi;
  std::set<std::size_t> seen;
  for (const YAML::Node& one : lasers) {
    const std::size_t id = laser_id(one, model.lasers.size());
    if (!seen.insert(id).second) {
      throw CalibrationError("laser " + std::to_string(id) + " is listed twice");
    }
    VelodyneLaser& laser = model.lasers[id];
    laser.elevation_deg = kDegree * number(one, "vert_correction", true);
    laser.azimuth_deg = -kDegree * number(one, "rot_correction", true);
    laser.distance = number(one, "dist_correction", false);
    laser.distance_x = number(one, "dist_correction_x", false);
    laser.distance_y = number(one, "dist_correction_y", false);
    const YAML::Node two = one["two_pt_correction_available"];
    laser.two_points = two ? two.as<bool>() : laser.distance_x != 0.0 || laser.distance_y != 0.0;
    laser.vertical_offset = number(one, "vert_offset_correction", false);
    if (laser.vertical_offset != 0.0) laser.height = 0.0;  // the unit's own instead of the design's
    laser.horizontal_offset = number(one, "horiz_offset_correction", false);
  }
  if (const YAML::Node unit = root["distance_resolution"]; unit && model.name != "VLS-128") {
    const auto metres = unit.as<double>();
    if (metres >= 0.001 && metres <= 0.01) {
      model.distance_unit = metres;
    }
  }
}

}  // namespace

void apply_velodyne_calibration(const std::string& yaml, VelodyneModel& model) {
  try {
    apply(YAML::Load(yaml), model);
  } catch (const YAML::Exception& error) {
    throw CalibrationError(std::string("no YAML calibration of a Velodyne: ") + error.what());
  }
}

}  // namespace surefoot::sensors
