// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>

namespace surefoot::dataset {

enum class PlyFlavour { kAscii, kBinary };  ///< binary is little-endian

/// Points [m] and, where given, one intensity a point, as PLY 1.0. Throws std::invalid_argument
/// where there are intensities but not as many as points.
[[nodiscard]] std::string format_ply(std::span<const Eigen::Vector3f> points,
                                     std::span<const float> intensities, PlyFlavour flavour);
/// Throws WriteError.
void write_ply(const std::filesystem::path& file, std::span<const Eigen::Vector3f> points,
               std::span<const float> intensities = {}, PlyFlavour flavour = PlyFlavour::kBinary);

}  // namespace surefoot::dataset
