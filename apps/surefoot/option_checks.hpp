// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>
#include <cstdint>

namespace surefoot::app {

/// For options of unsigned type: a whole number of at least `least`. CLI11 by itself reads -1 as
/// the greatest number there is.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t least);

/// A number from `low` to `high`. CLI::Range lets NaN pass.
[[nodiscard]] CLI::Validator number_within(double low, double high);

}  // namespace surefoot::app
