// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace surefoot {

/// The original's, under its names, and what is mended where it is asked for.
struct FloamParameters {
  int scan_line;            // lasers
  double max_dis, min_dis;  // [m] horizontal distance
  double map_resolution;    // [m] thinning of edges; of surfaces twice that
  bool use_rings;           // lines from the scan's ring numbers
  bool whole_sectors;
  bool centred_planes;
  bool distortion_compensation;  // the paper's two steps
};

}  // namespace surefoot
