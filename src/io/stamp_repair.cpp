// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/stamp_repair.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>
#include <vector>

#include "geometry/returns.hpp"
#include "io/decimal_time.hpp"
#include "io/point_clock.hpp"
#include "io/recording_filter.hpp"
#include "io/repeated_scans.hpp"
#include "io/saturated.hpp"
#include "io/stamp_steadying.hpp"
#include "io/sweep_span.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::io {

namespace {

constexpr std::size_t kAhead = 2;       // scans that are read before one is given out
constexpr std::size_t kIntervals = 15;  // last ones, whose median is the usual interval
constexpr std::size_t kTold = 2;        // from so many on they tell what a gap is
constexpr std::int64_t kUnknownInterval = 100'000'000;  // [ns] before any is known
// A stamp off by more than so many intervals is wild, if its neighbours fit each other.
constexpr std::int64_t kWild = 5;
// The first and the last have one neighbour: so long a pause beside a single scan is none.
constexpr std::int64_t kWildAtTheEnd = 1000;
// Without a look ahead: so many in a row that go on from each other are of a clock that was set.
constexpr std::size_t kSteady = 3;
// By so many intervals the last one may have come late, to be made up for by shorter ones.
constexpr std::int64_t kMadeUpFor = 2;
constexpr std::int64_t kLongestInterval = 10'000'000'000;  // [ns] of a LiDAR

class RepairedRecording : public RecordingFilter {
 public:
  RepairedRecording(std::unique_ptr<Recording> recording, const OpenOptions& options)
      : RecordingFilter(std::move(recording)),
        known_interval_ns_(options.rate_hz > 0.0 ? std::llround(1e9 / options.rate_hz) : 0),
        at_once_(options.repair_at_once) {
    merge_notes();
  }

  std::optional<ScanItem> next() override {
    while (true) {
      fill();
      if (waiting().empty()) return std::nullopt;
      ScanItem item = std::move(waiting().front());
      waiting().pop_front();
      if (!item.scan) return item;
      const bool again = last_ && is_last_again(*item.scan);
      // Where all scans are alike it may be a made recording.
      if (again && differ_) {
        note_once(twice_, "stamps: scans that were sent twice, first " + item.name +
                              ", are left out: the same points to the last bit");
        continue;
      }
      differ_ = differ_ || (last_ && !again);
      repair(item);
      return item;
    }
  }

 private:
  void fill() {
    std::size_t scans = 0;
    for (const ScanItem& item : waiting()) scans += item.scan ? 1 : 0;
    while (scans <= (at_once_ ? 0 : kAhead)) {
      std::optional<ScanItem> item = recording().next();
      merge_notes();
      if (!item) return;
      scans += item->scan ? 1 : 0;
      waiting().push_back(std::move(*item));
    }
  }

  /// Stamps of the scans that wait, as the recording gives them.
  std::vector<std::int64_t> stamps_ahead() const {
    std::vector<std::int64_t> stamps;
    for (const ScanItem& item : waiting()) {
      if (item.scan) stamps.push_back(item.scan->stamp_ns);
    }
    return stamps;
  }

  [[nodiscard]] std::int64_t usual_interval_ns() const {
    if (known_interval_ns_ > 0) return known_interval_ns_;
    if (intervals_.empty()) return kUnknownInterval;
    return quantile(std::vector(intervals_.begin(), intervals_.end()), 0.5);
  }

  /// The last scan's points again, to the last bit: no sensor measures so, unless it sees nothing.
  [[nodiscard]] bool is_last_again(const Scan& scan) const {
    const bool sees = std::any_of(scan.points.begin(), scan.points.end(),
                                  [](const Eigen::Vector3f& point) { return is_return(point); });
    return sees && scan.points.size() == last_points_.size() &&
           std::equal(scan.points.begin(), scan.points.end(), last_points_.begin(),
                      [](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
                        return (a.array() == b.array() || (a.array() != a.array())).all();
                      });
  }

