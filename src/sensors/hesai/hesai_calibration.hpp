// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sensors/hesai/hesai_model.hpp"

namespace surefoot::sensors {

/// Puts the angles of a calibration file (CSV: laser id from 1, elevation, azimuth [deg]) in place
/// of the model's. Throws CalibrationError.
void apply_hesai_calibration(const std::string& csv, HesaiModel& model);

}  // namespace surefoot::sensors
