// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/folder_report.hpp"

#include <stdexcept>
#include <string>
#include <string_view>

#include "experiments/comparison_folder.hpp"
#include "io/file_writer.hpp"
#include "io/recording.hpp"
#include "report/page.hpp"
#include "runs/report_maker.hpp"
#include "runs/run_files.hpp"

namespace surefoot::experiments {

namespace {

namespace fs = std::filesystem;

fs::path page_of(const ReportRequest& request) {
  if (!request.output.empty()) return request.output;
  return request.folders.size() == 1 ? request.folders.front() / runs::kReportFile
                                     : fs::path(runs::kReportFile);
}

/// An earlier page of this kind may go; check's, a map, a link or a device is somebody else's.
void require_page_or_nothing(const fs::path& file) {
  const std::string_view page = report::page_template();
  const std::string_view begin = page.substr(0, page.find(report::kTitlePlaceholder));
  const fs::file_status status = fs::symlink_status(file);
  if (!fs::exists(status) || io::is_file_beginning(file, begin)) return;
  if (fs::is_regular_file(status) && fs::file_size(file) == 0) return;
  throw std::invalid_argument(file.string() +
                              ": is there already and is no page of report's; choose another name");
}

}  // namespace

ReportOutcome report_folders(const ReportRequest& request,
                             const std::function<void(const std::string& text)>& complain) {
  const fs::path file = page_of(request);
  require_page_or_nothing(file);
  io::require_ending(file, {".html", ".htm"});
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
  runs::write_report(maker.take(request.title), file, request.map_points);
  return {file, is_whole};
}

}  // namespace surefoot::experiments
