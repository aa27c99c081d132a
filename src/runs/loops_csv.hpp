// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// loops.csv: a line for every place that a piece of way was compared with, what was asked and why
// it was taken or refused.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mapping/map_merge.hpp"
#include "mapping/walk_mapper.hpp"
#include "report/report.hpp"
#include "runs/loop_truth.hpp"

namespace surefoot::runs {

/// The whole file, of a walk's pieces and the loops between them. `truth` may be null; then two
/// columns are empty.
[[nodiscard]] std::string loops_csv(const std::vector<mapping::Piece>& pieces,
                                    const std::vector<mapping::Loop>& loops,
                                    const LoopTruth* truth);

/// The file as a report shows it: places by the scans that are nearest to their stamps. Throws
/// io::ReadError naming file and line.
[[nodiscard]] std::vector<report::ReportLoop> read_loops_csv(const std::filesystem::path& file,
                                                             const report::ScanTable& scans);

/// The head of a file of places of one map that were compared with another's.
[[nodiscard]] std::string join_csv_header();
/// Its lines for a map that was to be joined; `map`: its number.
[[nodiscard]] std::string join_csv(const mapping::MapJoin& join, std::size_t map);

/// revisits.csv: a line a piece of way, whether it lies where an earlier one does, and whether a
/// loop found that.
[[nodiscard]] std::string revisits_csv(const mapping::WalkMapper& mapper, const LoopTruth& truth);

}  // namespace surefoot::runs
