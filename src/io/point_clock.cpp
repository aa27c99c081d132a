// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/point_clock.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "io/decimal_time.hpp"
#include "io/recording_filter.hpp"
#include "io/saturated.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::io {

namespace {

/// The last few of something, and their median.
class LastOnes {
 public:
  void add(std::int64_t value) {
    constexpr std::size_t kKept = 15;
    values_.push_back(value);
    if (values_.size() > kKept) values_.pop_front();
  }
  void clear() { values_.clear(); }
  [[nodiscard]] std::int64_t usual(std::int64_t otherwise) const {
    if (values_.empty()) return otherwise;
    return quantile(std::vector(values_.begin(), values_.end()), 0.5);
  }

 private:
  std::deque<std::int64_t> values_;
};

/// How a scan's stamp, and the instant that its times count from, lie to its first point.
struct Lead {
  std::int64_t of_stamp = 0, of_origin = 0;
};
Lead lead_of(const ScanItem& item) {
  return {difference(item.scan->stamp_ns, item.clock->first_ns),
          difference(item.clock->origin_ns, item.clock->first_ns)};
}

class ClockedRecording final : public RecordingFilter {
 public:
  ClockedRecording(std::unique_ptr<Recording> recording, const OpenOptions& options)
      : RecordingFilter(std::move(recording)),
        known_interval_ns_(options.rate_hz > 0.0 ? std::llround(1e9 / options.rate_hz) : 0),
        at_once_(options.repair_at_once) {
    merge_notes();
  }

  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = take();
    if (item && item->scan && item->clock) follow(*item);
    merge_notes();
    return item;
  }

 private:
  [[nodiscard]] std::optional<ScanItem> take() {
    if (waiting().empty()) return recording().next();
    ScanItem item = std::move(waiting().front());
    waiting().pop_front();
    return item;
  }

  [[nodiscard]] std::int64_t usual_interval_ns() const {
    constexpr std::int64_t kUnknown = 100'000'000;
    return known_interval_ns_ > 0 ? known_interval_ns_ : intervals_.usual(kUnknown);
  }
  [[nodiscard]] bool agree(std::int64_t a, std::int64_t b) const {
    return distance(a, b) <= usual_interval_ns() / 2;
  }

  void follow(ScanItem& item) {
    const std::int64_t given = item.scan->stamp_ns;
    if (!started_) {
      begin(item);
    } else if (!agree(lead_of(item).of_stamp, stamps_.usual(0))) {
      settle(item);
    }
    keep(item);
    given_ns_ = given;
  }

  /// The first one has no other before it: the next two tell how stamps lie to points.
  void begin(ScanItem& item) {
    started_ = true;
    Lead usual = lead_of(item);
    const std::vector<Lead> ahead = at_once_ ? std::vector<Lead>{} : leads_ahead();
    if (ahead.size() == 2 && !agree(usual.of_stamp, ahead[0].of_stamp) &&
        !agree(usual.of_stamp, ahead[1].of_stamp)) {
      constexpr std::int64_t kEpochLeast = 1'000'000'000'000'000'000;  // September 2001
      if (agree(ahead[0].of_stamp, ahead[1].of_stamp)) {
        usual = ahead[0];
      } else if (item.clock->first_ns >= kEpochLeast) {
        usual.of_stamp = usual.of_origin;  // stamps are no clock, the points' is one
      }
    }
    stamps_.add(usual.of_stamp);
    origins_.add(usual.of_origin);
    if (!agree(lead_of(item).of_stamp, usual.of_stamp)) take_from_points(item);
  }

  [[nodiscard]] std::vector<Lead> leads_ahead() {
    constexpr std::size_t kAhead = 2;
    std::vector<Lead> leads;
    while (leads.size() < kAhead) {
      std::optional<ScanItem> item = recording().next();
      if (!item) break;
      if (item->scan && item->clock) leads.push_back(lead_of(*item));
      const bool other = item->scan && !item->clock;
      waiting().push_back(std::move(*item));
      if (other) break;
    }
    return leads;
  }

