// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "io/files/pcd_header.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::io {

/// A scan as PCD 0.7: x y z f32, and where the scan has them intensity f32, t (ns after the scan's
/// stamp, u32, or i32 where some are negative) and ring u16. The stamp itself is not in the format.
/// Throws std::invalid_argument where the scan's arrays differ in length.
[[nodiscard]] std::string format_pcd(const Scan& scan, PcdData flavour);
/// Throws WriteError.
void write_pcd(const std::filesystem::path& file, const Scan& scan,
               PcdData flavour = PcdData::binary);

}  // namespace surefoot::io
