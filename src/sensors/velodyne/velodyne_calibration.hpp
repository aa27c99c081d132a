// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "sensors/velodyne/velodyne_model.hpp"

namespace surefoot::sensors {

/// Puts the lasers of a calibration file (YAML, as the ROS driver reads it: `lasers` with
/// laser_id, rot_correction, vert_correction [rad], dist_correction, ... [m]) in place of the
/// model's. Times stay, and heights where the file has no vert_offset_correction. Throws
/// CalibrationError.
void apply_velodyne_calibration(const std::string& yaml, VelodyneModel& model);

}  // namespace surefoot::sensors
