// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "io/files/pcd_header.hpp"
#include "io/scan_fields.hpp"
#include "surefoot/scan.hpp"

namespace surefoot::io {

/// Columns as PCD 0.7, which holds them all.
[[nodiscard]] std::string format_pcd(std::span<const Column> columns, std::size_t points,
                                     PcdData flavour);
/// A scan with its written_columns. The stamp itself is not in the format.
[[nodiscard]] std::string format_pcd(const Scan& scan, PcdData flavour);
/// Throws WriteError.
void write_pcd(const std::filesystem::path& file, const Scan& scan,
               PcdData flavour = PcdData::binary);

}  // namespace surefoot::io
