// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/sweep_bend.hpp"

#include <algorithm>
#include <numeric>

#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

constexpr double kBendRate = 0.1;  // of the fading mean: ten scans, two or three of a trot's cycles
constexpr int kFew = 5;            // scans: of fewer a gait's swing has not averaged out
constexpr double kMostApart = 0.5;  // [s] between scans that tell how fast the sensor moves

Twist sum(const std::vector<Twist>& values) {
  return std::accumulate(values.begin(), values.end(), Twist(Twist::Zero()));
}

}  // namespace

/// The mean of all scans until they are more than the fading mean's memory.
double SweepBend::rate() const { return std::max(kBendRate, 1.0 / std::max(learnt_, 1)); }

void SweepBend::learn(const KnotWindow& registered) {
  const ScanTrajectory motion = registered.trajectory();
  const StampedPose before = last_.value_or(StampedPose{motion.mid_ns(), {}});
  const StampedPose now{motion.mid_ns(), motion.at(0.5)};
  last_ = now;
  const double elapsed = seconds(now.stamp_ns - before.stamp_ns);
  if (elapsed <= 0.0 || elapsed > kMostApart) return;
  if (mean_.empty()) mean_ = variance_ = {registered.segments(), Twist::Zero()};
  if (registered.segments() != mean_.size()) return;

  const Twist from_scan_to_scan = difference(now.pose, before.pose) / elapsed;
  const Twist removed = certainty();
  ++learnt_;
  for (std::size_t k = 0; k < mean_.size(); ++k) {
    const Twist seen =
        rotated(now.pose.rotation.conjugate(), registered.velocity(k + 1) - from_scan_to_scan);
    const Twist own = seen - mean_[k];
    mean_[k] += rate() * own;  // [K35]
    variance_[k] = (1.0 - rate()) * (variance_[k] + rate() * own.cwiseAbs2());
    // Of a map of n scans one in n was mapped straight.
    mean_[k] -= removed.cwiseProduct(mean_[k]) / learnt_;
  }
}

/// The share of the mean that is more than chance, per axis (James and Stein's positive part).
Twist SweepBend::certainty() const {
  if (learnt_ < kFew) return Twist::Zero();
  std::vector<Twist> squares;
  for (const Twist& mean : mean_) squares.emplace_back(mean.cwiseAbs2());
  const Twist chance = rate() / (2.0 - rate()) * alike(sum(variance_));
  return (1.0 - chance.array() / alike(sum(squares)).array().max(1e-12)).max(0.0);  // [K36]
}

KnotWindow SweepBend::straightened(const KnotWindow& registered) const {
  if (learnt_ < kFew || registered.segments() != mean_.size()) return registered;
  const std::size_t last = mean_.size();
  std::vector<Twist> bend(last + 1, Twist::Zero());
  for (std::size_t k = 0; k < last; ++k) bend[k + 1] = bend[k] + registered.step * mean_[k];
  const Twist middle = (sum(bend) - 0.5 * (bend.front() + bend.back())) / static_cast<double>(last);

  const Eigen::Quaterniond rotation = registered.trajectory().at(0.5).rotation;
  const Twist share = certainty();
  const auto straight = [&](const Pose& knot, const Twist& at) {
    return displaced(knot, rotated(rotation, share.cwiseProduct(middle - at)));  // [K37]
  };
  KnotWindow result = registered;
  // The last scan's segment that ends here saw what this one's last sees.
  result.knots[0] = straight(registered.knots[0], bend[last - 1]);
  for (std::size_t k = 0; k <= last; ++k) {
    result.knots[k + 1] = straight(registered.knots[k + 1], bend[k]);
  }
  return result;
}

}  // namespace surefoot
