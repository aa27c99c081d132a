// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/point_time_watch.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <utility>

#include "geometry/returns.hpp"
#include "io/recording_filter.hpp"
#include "io/recording_summary.hpp"
#include "io/scan_builder.hpp"
#include "io/sweep_span.hpp"
#include "text/printable.hpp"

namespace surefoot::io {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

constexpr const char* kNoTimes =
    "point times: none in these scans, so that nothing can be deskewed: where the sensor moves the "
    "error may grow a hundredfold. ";
constexpr const char* kDeriveThem =
    "If the LiDAR spins, --derive-times azimuth (with --spin and --cut) gives them";
constexpr const char* kEqualTimes =
    "point times: all equal in a scan, so that nothing can be deskewed: where the sensor moves the "
    "error may grow a hundredfold. If the LiDAR spins, --derive-times azimuth (with --spin and "
    "--cut) "
    "gives them";
constexpr const char* kBackward =
    "point times: they run counter-clockwise, seen from above, where LiDARs spin clockwise: right "
    "if "
    "it hangs upside down; else the times are reversed, and --derive-times azimuth gives better "
    "ones";

// Scans whose times are looked at; one odd scan is no habit of the recording.
constexpr int kWatched = 20, kHabit = 3;
// Scans that are looked at before the first is given out: their stamps tell the period.
constexpr std::size_t kLookAhead = 10;
// Intervals that are known before it is said that sweeps last too long for them, and from which
// share of one on they do.
constexpr std::size_t kIntervals = 10;
constexpr double kTooLong = 1.5;

// A field whose name sounds like times, of a layout as PointTable tells it, but not one that is
// read as such; empty: none.
std::string time_like_field(std::string_view layout) {
  const std::size_t begin = layout.find(": ");
  if (begin == std::string_view::npos) return {};
  for (std::string_view rest = layout.substr(begin + 2); !rest.empty();) {
    const std::size_t end = rest.find(", ");
    const std::string_view field = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 2);
    const std::string_view name = field.substr(0, field.rfind(' '));
    std::string plain(name);
    for (char& c : plain) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const auto has = [&](const char* word) { return plain.find(word) != std::string::npos; };
    if ((has("time") || has("stamp") || has("offset")) && !is_time_name(name)) {
      return std::string(name);
    }
  }
  return {};
}

std::string no_times_text(std::string_view layout) {
  const std::string field = time_like_field(layout);
  return kNoTimes + (field.empty()
                         ? kDeriveThem
                         : "Is it the field '" + text::printable(field) + "'? --time-field " +
                               text::shell_word(field) + " reads it");
}

double azimuth_of(const Eigen::Vector3f& point) {
  return std::atan2(static_cast<double>(point.y()), static_cast<double>(point.x()));
}

