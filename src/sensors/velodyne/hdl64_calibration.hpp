// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "sensors/velodyne/velodyne_model.hpp"

namespace surefoot::sensors {

/// The 64 lasers of an HDL-64E S2 and S3 as an example of each is calibrated; without times.
[[nodiscard]] std::vector<VelodyneLaser> hdl64_s2_lasers();
[[nodiscard]] std::vector<VelodyneLaser> hdl64_s3_lasers();

}  // namespace surefoot::sensors