  void repair(ScanItem& item) {
    Scan& scan = *item.scan;
    const std::int64_t given = scan.stamp_ns;
    if (!last_) {
      scan.stamp_ns = first_stamp(item);
    } else if (is_wild(item)) {
      // Where it would be, but before the next.
      scan.stamp_ns = sum(*last_, usual_interval_ns());
      const std::vector<std::int64_t> ahead = stamps_ahead();
      if (!ahead.empty()) {
        const std::int64_t to_next = difference(sum(ahead.front(), offset_ns_), *last_);
        scan.stamp_ns = std::min(scan.stamp_ns, sum(*last_, to_next / 2 + 1));
      }
      note_wild(given, item.name);
    } else if (at_once_ && last_came_late(*item.scan)) {
      note_once(late_noted_, "stamps: the one before " + item.name +
                                 " came late; the next ones come nearer to where they belong");
      scan.stamp_ns = std::max(sum(given, offset_ns_), sum(*last_, usual_interval_ns() / 2));
      steady_ = 0;
      confirm(given);
    } else if (at_once_ && !fits_at_once(item)) {
      const std::int64_t intervals = intervals_since_last(item);
      scan.stamp_ns = sum(*last_, times(intervals, usual_interval_ns()));
    } else {
      const std::int64_t told = difference(sum(given, offset_ns_), *last_);
      const bool leaps = told >= times(kWild, usual_interval_ns()) && is_ahead(item);
      if ((!at_once_ && (told <= 0 || leaps)) || is_no_time(given)) {
        set_clock(given, item.name, intervals_since_last(item));
      }
      scan.stamp_ns = sum(given, offset_ns_);
      note_lateness(item);
      if (times(2, distance(told, usual_interval_ns())) <= usual_interval_ns()) confirm(given);
      const std::int64_t step = difference(scan.stamp_ns, *last_);
      if (step < times(kWild, usual_interval_ns())) {
        if (!last_is_part_) intervals_.push_back(step);
      } else if (known_interval_ns_ > 0 || intervals_.size() >= kTold) {
        note_once(gap_noted_, "stamps: " + format_seconds(step) + " s without a scan before " +
                                  item.name + ", and nothing says that the clock was set: a gap");
      }
      if (intervals_.size() > kIntervals) intervals_.pop_front();
    }
    // Whatever was told: jumps of centuries leave sums at the end of their range.
    if (last_) scan.stamp_ns = std::max(scan.stamp_ns, sum(*last_, 1));
    given_ns_ = given;
    ++since_confirmed_;
    if (last_) last_step_ns_ = difference(scan.stamp_ns, *last_);
    last_ = scan.stamp_ns;
    last_logged_ns_ = item.logged_ns;
    last_sweep_ = span_of(scan);
    last_is_part_ = !item.remark.empty();
    last_points_ = scan.points;
  }

  /// The first one's, or, where the next two fit each other and not the first, what fits them.
  std::int64_t first_stamp(const ScanItem& item) {
    const std::int64_t given = item.scan->stamp_ns;
    const std::vector<std::int64_t> ahead = stamps_ahead();
    if (ahead.size() < 2) return given;
    const std::int64_t interval = difference(ahead[1], ahead[0]);
    if (interval <= 0 || interval > kLongestInterval) return given;
    const std::int64_t step = difference(ahead[0], given), steps = difference(ahead[1], given);
    if (step > 0 && step < times(kWildAtTheEnd, interval)) return given;
    if (steps > 0 && steps <= kLongestInterval) return given;  // it is the second that is wild
    const std::int64_t logged_next = waiting().front().logged_ns;
    const bool both = item.logged_ns != 0 && logged_next != 0;
    if (both && step > 0 && difference(logged_next, item.logged_ns) > step / 2) return given;
    note_wild(given, item.name);
    return difference(ahead[0], interval);
  }

  /// Whether the next ones go on from the last, as if this one had told its stamp wrongly.
  [[nodiscard]] bool is_wild(const ScanItem& item) const {
    const std::int64_t usual = usual_interval_ns();
    const std::int64_t step = difference(sum(item.scan->stamp_ns, offset_ns_), *last_);
    const std::vector<std::int64_t> ahead = stamps_ahead();
    const bool within = step > 0 && step <= times(kWild, usual);
    const std::int64_t given = item.scan->stamp_ns;
    if (within && !is_too_soon(*item.scan) && !is_late(step, ahead, given)) return false;
    if (ahead.empty() && !at_once_) {  // the last one
      const bool known = intervals_.size() >= kSteady && item.logged_ns == 0;
      return known && step >= times(kWildAtTheEnd, usual);
    }
    std::int64_t intervals = 2;
    for (const std::int64_t stamp : ahead) {
      const std::int64_t since = difference(sum(stamp, offset_ns_), *last_);
      if (times(2, since) <= usual || since >= times(intervals + kWild, usual)) return false;
      ++intervals;
    }
    return !ahead.empty();
  }

