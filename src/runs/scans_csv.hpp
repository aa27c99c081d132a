// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// scans.csv: a line for every scan of a run. One table of columns writes it and reads it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "report/report.hpp"
#include "runs/step_times.hpp"
#include "surefoot/estimate.hpp"

namespace surefoot::runs {

/// What is told of one scan.
struct ScanRow {
  std::size_t scan = 0;  ///< among those that were used
  std::string name;      ///< its file, or "revolution 12"
  const Estimate& estimate;
  const StepTimes& times;
};

/// The first line, with its end.
[[nodiscard]] std::string scans_csv_header();
/// What every header begins with, whichever version of the program wrote it.
[[nodiscard]] std::string scans_csv_beginning();
/// One line, whatever is in the texts: what would end it is written as \x0a.
[[nodiscard]] std::string scans_csv_line(const ScanRow& row);

/// Reads it back. Columns that are not known become numbers, NaN where they are empty; texts that
/// an older program did not write are empty. A last line that was not finished is left out. Throws
/// io::ReadError naming file, line and column.
[[nodiscard]] report::ScanTable read_scans_csv(const std::filesystem::path& file);

/// Which scan a stamp is of; stamps need not ascend, since clocks are set back.
class ScansByStamp {
 public:
  explicit ScansByStamp(const report::ScanTable& scans);

  /// The scan whose stamp is nearest; of several with that stamp the first from `from` on, or the
  /// last one before. There is one at least.
  [[nodiscard]] std::size_t nearest(std::int64_t stamp_ns, std::size_t from = 0) const;

 private:
  std::vector<std::pair<std::int64_t, std::size_t>> scans_;  // in the order of their stamps
};

/// How many scans had each status.
[[nodiscard]] std::map<std::string, std::size_t> count_statuses(const report::ScanTable& scans);
/// [ms] of every scan. Throws io::ReadError naming `file` if the table has none.
[[nodiscard]] std::vector<double> scan_milliseconds(const report::ScanTable& scans,
                                                    const std::filesystem::path& file);

}  // namespace surefoot::runs
