// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/report_json.hpp"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <stdexcept>
#include <unordered_map>

#include "report/base64.hpp"
#include "report/map_json.hpp"
#include "surefoot/seconds.hpp"

namespace surefoot::report {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormatVersion = 3;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

void expect_length(const char* what, std::size_t seen, std::size_t expected) {
  if (seen == expected) return;
  throw std::invalid_argument(std::string(what) + ": " + std::to_string(seen) + " values, " +
                              std::to_string(expected) + " expected");
}

Json floats(const std::vector<float>& values) { return base64_of(std::span<const float>(values)); }

Json times(const std::vector<std::int64_t>& stamps_ns, std::int64_t start_ns) {
  std::vector<float> result;
  for (const std::int64_t stamp : stamps_ns) {
    result.push_back(static_cast<float>(seconds(stamp - start_ns)));
  }
  return floats(result);
}

/// Positions [m] and roll, pitch, yaw [deg], three numbers a pose.
struct PoseSeries {
  std::vector<float> positions, angles;

  void add(const std::optional<Pose>& pose) {
    if (!pose) {
      positions.insert(positions.end(), 3, kNone);
      angles.insert(angles.end(), 3, kNone);
      return;
    }
    for (const double coordinate : pose->translation) {
      positions.push_back(static_cast<float>(coordinate));
    }
    for (const double angle : roll_pitch_yaw(pose->rotation)) {
      angles.push_back(static_cast<float>(angle * 180.0 / std::numbers::pi));
    }
  }
  void put_into(Json& json) const {
    json["positions"] = floats(positions);
    json["angles"] = floats(angles);
  }
};

Json truth_json(const Trajectory& truth, std::int64_t start_ns) {
  if (truth.empty()) return nullptr;
  PoseSeries series;
  std::vector<std::int64_t> stamps;
  for (const StampedPose& pose : truth) {
    stamps.push_back(pose.stamp_ns);
    series.add(pose.pose);
  }
  Json json = {{"times", times(stamps, start_ns)}};
  series.put_into(json);
  return json;
}

/// Texts that many scans share: each once, and for every scan the number of its own.
Json shared_texts(const std::vector<std::string>& texts) {
  std::unordered_map<std::string, std::uint32_t> known;
  Json distinct = Json::array();
  std::vector<std::uint32_t> numbers;
  for (const std::string& text : texts) {
    const auto [entry, is_new] = known.emplace(text, static_cast<std::uint32_t>(known.size()));
    if (is_new) distinct.push_back(text);
    numbers.push_back(entry->second);
  }
  return {{"texts", distinct}, {"numbers", base64_of(std::span<const std::uint32_t>(numbers))}};
}

/// The few messages that there are, by the scan's number.
Json messages_json(const std::vector<std::string>& messages) {
  Json json = Json::object();
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (!messages[i].empty()) json[std::to_string(i)] = messages[i];
  }
  return json;
}

Json scans_json(const ScanTable& scans, std::int64_t start_ns) {
  expect_length("statuses", scans.statuses.size(), scans.size());
  expect_length("messages", scans.messages.size(), scans.size());
  expect_length("weak directions", scans.degenerate.size(), scans.size());
  Json json = {{"count", scans.size()},
               {"times", times(scans.stamps_ns, start_ns)},
               {"status", shared_texts(scans.statuses)},
               {"degenerate", shared_texts(scans.degenerate)},
               {"messages", messages_json(scans.messages)},
               {"stages", scans.stages},
               {"columns", Json::object()}};
  for (const ScanColumn& column : scans.columns) {
    expect_length(column.name.c_str(), column.values.size(), scans.size());
    json["columns"][column.name] = floats(column.values);
  }
  return json;
}

Json evaluation_json(const std::optional<RunEvaluation>& evaluation, std::int64_t start_ns) {
  if (!evaluation) return nullptr;
  const ErrorSeries& errors = evaluation->errors;
  return {{"align", evaluation->align},
          {"figures", Json::parse(evaluation->json)},
          {"errors",
           {{"times", times(errors.stamps_ns, start_ns)},
            {"translation_m", floats(errors.translation_m)},
            {"horizontal_m", floats(errors.horizontal_m)},
            {"vertical_m", floats(errors.vertical_m)},
            {"tilt_deg", floats(errors.tilt_deg)},
            {"yaw_deg", floats(errors.yaw_deg)}}}};
}

Json deskewing_json(const DeskewSample& sample) {
  expect_length("a sweep's points as measured", sample.measured.size(), sample.times.size());
  expect_length("a sweep's deskewed points", sample.deskewed.size(), sample.times.size());
  std::vector<std::uint8_t> times;
  for (const float time : sample.times) {
    times.push_back(static_cast<std::uint8_t>(255.0F * std::clamp(time, 0.0F, 1.0F)));
  }
  return {{"scan", sample.scan},
          {"measured", points_json(sample.measured)},
          {"deskewed", points_json(sample.deskewed)},
          {"times", base64_of(std::span<const std::uint8_t>(times))}};
}

