// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/run_picture.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <stdexcept>

#include "report/panels.hpp"

namespace surefoot::report {

namespace {

// The page, from the top: title and legend; map | top view; time plots | height along the way.
constexpr Rect kHeader{48.0, 40.0, 1904.0, 80.0};
constexpr Rect kMap{48.0, 140.0, 1190.0, 780.0};
constexpr Rect kTopView{1345.0, 180.0, 607.0, 680.0};
constexpr Rect kTime{135.0, 990.0, 1080.0, 420.0};
constexpr Rect kSideView{1345.0, 990.0, 607.0, 420.0};

bool is_drawable_pose(const Pose& pose) {
  return is_drawable(pose.translation) && pose.rotation.coeffs().allFinite() &&
         pose.rotation.squaredNorm() > 0.0;
}

/// Ranges of nearly all of the map: single far returns would shrink everything else.
void find_map_ranges(DrawnRun& run) {
  constexpr double kTail = 0.005;
  std::array<std::vector<double>, 3> values;
  const std::size_t stride = run.map_points.size() / kSampledPoints + 1;
  for (std::size_t i = 0; i < run.map_points.size(); i += stride) {
    const Eigen::Vector3d point = run.map_points[i].cast<double>();
    if (!is_drawable(point)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      values[axis].push_back(point[static_cast<Eigen::Index>(axis)]);
    }
  }
  run.map_x = range_within(values[0], kTail);
  run.map_y = range_within(values[1], kTail);
  run.heights = padded(range_within(values[2], kTail), 0.0, 0.1);
}

double path_length(const DrawnRun& run) {
  double length = 0.0;
  for (std::size_t i = 1; i < run.path.size(); ++i) length += step_to(i, run).norm();
  return length;
}

std::string with_thousands(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, "\u2009");
  }
  return digits;
}

std::string summary(const DrawnRun& run) {
  const auto lost =
      static_cast<std::size_t>(std::count(run.untrusted.begin(), run.untrusted.end(), true));
  const std::size_t trusted = run.path.size() - lost;
  std::string text = with_thousands(trusted) + (trusted == 1 ? " pose" : " poses");
  if (lost > 0) text += "  \u00b7  " + with_thousands(lost) + " not trusted";
  if (!run.path.empty()) {
    const double seconds =
        1e-9 * (static_cast<double>(run.last_ns) - static_cast<double>(run.first_ns));
    std::array<char, 96> numbers{};
    std::snprintf(numbers.data(), numbers.size(), "  \u00b7  %.1f s  \u00b7  %.1f m", seconds,
                  path_length(run));
    text += numbers.data();
  }
  return text + "  \u00b7  " + with_thousands(run.map_points.size()) + " map points";
}

/// One entry of the legend; returns where the next one to its left may end.
double draw_entry(Canvas& canvas, double right, const std::string& name, const Stroke& stroke) {
  constexpr double kSample = 46.0;
  const TextStyle text{.size = 22.0, .anchor = Anchor::right};
  const double baseline = kHeader.bottom() - 8.0;
  canvas.text(name, {right, baseline}, text);
  const double end = right - canvas.text_width(name, text) - 12.0;
  const std::array<Pixel, 2> sample = {Pixel(end - kSample, baseline - 8.0),
                                       Pixel(end, baseline - 8.0)};
  canvas.line(sample, stroke);
  return end - kSample - 36.0;
}

/// Start and end as they are marked on the path; returns where the next entry may end.
double draw_marker_entries(Canvas& canvas, double right) {
  const TextStyle text{.size = 22.0, .anchor = Anchor::right};
  const Stroke edge{{0.1, 0.1, 0.12}, 1.5};
  const double baseline = kHeader.bottom() - 8.0;
  canvas.text("end", {right, baseline}, text);
  right -= canvas.text_width("end", text) + 20.0;
  canvas.triangle({right, baseline - 6.0}, style::kMarkerRadius, style::kEnd, edge);
  right -= 42.0;
  canvas.text("start", {right, baseline}, text);
  right -= canvas.text_width("start", text) + 20.0;
  canvas.circle({right, baseline - 8.0}, 0.75 * style::kMarkerRadius, style::kStart, edge);
  return right - 42.0;
}

