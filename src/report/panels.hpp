// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// The panels of a run's picture, each drawn into its rectangle, and what they share.
#pragma once

#include <cstdint>
#include <vector>

#include "report/canvas.hpp"
#include "report/plot.hpp"
#include "report/run_picture.hpp"

namespace surefoot::report {

namespace style {
inline constexpr Color kPath{0.84, 0.10, 0.26};
inline constexpr Color kReference{0.16, 0.32, 0.62, 0.45};
inline constexpr Color kStart{0.13, 0.40, 0.95};
inline constexpr Color kEnd{1.0, 0.82, 0.10};
inline constexpr Color kUntrusted{0.98, 0.56, 0.08, 0.4};
inline constexpr Color kLoop{0.06, 0.54, 0.37};
inline constexpr Color kRefusedLoop{0.47, 0.44, 0.39, 0.5};
inline constexpr Color kHalo{1.0, 1.0, 1.0, 0.9};
inline constexpr double kBandWidth = 26.0;       // of untrusted stretches of a path [px]
inline constexpr double kReferenceWidth = 10.0;  // a band, so that the path can be seen on it [px]
inline constexpr double kMarkerRadius = 12.0;
}  // namespace style

/// Up to this many points decide ranges and views; a regular sample of a large map does as well.
inline constexpr std::size_t kSampledPoints = 200'000;

/// The input without what cannot be drawn, and the ranges that several panels use.
struct DrawnRun {
  Trajectory path;
  std::vector<bool> untrusted;  // as long as `path`
  std::vector<int> segments;    // likewise
  Trajectory reference;
  DrawnLoops loops;
  std::int64_t first_ns = 0, last_ns = 0;       // of the path, whose clock may have been set back
  std::span<const Eigen::Vector3f> map_points;  // may hold points that cannot be drawn
  Range map_x, map_y;  // where nearly all of the map's points are, empty ([0, 0]) without a map
  Range heights;       // z of the colour map
};

[[nodiscard]] DrawnRun prepare_run(const PictureInput& input);

/// The map, seen obliquely, with the path and a colour bar.
void draw_map_panel(Canvas& canvas, const Rect& rect, const DrawnRun& run);
/// Top view x-y into `top`, and height over the way into `side`.
void draw_path_panels(Canvas& canvas, const Rect& top, const Rect& side, const DrawnRun& run);
/// z, roll and pitch over time.
void draw_time_panels(Canvas& canvas, const Rect& rect, const DrawnRun& run);

/// From the pose before the i-th to that [m]; nothing from one segment's frame to another's.
[[nodiscard]] Eigen::Vector3d step_to(std::size_t i, const DrawnRun& run);

/// A line a segment, a dot where it is a single pose: how they lie to each other is not known. A
/// pixel for each of the run's poses.
void draw_segments(Canvas& canvas, const std::vector<Pixel>& path, const std::vector<int>& segments,
                   const Stroke& stroke);

/// Path with halo, reference, untrusted stretches, start and end, with a pixel for each of the
/// run's poses.
void draw_path(Canvas& canvas, const std::vector<Pixel>& path, const std::vector<Pixel>& reference,
               const DrawnRun& run);

}  // namespace surefoot::report