  /// By how much sweeps may overlap by their stamps, or be early or late: half of one, and far more
  /// than stamps vary otherwise. Nothing where that is not known yet.
  [[nodiscard]] std::optional<std::int64_t> margin() const {
    if (intervals_.size() < kSteady) return std::nullopt;
    const std::int64_t usual = usual_interval_ns();
    std::vector<std::int64_t> off;  // gaps are few, the turns of two LiDARs are not
    for (const std::int64_t interval : intervals_) {
      off.push_back(std::min(distance(interval, usual), kLongestInterval));
    }
    return sum(std::min(usual, lasting_ns()) / 2, 2 * quantile(std::move(off), 0.8));
  }
  [[nodiscard]] std::int64_t lasting_ns() const {
    const std::int64_t lasts = std::int64_t{last_sweep_.last_ns} - last_sweep_.first_ns;
    return lasts > 0 ? lasts : usual_interval_ns();
  }

  /// A LiDAR does not begin a sweep while it is at the last one, nor much sooner than it usually
  /// does; unless it is the last one that came late.
  [[nodiscard]] bool is_too_soon(const Scan& scan) const {
    const std::optional<std::int64_t> most = margin();
    if (!most) return false;
    const std::int64_t usual = usual_interval_ns();
    const std::int64_t step = difference(sum(scan.stamp_ns, offset_ns_), *last_);
    const std::int64_t first = std::int64_t{span_of(scan).first_ns} - last_sweep_.first_ns;
    const bool overlaps = difference(lasting_ns(), sum(step, first)) > *most;
    const std::int64_t both = difference(sum(usual, usual), sum(step, last_step_ns_));
    return overlaps && difference(usual, step) > *most && both > *most;
  }

  /// Much later than usual, and the next one follows much sooner.
  [[nodiscard]] bool is_late(std::int64_t step, const std::vector<std::int64_t>& ahead,
                             std::int64_t given) const {
    const std::optional<std::int64_t> most = margin();
    if (!most || ahead.empty()) return false;
    const std::int64_t usual = usual_interval_ns();
    return difference(step, usual) > *most &&
           difference(usual, difference(ahead.front(), given)) > *most;
  }

  /// What clocks that were set add up to may be none: sums of it with others would overflow.
  [[nodiscard]] bool is_no_time(std::int64_t given) const {
    const std::int64_t at = sum(given, offset_ns_);
    return at != sane_time(at);
  }

  /// No message overtakes the fastest one by much: its stamp is of another clock.
  [[nodiscard]] bool is_ahead(const ScanItem& item) const {
    if (!least_late_ns_ || item.logged_ns == 0) return false;
    const std::int64_t late = difference(item.logged_ns, sum(item.scan->stamp_ns, offset_ns_));
    return late < difference(*least_late_ns_, times(kWild, usual_interval_ns()));
  }

  /// Since the last scan: one, or by when messages were received as many as were lost, too.
  [[nodiscard]] std::int64_t intervals_since_last(const ScanItem& item) const {
    if (item.logged_ns == 0 || last_logged_ns_ == 0) return 1;
    constexpr std::int64_t kMost = 1000;
    const double intervals = static_cast<double>(difference(item.logged_ns, last_logged_ns_)) /
                             static_cast<double>(usual_interval_ns());
    return std::clamp<std::int64_t>(std::llround(std::clamp(intervals, 0.0, 1e6)), 1, kMost);
  }

  /// The clock is what it was at this stamp.
  void confirm(std::int64_t given) {
    confirmed_ns_ = sum(given, offset_ns_);
    since_confirmed_ = 0;
  }

  /// Whether a stamp that cannot follow the last one follows those before it, and the last one was
  /// not so wrong that its time is not to be made up for.
  [[nodiscard]] bool last_came_late(const Scan& scan) const {
    const std::int64_t at = sum(scan.stamp_ns, offset_ns_);
    if (!confirmed_ns_ || since_confirmed_ > kWild) return false;
    if (at > *last_ && !is_too_soon(scan)) return false;
    const std::int64_t usual = usual_interval_ns();
    if (difference(*last_, at) > times(kMadeUpFor, usual)) return false;
    return times(2, distance(difference(at, *confirmed_ns_), times(since_confirmed_, usual))) <=
           usual;
  }