void draw_header(Canvas& canvas, const std::string& title, const DrawnRun& run) {
  TextStyle heading{.size = 38.0, .bold = true};
  heading.size *= std::min(1.0, kHeader.width / std::max(canvas.text_width(title, heading), 1.0));
  canvas.text(title, {kHeader.x, kHeader.y + 34.0}, heading);
  canvas.text(summary(run), {kHeader.x, kHeader.bottom() - 8.0},
              {.size = 23.0, .color = {0.38, 0.41, 0.46}});
  double right = draw_marker_entries(canvas, kHeader.right());
  const bool any_untrusted =
      std::find(run.untrusted.begin(), run.untrusted.end(), true) != run.untrusted.end();
  if (any_untrusted) {
    right = draw_entry(canvas, right, "not trustworthy", {style::kUntrusted, style::kBandWidth});
  }
  if (!run.reference.empty()) {
    right = draw_entry(canvas, right, "reference", {style::kReference, style::kReferenceWidth});
  }
  if (!run.loops.refused.empty()) {
    right = draw_entry(canvas, right, "refused", {style::kRefusedLoop, 1.5});
  }
  if (!run.loops.taken.empty()) {
    right = draw_entry(canvas, right, "loop", {style::kLoop, 3.0});
    right = draw_entry(canvas, right, "after loops", {style::kLoop, 2.5, LineStyle::dashed});
  }
  draw_entry(canvas, right, "estimate", {style::kPath, 4.5});
}

}  // namespace

DrawnRun prepare_run(const PictureInput& input) {
  if (!input.untrusted.empty() && input.untrusted.size() != input.trajectory.size()) {
    throw std::invalid_argument("draw_run_picture: " + std::to_string(input.untrusted.size()) +
                                " flags for " + std::to_string(input.trajectory.size()) + " poses");
  }
  if (!input.segments.empty() && input.segments.size() != input.trajectory.size()) {
    throw std::invalid_argument("draw_run_picture: " + std::to_string(input.segments.size()) +
                                " segments for " + std::to_string(input.trajectory.size()) +
                                " poses");
  }
  DrawnRun run;
  for (std::size_t i = 0; i < input.trajectory.size(); ++i) {
    if (!is_drawable_pose(input.trajectory[i].pose)) continue;
    run.path.push_back(input.trajectory[i]);
    run.untrusted.push_back(!input.untrusted.empty() && input.untrusted[i]);
    run.segments.push_back(input.segments.empty() ? 0 : input.segments[i]);
  }
  if (!run.path.empty()) {
    const auto [first, last] = std::ranges::minmax(run.path, {}, &StampedPose::stamp_ns);
    run.first_ns = first.stamp_ns;
    run.last_ns = last.stamp_ns;
  }
  std::copy_if(input.reference.begin(), input.reference.end(), std::back_inserter(run.reference),
               [](const StampedPose& stamped) { return is_drawable_pose(stamped.pose); });
  run.loops = input.loops;
  const auto cannot_be_drawn = [](const DrawnLoops::Places& places) {
    return !is_drawable(places.first) || !is_drawable(places.second);
  };
  std::erase_if(run.loops.taken, cannot_be_drawn);
  std::erase_if(run.loops.refused, cannot_be_drawn);
  std::erase_if(run.loops.corrected,
                [](const StampedPose& stamped) { return !is_drawable_pose(stamped.pose); });
  run.map_points = input.map_points;
  find_map_ranges(run);
  return run;
}

void draw_run_picture(const PictureInput& input, const std::filesystem::path& path) {
  const PageFormat format = page_format_of(path);
  const DrawnRun run = prepare_run(input);
  Canvas canvas(kPictureWidth, kPictureHeight, format);
  draw_header(canvas, input.title, run);
  draw_map_panel(canvas, kMap, run);
  draw_path_panels(canvas, kTopView, kSideView, run);
  draw_time_panels(canvas, kTime, run);
  canvas.save(path, PictureKind::run);
}

}  // namespace surefoot::report
