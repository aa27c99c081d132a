// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "surefoot/config.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "config/config_fields.hpp"

namespace surefoot {

namespace {

// A search looks at the cube of voxels within its radius; this bounds their number.
constexpr double kMaxSearchVoxels = 8.0;

template <typename Enum>
using EnumNames = std::span<const std::pair<Enum, const char*>>;

EnumNames<DeskewMode> enum_names(DeskewMode) {
  static constexpr std::pair<DeskewMode, const char*> names[] = {
      {DeskewMode::none, "none"},
      {DeskewMode::constant_velocity, "constant_velocity"},
      {DeskewMode::piecewise, "piecewise"}};
  return names;
}
EnumNames<RegistrationMode> enum_names(RegistrationMode) {
  static constexpr std::pair<RegistrationMode, const char*> names[] = {
      {RegistrationMode::decoupled, "decoupled"}, {RegistrationMode::coupled, "coupled"}};
  return names;
}
EnumNames<TargetKind> enum_names(TargetKind) {
  static constexpr std::pair<TargetKind, const char*> names[] = {{TargetKind::point, "point"},
                                                                 {TargetKind::surface, "surface"}};
  return names;
}

EnumNames<Residual> enum_names(Residual) {
  static constexpr std::pair<Residual, const char*> names[] = {
      {Residual::point_to_point, "point_to_point"}, {Residual::point_to_plane, "point_to_plane"}};
  return names;
}
EnumNames<LevelMode> enum_names(LevelMode) {
  static constexpr std::pair<LevelMode, const char*> names[] = {
      {LevelMode::ground, "ground"}, {LevelMode::mount, "mount"}, {LevelMode::none, "none"}};
  return names;
}

EnumNames<IcpTarget> enum_names(IcpTarget) {
  static constexpr std::pair<IcpTarget, const char*> names[] = {{IcpTarget::scan, "scan"},
                                                                {IcpTarget::map, "map"}};
  return names;
}
EnumNames<CtIcpSampling> enum_names(CtIcpSampling) {
  static constexpr std::pair<CtIcpSampling, const char*> names[] = {
      {CtIcpSampling::none, "none"},
      {CtIcpSampling::grid, "grid"},
      {CtIcpSampling::adaptive, "adaptive"}};
  return names;
}
EnumNames<CtIcpInitialization> enum_names(CtIcpInitialization) {
  static constexpr std::pair<CtIcpInitialization, const char*> names[] = {
      {CtIcpInitialization::none, "none"},
      {CtIcpInitialization::constant_velocity, "constant_velocity"}};
  return names;
}
EnumNames<bool> enum_names(bool) {
  static constexpr std::pair<bool, const char*> names[] = {{true, "true"}, {false, "false"}};
  return names;
}
/// Whether values of a type are words rather than numbers.
template <typename Value>
constexpr bool kHasNames = std::is_enum_v<Value> || std::is_same_v<Value, bool>;

/// The shortest text that reads back to the same number.
template <typename Number>
std::string number_text(Number value) {
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string("?");
}

std::string range_text(const ConfigField& field, Config& config) {
  return std::visit(
      [&](auto* slot) -> std::string {
        using Value = std::remove_pointer_t<decltype(slot)>;
        if constexpr (kHasNames<Value>) {
          std::string text;
          for (const auto& [value, name] : enum_names(Value{})) {
            text += (text.empty() ? "" : " | ") + std::string(name);
          }
          return text;
        } else {
          return number_text(field.min) + " .. " + number_text(field.max);
        }
      },
      field.slot(config));
}

[[noreturn]] void refuse(const ConfigField& field, Config& config, std::string_view value) {
  const std::string unit = *field.unit ? " " + std::string(field.unit) : "";
  throw ConfigError("parameter " + std::string(field.name) + ": got '" + std::string(value) +
                    "', expected " + range_text(field, config) + unit + " (" + field.help + ")");
}

template <typename Number>
bool parse_number(std::string_view text, Number& value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc{} && result.ptr == end;
}

void assign(const ConfigField& field, Config& config, std::string_view text) {
  std::visit(
      [&](auto* slot) {
        using Value = std::remove_pointer_t<decltype(slot)>;
        Value parsed{};
        if constexpr (kHasNames<Value>) {
          for (const auto& [value, name] : enum_names(Value{})) {
            if (text == name) {
              *slot = value;
              return;
            }
          }
          refuse(field, config, text);
        } else {
          if (!parse_number(text, parsed)) refuse(field, config, text);
          const double number = static_cast<double>(parsed);
          if (!std::isfinite(number) || number < field.min || number > field.max) {
            refuse(field, config, text);
          }
          *slot = parsed;
        }
      },
      field.slot(config));
}

const ConfigField& find_field(std::string_view name) {
  for (const ConfigField& field : config_fields()) {
    if (name == field.name) return field;
  }
  throw ConfigError("there is no parameter '" + std::string(name) +
                    "'; `surefoot config` prints the ones there are");
}

std::string text_of(const ConfigField& field, Config& config) {
  return std::visit(
      [](auto* slot) -> std::string {
        using Value = std::remove_pointer_t<decltype(slot)>;
        if constexpr (kHasNames<Value>) {
          for (const auto& [value, name] : enum_names(Value{})) {
            if (value == *slot) return name;
          }
          return "?";
        } else {
          return number_text(*slot);
        }
      },
      field.slot(config));
}

}  // namespace

Config::Config() {
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
  return text_of(find_field(name), copy);
}

void validate(const Config& config) {
  Config copy = config;
  for (const ConfigField& field : config_fields()) assign(field, copy, text_of(field, copy));
  if (config.preprocess.min_range >= config.preprocess.max_range) {
    throw ConfigError("preprocess.min_range (" + number_text(config.preprocess.min_range) +
                      " m) must be less than preprocess.max_range (" +
                      number_text(config.preprocess.max_range) + " m)");
  }
  if (config.registration.relaxed_distance < config.registration.max_distance) {
    throw ConfigError("registration.relaxed_distance (" +
                      number_text(config.registration.relaxed_distance) +
                      " m) must not be less than registration.max_distance (" +
                      number_text(config.registration.max_distance) + " m)");
  }
  if (config.registration.relaxed_distance > kMaxSearchVoxels * config.map.voxel_size) {
    throw ConfigError("registration.relaxed_distance (" +
                      number_text(config.registration.relaxed_distance) +
                      " m) must not be more than " + number_text(kMaxSearchVoxels) +
                      " times map.voxel_size (" + number_text(config.map.voxel_size) + " m)");
  }
  if (config.icp.max_correspondence_distance > config.icp.voxel_size) {
    throw ConfigError("icp.voxel_size (" + number_text(config.icp.voxel_size) +
                      " m) must not be less than icp.max_correspondence_distance (" +
                      number_text(config.icp.max_correspondence_distance) + " m)");
  }
  if (config.knots.points_per_voxel < 2 * config.knots.min_points) {
    throw ConfigError("knots.points_per_voxel (" + number_text(config.knots.points_per_voxel) +
                      ") must be at least twice knots.min_points (" +
                      number_text(config.knots.min_points) + "), which a pole needs");
  }
  if (config.ct_icp.default_radius > kMaxSearchVoxels * config.ct_icp.resolution) {
    throw ConfigError("ct_icp.default_radius (" + number_text(config.ct_icp.default_radius) +
                      " m) must not be more than " + number_text(kMaxSearchVoxels) +
                      " times ct_icp.resolution (" + number_text(config.ct_icp.resolution) + " m)");
  }
  if (config.ct_icp.min_number_neighbors > config.ct_icp.max_num_neighbors) {
    throw ConfigError("ct_icp.min_number_neighbors (" +
                      number_text(config.ct_icp.min_number_neighbors) +
                      ") must not be more than ct_icp.max_num_neighbors (" +
                      number_text(config.ct_icp.max_num_neighbors) + ")");
  }
  const int lines = config.floam.scan_line;
  if (lines != 16 && lines != 32 && lines != 64) {
    throw ConfigError("floam.scan_line: got " + number_text(lines) + ", expected 16, 32 or 64");
  }
}

Pose mount_pose(const Config::Level& level) {
  const Eigen::Vector3d angles_deg(level.mount_roll_deg, level.mount_pitch_deg,
                                   level.mount_yaw_deg);
  return {from_roll_pitch_yaw(angles_deg * (std::numbers::pi / 180.0)),
          {level.mount_x, level.mount_y, level.mount_z}};
}

}  // namespace surefoot
