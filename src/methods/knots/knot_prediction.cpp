// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

// A gap between scans is bridged by segments as long as the scan's, up to so many times as many.
constexpr double kMostSegments = 3.0;

}  // namespace

KnotEnd beginning_of(const PreparedScan& scan, const KnotEnd& last, const VelocityModel& model,
                     const Config& config) {
  const double segment = seconds(scan.end_ns - scan.start_ns) / config.knots.segments;
  const double until_start = seconds(scan.start_ns - last.stamp_ns);
  const double until_end = seconds(scan.end_ns - last.stamp_ns);
  const double longest = config.motion_prior.max_extrapolation;
  if (until_start <= longest && until_end >= std::max(segment, kInstant)) return last;
  const Pose& pose = last.prior.means[1];
  const Pose carried =
      displaced(pose, std::clamp(until_start, 0.0, longest) * model.mean(pose.rotation));
  const double step = std::max(segment, kInstant);
  return {at_rest(carried, step, std::max(until_start, 0.0)),
          std::min(scan.start_ns, scan.end_ns - kInstantNs), step};
}

KnotWindow predict_knots(const PreparedScan& scan, const KnotEnd& begin, const VelocityModel& model,
                         const Config::Knots& config) {
  const double duration = seconds(scan.end_ns - scan.start_ns);
  const int usual = config.segments;
  const double span = seconds(scan.end_ns - begin.stamp_ns);
  const double wanted = std::clamp(span / (duration / usual), 1.0, kMostSegments * usual);
  const int segments = duration > kInstant ? static_cast<int>(std::lround(wanted)) : usual;
  KnotWindow window{{begin.prior.means[0], begin.prior.means[1]},
                    begin.step,
                    span / segments,
                    begin.stamp_ns,
                    scan.end_ns};
  Twist velocity = window.velocity(0);
  const Eigen::Quaterniond heading = begin.prior.means[1].rotation;
  for (int s = 0; s < segments; ++s) {
    velocity = model.next(velocity, heading, window.step);
    window.knots.push_back(displaced(window.knots.back(), window.step * velocity));
  }
  return window;
}

}  // namespace surefoot
