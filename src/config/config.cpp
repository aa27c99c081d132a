// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "surefoot/config.hpp"

#include <numbers>

#include "config/field_text.hpp"
#include "config/method.hpp"

namespace surefoot {

namespace {

const ConfigField& find_field(std::string_view name) {
  for (const ConfigField& field : config_fields()) {
    if (name == field.name) return field;
  }
  throw ConfigError("there is no parameter '" + std::string(name) +
                    "'; `surefoot config` prints the ones there are");
}

}  // namespace

Config::Config() {
  for (const Method* each : registered_methods()) {
    if (each->make_parameters) others.push_back(each->make_parameters());
  }
  for (const ConfigField& field : config_fields()) assign(field, *this, field.default_value);
}

const std::vector<ParameterInfo>& parameters() {
  static const std::vector<ParameterInfo> infos = [] {
    std::vector<ParameterInfo> result;
    Config config;
    for (const ConfigField& field : config_fields()) {
      result.push_back({field.name, field.default_value, field.unit, range_text(field, config),
                        field.help, field.source});
    }
    return result;
  }();
  return infos;
}

void set_parameter(Config& config, std::string_view name, std::string_view value) {
  assign(find_field(name), config, value);
}

std::string get_parameter(const Config& config, std::string_view name) {
  Config copy = config;
  return value_text(find_field(name), copy);
}

void validate(const Config& config) {
  Config copy = config;
  for (const ConfigField& field : config_fields()) assign(field, copy, value_text(field, copy));
  if (config.preprocess.min_range >= config.preprocess.max_range) {
    throw ConfigError("preprocess.min_range (" + number_text(config.preprocess.min_range) +
                      " m) must be less than preprocess.max_range (" +
                      number_text(config.preprocess.max_range) + " m)");
  }
  const Method& method = find_method(config.method);
  if (method.check) method.check(config);
}

Pose mount_pose(const Config::Level& level) {
  const Eigen::Vector3d angles_deg(level.mount_roll_deg, level.mount_pitch_deg,
                                   level.mount_yaw_deg);
  return {from_roll_pitch_yaw(angles_deg * (std::numbers::pi / 180.0)),
          {level.mount_x, level.mount_y, level.mount_z}};
}

}  // namespace surefoot