Json loops_json(const ReportRun& run) {
  Json json = Json::array();
  for (const ReportLoop& loop : run.loops) {
    json.push_back(
        {{"scan", loop.scan}, {"place", loop.place}, {"verdict", loop.verdict}, {"why", loop.why}});
  }
  return json;
}

/// The poses after all loops; null where no loop moved them.
Json corrected_json(const ReportRun& run) {
  if (run.corrected.empty()) return nullptr;
  expect_length("corrected poses", run.corrected.size(), run.scans.size());
  PoseSeries poses;
  for (const std::optional<Pose>& pose : run.corrected) poses.add(pose);
  Json json = Json::object();
  poses.put_into(json);
  return json;
}

Json run_json(const ReportRun& run, std::int64_t start_ns, std::size_t map_points) {
  expect_length("poses", run.poses.size(), run.scans.size());
  PoseSeries poses;
  for (const std::optional<Pose>& pose : run.poses) poses.add(pose);
  Json json = {{"name", run.name},
               {"recording", run.recording},
               {"facts", run.facts},
               {"notes", run.notes},
               {"parameters", Json::array()},
               {"scans", scans_json(run.scans, start_ns)},
               {"path", Json::object()},
               {"evaluation", evaluation_json(run.evaluation, start_ns)},
               {"map", map_json(run.map, map_points)},
               {"deskewing", Json::array()},
               {"loops", loops_json(run)},
               {"corrected", corrected_json(run)}};
  poses.put_into(json["path"]);
  for (const DeskewSample& sample : run.deskewing) {
    if (!sample.times.empty()) json["deskewing"].push_back(deskewing_json(sample));
  }
  for (const ReportParameter& parameter : run.parameters) {
    json["parameters"].push_back({{"name", parameter.name},
                                  {"value", parameter.value},
                                  {"default", parameter.default_value},
                                  {"unit", parameter.unit},
                                  {"help", parameter.help}});
  }
  return json;
}

Json table_json(const ReportTable& table) {
  Json json = {{"title", table.title}, {"columns", table.columns}, {"rows", Json::array()}};
  for (const std::vector<ReportCell>& row : table.rows) {
    expect_length(table.title.c_str(), row.size(), table.columns.size());
    Json cells = Json::array();
    for (const ReportCell& cell : row) {
      cells.push_back({{"text", cell.text}, {"place", cell.place}});
    }
    json["rows"].push_back(std::move(cells));
  }
  return json;
}

/// The least stamp of any run of the recording: a clock may have been set back.
std::int64_t start_of(const Report& report, std::size_t recording) {
  std::int64_t start = std::numeric_limits<std::int64_t>::max();
  for (const ReportRun& run : report.runs) {
    if (run.recording == recording && run.scans.size() > 0) {
      start = std::min(start, std::ranges::min(run.scans.stamps_ns));
    }
  }
  return start == std::numeric_limits<std::int64_t>::max() ? 0 : start;
}

std::size_t points_a_map(const Report& report) {
  const auto maps = std::count_if(report.runs.begin(), report.runs.end(),
                                  [](const ReportRun& run) { return !run.map.points.empty(); });
  return std::min(kMapPoints, kMostMapPoints / std::max<std::size_t>(maps, 1));
}

/// "<" may begin "</script>" or "<!--"; JSON has another spelling of it for inside of strings,
/// which is the only place where it occurs.
std::string inside_script(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; at += 6) {
    json.replace(at, 1, "\\u003c");
  }
  return json;
}

}  // namespace

std::string to_json(const Report& report, std::size_t map_points) {
  if (map_points == 0) map_points = points_a_map(report);
  std::vector<std::int64_t> starts;
  Json json = {{"format", kFormatVersion}, {"title", report.title},   {"version", report.version},
               {"notes", report.notes},    {"tables", Json::array()}, {"recordings", Json::array()},
               {"runs", Json::array()}};
  for (const ReportTable& table : report.tables) json["tables"].push_back(table_json(table));
  for (std::size_t i = 0; i < report.recordings.size(); ++i) {
    starts.push_back(start_of(report, i));
    const ReportRecording& recording = report.recordings[i];
    const Eigen::Vector3d& origin = recording.origin;
    json["recordings"].push_back({{"name", recording.name},
                                  {"truth", truth_json(recording.truth, starts[i])},
                                  {"origin", {origin.x(), origin.y(), origin.z()}}});
  }
  for (const ReportRun& run : report.runs) {
    if (run.recording >= starts.size()) {
      throw std::invalid_argument("run " + run.name + " is of recording " +
                                  std::to_string(run.recording) + " of " +
                                  std::to_string(starts.size()));
    }
    json["runs"].push_back(run_json(run, starts[run.recording], map_points));
  }
  return inside_script(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace surefoot::report
