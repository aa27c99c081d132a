// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/findings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "surefoot/config.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::checks {
namespace {

using io::PointTimes;

// A scan is missing where an interval is half as long again as usual.
constexpr double kGap = 1.5;
// Sweeps that last so much longer than it is to the next one lie over each other.
constexpr double kOverlap = 1.25;
// Intervals that differ from the usual one by less than this share of it are regular.
constexpr double kRegular = 0.1;
// Sweeps of so small a share of the interval leave room for others.
constexpr double kPartOfInterval = 0.75;
// Sweeps may lie over each other by this share of one: a packet, or a rounding.
constexpr double kBefore = 0.05;
// A scan with less than this share of the usual returns, or directions, is part of one.
constexpr double kPart = 0.5;
// What more than every tenth scan (or packet, or point) has is the recording's way, not a mishap.
constexpr double kHabit = 0.1;
constexpr double kMost = 0.5;
constexpr double kSlowest = 5.0;  // [Hz] rates of LiDARs that spin are 5 to 20

std::string text(const char* format, double a, double b = 0.0) {
  char buffer[200];
  std::snprintf(buffer, sizeof(buffer), format, a, b);
  return buffer;
}

double real(std::size_t value) { return static_cast<double>(value); }

/// Collects what several scans have in common.
class Findings {
 public:
  void scan(const std::string& what, const std::string& name) {
    Finding& finding = at(what);
    if (finding.scans++ == 0) finding.first = name;
  }
  void recording(bool suffers, const std::string& what, const std::string& detail) {
    Finding& finding = at(what);
    finding.suffers = suffers;
    finding.detail = detail;
  }
  /// Settles what is known once all scans were seen; nothing where none has it.
  template <typename Judge>
  void judge(const std::string& what, Judge&& judge) {
    for (Finding& finding : list_) {
      if (finding.what == what) judge(finding);
    }
  }
  [[nodiscard]] std::vector<Finding> take() {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const Finding& a, const Finding& b) { return a.suffers > b.suffers; });
    return std::move(list_);
  }

 private:
  Finding& at(const std::string& what) {
    for (Finding& finding : list_) {
      if (finding.what == what) return finding;
    }
    list_.push_back({});
    list_.back().what = what;
    return list_.back();
  }
  std::vector<Finding> list_;
};

class Inspection {
 public:
  Inspection(const std::vector<ScanFacts>& scans, const Figures& figures)
      : scans_(scans), figures_(figures) {}

  std::vector<Finding> execute(const io::CaptureCounts& counts,
                               const std::vector<std::string>& losses) {
    look_at_pace();
    for (std::size_t i = 0; i < scans_.size(); ++i) {
      if (!scans_[i].error.empty()) {
        found_.scan("scans that cannot be read", scans_[i].error);
        continue;
      }
      look_at_stamp(scans_[i]);
      look_at_points(scans_[i], i + 1 == scans_.size());
      look_at_times(scans_[i]);
    }
    by_points_ = std::all_of(scans_.begin(), scans_.end(), [](const ScanFacts& scan) {
      return !scan.error.empty() || scan.clock;
    });
    judge_stamps();
    judge_points();
    judge_times();
    judge_recording(counts);
    judge_losses(losses);
    return found_.take();
  }

 private:
  [[nodiscard]] double share(const Finding& finding) const {
    return real(finding.scans) / std::max(1.0, real(figures_.scans));
  }

  /// A run's interval between two scans, as it mends their stamps.
  static double step_between(const ScanFacts& last, const ScanFacts& scan) {
    const double stored = seconds(scan.stamp_ns - last.stamp_ns);
    const double mended =
        seconds(scan.mended_ns.value_or(scan.stamp_ns) - last.mended_ns.value_or(last.stamp_ns));
    // What goes back, or stands, is told as it is stored; a gap is one for a run.
    return stored > 0.0 && mended > 0.0 ? mended : stored;
  }
  static double shift_of(const ScanFacts& scan) {
    return seconds(scan.mended_ns.value_or(scan.stamp_ns) - scan.stamp_ns);
  }

