// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "io/point_table.hpp"

namespace surefoot::io {

/// ASPRS LAS 1.0 to 1.4, point formats 0 to 10: x, y, z [m], intensity, and time where the format
/// has one. An offset as large as that of a map's grid is left out, since points are kept as
/// floats. LAZ is refused. The table looks into `file`. Throws ReadError.
[[nodiscard]] PointTable parse_las(std::span<const std::byte> file);

}  // namespace surefoot::io
