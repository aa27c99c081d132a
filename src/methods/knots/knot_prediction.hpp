// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Where a scan's knots are expected.
#pragma once

#include <cstdint>

#include "core/preprocess.hpp"
#include "methods/knots/knot_prior.hpp"
#include "methods/knots/knot_window.hpp"
#include "methods/knots/velocity_model.hpp"
#include "surefoot/config.hpp"

namespace surefoot {

/// A scan that is shorter has no times [s, ns].
inline constexpr double kInstant = 1e-3;
inline constexpr std::int64_t kInstantNs = 1'000'000;

/// [s] From knot to knot of a scan by itself, of so many segments; of one without times as if each
/// were an instant.
[[nodiscard]] double usual_step(const PreparedScan& scan, int segments);
/// Segments of a scan that begins with a gap, `span` [s] with it: about as long as the scan's, and
/// up to three times as many.
[[nodiscard]] int segments_over(double span, const PreparedScan& scan, int segments);

/// The last two knots before a scan, with what is known of them.
struct KnotEnd {
  KnotPrior prior;
  std::int64_t stamp_ns = 0;  ///< of the last
  double step = 0.0;          ///< [s] between the two
};

/// Where a scan begins: where the last one ended. After a gap longer than
/// motion_prior.max_extrapolation, or where scans overlap, the velocity of then says nothing: as if
/// at rest, at a place that is known the less the longer ago it was.
[[nodiscard]] KnotEnd beginning_of(const PreparedScan& scan, const KnotEnd& last,
                                   const VelocityModel& model, const Config& config);

/// The knots of a scan that begins there, as the velocity model expects them.
[[nodiscard]] KnotWindow predict_knots(const PreparedScan& scan, const KnotEnd& begin,
                                       const VelocityModel& model, const Config::Knots& config);

}  // namespace surefoot
