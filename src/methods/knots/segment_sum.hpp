// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "methods/knots/knot_points.hpp"
#include "methods/knots/knot_window.hpp"
#include "methods/knots/segment_rows.hpp"
#include "methods/knots/surfel_map.hpp"
#include "surefoot/config.hpp"

namespace surefoot {

/// Sums over one segment's points.
struct SegmentSum {
  SegmentSums surfels;
  SegmentSums doubtful;  // of these what clouds are not worth, of a look that may be the last one
  int matches = 0;       // points
  int clouds = 0;        // of these, on what is no plane and no pole
  int unseen = 0;        // others, where the map has no surfel
};

/// How an iteration looks at the map.
struct Look {
  double inflation;    // of the noise variance
  int finest;          // grid of the map
  std::size_t stride;  // every so many-th point, for so many
  bool last;           // it may be: what a registration tells in the end is summed up, too
};

/// Moves a segment's points by the window's knots and compares them with the map.
[[nodiscard]] SegmentSum sum_segment(KnotPoints& points, std::size_t segment, const SurfelMap& map,
                                     const KnotWindow& window, const Look& look,
                                     const Config::Knots& config);

}  // namespace surefoot
