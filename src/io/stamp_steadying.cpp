// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "io/stamp_steadying.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "io/recording_filter.hpp"
#include "io/saturated.hpp"
#include "io/steady_line.hpp"

namespace surefoot::io {
namespace {

constexpr std::size_t kReadAhead = 30;  // scans that tell
// Without a look ahead a stamp comes nearer to the line by so much at a time,
constexpr double kNearer = 0.1;  // sweeps
// and so many scans in a row tell that sweeps were counted wrongly.
constexpr std::size_t kAgreeAtOnce = 3;

class SteadiedRecording final : public RecordingFilter {
 public:
  explicit SteadiedRecording(std::unique_ptr<Recording> recording)
      : RecordingFilter(std::move(recording)) {
    merge_notes();
  }

  std::optional<ScanItem> next() override {
    if (!asked_) ask();
    if (row_) read_ahead(kReadAhead);
    if (waiting().empty()) {
      std::optional<ScanItem> item = recording().next();
      merge_notes();
      return item;
    }
    if (row_ && waiting().front().scan) place_front();
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
    if (!JitterEvidence(beginnings_ahead()).any()) return;
    read_ahead(kReadAhead);
    const JitterEvidence evidence(beginnings_ahead());
    if (evidence.is_clear()) row_.emplace(evidence.usual_ns());
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
    row_->fit();
    Scan& scan = *waiting().front().scan;
    const std::int64_t begins = row_->begun_ns(placed_.front());
    scan.stamp_ns = sum(scan.stamp_ns, difference(begins, ahead.front().at_ns));
    if (given_) scan.stamp_ns = std::max(scan.stamp_ns, sum(*given_, 1));
    given_ = scan.stamp_ns;
    placed_.pop_front();
    if (!std::exchange(noted_, true)) note(steadied_text(*row_));
  }

  /// The next place in the row of sweeps: a sweep later, or several where scans are missing. False
  /// where a row has ended, and those in front are to go first.
  bool place(const std::vector<Beginning>& ahead, std::size_t i) {
    const double turned = row_->turned_until(std::span(ahead).subspan(i));
    if (row_->goes_on(turned)) {
      row_->go_on(ahead[i], turned);
    } else {
      if (!placed_.empty()) return false;
      row_->begin(ahead[i]);
    }
    placed_.push_back(row_->turned());
    return true;
  }

  bool asked_ = false, noted_ = false;
  std::optional<SteadyRow> row_;  ///< where stamps are steadied
  std::deque<double> placed_;     ///< where those that wait stand in it [ns]
  std::optional<std::int64_t> given_;
};

/// The same without a look at the next scans. What is not known yet makes stamps drift for a while
/// instead of leaping: they come nearer to the line by a part of a sweep at a time.
class SteadiedAtOnce final : public RecordingFilter {
 public:
  explicit SteadiedAtOnce(std::unique_ptr<Recording> recording)
      : RecordingFilter(std::move(recording)) {
    merge_notes();
  }

  std::optional<ScanItem> next() override {
    std::optional<ScanItem> item = recording().next();
    merge_notes();
    if (item && item->scan) steady(*item->scan, beginning_of(*item));
    return item;
  }

  void skip(std::size_t scans) override {  // each tells something
    while (scans-- > 0 && next()) {
    }
  }

 private:
  void steady(Scan& scan, const Beginning& given) {
    double last_turned = 0.0;
    if (row_) {
      begun_ns_ = place(given);
    } else if (is_clear_with(given)) {
      for (std::size_t i = 0; i < recent_.size(); ++i) last_turned = add_recent(i);
      row_->fit();
      note(steadied_text(*row_));
      begun_ns_ = step_on(last_turned);
    } else {
      begun_ns_ = given.at_ns;
    }
    scan.stamp_ns = sum(scan.stamp_ns, difference(begun_ns_, given.at_ns));
    if (last_stamp_ns_) scan.stamp_ns = std::max(scan.stamp_ns, sum(*last_stamp_ns_, 1));
    last_stamp_ns_ = scan.stamp_ns;
  }

  /// Whether the last scans leave no doubt.
  bool is_clear_with(const Beginning& given) {
    recent_.push_back(given);
    if (recent_.size() > kReadAhead) recent_.erase(recent_.begin());
    const JitterEvidence evidence(recent_);
    if (recent_.size() < kReadAhead || !evidence.is_clear()) return false;
    row_.emplace(evidence.usual_ns());
    return true;
  }

  /// Of the scans that made it clear, each with those behind it: what turned before it.
  double add_recent(std::size_t i) {
    const double turned = row_->turned_until(std::span(recent_).subspan(i));
    row_->goes_on(turned) ? row_->go_on(recent_[i], turned) : row_->begin(recent_[i]);
    return turned;
  }

  /// When the scan began.
  std::int64_t place(const Beginning& given) {
    const bool counts = row_->counts_sweeps(given);
    const double turned = row_->turned_until(std::span(&given, 1));
    if (!row_->goes_on(turned)) {
      row_->begin(given);
      off_.clear();
      return given.at_ns;
    }
    const double sweeps = counts ? miscounted(given, turned) : 0.0;
    row_->go_on(given, turned + sweeps * row_->usual_ns());
    row_->fit();
    return step_on(turned + std::max(0.0, sweeps) * row_->usual_ns());
  }

  /// Sweeps that were counted too few, or less than none: some scans in a row are as far off. One
  /// may have come late.
  double miscounted(const Beginning& given, double turned) {
    const std::int64_t expected = row_->begun_ns(row_->turned() + turned);
    off_.push_back(real(difference(given.at_ns, expected)) / row_->usual_ns());
    if (off_.size() < kAgreeAtOnce) return 0.0;
    const auto [least, most] = std::minmax_element(off_.begin(), off_.end());
    const double sweeps = std::round(*least > 0.0 ? *least : std::min(0.0, *most));
    off_.pop_front();
    for (double& off : off_) off -= sweeps;
    return sweeps;
  }

  /// So much after the one before, as that was given out, and some way to the line.
  [[nodiscard]] std::int64_t step_on(double turned) const {
    const std::int64_t expected = sum(begun_ns_, std::llround(turned));
    const std::int64_t wanted = row_->begun_ns(row_->turned());
    const auto most = std::llround(kNearer * row_->usual_ns());
    return sum(expected, std::clamp<std::int64_t>(difference(wanted, expected), -most, most));
  }

  std::vector<Beginning> recent_;  ///< until it is clear
  std::optional<SteadyRow> row_;   ///< from then on
  std::int64_t begun_ns_ = 0;      ///< when the last scan began, as it was given out
  std::deque<double> off_;         ///< the line: the last ones, as they were given [sweeps]
  std::optional<std::int64_t> last_stamp_ns_;
};

}  // namespace

std::unique_ptr<Recording> steady_stamps(std::unique_ptr<Recording> recording) {
  return std::make_unique<SteadiedRecording>(std::move(recording));
}

std::unique_ptr<Recording> steady_stamps_at_once(std::unique_ptr<Recording> recording) {
  return std::make_unique<SteadiedAtOnce>(std::move(recording));
}

}  // namespace surefoot::io
