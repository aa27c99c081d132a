// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/motion_sentences.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace surefoot::checks {
namespace {

constexpr double kUnlikely = 0.001;

template <typename... Values>
std::string text(const char* format, Values... values) {
  char buffer[400];
  std::snprintf(buffer, sizeof(buffer), format, values...);
  return buffer;
}

std::string against(const TimeTrial& trial) {
  const std::size_t compared = trial.worse + trial.better;
  if (compared == 0) return text("%s in no scan that can be compared", name_of(trial.reading));
  const bool worse = trial.worse >= trial.better;
  return text("%s %.1f mm (%s in %zu of %zu scans)", name_of(trial.reading),
              1e3 * trial.middle_blur, worse ? "worse" : "better",
              worse ? trial.worse : trial.better, compared);
}

std::string all_trials(const TimeTrials& trials) {
  std::string sentence =
      text("the map is blurred by %.1f mm with the times %s",
           1e3 * trials.trials.front().middle_blur, name_of(trials.trials.front().reading));
  for (std::size_t i = 1; i < trials.trials.size(); ++i) {
    sentence += (i == 1 ? "; " : ", ") + against(trials.trials[i]);
  }
  return sentence;
}

/// Of scans that no map takes there is no blur, and none to compare.
bool nothing_compared(const TimeTrials& trials) {
  return std::all_of(trials.trials.begin(), trials.trials.end(),
                     [](const TimeTrial& trial) { return trial.worse + trial.better == 0; });
}

/// A finding about times that the trials have settled.
void settle_untimed(const TimeTrials& trials, std::vector<Finding>& findings) {
  for (Finding& finding : findings) {
    if (finding.what != "no point times" && finding.what != "point times that are all equal") {
      continue;
    }
    if (!finding.suffers) continue;  // a few scans say nothing of the others
    const TimeReading best = trials.trials[trials.preferred].reading;
    if (trials.preferred > 0) {
      finding.detail =
          std::string("nothing is deskewed, and the motion prefers times by azimuth: ") +
          flags_of(best);
    } else if (trials.decided) {
      finding.suffers = false;
      finding.detail = "and the map is sharpest without: the scans are deskewed already";
    }
  }
}

void add_contradiction(const TimeTrials& trials, const io::OpenOptions& reader,
                       std::vector<Finding>& findings) {
  const TimeTrial& best = trials.trials[trials.preferred];
  if (best.reading != TimeReading::backward && best.reading != TimeReading::none) return;
  const bool turned = reader.time_direction == io::TimeDirection::backward;
  const bool again = turned && best.reading == TimeReading::backward;
  const double ratio = trials.trials.front().middle_blur / std::max(best.middle_blur, 1e-9);
  findings.push_back({true, "point times that the motion contradicts",
                      text("read as %s the map is %.2f times as sharp, in %zu of %zu scans: %s",
                           name_of(best.reading), ratio, best.better, best.better + best.worse,
                           again ? "--point-times forward" : flags_of(best.reading)),
                      0, ""});
}

void add_untrusted(const MotionCheck& motion, std::vector<Finding>& findings) {
  const TimeTrial& best = motion.trials.trials[motion.trials.preferred];
  if (best.untrusted == 0) return;
  constexpr double kMostUntrusted = 0.1;
  const double share = static_cast<double>(best.untrusted) / static_cast<double>(motion.count);
  findings.push_back(
      {share > kMostUntrusted, "scans that do not fit those before",
       text("%zu of the %zu that were tried were not registered: ", best.untrusted, motion.count) +
           "are they in the order in which they were recorded?",
       0, ""});
}

/// The flag that mends stamps that are so late; empty where none does.
std::string stamp_flag(double lag_s, const io::OpenOptions& reader, const Figures& figures) {
  const double sweep = figures.duration_s.median;
  const bool follows = figures.first_time_s.median > -0.5 * sweep;
  if (lag_s < 0.0 && follows && reader.stamp_at != io::StampAt::end) return ": --stamp-at end";
  if (lag_s > 0.0 && reader.stamp_at == io::StampAt::end) return ": --stamp-at start";
  return {};
}

void add_lag(const MotionCheck& motion, const io::OpenOptions& reader, const Figures& figures,
             std::vector<Finding>& findings, std::vector<std::string>& sentences) {
  const StampLag& lag = motion.lag;
  if (motion.reference.empty()) return;
  if (lag.pairs < 10) {
    sentences.push_back("stamps: " + motion.reference + " does not cover the stretch");
    return;
  }
  const std::size_t differ = lag.better + lag.worse;
  sentences.push_back(
      differ == 0
          ? text("stamps: turns from scan to scan fit those of %s best as they are (%.3f deg RMS)",
                 motion.reference.c_str(), lag.error_deg)
          : text("stamps: turns from scan to scan fit those of %s best moved by %+.3f s (%.3f deg "
                 "RMS, as they are %.3f deg, better in %zu of %zu)",
                 motion.reference.c_str(), lag.lag_s, lag.best_deg, lag.error_deg, lag.better,
                 differ));
  const double sweep =
      figures.duration_s.median > 0.0 ? figures.duration_s.median : figures.usual_interval_s;
  // Nearer to another end of the sweep than to the one that was taken.
  if (lag.chance >= kUnlikely || std::abs(lag.lag_s) < 0.5 * sweep) return;
  findings.push_back(
      {false, lag.lag_s < 0.0 ? "stamps that name the end of the sweep" : "stamps that come early",
       text("by %s they are %.3f s %s; the shape of a run is the same, its stamps are not%s",
            motion.reference.c_str(), std::abs(lag.lag_s), lag.lag_s < 0.0 ? "late" : "early",
            stamp_flag(lag.lag_s, reader, figures).c_str()),
       0, ""});
}

/// Which stretch it is, and how the sensor moved on it.
std::string stretch_sentence(const MotionCheck& motion) {
  const std::string scans = text("scans %zu to %zu", motion.begin, motion.begin + motion.count - 1);
  const std::optional<StretchMotion>& moved = motion.moved;
  if (!moved) {
    return scans + text(", where it turns most (about %.0f deg in all)", motion.turned_deg);
  }
  if (moved->stood_still()) return scans + ": the sensor stood still";
  if (moved->on_the_spot() && moved->turned_deg > 0.0) {
    return scans + text(", where it turns most: turned by %.0f deg on the spot", moved->turned_deg);
  }
  return scans +
         text(", where it turns most: %.1f m, turned by %.0f deg", moved->way_m, moved->turned_deg);
}

}  // namespace

