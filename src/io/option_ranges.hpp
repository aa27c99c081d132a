// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What numbers may be, wherever they are given: on the command line or from Python.
#pragma once

namespace surefoot::io {

struct NumberRange {
  double low, high;
};

// Of OpenOptions.
inline constexpr NumberRange kRates{1e-3, 1e4};     ///< rate_hz [Hz]
inline constexpr NumberRange kCuts{0.0, 359.99};    ///< cut_azimuth_deg [deg]
inline constexpr NumberRange kPorts{1.0, 65535.0};  ///< udp_port

}  // namespace surefoot::io