  /// Whether a stamp goes on from those before, if need be by a clock that was set.
  bool fits_at_once(const ScanItem& item) {
    const std::int64_t given = item.scan->stamp_ns;
    if (sum(given, offset_ns_) <= *last_ || is_ahead(item) || is_too_soon(*item.scan)) {
      const std::int64_t step = difference(given, given_ns_);
      steady_ = step > 0 && step <= times(kWild, usual_interval_ns()) ? steady_ + 1 : 1;
      if (steady_ < kSteady) {
        if (given == given_ns_) {
          note_once(stands_noted_, stands_text(item.name));
        } else {
          note_wild(given, item.name);
        }
        return false;
      }
      set_clock(given, item.name, intervals_since_last(item));
    }
    steady_ = 0;
    return true;
  }

  void note_lateness(const ScanItem& item) {
    if (item.logged_ns == 0) return;
    const std::int64_t late = difference(item.logged_ns, item.scan->stamp_ns);
    least_late_ns_ = least_late_ns_ ? std::min(*least_late_ns_, late) : late;
  }

  /// The clock goes on where it was, from this scan on.
  void set_clock(std::int64_t given, const std::string& name, std::int64_t intervals) {
    const std::int64_t back = difference(*last_, sum(given, offset_ns_));
    offset_ns_ = difference(sum(*last_, times(intervals, usual_interval_ns())), given);
    if (back < 0) {
      note_once(ahead_noted_, "stamps: the clock jumps ahead by " +
                                  format_seconds(difference(0, back)) + " s at " + name +
                                  "; it goes on where it was");
    } else if (given == given_ns_) {
      note_once(stands_noted_, stands_text(name));
    } else {
      note_once(set_back_noted_, "stamps: the clock goes back by " + format_seconds(back) +
                                     " s at " + name + "; it goes on where it was");
    }
  }

  static std::string stands_text(const std::string& name) {
    return "stamps: they stand still at " + name + "; the usual interval is taken instead";
  }

  void note_wild(std::int64_t given, const std::string& name) {
    note_once(wild_noted_, "stamps: that of " + name + ", " + format_seconds(given) + " s, " +
                               (at_once_ ? "does not fit those before" : "fits neither side") +
                               "; such are put where they belong");
  }

  void note_once(bool& noted, std::string text) {
    if (!noted) note(std::move(text));
    noted = true;
  }

  std::int64_t known_interval_ns_;
  bool at_once_;
  std::deque<std::int64_t> intervals_;
  std::optional<std::int64_t> last_;  // as given out
  std::int64_t given_ns_ = 0;         // the same scan's, as read
  std::vector<Eigen::Vector3f> last_points_;
  SweepSpan last_sweep_;
  bool last_is_part_ = false;  // of a revolution, which the next one follows early
  std::int64_t last_step_ns_ = 0;
  std::int64_t offset_ns_ = 0;
  std::int64_t last_logged_ns_ = 0;
  std::optional<std::int64_t> confirmed_ns_;  // that followed the one before as they usually do
  std::int64_t since_confirmed_ = 0;          // scans
  std::size_t steady_ = 0;  // stamps in a row that fit each other, but not those before
  std::optional<std::int64_t> least_late_ns_;  // of receipts after stamps
  bool gap_noted_ = false, wild_noted_ = false, set_back_noted_ = false, ahead_noted_ = false,
       stands_noted_ = false, late_noted_ = false, twice_ = false;
  bool differ_ = false;  // two scans that follow each other do
};

/// Whose scans are read, also where they are passed over: what is between two tells how far apart
/// they belong. Those before the first one tell nothing.
class ReadWhole final : public RecordingFilter {
 public:
  explicit ReadWhole(std::unique_ptr<Recording> recording) : RecordingFilter(std::move(recording)) {
    merge_notes();
  }
  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = recording().next();
    merge_notes();
    begun_ = true;
    return item;
  }
  void skip(std::size_t scans) override {
    if (!begun_) return recording().skip(scans);
    while (scans > 0 && next()) --scans;
  }

 private:
  bool begun_ = false;
};

}  // namespace

std::unique_ptr<Recording> repair_stamps(std::unique_ptr<Recording> recording,
                                         const OpenOptions& options) {
  auto repaired = std::make_unique<RepairedRecording>(
      follow_point_clock(leave_out_repeated(std::move(recording)), options), options);
  return options.repair_at_once ? steady_stamps_at_once(std::move(repaired))
                                : std::make_unique<ReadWhole>(steady_stamps(std::move(repaired)));
}

}  // namespace surefoot::io
