// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/stamp_steadying.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "io/recording_filter.hpp"
#include "io/saturated.hpp"
#include "io/sweep_span.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::io {

namespace {

// Pairs of scans without which nothing is clear.
constexpr std::size_t kLeastPairs = 8;
// Sweeps that overlap by less than this share may do so by rounding, or by a packet.
constexpr double kOverlap = 0.02;
constexpr double kManyOverlap = 0.2;                   // share of the pairs
constexpr double kAlike = 0.02;                        // spread of the sweeps' durations
constexpr double kFollowing = 0.1;                     // of a sweep, between them on average
constexpr std::size_t kReadAhead = 30, kWindow = 200;  // scans that the line is drawn through
constexpr std::size_t kAgreeing = 8;       // of them have to come late for a scan to be missing
constexpr double kLongestPause = 5.0;      // sweeps; what comes after it begins anew
constexpr std::size_t kLeastForRise = 16;  // scans, of which fewer say nothing of it
// What a sweep may last less than a turn, as a share: how much the line may rise unasked.
constexpr double kUsualRise = 0.005;

double real(std::int64_t ns) { return static_cast<double>(ns); }

/// When a scan's first point was measured, by its stamp, and for how long the sweep lasted.
struct Beginning {
  std::int64_t at_ns = 0;
  double lasts_ns = 0.0;
  std::optional<std::int64_t> clock_ns;  ///< of the points, where they have one
};

Beginning beginning_of(const ScanItem& item) {
  const SweepSpan sweep = span_of(*item.scan);
  Beginning beginning{sum(item.scan->stamp_ns, sweep.first_ns),
                      real(sweep.last_ns) - real(sweep.first_ns), std::nullopt};
  if (item.clock) beginning.clock_ns = item.clock->first_ns;
  return beginning;
}

/// What the first scans tell.
class Evidence {
 public:
  explicit Evidence(const std::vector<Beginning>& scans) {
    for (std::size_t i = 0; i < scans.size(); ++i) {
      lasts_.push_back(scans[i].lasts_ns);
      if (i > 0) steps_.push_back(real(difference(scans[i].at_ns, scans[i - 1].at_ns)));
    }
    if (steps_.empty()) return;
    usual_ = quantile(lasts_, 0.5);
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      overlapping_ += lasts_[i] - steps_[i] > kOverlap * usual_ ? 1 : 0;
    }
  }
  [[nodiscard]] double usual_ns() const { return usual_; }
  [[nodiscard]] bool any() const { return overlapping_ > 0; }
  [[nodiscard]] bool is_clear() const {
    if (steps_.size() < kLeastPairs || !(usual_ > 0.0)) return false;
    const bool alike = quantile(lasts_, 0.9) - quantile(lasts_, 0.1) <= kAlike * usual_;
    double mean = 0.0;
    for (const double step : steps_) mean += step / real(static_cast<std::int64_t>(steps_.size()));
    const bool following = std::abs(mean - usual_) <= kFollowing * usual_;
    const bool many = real(overlapping_) >= kManyOverlap * static_cast<double>(steps_.size());
    return alike && following && many;
  }

 private:
  std::vector<double> lasts_, steps_;
  double usual_ = 0.0;
  std::int64_t overlapping_ = 0;
};

/// Stamps over a time that sweeps themselves make up: a line through them.
class SteadyLine {
 public:
  void add(double turned, double stamp) {
    points_.push_back({turned, stamp - turned});
    if (points_.size() > kWindow) points_.pop_front();
  }
  void clear() { points_.clear(); }
  [[nodiscard]] bool empty() const { return points_.empty(); }

  /// Rise by the median of what pairs half a window apart say, as far as they can know it.
  void fit(double lasts) {
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
  [[nodiscard]] double at(double turned) const {
    return turned + level_ + rise_ * (turned - points_.back().turned);
  }
  [[nodiscard]] double spread() const { return spread_; }

 private:
  struct Point {
    double turned = 0.0, over = 0.0;  ///< [ns] since it began
  };

  double spread_about(double rise) {
    std::vector<double> levels;
    for (const Point& point : points_) {
      levels.push_back(point.over - rise * (point.turned - points_.back().turned));
    }
    level_ = quantile(levels, 0.5);
    for (double& level : levels) level = std::abs(level - level_);
    return quantile(std::move(levels), 0.5);
  }

  std::deque<Point> points_;
  double rise_ = 0.0, level_ = 0.0, spread_ = 0.0;
};

class SteadiedRecording final : public RecordingFilter {
 public:
  explicit SteadiedRecording(std::unique_ptr<Recording> recording)
      : RecordingFilter(std::move(recording)) {
    merge_notes();
  }

  std::optional<ScanItem> next() override {
    if (!asked_) ask();
    if (steadies_) read_ahead(kReadAhead);
    if (waiting().empty()) {
      std::optional<ScanItem> item = recording().next();
      merge_notes();
      return item;
    }
    if (steadies_ && waiting().front().scan) place_front();
    ScanItem item = std::move(waiting().front());
    waiting().pop_front();
    return item;
  }

