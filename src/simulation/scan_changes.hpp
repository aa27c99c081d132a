// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a fault does to one scan: its points, their order, their times.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "surefoot/scan.hpp"

namespace surefoot::simulation {

/// Changes a scan, number `n` of the recording: the same scan and number, the same change.
using Change = std::function<void(Scan& scan, std::uint64_t n)>;
/// Whether a point [m], number `i` of its scan, is kept.
using Keep = std::function<bool(const Eigen::Vector3f& point, std::size_t i)>;

/// Between the first point's time and the last one's [ns]; the stamp where points have no times.
[[nodiscard]] std::int64_t middle_of(const Scan& scan);

[[nodiscard]] Change at_later_stamps(std::int64_t shift_ns);
[[nodiscard]] Change only(Keep keep);
/// All coordinates of all points are this value.
[[nodiscard]] Change every_point(float value);
[[nodiscard]] Change scaled(float factor);
/// Every beam ends so far away [m], give or take a centimetre.
[[nodiscard]] Change covered(float distance);
/// A share of the points at any range.
[[nodiscard]] Change garbage(double share);
/// Ranges with so much noise more [m].
[[nodiscard]] Change noisy(double sigma);

/// A tunnel's wall of 1.5 m radius about the x axis, and nothing else.
void tube(Scan& scan, std::uint64_t n);
/// A level floor, 0.5 m below the sensor.
void floor_only(Scan& scan, std::uint64_t n);
/// Every point twice.
void doubled(Scan& scan, std::uint64_t n);
/// The points from the last to the first, each with its own time.
void reversed_order(Scan& scan, std::uint64_t n);
/// The first point's time is the last one's, and so on.
void reversed_times(Scan& scan, std::uint64_t n);
/// Stamped at its middle.
void without_times(Scan& scan, std::uint64_t n);
/// Left is right.
void mirrored(Scan& scan, std::uint64_t n);

}  // namespace surefoot::simulation