  /// How often the LiDAR measures, which its sweeps tell where scans are missing all along; and
  /// whether stamps are mended all along.
  void look_at_pace() {
    const double usual = figures_.usual_interval_s, sweep = figures_.duration_s.median;
    pace_s_ = usual;
    double close = 0.0, regular = 0.0, shifted = 0.0;
    const ScanFacts* last = nullptr;
    for (const ScanFacts& scan : scans_) {
      if (!scan.error.empty()) continue;
      if (last != nullptr) {
        const double step = step_between(*last, scan);
        close += std::abs(step - sweep) < (1.0 - kPartOfInterval) * sweep ? 1.0 : 0.0;
        regular += std::abs(step - usual) < kRegular * usual ? 1.0 : 0.0;
        const double shift = std::abs(shift_of(scan));
        const bool moves = std::abs(shift - std::abs(shift_of(*last))) > 0.0;
        shifted += moves && shift < usual ? 1.0 : 0.0;
      }
      last = &scan;
    }
    come_and_go_ = shifted > kMost * real(figures_.scans);
    if (!(sweep > 0.0) || sweep >= kPartOfInterval * usual) return;
    const bool some_follow = close > kHabit * real(figures_.scans);
    if (!some_follow && figures_.around.median < kLooksAround) return;
    if (regular > (1.0 - kHabit) * real(figures_.scans)) {
      found_.recording(false, "sweeps with pauses between them",
                       text("they last %.3f s, scans are %.3f s apart: the others are missing, or "
                            "were left out",
                            sweep, usual));
    } else {
      pace_s_ = sweep;
    }
  }

  void look_at_stamp(const ScanFacts& scan) {
    if (last_ != nullptr) {
      const double step = step_between(*last_, scan);
      if (step < 0.0) found_.scan("stamps that go back", scan.name);
      if (step == 0.0) found_.scan("stamps that are the last one's again", scan.name);
      if (pace_s_ > 0.0 && step > kGap * pace_s_) {
        found_.scan("gaps", scan.name);
        longest_gap_ = std::max(longest_gap_, step);
        missing_ += step / pace_s_ - 1.0;
      }
      if (lies_over_last(scan, step)) {
        found_.scan("sweeps that begin before the last one has ended", scan.name);
      }
    }
    const double shift = shift_of(scan), last_shift = last_ != nullptr ? shift_of(*last_) : 0.0;
    const bool goes_on = last_ == nullptr || seconds(scan.stamp_ns - last_->stamp_ns) > 0.0;
    if (come_and_go_) {
      if (shift != 0.0) found_.scan("stamps that come and go", scan.name);
      greatest_shift_ = std::max(greatest_shift_, std::abs(shift));
    } else if (shift < 0.0) {
      found_.scan("stamps that are too late", scan.name);
    } else if (shift > 0.0 && goes_on && shift - last_shift > kBefore * pace_s_) {
      found_.scan("stamps that are too early", scan.name);
    }
    if (scan.sent_again) found_.scan("scans that are sent again", scan.name);
    last_ = &scan;
  }

  [[nodiscard]] bool lies_over_last(const ScanFacts& scan, double step) const {
    if (scan.times != PointTimes::there || last_->times != PointTimes::there) return false;
    const double sweep = figures_.duration_s.median;
    if (come_and_go_ || sweep > kOverlap * figures_.usual_interval_s) return false;  // is said
    return step > 0.0 && last_->last_s - (step + scan.first_s) > kBefore * sweep;
  }

  void look_at_points(const ScanFacts& scan, bool is_last) {
    const double usual = figures_.returns.median;
    if (scan.returns < static_cast<std::size_t>(config_.preprocess.min_points)) {
      found_.scan("scans with hardly a return", scan.name);
    } else if (!scan.remark.empty()) {
      const bool at_the_end = is_last || &scan == &scans_.front();
      found_.scan(at_the_end ? "first and last scan in part" : "scans in part", scan.name);
    } else if (real(scan.returns) < kPart * usual ||
               scan.seen_around < kPart * figures_.around.median) {
      found_.scan("scans with less than half of the usual points or directions", scan.name);
    }
    if (scan.at_one_height) found_.scan("points at one height", scan.name);
    if (scan.not_finite > 0) found_.scan("points that are NaN or infinite", scan.name);
    if (scan.zero > 0) found_.scan("points that are zero", scan.name);
    if (scan.untimed > 0) {
      found_.scan("points without a usable time", scan.name);
      untimed_ += scan.untimed;
    }
    const std::size_t usual_rings = figures_.rings.size();
    if (usual_rings > 1 && 2 * scan.rings.size() < usual_rings) {
      found_.scan("scans with less than half of the rings", scan.name);
    }
  }