  void skip(std::size_t scans) override {
    for (; scans > 0 && !waiting().empty(); --scans) {
      if (waiting().front().scan && !placed_.empty()) placed_.pop_front();
      waiting().pop_front();
    }
    recording().skip(scans);
  }

 private:
  void ask() {
    asked_ = true;
    read_ahead(kLeastPairs + 1);
    if (!Evidence(beginnings_ahead()).any()) return;
    read_ahead(kReadAhead);
    const Evidence evidence(beginnings_ahead());
    steadies_ = evidence.is_clear();
    usual_ns_ = evidence.usual_ns();
  }

  void read_ahead(std::size_t scans) {
    while (waiting().size() < scans) {
      std::optional<ScanItem> item = recording().next();
      merge_notes();
      if (!item) return;
      waiting().push_back(std::move(*item));
    }
  }

  [[nodiscard]] std::vector<Beginning> beginnings_ahead() const {
    std::vector<Beginning> beginnings;
    for (const ScanItem& item : waiting()) {
      if (item.scan) beginnings.push_back(beginning_of(item));
    }
    return beginnings;
  }

  /// Gives the first that waits its stamp, after those behind it have taken their place, too.
  void place_front() {
    const std::vector<Beginning> ahead = beginnings_ahead();
    bool goes_on = true;
    while (goes_on && (placed_.empty() || placed_.size() + kAgreeing < ahead.size())) {
      goes_on = place(ahead, placed_.size());
    }
    line_.fit(usual_ns_);
    Scan& scan = *waiting().front().scan;
    const std::int64_t begins = sum(begun_ns_, std::llround(line_.at(placed_.front())));
    scan.stamp_ns = sum(scan.stamp_ns, difference(begins, ahead.front().at_ns));
    if (given_) scan.stamp_ns = std::max(scan.stamp_ns, sum(*given_, 1));
    given_ = scan.stamp_ns;
    placed_.pop_front();
    if (!noted_) {
      note("stamps: they come and go by " + std::to_string(std::llround(1e-6 * line_.spread())) +
           " ms and more beside sweeps that follow each other steadily (times of arrival?); they "
           "are taken from a line through them");
    }
    noted_ = true;
  }

  /// The next place in the row of sweeps: a sweep later, or several where scans are missing. False
  /// where a row has ended, and those in front are to go first.
  bool place(const std::vector<Beginning>& ahead, std::size_t i) {
    const Beginning& scan = ahead[i];
    const double turned = line_.empty() ? 0.0 : turned_ + turned_between(ahead, i);
    if (line_.empty() || !(turned > turned_) || turned - turned_ > kLongestPause * usual_ns_) {
      if (!placed_.empty()) return false;
      line_.clear();
      begun_ns_ = scan.at_ns;
      turned_ = 0.0;
    } else {
      turned_ = turned;
    }
    line_.add(turned_, real(difference(scan.at_ns, begun_ns_)));
    placed_.push_back(turned_);
    last_ = scan;
    return true;
  }

  /// From the last scan that was placed to this one, by the points' clock or in sweeps. Of missing
  /// ones all that follow have to be late.
  [[nodiscard]] double turned_between(const std::vector<Beginning>& ahead, std::size_t i) {
    if (last_.clock_ns && ahead[i].clock_ns) {
      return real(difference(*ahead[i].clock_ns, *last_.clock_ns));
    }
    // A scan in part says little of how long a sweep lasts.
    const auto lasts = [this](const Beginning& scan) {
      return std::abs(scan.lasts_ns - usual_ns_) <= kAlike * usual_ns_ ? scan.lasts_ns : usual_ns_;
    };
    line_.fit(usual_ns_);
    double least = std::numeric_limits<double>::infinity();
    double turned = lasts(last_);
    for (std::size_t k = i; k < std::min(i + kAgreeing, ahead.size()); ++k) {
      const double at = real(difference(ahead[k].at_ns, begun_ns_));
      least = std::min(least, (at - line_.at(turned_ + turned)) / usual_ns_);
      turned += lasts(ahead[k]);
    }
    return lasts(last_) + usual_ns_ * std::max(0.0, std::round(least));
  }

  bool asked_ = false, steadies_ = false, noted_ = false;
  SteadyLine line_;
  std::deque<double> placed_;  ///< where those that wait stand in the row of sweeps [ns]
  std::int64_t begun_ns_ = 0;  ///< what the row and the line count from
  double turned_ = 0.0;        ///< of the last one that was placed
  Beginning last_;             ///< the same scan
  double usual_ns_ = 0.0;      ///< that a sweep lasts
  std::optional<std::int64_t> given_;
};

}  // namespace

std::unique_ptr<Recording> steady_stamps(std::unique_ptr<Recording> recording) {
  return std::make_unique<SteadiedRecording>(std::move(recording));
}

}  // namespace surefoot::io
