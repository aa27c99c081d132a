// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

#include "io/point_table.hpp"

namespace surefoot::io {

/// The points of a PCD 0.7 file: ascii, binary or binary_compressed. The table looks into `file`.
/// Of fields with several elements a point only the first is a column. Throws ReadError.
[[nodiscard]] PointTable parse_pcd(std::span<const std::byte> file);

}  // namespace surefoot::io
