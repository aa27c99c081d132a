// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "methods/knots/sweep_bend.hpp"

#include <algorithm>
#include <numeric>

#include "surefoot/seconds.hpp"

namespace surefoot {

namespace {

constexpr double kBendRate = 0.1;  // of the fading mean: ten scans, two or three of a trot's cycles
constexpr int kFew = 4;            // scans: of fewer a gait's swing has not averaged out
constexpr double kMostDoubt = 6.0;  // times chance, of a map of 24 scans and more
constexpr double kUnknown = 200.0;  // so many means compared tell how they wander as well as that
constexpr std::size_t kScansApart = 30;  // of two means: hardly a scan counts in both
constexpr double kWanderRate = 0.02;
constexpr double kSudden = 3.0;   // standard deviations of what a scan has of its own, at most
constexpr double kLeast = 0.003;  // [m/s, rad/s] any sensor's velocity may vary by
constexpr double kTiny = 1e-12;
constexpr double kMostApart = 0.5;  // [s] between scans that tell how fast the sensor moves

Twist sum(const std::vector<Twist>& values) {
  return std::accumulate(values.begin(), values.end(), Twist(Twist::Zero()));
}

Twist sum_of_squares(const std::vector<Twist>& values) {
  Twist sum = Twist::Zero();
  for (const Twist& value : values) sum += value.cwiseAbs2();
  return sum;
}

StampedPose middle_of(const KnotWindow& scan) {
  const ScanTrajectory motion = scan.trajectory();
  return {motion.mid_ns(), motion.at(0.5)};
}

bool follows(const StampedPose& next, const StampedPose& last) {
  const double elapsed = seconds(next.stamp_ns - last.stamp_ns);
  return elapsed > 0.0 && elapsed <= kMostApart;
}

Twist velocity_between(const StampedPose& from, const StampedPose& to) {
  return difference(to.pose, from.pose) / seconds(to.stamp_ns - from.stamp_ns);
}

}  // namespace

/// The mean of all scans until they are more than the fading mean's memory.
double SweepBend::rate() const { return std::max(kBendRate, 1.0 / std::max(learnt_, 1)); }

void SweepBend::learn(const KnotWindow& registered) {
  const StampedPose now = middle_of(registered);
  if (last_) {
    const StampedPose then = middle_of(*last_);
    if (before_ && follows(then, *before_) && follows(now, then)) learn_from(*last_, *before_, now);
    before_ = then;
  }
  last_ = registered;
}

/// Nothing is known of scans of so many segments.
void SweepBend::begin(std::size_t segments) {
  mean_ = variance_ = straightened_ = {segments, Twist::Zero()};
  means_.clear();
  wander_ = Twist::Zero();
  compared_ = learnt_ = 0;
}

void SweepBend::learn_from(const KnotWindow& registered, const StampedPose& before,
                           const StampedPose& after) {
  if (!usual_size_.takes(registered.segments())) return;
  if (registered.segments() != mean_.size()) begin(registered.segments());
  const StampedPose middle = middle_of(registered);
  const Twist velocity_before = velocity_between(before, middle);
  const Twist change = (velocity_between(middle, after) - velocity_before) /
                       (0.5 * seconds(after.stamp_ns - before.stamp_ns));
  double since = seconds(registered.begin_ns - before.stamp_ns) + 0.5 * registered.step -
                 0.5 * seconds(middle.stamp_ns - before.stamp_ns);
  std::vector<Twist> own;
  for (const Twist& mean : mean_) {
    const Twist from_scan_to_scan = velocity_before + since * change;
    const Twist seen = registered.velocity(own.size() + 1) - from_scan_to_scan;
    own.emplace_back(rotated(middle.pose.rotation.conjugate(), seen) - mean);
    since += registered.step;
  }
  const Twist counted = counted_of(own), removed = certainty();
  ++learnt_;
  for (std::size_t k = 0; k < mean_.size(); ++k) {
    const Twist step = counted.cwiseProduct(own[k]);
    mean_[k] += rate() * step;  // [K35]
    variance_[k] = (1.0 - rate()) * (variance_[k] + rate() * step.cwiseAbs2());
    // Of a map of n scans one in n was mapped straight.
    const Twist straight = removed.cwiseProduct(mean_[k]) / learnt_;
    mean_[k] -= straight;
    straightened_[k] += straight;
  }
  compare_means();
}

/// How much of what a scan has of its own counts, per axis: who suddenly turns is no bend.
Twist SweepBend::counted_of(const std::vector<Twist>& own) const {
  if (learnt_ < kFew) return Twist::Ones();
  const Twist usual = alike(sum(variance_)).cwiseMax(kLeast * kLeast);
  return (kSudden * kSudden * usual.array() / alike(sum_of_squares(own)).array().max(kTiny))
      .min(1.0)
      .sqrt();
}

/// What bends a map stays as it is; by how much means differ of scans far apart tells what a gait
/// adds that nearly keeps time with the sensor's turns, as 2.5 strides a second do
/// with ten turns.
void SweepBend::compare_means() {
  std::vector<Twist> now = mean_;
  for (std::size_t k = 0; k < now.size(); ++k) now[k] += straightened_[k];
  means_.push_back(now);
  if (means_.size() <= kScansApart) return;
  for (std::size_t k = 0; k < now.size(); ++k) now[k] -= means_.front()[k];
  means_.pop_front();
  const Twist squares = 0.5 * alike(sum_of_squares(now));
  wander_ += kWanderRate * (squares.cwiseQuotient(chance().cwiseMax(kTiny)) - wander_);
  ++compared_;
}

/// The square of what the mean would be by chance, were scans independent of each other.
Twist SweepBend::chance() const { return rate() / (2.0 - rate()) * alike(sum(variance_)); }

/// What bends a map is mostly its first scans: later more must speak for a bend than chance alone,
/// until it is known how means wander.
Twist SweepBend::doubt() const {
  const double at_first = std::clamp(static_cast<double>(learnt_) / kFew, 1.0, kMostDoubt);
  const double unknown = kUnknown / (kUnknown + compared_);
  return wander_.array() + unknown * at_first;
}

/// The share of the mean that is more than chance, per axis (James and Stein's positive part).
Twist SweepBend::certainty() const {
  if (learnt_ < kFew) return Twist::Zero();
  const Twist squares = alike(sum_of_squares(mean_)).cwiseMax(kTiny);
  return (1.0 - doubt().cwiseProduct(chance()).array() / squares.array()).max(0.0);  // [K36]
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