/// Adds to a recording what its scans' times lack.
class WatchedRecording : public RecordingFilter {
 public:
  WatchedRecording(std::unique_ptr<Recording> recording, OpenOptions options)
      : RecordingFilter(std::move(recording)), options_(std::move(options)) {
    if (options_.time_direction == TimeDirection::backward) {
      note("point times: counted back from the stamp, as asked for");
    } else if (options_.time_direction == TimeDirection::none) {
      note("point times: left out, as asked for");
    }
    merge_notes();
  }

  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = take();
    if (item && item->scan) {
      watch(*item->scan, item->layout);
      // Times of another making count from another instant.
      const bool made = options_.time_direction == TimeDirection::backward ||
                        options_.derive_times == DeriveTimes::azimuth || options_.rows > 0;
      if (made) item->clock.reset();
    }
    merge_notes();
    return item;
  }

 private:
  std::optional<ScanItem> take() {
    const bool derived = options_.derive_times == DeriveTimes::azimuth || options_.rows > 0;
    if (derived && period_ns_ == 0) look_ahead();
    if (waiting().empty()) return recording().next();
    ScanItem item = std::move(waiting().front());
    waiting().pop_front();
    return item;
  }

  void look_ahead() {
    std::vector<double> intervals;
    std::optional<std::int64_t> last;
    while (waiting().size() < kLookAhead) {
      std::optional<ScanItem> item = recording().next();
      if (!item) break;
      if (item->scan) {
        if (last) intervals.push_back(static_cast<double>(item->scan->stamp_ns - *last));
        last = item->scan->stamp_ns;
      }
      waiting().push_back(std::move(*item));
    }
    const double usual =
        options_.rate_hz > 0.0 ? 1e9 / options_.rate_hz : spread_of(intervals).median;
    if (!(usual > 0.0 && usual < 2e9)) {
      throw ReadError(
          "point times that are derived: the stamps do not tell how long a revolution takes; "
          "--rate does");
    }
    period_ns_ = std::llround(usual);
  }

  void note_derived(const char* from) {
    if (std::exchange(derived_noted_, true)) return;
    note(std::string("point times: derived from ") + from + ", a revolution of " +
         std::to_string(period_ns_ / 1000) + " us");
  }

  void note_other_size(const Scan& scan) {
    if (std::exchange(other_size_noted_, true)) return;
    note("point times: not derived from the columns of scans that do not have all " +
         std::to_string(options_.rows * options_.columns) + " points; the first has " +
         std::to_string(scan.points.size()));
  }

  /// Sweeps that lie over each other: their times are of another unit, or a share of the sweep.
  void look_at_length(const Scan& scan) {
    if (intervals_s_.size() == kIntervals) return;
    if (last_stamp_ns_ && scan.stamp_ns > *last_stamp_ns_) {
      const SweepSpan span = span_of(scan);
      intervals_s_.push_back(
          1e-9 * (static_cast<double>(scan.stamp_ns) - static_cast<double>(*last_stamp_ns_)));
      lengths_s_.push_back(1e-9 * (static_cast<double>(span.last_ns) - span.first_ns));
    }
    last_stamp_ns_ = scan.stamp_ns;
    if (intervals_s_.size() < kIntervals) return;
    const double usual = spread_of(intervals_s_).median, lasts = spread_of(lengths_s_).median;
    if (lasts <= kTooLong * usual) return;
    std::array<char, 200> text;
    std::snprintf(text.data(), text.size(),
                  "point times: sweeps last %.4f s, and the scans are %.4f s apart: is the unit of "
                  "the point times wrong (--time-unit), or the rate (--rate)?",
                  lasts, usual);
    note(text.data());
  }

  void watch(Scan& scan, const std::string& layout) {
    if (options_.time_direction == TimeDirection::none) {
      scan.times_ns.clear();
      return;
    }
    if (options_.time_direction == TimeDirection::backward) count_backward(scan);
    if (options_.rows > 0 && scan.points.size() == options_.rows * options_.columns) {
      time_columns(scan, options_.rows, {{}, 0.0, period_ns_, options_.stamp_at});
      note_derived("the columns");
      return;
    }
    if (options_.derive_times == DeriveTimes::azimuth) {
      note_derived("azimuth");
      derive_times(scan, {options_.spin, options_.cut_azimuth_deg, period_ns_, options_.stamp_at});
      return;
    }
    if (options_.rows > 0 && !scan.points.empty()) note_other_size(scan);
    look_at_length(scan);
    if (said_ || watched_ == kWatched || scan.points.empty()) return;
    ++watched_;
    const PointTimes times = point_times_of(scan);
    const bool backward =
        times == PointTimes::there && spin_of(scan) == std::optional(Spin::counterclockwise);
    odd_ = times != PointTimes::there || backward ? odd_ + 1 : 0;
    if (odd_ < kHabit) return;
    note(backward ? kBackward : times == PointTimes::none ? no_times_text(layout) : kEqualTimes);
    said_ = true;
  }

  OpenOptions options_;
  std::int64_t period_ns_ = 0;
  int watched_ = 0, odd_ = 0;  // scans; odd ones in a row
  bool said_ = false, derived_noted_ = false, other_size_noted_ = false;
  std::optional<std::int64_t> last_stamp_ns_;
  std::vector<double> intervals_s_, lengths_s_;  // of the first scans
};

}  // namespace

