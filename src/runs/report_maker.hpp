// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// Folders of runs, evaluated and put together for the report.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "report/report.hpp"

namespace surefoot::runs {

class ReportMaker {
 public:
  /// `truth` of all runs; empty: the gt.tum of each run's recording, where there is one.
  explicit ReportMaker(std::filesystem::path truth = {}) : truth_(std::move(truth)) {}

  /// Adds a run. `name` empty: its method, or its folder if another run has that name. `truth`
  /// goes before the one of the constructor. Throws io::ReadError.
  void add_run(const std::filesystem::path& folder, const std::string& name = {},
               const std::filesystem::path& truth = {});

  /// With the first run's recording as title if `title` is empty.
  [[nodiscard]] report::Report take(const std::string& title);

  void add_note(const std::string& note) { report_.notes.push_back(note); }
  void add_table(report::ReportTable table) { report_.tables.push_back(std::move(table)); }
  /// What could not be done, for the terminal; the page says it, too.
  [[nodiscard]] const std::vector<std::string>& problems() const { return problems_; }

 private:
  std::size_t recording_of(const std::filesystem::path& input);
  [[nodiscard]] Trajectory shown_truth(std::size_t recording) const;

  std::filesystem::path truth_;
  report::Report report_;
  /// What is known of one of report_.recordings.
  struct Recording {
    std::filesystem::path input;
    std::optional<Eigen::Vector3d> origin;  // of the truth's world, where one is known
    Trajectory truth;                       // the whole of it
  };
  std::vector<Recording> recordings_;
  std::vector<std::string> problems_;
};

/// Whether the program was built with the page.
[[nodiscard]] bool has_report_page();

/// Writes the page. Throws std::runtime_error if the program was built without it, and
/// io::WriteError.
void write_report(const report::Report& report, const std::filesystem::path& file,
                  std::size_t map_points = 0);

}  // namespace surefoot::runs
