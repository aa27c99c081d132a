// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/recording_summary.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "geometry/returns.hpp"
#include "io/repeated_scans.hpp"
#include "surefoot/quantile.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::io {
namespace {

// A gap is an interval half as long again as the usual one: a scan is missing.
constexpr double kGapFactor = 1.5;
// Scans shorter or longer than this are rarely whole sweeps [s].
constexpr double kShortestSweep = 0.01;
constexpr double kLongestSweep = 1.0;

class Summariser {
 public:
  void add(const ScanItem& item) {
    if (!item.layout.empty() && std::find(summary_.layouts.begin(), summary_.layouts.end(),
                                          item.layout) == summary_.layouts.end()) {
      summary_.layouts.push_back(item.layout);
    }
    if (!item.scan) {
      ++summary_.unreadable;
      note_oddity("unreadable", item.error);
      return;
    }
    ++summary_.scans;
    if (seen_.came_before(*item.scan)) note_oddity("scans that are sent again", item.name);
    if (!item.remark.empty()) {
      note_oddity("partial", item.name + ": " + item.remark);
    }
    if (item.dropped_points > 0) {
      note_oddity("points without a usable time, dropped",
                  item.name + ": " + std::to_string(item.dropped_points));
    }
    add_stamp(*item.scan, item.name);
    add_points(item);
    add_times(*item.scan, item.name);
    rings_.insert(item.scan->rings.begin(), item.scan->rings.end());
  }

  RecordingSummary finish(const Recording& recording) {
    summary_.description = recording.description();
    summary_.notes = recording.notes();
    summary_.capture = recording.capture_counts();
    summary_.points = spread_of(points_);
    summary_.interval_s = spread_of(intervals_);
    summary_.usual_interval_s = usual_interval(intervals_);
    summary_.duration_s = spread_of(durations_);
    summary_.range_m = overall(ranges_);
    summary_.intensity = overall(intensities_);
    summary_.has_intensities = !intensities_.empty();
    summary_.rings.assign(rings_.begin(), rings_.end());
    add_gaps();
    if (summary_.layouts.size() > 1) {
      note_oddity("fields differ between scans",
                  std::to_string(summary_.layouts.size()) + " layouts");
    }
    return std::move(summary_);
  }

 private:
  void note_oddity(const std::string& what, const std::string& first) {
    for (Oddity& oddity : summary_.oddities) {
      if (oddity.what == what) {
        ++oddity.scans;
        return;
      }
    }
    summary_.oddities.push_back({what, 1, first});
  }

  void add_stamp(const Scan& scan, const std::string& name) {
    if (last_stamp_ns_) {
      const std::int64_t step = scan.stamp_ns - *last_stamp_ns_;
      intervals_.push_back(seconds(step));
      interval_ends_.push_back(name);
      if (step <= 0) {
        note_oddity(step == 0 ? "stamp equal to the one before" : "stamp before the one before",
                    name);
      }
    } else {
      summary_.first_stamp_ns = scan.stamp_ns;
    }
    last_stamp_ns_ = scan.stamp_ns;
    summary_.last_stamp_ns = scan.stamp_ns;
  }

  void add_points(const ScanItem& item) {
    const Scan& scan = *item.scan;
    const std::string& name = item.name;
    std::vector<double> ranges;
    std::vector<double> intensities;
    std::size_t not_finite = item.dropped_not_finite;
    std::size_t zero = item.dropped_zero;
    points_.push_back(static_cast<double>(scan.points.size() + not_finite + zero));
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const double range = scan.points[i].cast<double>().norm();
      not_finite += std::isfinite(range) ? 0 : 1;
      zero += range < kNoRange ? 1 : 0;
      if (std::isfinite(range) && range >= kNoRange) {
        ranges.push_back(range);
        if (!scan.intensities.empty() && std::isfinite(scan.intensities[i])) {
          intensities.push_back(scan.intensities[i]);
        }
      }
    }
    if (ranges.empty()) {
      note_oddity("no return at all", name);
    } else {
      ranges_.push_back(spread_of(ranges));
    }
    if (!intensities.empty()) {
      intensities_.push_back(spread_of(intensities));
    }
    if (not_finite > 0) {
      note_oddity("scans with points that are NaN or infinite",
                  name + ": " + std::to_string(not_finite));
    }
    if (zero > 0) {
      note_oddity("scans with points that are zero", name + ": " + std::to_string(zero));
    }
  }

  void add_times(const Scan& scan, const std::string& name) {
    if (scan.times_ns.empty()) {
      note_oddity("no point times, cannot be deskewed", name);
      return;
    }
    const auto [least, greatest] = std::minmax_element(scan.times_ns.begin(), scan.times_ns.end());
    const double duration = seconds(std::int64_t{*greatest} - std::int64_t{*least});
    durations_.push_back(duration);
    if (duration == 0.0) {
      note_oddity("all point times equal", name);
    } else if (duration < kShortestSweep) {
      note_oddity("scan shorter than 0.01 s", name);
    } else if (duration > kLongestSweep) {
      note_oddity("scan longer than 1 s", name);
    }
  }

  void add_gaps() {
    const double usual = summary_.usual_interval_s;
    for (std::size_t i = 0; i < intervals_.size() && usual > 0.0; ++i) {
      if (intervals_[i] > kGapFactor * usual) {
        note_oddity("gap before a scan", interval_ends_[i]);
      }
    }
  }

  // Extremes over all scans; the median of the scans' medians.
  static Spread overall(const std::vector<Spread>& spreads) {
    std::vector<double> medians;
    Spread all;
    for (const Spread& spread : spreads) {
      all.least = medians.empty() ? spread.least : std::min(all.least, spread.least);
      all.greatest = medians.empty() ? spread.greatest : std::max(all.greatest, spread.greatest);
      medians.push_back(spread.median);
    }
    all.median = spread_of(medians).median;
    return all;
  }

  RecordingSummary summary_;
  SeenScans seen_;
  std::optional<std::int64_t> last_stamp_ns_;
  std::vector<double> points_, intervals_, durations_;
  std::vector<std::string> interval_ends_;
  std::vector<Spread> ranges_, intensities_;
  std::set<std::uint16_t> rings_;
};

}  // namespace

Spread spread_of(const std::vector<double>& values) {
  if (values.empty()) {
    return {};
  }
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  return {*least, quantile(values, 0.5), *greatest};
}

double usual_interval(const std::vector<double>& intervals) {
  const std::size_t parts = intervals.size() > 1 ? 1 : 0;
  return spread_of({intervals.begin() + static_cast<std::ptrdiff_t>(parts), intervals.end()})
      .median;
}

RecordingSummary summarise(Recording& recording) {
  Summariser summariser;
  while (const std::optional<ScanItem> item = recording.next()) {
    summariser.add(*item);
  }
  return summariser.finish(recording);
}

}  // namespace surefoot::io
