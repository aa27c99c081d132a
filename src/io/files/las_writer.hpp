// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <span>
#include <string>

namespace surefoot::io {

/// Points [m] as ASPRS LAS 1.4, point format 0 (no time), to the millimetre. The offset is whole
/// metres, so that a map far from its origin keeps its digits. Throws std::invalid_argument where a
/// point is not finite, or where the format cannot hold so many points or such a large map.
[[nodiscard]] std::string format_las(std::span<const Eigen::Vector3d> points);
/// Throws WriteError.
void write_las(const std::filesystem::path& file, std::span<const Eigen::Vector3d> points);

}  // namespace surefoot::io
