// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/folder_report.hpp"

#include "experiments/comparison_folder.hpp"
#include "io/recording.hpp"
#include "runs/report_maker.hpp"
#include "runs/run_files.hpp"

namespace surefoot::experiments {

ReportOutcome report_folders(const ReportRequest& request,
                             const std::function<void(const std::string& text)>& complain) {
  namespace fs = std::filesystem;
  runs::ReportMaker maker(request.truth);
  std::size_t added = 0;
  for (const fs::path& folder : request.folders) {
    try {
      if (is_comparison_folder(folder)) {
        add_comparison(folder, maker);
      } else {
        maker.add_run(folder);
      }
      ++added;
    } catch (const io::ReadError& error) {
      if (request.folders.size() == 1) throw;
      complain(std::string("left out: ") + error.what());
    }
  }
  if (added == 0) throw io::ReadError("none of the folders holds a run");
  for (const std::string& problem : maker.problems()) complain(problem);
  const bool is_whole = added == request.folders.size() && maker.problems().empty();
  fs::path file = request.output;
  if (file.empty()) file = runs::kReportFile;
  if (request.output.empty() && request.folders.size() == 1) file = request.folders.front() / file;
  runs::write_report(maker.take(request.title), file, request.map_points);
  return {file, is_whole};
}

}  // namespace surefoot::experiments
