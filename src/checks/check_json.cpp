// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/check_json.hpp"

#include <nlohmann/json.hpp>

#include "io/decimal_time.hpp"

namespace surefoot::checks {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const io::Spread& spread) {
  return {{"min", spread.least}, {"median", spread.median}, {"max", spread.greatest}};
}

Json json_of(const Figures& figures) {
  Json json;
  json["scans"] = figures.scans;
  json["unreadable"] = figures.unreadable;
  // As text: a JSON number is a double, which does not hold an epoch time to the nanosecond.
  json["first_stamp"] = io::format_seconds(figures.first_stamp_ns);
  json["last_stamp"] = io::format_seconds(figures.last_stamp_ns);
  json["rate_hz"] = figures.rate_hz();
  json["interval_s"] = json_of(figures.interval_s);
  json["points_per_scan"] = json_of(figures.points);
  json["returns_per_scan"] = json_of(figures.returns);
  json["nan_share"] = figures.not_finite_share;
  json["zero_share"] = figures.zero_share;
  json["scan_duration_s"] = json_of(figures.duration_s);
  json["first_point_s"] = json_of(figures.first_time_s);
  json["last_point_s"] = json_of(figures.last_time_s);
  json["range_m"] = json_of(figures.range_m);
  json["directions_seen"] = json_of(figures.around);
  json["rings"] = figures.rings;
  json["turned_deg"] = figures.turned_deg;
  return json;
}

Json json_of(const MotionCheck& motion) {
  Json json;
  json["first_scan"] = motion.begin;
  json["scans"] = motion.count;
  json["turned_deg"] = motion.moved ? motion.moved->turned_deg : motion.turned_deg;
  if (motion.moved) {
    json["moved_m"] = motion.moved->way_m;
    json["stood_still"] = motion.moved->stood_still();
  }
  json["decided"] = motion.trials.decided;
  json["preferred"] = name_of(motion.trials.trials[motion.trials.preferred].reading);
  for (const TimeTrial& trial : motion.trials.trials) {
    json["readings"].push_back({{"times", name_of(trial.reading)},
                                {"flags", flags_of(trial.reading)},
                                {"blur_m", trial.middle_blur},
                                {"worse", trial.worse},
                                {"better", trial.better},
                                {"chance", trial.chance},
                                {"not_registered", trial.untrusted}});
  }
  if (!motion.reference.empty()) {
    json["stamps"] = {{"compared_with", motion.reference}, {"pairs", motion.lag.pairs},
                      {"lag_s", motion.lag.lag_s},         {"error_deg", motion.lag.error_deg},
                      {"best_deg", motion.lag.best_deg},   {"chance", motion.lag.chance}};
  }
  return json;
}

Json json_of(const std::vector<io::TopicSurvey>& topics) {
  Json json = Json::array();
  for (const io::TopicSurvey& survey : topics) {
    json.push_back({{"name", survey.topic.name},
                    {"type", survey.topic.type},
                    {"scans", survey.usable},
                    {"rate_hz", survey.rate_hz()},
                    {"frame", survey.frame},
                    {"content", survey.content}});
  }
  return json;
}

/// File names may hold any bytes.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string to_json(const std::vector<io::TopicSurvey>& topics) {
  return text_of({{"topics", json_of(topics)}});
}

std::string to_json(const io::RecordingSummary& summary,
                    const std::vector<io::TopicSurvey>& topics) {
  Json json;
  json["description"] = summary.description;
  json["notes"] = summary.notes;
  json["fields"] = summary.layouts;
  json["scans"] = summary.scans;
  json["unreadable"] = summary.unreadable;
  json["points_per_scan"] = json_of(summary.points);
  // As text: a JSON number is a double, which does not hold an epoch time to the nanosecond.
  json["first_stamp"] = io::format_seconds(summary.first_stamp_ns);
  json["last_stamp"] = io::format_seconds(summary.last_stamp_ns);
  json["rate_hz"] = summary.rate_hz();
  json["interval_s"] = json_of(summary.interval_s);
  json["scan_duration_s"] = json_of(summary.duration_s);
  json["range_m"] = json_of(summary.range_m);
  if (summary.has_intensities) {
    json["intensity"] = json_of(summary.intensity);
  }
  json["rings"] = summary.rings;
  const io::CaptureCounts& counts = summary.capture;
  if (counts.packets > 0) {
    json["packets"] = {{"all", counts.packets},
                       {"data", counts.data_packets},
                       {"position", counts.position_packets},
                       {"truncated", counts.truncated},
                       {"other", counts.other},
                       {"fragments", counts.fragments},
                       {"reordered", counts.reordered},
                       {"lost", counts.lost}};
  }
  if (!topics.empty()) json["topics"] = json_of(topics);
  json["odd"] = Json::array();
  for (const io::Oddity& oddity : summary.oddities) {
    json["odd"].push_back(
        {{"what", oddity.what}, {"scans", oddity.scans}, {"first", oddity.first}});
  }
  return text_of(json);
}

std::string to_json(const RecordingCheck& check) {
  Json json;
  json["description"] = check.description;
  json["fit"] = !check.suffers();
  json["verdict"] = check.verdict();
  json["fields"] = check.layouts;
  json["notes"] = check.notes;
  json["figures"] = json_of(check.figures);
  json["times"] = check.time_sentences;
  json["motion_says"] = check.motion_sentences;
  if (check.motion) json["motion"] = json_of(*check.motion);
  json["findings"] = Json::array();
  for (const Finding& finding : check.findings) {
    json["findings"].push_back({{"suffers", finding.suffers},
                                {"what", finding.what},
                                {"detail", finding.detail},
                                {"scans", finding.scans},
                                {"first", finding.first}});
  }
  return text_of(json);
}

}  // namespace surefoot::checks