  void look_at_times(const ScanFacts& scan) {
    if (scan.returns == 0) return;
    if (scan.times == PointTimes::none) found_.scan("no point times", scan.name);
    if (scan.times == PointTimes::equal) found_.scan("point times that are all equal", scan.name);
    if (scan.times != PointTimes::there) return;
    const double interval = figures_.usual_interval_s;
    // Two scans may both be parts of a sweep: a capture begins and ends within one.
    const bool tells = figures_.scans > 2 && interval > 0.0;
    if (tells && scan.last_s - scan.first_s > kOverlap * interval) {
      found_.scan("sweeps that last longer than it is to the next", scan.name);
    }
    if (scan.spin == io::Spin::counterclockwise) {
      found_.scan("sweeps that run counter-clockwise", scan.name);
    }
  }

  void judge_stamps() {
    const auto mended = [&](const char* what, const char* how) {
      found_.judge(what, [&](Finding& finding) {
        // Points that have a clock of their own leave nothing to be guessed.
        finding.suffers = !by_points_ && share(finding) > kHabit;
        finding.detail = by_points_ ? "a run takes them from the points' times" : how;
      });
    };
    mended("stamps that go back", "a run puts them where they belong");
    mended("stamps that are the last one's again",
           "a run takes the usual interval instead; where most stand still, --rate says it");
    mended("stamps that are too late", "a run puts them where they belong");
    mended("stamps that are too early", "a run puts them where they belong");
    found_.judge("stamps that come and go", [&](Finding& finding) {
      finding.detail = text(
          "by up to %.3f s beside steady sweeps: times of arrival? A run takes a "
          "line through them",
          greatest_shift_);
    });
    found_.judge("sweeps that begin before the last one has ended", [&](Finding& finding) {
      finding.suffers = share(finding) > kHabit;
      finding.detail = "no LiDAR does so: their stamps are wrong, times of arrival perhaps";
    });
    found_.judge("gaps", [&](Finding& finding) {
      const double bridged = config_.motion_prior.max_extrapolation;
      finding.suffers = longest_gap_ > bridged || missing_ > kHabit * real(figures_.scans);
      finding.detail =
          text("the longest %.3f s, about %.0f scans missing in all", longest_gap_, missing_) +
          text("; a run goes on as it moved for %.1f s", bridged);
    });
    found_.judge("scans that are sent again", [&](Finding& finding) {
      finding.suffers = share(finding) > kHabit;
      finding.detail = "as they came before, point by point: a run leaves them out";
    });
    found_.judge("scans that cannot be read", [&](Finding& finding) {
      finding.suffers = true;
      finding.detail = "a run leaves them out";
    });
  }

