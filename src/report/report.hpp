// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a report tells: runs, the recordings they were made on, and how they compare.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "surefoot/trajectory.hpp"

namespace surefoot::report {

/// One label and what stands behind it.
using Fact = std::pair<std::string, std::string>;

struct ReportParameter {
  std::string name;
  std::string value;
  std::string default_value;
  std::string unit;  ///< "" where the value has none
  std::string help;
};

/// A number for every scan; NaN where a scan has none.
struct ScanColumn {
  std::string name;  ///< as in scans.csv, such as "stage1_iterations" or "ms_search"
  std::vector<float> values;
};

/// What scans.csv tells, one entry a scan in each vector.
struct ScanTable {
  std::vector<std::int64_t> stamps_ns;
  std::vector<std::string> statuses;    ///< "ok", "degenerate", ...
  std::vector<std::string> messages;    ///< why it is not "ok"
  std::vector<std::string> degenerate;  ///< names of the weak directions, between blanks
  std::vector<std::string> stages;      ///< of the run's registration; columns "stage1_..." tell of
                                        ///< the first
  std::vector<ScanColumn> columns;

  [[nodiscard]] std::size_t size() const { return stamps_ns.size(); }
};

/// The absolute errors of the poses that have a partner in the truth.
struct ErrorSeries {
  std::vector<std::int64_t> stamps_ns;
  std::vector<float> translation_m;
  std::vector<float> horizontal_m;
  std::vector<float> vertical_m;  ///< positive: too high
  std::vector<float> tilt_deg;
  std::vector<float> yaw_deg;
};

/// How a run compares with the truth.
struct RunEvaluation {
  std::string align;  ///< how the figures were aligned, as `surefoot eval --align` names it
  std::string json;   ///< one object as `surefoot eval --json` prints it
  ErrorSeries errors;
};

/// Points in the frame in which the run is shown; the other vectors are as long or empty.
struct MapCloud {
  std::vector<Eigen::Vector3f> points;  ///< [m]
  std::vector<float> intensities;
  std::vector<float> first_seen;  ///< [s] after the run's first scan
};

/// A sweep's points, all laid into the map by its pose at mid-scan; vectors of equal length.
struct DeskewSample {
  std::size_t scan = 0;                   ///< its place in the run's ScanTable
  std::vector<Eigen::Vector3f> measured;  ///< [m] as they came
  std::vector<Eigen::Vector3f> deskewed;  ///< [m] each by the pose at its own instant
  std::vector<float> times;               ///< within the sweep, 0 to 1
};

/// A place that the run compared with one where it had been before.
struct ReportLoop {
  std::size_t scan = 0;   ///< its place in the run's ScanTable
  std::size_t place = 0;  ///< of where it had been, likewise
  std::string verdict;    ///< as in loops.csv: "taken", or what it was refused for
  std::string why;        ///< the verdict in a sentence
};

/// Poses are given in the frame in which runs are shown: the truth's world where there is a truth,
/// the run's own map otherwise, and near its origin: they are drawn as floats. z is up.
struct ReportRun {
  std::string name;
  std::size_t recording = 0;  ///< index of Report::recordings
  std::vector<Fact> facts;
  std::vector<std::string> notes;
  std::vector<ReportParameter> parameters;
  ScanTable scans;                         ///< with stamps of a clock that goes on
  std::vector<std::optional<Pose>> poses;  ///< one a scan; none for a rejected one
  std::optional<RunEvaluation> evaluation;
  MapCloud map;
  std::vector<DeskewSample> deskewing;
  std::vector<ReportLoop> loops;
  std::vector<std::optional<Pose>> corrected;  ///< by the loops, one a scan; empty: none is known
};

struct ReportRecording {
  std::string name;
  Trajectory truth;  ///< over the time of the runs; empty if there is none
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< [m] what was taken off coordinates
};

struct ReportCell {
  std::string text;
  int place = 0;  ///< 1: best, 2: second, 0: neither
};

/// A table over several runs.
struct ReportTable {
  std::string title;
  std::vector<std::string> columns;
  std::vector<std::vector<ReportCell>> rows;  ///< as long as `columns` each
};

struct Report {
  std::string title;
  std::string version;  ///< of the program
  std::vector<std::string> notes;
  std::vector<ReportTable> tables;
  std::vector<ReportRecording> recordings;
  std::vector<ReportRun> runs;
};

}  // namespace surefoot::report
