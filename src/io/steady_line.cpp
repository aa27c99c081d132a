// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/steady_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "io/sweep_span.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::io {
namespace {

// Sweeps that overlap by less than this share may do so by rounding, or by a packet.
constexpr double kOverlap = 0.02;
constexpr double kManyOverlap = 0.2;       // share of the pairs
constexpr double kFollowing = 0.1;         // of a sweep, between them on average
constexpr std::size_t kWindow = 200;       // scans that the line is drawn through
constexpr std::size_t kLeastForRise = 16;  // scans, of which fewer say nothing of it
// What a sweep may last less than a turn, as a share: how much the line may rise unasked.
constexpr double kUsualRise = 0.005;
// A scan that comes so much later than it should is behind a missing one, where no other tells.
constexpr double kSurelyMissing = 1.5;  // sweeps

}  // namespace

Beginning beginning_of(const ScanItem& item) {
  const SweepSpan sweep = span_of(*item.scan);
  Beginning beginning{sum(item.scan->stamp_ns, sweep.first_ns),
                      real(sweep.last_ns) - real(sweep.first_ns), std::nullopt};
  if (item.clock) beginning.clock_ns = item.clock->first_ns;
  return beginning;
}

void JitterEvidence::add(const Beginning& scan) {
  if (!lasts_.empty()) steps_.push_back(real(difference(scan.at_ns, last_at_ns_)));
  lasts_.push_back(scan.lasts_ns);
  last_at_ns_ = scan.at_ns;
}

void JitterEvidence::sum_up() {
  if (steps_.empty()) return;
  usual_ = quantile(lasts_, 0.5);
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    overlapping_ += lasts_[i] - steps_[i] > kOverlap * usual_ ? 1 : 0;
  }
}

bool JitterEvidence::is_clear() const {
  if (steps_.size() < kLeastPairs || !(usual_ > 0.0)) return false;
  const bool alike = quantile(lasts_, 0.9) - quantile(lasts_, 0.1) <= kAlike * usual_;
  double mean = 0.0;
  for (const double step : steps_) mean += step / real(static_cast<std::int64_t>(steps_.size()));
  const bool following = std::abs(mean - usual_) <= kFollowing * usual_;
  const bool many = real(overlapping_) >= kManyOverlap * static_cast<double>(steps_.size());
  return alike && following && many;
}

void SteadyLine::add(double turned, double stamp) {
  points_.push_back({turned, stamp - turned});
  keep_last(kWindow);
}

void SteadyLine::keep_last(std::size_t points) {
  while (points_.size() > points) points_.pop_front();
}

void SteadyLine::fit(double lasts) {
  const std::size_t n = points_.size(), half = n / 2;
  std::vector<double> rises;
  for (std::size_t i = 0; i + half < n && half > 0; ++i) {
    const double run = points_[i + half].turned - points_[i].turned;
    if (run > 0.0) rises.push_back((points_[i + half].over - points_[i].over) / run);
  }
  rise_ = n < kLeastForRise ? 0.0 : quantile(rises, 0.5);
  spread_ = spread_about(rise_);
  const double width = std::max(1.0, static_cast<double>(n)) * lasts;
  const double doubt = spread_ * std::sqrt(12.0 / std::max(1.0, static_cast<double>(n))) / width;
  rise_ *= kUsualRise * kUsualRise / (kUsualRise * kUsualRise + doubt * doubt);
  spread_ = spread_about(rise_);
}

double SteadyLine::spread_about(double rise) {
  std::vector<double> levels;
  for (const Point& point : points_) {
    levels.push_back(point.over - rise * (point.turned - points_.back().turned));
  }
  level_ = quantile(levels, 0.5);
  for (double& level : levels) level = std::abs(level - level_);
  return quantile(std::move(levels), 0.5);
}

double SteadyRow::turned_until(std::span<const Beginning> next) {
  if (line_.empty()) return 0.0;
  if (!counts_sweeps(next.front())) {
    return real(difference(*next.front().clock_ns, *last_.clock_ns));
  }
  // A scan in part says little of how long a sweep lasts.
  const auto lasts = [this](const Beginning& scan) {
    return std::abs(scan.lasts_ns - usual_ns_) <= kAlike * usual_ns_ ? scan.lasts_ns : usual_ns_;
  };
  fit();
  double least = std::numeric_limits<double>::infinity();
  double turned = lasts(last_);
  for (const Beginning& scan : next.first(std::min(next.size(), kAgreeing))) {
    const double at = real(difference(scan.at_ns, begun_ns_));
    least = std::min(least, (at - line_.at(turned_ + turned)) / usual_ns_);
    turned += lasts(scan);
  }
  const double late = next.size() > 1 || least > kSurelyMissing ? std::round(least) : 0.0;
  return lasts(last_) + usual_ns_ * std::max(0.0, late);
}

void SteadyRow::begin(const Beginning& scan) {
  line_.clear();
  begun_ns_ = scan.at_ns;
  turned_ = 0.0;
  add(scan);
}

void SteadyRow::go_on(const Beginning& scan, double turned) {
  turned_ += turned;
  add(scan);
}

void SteadyRow::add(const Beginning& scan) {
  line_.add(turned_, real(difference(scan.at_ns, begun_ns_)));
  last_ = scan;
}

std::string steadied_text(const SteadyRow& row) {
  return "stamps: they come and go by " + std::to_string(std::llround(1e-6 * row.spread())) +
         " ms and more beside sweeps that follow each other steadily (times of arrival?); they "
         "are taken from a line through them";
}

}  // namespace surefoot::io
