// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "io/point_table.hpp"

namespace surefoot::io {

/// The vertices of a PLY 1.0 file, ascii or binary of either byte order. Other elements, and lists,
/// are passed over. The table looks into `file`. Throws ReadError.
[[nodiscard]] PointTable parse_ply(std::span<const std::byte> file);

}  // namespace surefoot::io