std::vector<std::string> time_sentences(const Figures& figures) {
  const double first = figures.first_time_s.median, last = figures.last_time_s.median;
  if (last <= first) return {};
  const double sweep = last - first;
  const char* place = first > -0.25 * sweep ? "follows its stamp"
                      : last < 0.25 * sweep ? "ends with its stamp"
                                            : "lies about its stamp";
  std::string sentence = text("a sweep %s: points from %+.4f to %+.4f s", place, first, last);
  if (figures.usual_interval_s > 0.0) {
    sentence += text(", %.0f %% of the time to the next", 100.0 * sweep / figures.usual_interval_s);
  }
  return {sentence};
}

void conclude(const MotionCheck& motion, const io::OpenOptions& reader, const Figures& figures,
              std::vector<Finding>& findings, std::vector<std::string>& sentences) {
  const TimeTrials& trials = motion.trials;
  sentences.push_back(stretch_sentence(motion));
  if (motion.moved && motion.moved->stood_still()) {
    sentences.emplace_back("who stands still tells nothing of times: neither points' nor stamps'");
  } else if (trials.trials.size() > 1 && !nothing_compared(trials)) {
    sentences.push_back(all_trials(trials));
    sentences.push_back(trials.decided
                            ? std::string("the data prefer them ") +
                                  name_of(trials.trials[trials.preferred].reading)
                            : std::string("the motion does not tell which is right: too little of "
                                          "it, or too few scans"));
  } else if (trials.trials.size() > 1) {
    sentences.emplace_back("the motion tells nothing of times: no scan could be compared");
  }
  settle_untimed(trials, findings);
  add_contradiction(trials, reader, findings);
  add_untrusted(motion, findings);
  add_lag(motion, reader, figures, findings, sentences);
}

}  // namespace surefoot::checks
