// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "surefoot/scan_trajectory.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace surefoot {

ScanTrajectory::ScanTrajectory(const Pose& pose, std::int64_t stamp_ns)
    : boundaries_{pose, pose}, twists_{Twist::Zero()}, start_ns_(stamp_ns), end_ns_(stamp_ns) {}

ScanTrajectory::ScanTrajectory(std::vector<Pose> boundaries, std::int64_t start_ns,
                               std::int64_t end_ns)
    : boundaries_(std::move(boundaries)), start_ns_(start_ns), end_ns_(end_ns) {
  if (boundaries_.size() < 2) {
    throw std::invalid_argument("ScanTrajectory: " + std::to_string(boundaries_.size()) +
                                " boundary poses; expected at least 2");
  }
  twists_.reserve(boundaries_.size() - 1);
  for (std::size_t k = 0; k + 1 < boundaries_.size(); ++k) {
    twists_.push_back(se3_log(boundaries_[k].inverse() * boundaries_[k + 1]));  // [Eq 9]
  }
}

Pose ScanTrajectory::at(double tau) const {
  const double scaled = tau * static_cast<double>(segments());
  const double last = static_cast<double>(segments() - 1);
  const auto k = static_cast<std::size_t>(std::clamp(scaled, 0.0, last));
  const double u = scaled - static_cast<double>(k);  // [Eq 10]
  return boundaries_[k] * se3_exp(u * twists_[k]);   // [Eq 11]
}

double ScanTrajectory::tau(std::int64_t stamp_ns) const {
  if (end_ns_ == start_ns_) return 0.5;
  return static_cast<double>(stamp_ns - start_ns_) / static_cast<double>(end_ns_ - start_ns_);
}

Pose ScanTrajectory::at_time(std::int64_t stamp_ns) const { return at(tau(stamp_ns)); }

ScanTrajectory ScanTrajectory::moved(const Pose& T_new_old) const {
  ScanTrajectory result = *this;
  for (Pose& pose : result.boundaries_) pose = T_new_old * pose;
  return result;
}

ScanTrajectory ScanTrajectory::delayed(std::int64_t by_ns) const {
  ScanTrajectory result = *this;
  result.start_ns_ += by_ns;
  result.end_ns_ += by_ns;
  return result;
}

}  // namespace surefoot
