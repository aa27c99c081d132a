// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "sensors/hesai/hesai_calibration.hpp"

#include <cmath>
#include <locale>
#include <sstream>

#include "sensors/packet_decoder.hpp"

namespace surefoot::sensors {
namespace {

struct Row {
  double id = 0.0, elevation_deg = 0.0, azimuth_deg = 0.0;
};

bool parse_row(const std::string& line, Row& row) {
  std::istringstream stream(line);
  stream.imbue(std::locale::classic());
  char comma = 0;
  char other = 0;
  return stream >> row.id >> comma >> row.elevation_deg >> other >> row.azimuth_deg &&
         comma == ',' && other == ',' && std::abs(row.elevation_deg) <= 90.0 &&
         std::abs(row.azimuth_deg) <= 360.0;
}

}  // namespace

void apply_hesai_calibration(const std::string& csv, HesaiModel& model) {
  std::istringstream lines(csv);
  std::size_t known = 0;
  for (std::string line; std::getline(lines, line);) {
    Row row;
    if (!parse_row(line, row)) {
      continue;  // a heading
    }
    if (row.id != static_cast<double>(known + 1) || known == model.channels.size()) {
      throw CalibrationError("laser " + std::to_string(row.id) + " after " + std::to_string(known) +
                             " lasers; expected lasers 1 to " +
                             std::to_string(model.channels.size()) + " in order");
    }
    model.channels[known].elevation_deg = row.elevation_deg;
    model.channels[known].azimuth_deg = row.azimuth_deg;
    ++known;
  }
  if (known != model.channels.size()) {
    throw CalibrationError("it has " + std::to_string(known) +
                           " lines of laser id, elevation, azimuth; expected " +
                           std::to_string(model.channels.size()) + " for the " + model.name);
  }
}

}  // namespace surefoot::sensors
