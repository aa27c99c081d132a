// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include "report/canvas.hpp"

namespace surefoot::report {

/// The perceptually uniform map "viridis" at `value` in [0, 1] (values outside are clamped): from
/// dark violet over green to yellow, readable with every colour vision and in grey.
[[nodiscard]] Color viridis(double value);

}  // namespace surefoot::report
