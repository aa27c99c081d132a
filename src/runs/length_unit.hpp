// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "surefoot/scan.hpp"

namespace surefoot::runs {

/// Says what is wrong with a typical range [m] that no LiDAR on a robot has seen, most likely for
/// being in millimetres; nothing if it can be metres.
[[nodiscard]] std::optional<std::string> odd_range(double median_range);

/// Throws io::ReadError beginning with `where` if the scan's coordinates cannot be metres.
void refuse_other_units(const Scan& scan, const std::string& where);

}  // namespace surefoot::runs
