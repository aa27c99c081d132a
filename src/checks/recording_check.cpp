// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/recording_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "checks/mended_stamps.hpp"
#include "checks/motion_sentences.hpp"
#include "io/bags/bag_files.hpp"
#include "io/bags/motion_topics.hpp"
#include "io/messages/cloud_message.hpp"
#include "io/trajectory_files.hpp"
#include "runs/length_unit.hpp"
#include "runs/run_truth.hpp"

namespace surefoot::checks {
namespace {

// Fewer scans show no motion.
constexpr std::size_t kLeastScans = 10;
// Of a scan that is tried; the odometry takes some thousands of them.
constexpr std::size_t kMostPoints = 40'000;
constexpr std::int64_t kMarginNs = 1'000'000'000;

Scan thinned(const Scan& scan) {
  const std::size_t step = (scan.points.size() + kMostPoints - 1) / kMostPoints;
  if (step <= 1) return scan;
  Scan thin;
  thin.stamp_ns = scan.stamp_ns;
  for (std::size_t i = 0; i < scan.points.size(); i += step) {
    thin.points.push_back(scan.points[i]);
    if (!scan.times_ns.empty()) thin.times_ns.push_back(scan.times_ns[i]);
    if (!scan.rings.empty()) thin.rings.push_back(scan.rings[i]);
  }
  return thin;
}

class Check {
 public:
  Check(const CheckOptions& options, const CheckListener& listener)
      : options_(options), listener_(listener) {}

  RecordingCheck execute() {
    read_truth();
    look_at_all();
    if (const auto odd = runs::odd_range(result_.figures.range_m.median)) {
      result_.findings.insert(result_.findings.begin(), {true, "odd ranges", *odd, 0, ""});
    }
    result_.time_sentences = time_sentences(result_.figures);
    if (options_.motion && !listener_.interrupted()) {
      if (result_.figures.scans >= kLeastScans) {
        try_motion();
      } else {
        result_.notes.push_back("the motion is not asked, of fewer than " +
                                std::to_string(kLeastScans) + " scans");
      }
    }
    std::stable_sort(result_.findings.begin(), result_.findings.end(),
                     [](const Finding& a, const Finding& b) { return a.suffers > b.suffers; });
    return std::move(result_);
  }

 private:
  // Before the recording, which may be too short to ask it anything.
  void read_truth() {
    if (options_.truth.empty()) return;
    truth_ = is_bag(options_.truth)
                 ? io::read_pose_topic(options_.truth, options_.truth_topic).poses
                 : runs::read_truth_poses(options_.truth);
  }

  void look_at_all() {
    io::OpenOptions reader = options_.reader;
    reader.repair_stamps = false;  // what is odd is told, not mended
    const auto recording = io::open_recording(options_.input, reader);
    ScanLooker looker;
    std::string no_scans;
    while (!listener_.interrupted()) {
      const std::optional<io::ScanItem> item = recording->next();
      if (!item) break;
      result_.scans.push_back(looker.look(*item));
      add_layout(item->layout);
      if (no_scans.empty()) no_scans = io::why_no_scans(recording->topic(), item->frame);
      listener_.progress(result_.scans.size(), recording->progress());
    }
    mend_stamps(result_.scans, options_.reader);
    result_.description = recording->description();
    result_.notes = recording->notes();
    result_.counts = recording->capture_counts();
    result_.figures = figures_of(result_.scans);
    result_.findings =
        findings_of(result_.scans, result_.figures, result_.counts, recording->losses());
    if (!no_scans.empty()) {
      result_.findings.push_back({true, "scans of a map or deskewed", no_scans, 0, ""});
    }
    if (result_.layouts.size() > 1) {
      result_.findings.push_back({false, "fields that differ between scans",
                                  std::to_string(result_.layouts.size()) + " layouts", 0, ""});
    }
  }

  void add_layout(const std::string& layout) {
    auto& all = result_.layouts;
    if (!layout.empty() && std::find(all.begin(), all.end(), layout) == all.end()) {
      all.push_back(layout);
    }
  }

  /// The stretch that turns most.
  void choose_stretch(MotionCheck& motion) const {
    const std::size_t length = std::min(options_.stretch_scans, result_.scans.size());
    double turned = 0.0;
    for (std::size_t i = 0; i < result_.scans.size(); ++i) {
      turned += std::abs(result_.scans[i].turned_deg);
      if (i >= length) turned -= std::abs(result_.scans[i - length].turned_deg);
      if (i + 1 < length || (i + 1 > length && turned <= motion.turned_deg)) continue;
      motion.turned_deg = turned;
      motion.begin = i + 1 - length;
    }
  }