PointTimes point_times_of(const Scan& scan) {
  if (scan.times_ns.empty()) return PointTimes::none;
  const auto [least, greatest] = std::minmax_element(scan.times_ns.begin(), scan.times_ns.end());
  return *least == *greatest ? PointTimes::equal : PointTimes::there;
}

std::optional<Spin> spin_of(const Scan& scan) {
  if (point_times_of(scan) != PointTimes::there) return std::nullopt;
  // All lasers of a spinning LiDAR look about one way at an instant: the mean direction of each
  // stretch of time is sharp, and turns steadily.
  constexpr std::size_t kStretches = 40;
  const auto [least, greatest] = std::minmax_element(scan.times_ns.begin(), scan.times_ns.end());
  const double duration = static_cast<double>(*greatest) - static_cast<double>(*least);
  std::array<std::complex<double>, kStretches> sums{};
  std::array<double, kStretches> counts{};
  // Every few points tell it.
  constexpr std::size_t kLookedAt = 8000;
  for (std::size_t i = 0; i < scan.points.size(); i += scan.points.size() / kLookedAt + 1) {
    if (!is_return(scan.points[i])) continue;
    const double share =
        (static_cast<double>(scan.times_ns[i]) - static_cast<double>(*least)) / duration;
    const auto k = std::min(static_cast<std::size_t>(share * kStretches), kStretches - 1);
    sums[k] += std::polar(1.0, azimuth_of(scan.points[i]));
    counts[k] += 1.0;
  }
  constexpr double kSharp = 0.9;
  int clockwise = 0, counterclockwise = 0;
  for (std::size_t k = 1; k < kStretches; ++k) {
    const bool sharp = std::abs(sums[k - 1]) > kSharp * counts[k - 1] && counts[k - 1] > 0.0 &&
                       std::abs(sums[k]) > kSharp * counts[k] && counts[k] > 0.0;
    if (sharp) ++(std::arg(sums[k] / sums[k - 1]) < 0.0 ? clockwise : counterclockwise);
  }
  constexpr int kMost = static_cast<int>(kStretches) * 3 / 4;
  if (clockwise >= kMost) return Spin::clockwise;
  if (counterclockwise >= kMost) return Spin::counterclockwise;
  return std::nullopt;
}

void count_backward(Scan& scan) {
  // Not of the lowest number, which has no opposite.
  for (std::int32_t& time : scan.times_ns) time = -std::max(time, -INT32_MAX);
}

void derive_times(Scan& scan, const SweepTiming& sweep) {
  const double cut = sweep.cut_deg * std::numbers::pi / 180.0;
  const double sign = sweep.spin == Spin::clockwise ? -1.0 : 1.0;
  const std::int64_t first = sweep.stamp_at == StampAt::end ? -sweep.period_ns : 0;
  scan.times_ns.resize(scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    std::int64_t offset = 0;
    if (is_return(scan.points[i])) {
      const double turned = sign * (azimuth_of(scan.points[i]) - cut) / kTurn;
      offset = std::llround((turned - std::floor(turned)) * static_cast<double>(sweep.period_ns));
    }
    scan.times_ns[i] = static_cast<std::int32_t>(first + offset);
  }
}

void time_columns(Scan& scan, std::size_t rows, const SweepTiming& sweep) {
  const std::int64_t first = sweep.stamp_at == StampAt::end ? -sweep.period_ns : 0;
  const std::size_t columns = std::max<std::size_t>(1, scan.points.size() / rows);
  scan.times_ns.resize(scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const auto column = static_cast<std::int64_t>(i / rows);
    scan.times_ns[i] = static_cast<std::int32_t>(first + column * sweep.period_ns /
                                                             static_cast<std::int64_t>(columns));
  }
}

std::unique_ptr<Recording> watch_point_times(std::unique_ptr<Recording> recording,
                                             const OpenOptions& options) {
  return std::make_unique<WatchedRecording>(std::move(recording), options);
}

}  // namespace surefoot::io
