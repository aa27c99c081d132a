// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/knot_prediction.hpp"

#include <algorithm>
#include <cmath>

#include "surefoot/seconds.hpp"

namespace surefoot {

double usual_step(const PreparedScan& scan, int segments) {
  return std::max(seconds(scan.end_ns - scan.start_ns) / segments, kInstant);
}

int segments_over(double span, const PreparedScan& scan, int segments) {
  constexpr double kMost = 3.0;  // times as many
  const double duration = seconds(scan.end_ns - scan.start_ns);
  if (duration <= kInstant) return segments;
  return static_cast<int>(
      std::lround(std::clamp(span / (duration / segments), 1.0, kMost * segments)));
}

KnotEnd beginning_of(const PreparedScan& scan, const KnotEnd& last, const VelocityModel& model,
                     const Config& config) {
  const double step = usual_step(scan, config.knots.segments);
  const double until_start = seconds(scan.start_ns - last.stamp_ns);
  const double until_end = seconds(scan.end_ns - last.stamp_ns);
  const double longest = config.motion_prior.max_extrapolation;
  if (until_start <= longest && until_end >= step) return last;
  const Pose& pose = last.prior.means[1];
  const Pose carried =
      displaced(pose, std::clamp(until_start, 0.0, longest) * model.mean(pose.rotation));
  return {at_rest(carried, step, std::max(until_start, 0.0)),
          std::min(scan.start_ns, scan.end_ns - kInstantNs), step};
}

KnotWindow predict_knots(const PreparedScan& scan, const KnotEnd& begin, const VelocityModel& model,
                         const Config::Knots& config) {
  const double span = seconds(scan.end_ns - begin.stamp_ns);
  const int segments = segments_over(span, scan, config.segments);
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