  void try_motion() {
    MotionCheck motion;
    choose_stretch(motion);
    const auto recording = io::open_recording(options_.input, options_.reader);
    recording->skip(motion.begin);
    std::vector<Scan> scans;
    while (scans.size() < options_.stretch_scans && !listener_.interrupted()) {
      const std::optional<io::ScanItem> item = recording->next();
      if (!item) break;
      if (item->scan && item->remark.empty()) scans.push_back(thinned(*item->scan));
    }
    motion.count = scans.size();
    if (scans.size() < kLeastScans || listener_.interrupted()) return;
    listener_.say("trying the point times on scans " + std::to_string(motion.begin) + " to " +
                  std::to_string(motion.begin + scans.size() - 1));
    const auto period = static_cast<std::int64_t>(1e9 * result_.figures.usual_interval_s);
    motion.trials =
        try_times(scans, period, result_.figures.around.median > kLooksAround, options_.threads);
    look_at_motion(motion);
    if (!motion.moved || !motion.moved->stood_still()) find_lag(motion);
    conclude(motion, options_.reader, result_.figures, result_.findings, result_.motion_sentences);
    result_.motion = std::move(motion);
  }

  /// Who stands has no times to be right or wrong: what noise prefers is no preference. That he
  /// stands is told by any reading, since none makes a walk look so.
  static void look_at_motion(MotionCheck& motion) {
    TimeTrials& trials = motion.trials;
    const bool stood =
        std::any_of(trials.trials.begin(), trials.trials.end(), [](const TimeTrial& trial) {
          const auto moved = motion_along(trial.trajectory);
          return moved && 2 * trial.untrusted < trial.blur.size() && moved->stood_still();
        });
    if (stood) {
      trials.preferred = 0;
      trials.decided = false;
      motion.moved = StretchMotion{};
    } else {
      motion.moved = motion_along(trials.trials[trials.preferred].trajectory);
    }
  }

  void find_lag(MotionCheck& motion) {
    const Trajectory& path = motion.trials.trials[motion.trials.preferred].trajectory;
    if (path.size() < kLeastScans) return;
    Trajectory reference;
    if (!options_.truth.empty()) {
      reference = truth_;
      motion.reference = options_.truth.filename().string();
    } else if (is_bag(options_.input)) {
      io::Gyroscope gyroscope = io::read_gyroscope(
          options_.input, path.front().stamp_ns - kMarginNs, path.back().stamp_ns + kMarginNs);
      reference = std::move(gyroscope.turning);
      motion.reference = gyroscope.topic;
    }
    const std::filesystem::path beside = runs::truth_beside(options_.input);
    if (motion.reference.empty() && !beside.empty()) {
      try {
        reference = runs::read_truth_poses(beside);
        motion.reference = runs::kTruthFile;
      } catch (const io::ReadError& error) {
        result_.findings.push_back({false, "a truth that cannot be read", error.what(), 0, ""});
      }
    }
    if (motion.reference.empty()) return;
    constexpr double kSweeps = 1.5;
    const double sweep = result_.figures.duration_s.median > 0.0 ? result_.figures.duration_s.median
                                                                 : result_.figures.usual_interval_s;
    motion.lag = find_stamp_lag(path, reference, kSweeps * sweep);
  }

  static bool is_bag(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(path, ignored)) return io::is_bag_file(path);
    return !io::bag_files(path).empty();
  }

  const CheckOptions& options_;
  const CheckListener& listener_;
  Trajectory truth_;
  RecordingCheck result_;
};

}  // namespace

bool RecordingCheck::suffers() const {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.suffers; });
}

std::string RecordingCheck::verdict() const {
  const auto bad = std::count_if(findings.begin(), findings.end(),
                                 [](const Finding& finding) { return finding.suffers; });
  if (bad == 0) return "fit for a run";
  return "a run would suffer of " + std::to_string(bad) + (bad == 1 ? " thing" : " things");
}

RecordingCheck check_recording(const CheckOptions& options, const CheckListener& listener) {
  return Check(options, listener).execute();
}

}  // namespace surefoot::checks
