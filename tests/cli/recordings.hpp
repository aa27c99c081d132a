// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Small recordings of a sensor that glides through a hall, in every format that is read.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "surefoot/scan.hpp"

namespace surefoot::test {

inline constexpr double kGlideSpeed = 0.5;  // [m/s] along the sensor's x axis

/// The first `count` scans at 10 Hz, every point with its time.
[[nodiscard]] std::vector<Scan> hall_scans(int count);

/// Such a recording along a bend, as binary PCD files, with the truth beside it every 10 ms.
/// `thin_from`: scans from this one on have half their points.
void write_bend_recording(const std::filesystem::path& folder, double yaw_rate, std::size_t count,
                          std::size_t thin_from = SIZE_MAX);

/// PLY with x, y, z and intensity in the byte order of the other half of the world.
[[nodiscard]] std::string big_endian_ply(const Scan& scan);
/// KITTI's float32 x y z intensity.
[[nodiscard]] std::string kitti_bin(const Scan& scan);

/// The scan's stamp as times.txt has it: seconds with nine decimals.
[[nodiscard]] std::string stamp_line(const Scan& scan);

/// Writes the scans as binary PCD files and their stamps beside them; makes the folder.
void write_pcd_recording(const std::filesystem::path& folder, const std::vector<Scan>& scans);
/// A recording of one scan over and over, far longer than a test waits for; makes the folder.
void write_long_recording(const std::filesystem::path& folder, int scans);
/// Name of the scan's file in such a folder: 000012.pcd.
[[nodiscard]] std::string scan_name(std::size_t index);

}  // namespace surefoot::test
