// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What tells that stamps come and go beside sweeps that follow each other steadily, and the line
// through them that tells when they really began.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "io/recording.hpp"
#include "io/saturated.hpp"

namespace surefoot::io {

// Pairs of scans without which nothing is clear.
inline constexpr std::size_t kLeastPairs = 8;
inline constexpr double kAlike = 0.02;        // spread of the sweeps' durations, as a share
inline constexpr std::size_t kAgreeing = 8;   // scans that have to tell the same
inline constexpr double kLongestPause = 5.0;  // sweeps; what comes after it begins anew

[[nodiscard]] inline double real(std::int64_t ns) { return static_cast<double>(ns); }

/// When a scan's first point was measured, by its stamp, and for how long the sweep lasted.
struct Beginning {
  std::int64_t at_ns = 0;
  double lasts_ns = 0.0;
  std::optional<std::int64_t> clock_ns;  ///< of the points, where they have one
};

[[nodiscard]] Beginning beginning_of(const ScanItem& item);

/// What scans that follow each other tell.
class JitterEvidence {
 public:
  template <typename Scans>
  explicit JitterEvidence(const Scans& scans) {
    for (const Beginning& scan : scans) add(scan);
    sum_up();
  }
  [[nodiscard]] double usual_ns() const { return usual_; }
  /// Whether any sweep begins before the one before has ended.
  [[nodiscard]] bool any() const { return overlapping_ > 0; }
  /// Whether many do, though all last equally long and follow each other closely on average.
  [[nodiscard]] bool is_clear() const;

 private:
  void add(const Beginning& scan);
  void sum_up();

  std::vector<double> lasts_, steps_;
  std::int64_t last_at_ns_ = 0;
  double usual_ = 0.0;
  std::int64_t overlapping_ = 0;
};

/// Stamps over a time that sweeps themselves make up: a line through them.
class SteadyLine {
 public:
  void add(double turned, double stamp);
  void clear() { points_.clear(); }
  void keep_last(std::size_t points);
  [[nodiscard]] bool empty() const { return points_.empty(); }

  /// Rise by the median of what pairs half a window apart say, as far as they can know it.
  void fit(double lasts);
  [[nodiscard]] double at(double turned) const {
    return turned + level_ + rise_ * (turned - points_.back().turned);
  }
  [[nodiscard]] double spread() const { return spread_; }

 private:
  struct Point {
    double turned = 0.0, over = 0.0;  ///< [ns] since it began
  };

  double spread_about(double rise);

  std::deque<Point> points_;
  double rise_ = 0.0, level_ = 0.0, spread_ = 0.0;
};

/// Sweeps one after the other, as their durations or the points' clock tell, and a line through
/// their stamps.
class SteadyRow {
 public:
  explicit SteadyRow(double usual_ns) : usual_ns_(usual_ns) {}

  /// What the LiDAR turned from the last scan to the next one, which others may follow: one sweep,
  /// or more where scans are missing. Of missing ones all that follow have to be late.
  [[nodiscard]] double turned_until(std::span<const Beginning> next);
  /// Whether so much is neither none nor a pause, behind which a row begins anew.
  [[nodiscard]] bool goes_on(double turned) const {
    return !line_.empty() && turned > 0.0 && turned <= kLongestPause * usual_ns_;
  }
  /// Whether that is counted in sweeps: the points have no clock.
  [[nodiscard]] bool counts_sweeps(const Beginning& next) const {
    return !(last_.clock_ns && next.clock_ns);
  }
  void begin(const Beginning& scan);
  void go_on(const Beginning& scan, double turned);

  void fit() { line_.fit(usual_ns_); }
  /// When a scan began, by the line that was fitted last.
  [[nodiscard]] std::int64_t begun_ns(double turned) const {
    return sum(begun_ns_, std::llround(line_.at(turned)));
  }
  /// Of the last scan, since the row began [ns].
  [[nodiscard]] double turned() const { return turned_; }
  [[nodiscard]] double spread() const { return line_.spread(); }
  [[nodiscard]] double usual_ns() const { return usual_ns_; }

 private:
  void add(const Beginning& scan);

  double usual_ns_;  ///< that a sweep lasts
  SteadyLine line_;
  std::int64_t begun_ns_ = 0;  ///< what the row and the line count from
  double turned_ = 0.0;
  Beginning last_;
};

/// What is said where stamps are steadied.
[[nodiscard]] std::string steadied_text(const SteadyRow& row);

}  // namespace surefoot::io
