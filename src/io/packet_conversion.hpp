// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// A capture into another: the packets of the scans that are asked for, as they are.
#pragma once

#include "io/conversion.hpp"

namespace surefoot::io {

/// Scans are chosen as for every other conversion. Of the frames between the first and the last of
/// them all go that are not the sensor's data (positions, IMU, other traffic). Throws as
/// convert_recording(), ReadError where the input is no capture.
[[nodiscard]] ConversionOutcome convert_packets(const ConversionRequest& request,
                                                const ConversionListener& listener);

}  // namespace surefoot::io