  /// Stamp and points have not gone on by as much: one of them has jumped, or stands.
  void settle(ScanItem& item) {
    const std::int64_t told = difference(item.scan->stamp_ns, last_ns_);
    const std::int64_t ran = difference(item.clock->first_ns, last_first_ns_);
    const std::int64_t usual = usual_interval_ns();
    const bool both_received = item.logged_ns != 0 && last_logged_ns_ != 0;
    const std::int64_t received = both_received ? difference(item.logged_ns, last_logged_ns_) : 0;
    // Several may have been received at once.
    const std::int64_t expected = received > usual / 2 ? received : usual;
    const bool points_go_on =
        ran > 0 && (told <= 0 || distance(ran, expected) <= distance(told, expected));
    if (points_go_on) {
      take_from_points(item);
      return;
    }
    stamps_.clear();
    stamps_.add(lead_of(item).of_stamp);
    note_once(set_noted_, "point times: their clock is set at " + item.name +
                              "; the stamps go on, and are believed");
  }

  void take_from_points(ScanItem& item) {
    const std::int64_t given = item.scan->stamp_ns;
    item.scan->stamp_ns = sum(item.clock->first_ns, stamps_.usual(0));
    if (any_ && given == given_ns_) {
      note_once(stands_noted_, "stamps: they stand still at " + item.name +
                                   "; they are taken from the points' times instead");
    } else {
      note_once(taken_noted_,
                "stamps: that of " + item.name + ", " + format_seconds(given) +
                    " s, does not go with its points' times; such are taken from these");
    }
  }

  /// Times count from where they usually do, so that stamp and times add up as before.
  void keep(ScanItem& item) {
    Scan& scan = *item.scan;
    const std::int64_t usual = origins_.usual(0);
    const std::int64_t off = difference(lead_of(item).of_origin, usual);
    // A distance of more is none that times of 32 bits were counted over.
    constexpr std::int64_t kMost = 5'000'000'000;
    if (agree(off, 0)) {
      origins_.add(lead_of(item).of_origin);
      if (agree(lead_of(item).of_stamp, stamps_.usual(0))) stamps_.add(lead_of(item).of_stamp);
    } else if (distance(off, 0) <= kMost) {
      for (std::int32_t& time : scan.times_ns) {
        time = static_cast<std::int32_t>(
            std::clamp<std::int64_t>(time + off, std::numeric_limits<std::int32_t>::min(),
                                     std::numeric_limits<std::int32_t>::max()));
      }
      item.clock->origin_ns = difference(item.clock->origin_ns, off);
    }
    if (any_) {
      const std::int64_t step = difference(scan.stamp_ns, last_ns_);
      constexpr std::int64_t kLongest = 10'000'000'000;  // [ns] of a LiDAR
      if (step > 0 && step <= kLongest) intervals_.add(step);
    }
    any_ = true;
    last_ns_ = scan.stamp_ns;
    last_first_ns_ = item.clock->first_ns;
    last_logged_ns_ = item.logged_ns;
  }

  void note_once(bool& noted, std::string text) {
    if (!noted) note(std::move(text));
    noted = true;
  }

  std::int64_t known_interval_ns_;
  bool at_once_;
  LastOnes intervals_, stamps_, origins_;  // leads of the stamps and of what times count from
  bool started_ = false, any_ = false;
  std::int64_t last_ns_ = 0;        // stamp, as given out
  std::int64_t given_ns_ = 0;       // the same scan's, as read
  std::int64_t last_first_ns_ = 0;  // its first point, by the points' clock
  std::int64_t last_logged_ns_ = 0;
  bool stands_noted_ = false, taken_noted_ = false, set_noted_ = false;
};

}  // namespace

std::unique_ptr<Recording> follow_point_clock(std::unique_ptr<Recording> recording,
                                              const OpenOptions& options) {
  return std::make_unique<ClockedRecording>(std::move(recording), options);
}

}  // namespace surefoot::io
