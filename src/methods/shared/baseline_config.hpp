// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "surefoot/config.hpp"

namespace surefoot {

/// A baseline limits ranges itself, and begins its map with the LiDAR's own axes.
[[nodiscard]] Config baseline_config(std::string method);

}  // namespace surefoot
