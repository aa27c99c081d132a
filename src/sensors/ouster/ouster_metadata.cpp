// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/ouster/ouster_metadata.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "sensors/packet_decoder.hpp"

namespace surefoot::sensors {
namespace {

using Json = nlohmann::json;

// Ouster's sensor documentation, "Lidar data packet format".
const std::vector<OusterProfile>& profiles() {
  static const std::vector<OusterProfile> all = {
      {"LEGACY", 12, {0, 20, 0}, {32, 8, 0}, {48, 16, 0}, {}, {}, {}},
      {"RNG19_RFL8_SIG16_NIR16", 12, {0, 19, 0}, {32, 8, 0}, {48, 16, 0}, {}, {}, {}},
      {"RNG19_RFL8_SIG16_NIR16_DUAL",
       16,
       {0, 19, 0},
       {24, 8, 0},
       {64, 16, 0},
       {32, 19, 0},
       {56, 8, 0},
       {80, 16, 0}},
      {"RNG15_RFL8_NIR8", 4, {0, 15, 3}, {16, 8, 0}, {}, {}, {}, {}},
      {"RNG15_RFL8_WIN8", 4, {0, 15, 3}, {16, 8, 0}, {}, {}, {}, {}},
      {"RNG15_RFL8_NIR8_DUAL", 8, {0, 15, 3}, {16, 8, 0}, {}, {32, 15, 3}, {48, 8, 0}, {}},
      {"FIVE_WORD_PIXEL",
       20,
       {0, 19, 0},
       {24, 8, 0},
       {64, 16, 0},
       {32, 19, 0},
       {56, 8, 0},
       {80, 16, 0}}};
  return all;
}

// A part of the new form, or the whole, where the old form has everything side by side.
const Json& part(const Json& root, const char* name) {
  return root.contains(name) && root[name].is_object() ? root[name] : root;
}

std::vector<double> numbers(const Json& from, const char* key, std::size_t most) {
  if (!from.contains(key) || !from[key].is_array() || from[key].size() > most) {
    throw CalibrationError(std::string("no list '") + key + "'");
  }
  std::vector<double> values;
  for (const Json& one : from[key]) {
    const double value = one.is_number() ? one.get<double>() : std::nan("");
    if (!(std::abs(value) <= 1e6)) {
      throw CalibrationError(std::string("'") + key + "' holds what is no number, or too large");
    }
    values.push_back(value);
  }
  return values;
}

std::size_t count(const Json& from, const char* key, std::size_t least, std::size_t most) {
  const bool known = from.contains(key) && from[key].is_number_integer();
  const std::int64_t value = known ? from[key].get<std::int64_t>() : -1;
  if (value < static_cast<std::int64_t>(least) || value > static_cast<std::int64_t>(most)) {
    throw CalibrationError(std::string("'") + key + "' is " +
                           (known ? std::to_string(value) : "missing") + "; expected " +
                           std::to_string(least) + " to " + std::to_string(most));
  }
  return static_cast<std::size_t>(value);
}

std::string text(const Json& from, const char* key) {
  return from.contains(key) && from[key].is_string() ? from[key].get<std::string>() : std::string();
}

// Millimetres to metres.
Eigen::Matrix4d transform(const Json& from, const char* key) {
  const std::vector<double> values = numbers(from, key, 16);
  if (values.size() != 16) {
    throw CalibrationError(std::string("'") + key + "' is no 4 x 4 matrix");
  }
  Eigen::Matrix4d matrix;
  for (Eigen::Index i = 0; i < 16; ++i) {
    matrix(i / 4, i % 4) = values[static_cast<std::size_t>(i)];
  }
  matrix.topRightCorner<3, 1>() *= 1e-3;
  return matrix;
}

// "1024x10": columns a frame, frames a second.
void read_mode(const Json& root, OusterMetadata& metadata) {
  const std::string mode = text(part(root, "config_params"), "lidar_mode");
  unsigned columns = 0;
  unsigned rate = 0;
  if (std::sscanf(mode.c_str(), "%5ux%3u", &columns, &rate) != 2 || columns < 64 ||
      columns > 8192 || rate < 1 || rate > 100) {
    throw CalibrationError("'lidar_mode' is '" + mode + "'; expected such as 1024x10");
  }
  metadata.columns_per_frame = columns;
  metadata.rate_hz = rate;
}

void read_format(const Json& root, OusterMetadata& metadata) {
  const char* key = root.contains("lidar_data_format") ? "lidar_data_format" : "data_format";
  std::string profile = "LEGACY";
  metadata.columns_per_packet = 16;
  metadata.pixels = 64;  // firmware that does not say it
  metadata.first_column = 0;
  if (root.contains(key) && root[key].is_object()) {
    const Json& format = root[key];
    metadata.columns_per_frame = count(format, "columns_per_frame", 64, 8192);
    metadata.columns_per_packet = count(format, "columns_per_packet", 1, 128);
    metadata.pixels = count(format, "pixels_per_column", 1, 256);
    profile = format.contains("udp_profile_lidar") ? text(format, "udp_profile_lidar") : profile;
  }
  metadata.last_column = metadata.columns_per_frame - 1;
  if (root.contains(key) && root[key].contains("column_window")) {
    const std::vector<double> window = numbers(root[key], "column_window", 2);
    const auto most = static_cast<double>(metadata.columns_per_frame - 1);
    if (window.size() != 2 || !(window[0] >= 0 && window[0] <= most) ||
        !(window[1] >= 0 && window[1] <= most)) {
      throw CalibrationError("'column_window' lies outside the columns of a frame");
    }
    metadata.first_column = static_cast<std::size_t>(window[0]);
    metadata.last_column = static_cast<std::size_t>(window[1]);
  }
  const auto found = std::find_if(profiles().begin(), profiles().end(),
                                  [&](const OusterProfile& one) { return one.name == profile; });
  if (found == profiles().end()) {
    throw CalibrationError("lidar packets of profile '" + profile + "' are not known");
  }
  metadata.profile = *found;
}

void read_beams(const Json& root, OusterMetadata& metadata) {
  const Json& beams = part(root, "beam_intrinsics");
  constexpr std::size_t kMost = 256;
  metadata.elevation_deg = numbers(beams, "beam_altitude_angles", kMost);
  metadata.azimuth_deg = numbers(beams, "beam_azimuth_angles", kMost);
  if (metadata.elevation_deg.size() != metadata.pixels ||
      metadata.azimuth_deg.size() != metadata.pixels) {
    throw CalibrationError(std::to_string(metadata.elevation_deg.size()) + " altitude and " +
                           std::to_string(metadata.azimuth_deg.size()) +
                           " azimuth angles for columns of " + std::to_string(metadata.pixels) +
                           " pixels");
  }
  if (beams.contains("beam_to_lidar_transform")) {
    metadata.T_lidar_beam = transform(beams, "beam_to_lidar_transform");
  } else if (beams.contains("lidar_origin_to_beam_origin_mm")) {
    const Json& distance = beams["lidar_origin_to_beam_origin_mm"];
    const double millimetres = distance.is_number() ? distance.get<double>() : std::nan("");
    if (!(std::abs(millimetres) <= 1e3)) {
      throw CalibrationError("'lidar_origin_to_beam_origin_mm' is no distance");
    }
    metadata.T_lidar_beam(0, 3) = 1e-3 * millimetres;
  } else {
    metadata.T_lidar_beam(0, 3) = 0.012163;  // of the first OS1, whose firmware does not say it
  }
  const Json& lidar = part(root, "lidar_intrinsics");
  if (lidar.contains("lidar_to_sensor_transform")) {
    metadata.T_sensor_lidar = transform(lidar, "lidar_to_sensor_transform");
  } else {  // as the maker's SDK does with the short files of the first OS1 and of its viewer
    metadata.T_sensor_lidar(0, 0) = metadata.T_sensor_lidar(1, 1) = -1.0;
    metadata.T_sensor_lidar(2, 3) = 0.03618;
  }
}

}  // namespace

OusterMetadata parse_ouster_metadata(const std::string& json) {
  const Json root = Json::parse(json, nullptr, false);
  if (!root.is_object()) {
    throw CalibrationError("no JSON object; expected the metadata of an Ouster");
  }
  OusterMetadata metadata;
  metadata.product = text(part(root, "sensor_info"), "prod_line");
  if (metadata.product.empty() || metadata.product.size() > 40) {
    metadata.product = "Ouster";
  }
  read_mode(root, metadata);
  read_format(root, metadata);
  read_beams(root, metadata);
  if (metadata.columns_per_frame % metadata.columns_per_packet != 0 ||
      metadata.packet_bytes() > 65'507) {
    throw CalibrationError("packets of " + std::to_string(metadata.columns_per_packet) +
                           " columns and " + std::to_string(metadata.packet_bytes()) +
                           " bytes are none");
  }
  return metadata;
}

bool is_ouster_size(std::size_t bytes) {
  constexpr std::array<std::size_t, 4> kPixels = {16, 32, 64, 128};
  for (const OusterProfile& profile : profiles()) {
    OusterMetadata metadata;
    metadata.profile = profile;
    metadata.columns_per_packet = 16;
    for (const std::size_t pixels : kPixels) {
      metadata.pixels = pixels;
      if (metadata.packet_bytes() == bytes) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace surefoot::sensors
