// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "evaluation/segments.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "evaluation/drift.hpp"
#include "evaluation/pose_error.hpp"

namespace surefoot::evaluation {

namespace {

constexpr std::size_t kStartEvery = 10;  // poses, as in the benchmark's development kit

/// Adds the errors of all stretches of one length.
void add_stretches(const AssociatedTrajectories& pairs, const std::vector<double>& along,
                   double length, SegmentError& sum) {
  for (std::size_t i = 0; i < along.size(); i += kStartEvery) {
    const auto end = std::upper_bound(along.begin(), along.end(), along[i] + length);
    if (end == along.end()) return;
    const auto j = static_cast<std::size_t>(end - along.begin());
    const Pose reference = pairs.reference[i].pose.inverse() * pairs.reference[j].pose;
    const Pose estimate = pairs.estimate[i].pose.inverse() * pairs.estimate[j].pose;
    const Pose error = estimate.inverse() * reference;
    sum.translation_percent += 100.0 * size_of(error, Relation::translation) / length;
    sum.rotation_deg_per_m += size_of(error, Relation::rotation_angle) / length;
    ++sum.count;
  }
}

SegmentError mean_of(SegmentError sum) {
  const auto count = static_cast<double>(std::max<std::size_t>(sum.count, 1));
  sum.translation_percent /= count;
  sum.rotation_deg_per_m /= count;
  return sum;
}

}  // namespace

std::vector<double> segment_lengths_for(double path_length) {
  const double unit = path_length >= 200.0 ? 100.0 : path_length >= 20.0 ? 10.0 : 1.0;
  std::vector<double> lengths;
  for (int i = 1; i <= 8; ++i) lengths.push_back(unit * i);
  return lengths;
}

SegmentErrors segment_errors(const AssociatedTrajectories& pairs,
                             const std::vector<double>& lengths) {
  const std::vector<double> along = path_lengths(pairs.reference);
  SegmentErrors result;
  for (const double length : lengths) {
    if (!std::isfinite(length) || length <= 0.0) {
      throw std::invalid_argument("a segment of " + std::to_string(length) +
                                  " m is not possible: expected a positive number");
    }
    SegmentError sum{.length = length};
    add_stretches(pairs, along, length, sum);
    result.all.count += sum.count;
    result.all.translation_percent += sum.translation_percent;
    result.all.rotation_deg_per_m += sum.rotation_deg_per_m;
    result.by_length.push_back(mean_of(sum));
  }
  result.all = mean_of(result.all);
  return result;
}

}  // namespace surefoot::evaluation