  void judge_points() {
    found_.judge("scans with hardly a return", [&](Finding& finding) {
      finding.suffers = true;
      finding.detail =
          text("less than %.0f; a run rejects them", double(config_.preprocess.min_points));
    });
    for (const char* what : {"scans in part", "scans with less than half of the rings",
                             "scans with less than half of the usual points or directions"}) {
      found_.judge(what, [&](Finding& finding) {
        finding.suffers = share(finding) > kHabit;
        finding.detail = "messages, packets or returns are missing";
      });
    }
    found_.judge("points at one height", [&](Finding& finding) {
      finding.suffers = share(finding) > kMost;
      finding.detail = "as a LiDAR has them that scans one plane; a run needs one that sees height";
    });
    found_.judge("points that are NaN or infinite", [&](Finding& finding) {
      finding.detail =
          text("%.1f %% of all points; a run passes them over", 100.0 * figures_.not_finite_share);
    });
    found_.judge("points that are zero", [&](Finding& finding) {
      finding.detail = text("%.1f %% of all points: no return; a run passes them over",
                            100.0 * figures_.zero_share);
    });
    found_.judge("points without a usable time", [&](Finding& finding) {
      const double of_all = real(untimed_) / std::max(1.0, real(untimed_) + all_points());
      finding.suffers = of_all > kHabit;
      finding.detail = text("%.2f %% of all points; they are left out", 100.0 * of_all);
    });
    const double nearest = config_.preprocess.min_range;
    if (figures_.scans > 0 && figures_.range_m.median > 0.0 && figures_.range_m.median < nearest) {
      found_.recording(true, "half of the points are nearer than a run uses",
                       text("%.2f m in the middle, preprocess.min_range is %.2f m",
                            figures_.range_m.median, nearest));
    }
  }

  void judge_times() {
    found_.judge("no point times", [&](Finding& finding) { judge_untimed(finding); });
    found_.judge("point times that are all equal", [&](Finding& f) { judge_untimed(f); });
    found_.judge("sweeps that last longer than it is to the next", [&](Finding& finding) {
      finding.suffers = share(finding) > kHabit;
      finding.detail = text(
          "up to %.4f s, the scans are %.4f s apart: is the unit of the point times "
          "wrong (--time-unit), or the rate (--rate)?",
          figures_.duration_s.greatest, figures_.usual_interval_s);
    });
    found_.judge("sweeps that run counter-clockwise", [&](Finding& finding) {
      finding.detail =
          "LiDARs spin clockwise seen from above: it hangs upside down, or its times "
          "are reversed";
    });
  }

  void judge_untimed(Finding& finding) {
    finding.suffers = share(finding) > kHabit;
    finding.detail = finding.suffers
                         ? "nothing can be deskewed; if the LiDAR spins, --derive-times azimuth"
                         : "of a few scans, which are not deskewed";
  }

  void judge_recording(const io::CaptureCounts& counts) {
    const double rate = figures_.rate_hz();
    if (figures_.scans > 1 && rate > 0.0 && rate < kSlowest - 0.5) {
      found_.recording(false, "few scans a second",
                       text("%.2f Hz: between two of them the robot must hardly turn", rate));
    }
    if (figures_.scans == 1) found_.recording(true, "a single scan", "there is no motion to find");
    if (figures_.scans == 0) found_.recording(true, "no scan at all", "");
    if (counts.lost == 0) return;
    const double lost = real(counts.lost) / real(counts.lost + counts.data_packets);
    found_.recording(lost > kHabit, "lost packets",
                     text("%.0f, %.2f %% of all", real(counts.lost), 100.0 * lost));
  }

  void judge_losses(const std::vector<std::string>& losses) {
    if (losses.empty()) return;
    const std::string more =
        losses.size() > 1 ? text(" (and %.0f more notes)", real(losses.size() - 1)) : "";
    found_.recording(true, "parts that are lost or damaged", losses.front() + more);
  }

  [[nodiscard]] double all_points() const {
    double sum = 0.0;
    for (const ScanFacts& scan : scans_) sum += real(scan.points);
    return sum;
  }

  const std::vector<ScanFacts>& scans_;
  const Figures& figures_;
  const Config config_;
  Findings found_;
  const ScanFacts* last_ = nullptr;
  double longest_gap_ = 0.0;
  double missing_ = 0.0;  // scans
  std::size_t untimed_ = 0;
  double pace_s_ = 0.0;  // between sweeps
  bool come_and_go_ = false;
  double greatest_shift_ = 0.0;  // of those stamps [s]
  bool by_points_ = false;       // every scan's points have a clock
};

}  // namespace

std::vector<Finding> findings_of(const std::vector<ScanFacts>& scans, const Figures& figures,
                                 const io::CaptureCounts& counts,
                                 const std::vector<std::string>& losses) {
  return Inspection(scans, figures).execute(counts, losses);
}

}  // namespace surefoot::checks
