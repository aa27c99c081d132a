// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/comparison_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <system_error>

#include "io/recording.hpp"
#include "runs/run_files.hpp"

namespace surefoot::experiments {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

constexpr const char* kFileName = "compare.json";
constexpr const char* kFormat = "surefoot-comparison";

/// What comparisons, ablations and sweeps write besides it and the folders of their runs.
constexpr const char* kResults[] = {kFileName,     "tables.md",    "tables.csv",    "tables.tex",
                                    "ablation.md", "ablation.csv", "ablation.json", "sweep.md",
                                    "sweep.csv",   "sweep.json"};
constexpr const char* kFigures[] = {"trajectories_3d", "trajectories_side", "trajectories_top",
                                    "errors_over_time", "ablation"};

/// By its first entry: the whole of it may be long.
bool is_ours(const fs::path& file) {
  std::string begin(200, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), std::ssize(begin));
  return begin.find(kFormat) != std::string::npos;
}

report::ReportTable table_of(const Json& json) {
  report::ReportTable table{json.at("title"), {"Sequence", "Figure"}, {}};
  for (const Json& row : json.at("rows")) {
    std::vector<report::ReportCell> cells = {{row.at("sequence"), 0}, {row.at("figure"), 0}};
    for (const Json& cell : row.at("cells")) {
      if (table.rows.empty()) table.columns.push_back(cell.at("method"));
      cells.push_back(
          {cell.at("text"), cell.at("place").is_null() ? 0 : cell.at("place").get<int>()});
    }
    if (cells.size() != table.columns.size()) {
      throw io::ReadError(fmt::format("table '{}': a row of {} cells, {} expected", table.title,
                                      cells.size(), table.columns.size()));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

void add_result(const fs::path& folder, const Json& recording, const Json& result,
                runs::ReportMaker& maker) {
  const std::string method = result.at("method"), outcome = result.at("outcome_text");
  for (const Json& run : result.at("runs")) {
    const fs::path run_folder = folder / run.at("folder").get<std::string>();
    if (!fs::exists(run_folder / runs::kScansFile)) continue;
    maker.add_run(run_folder, method, recording.at("truth").get<std::string>());
    return;
  }
  maker.add_note(fmt::format("{}, {}: {}", recording.at("name").get<std::string>(), method,
                             outcome.empty() ? "no results" : outcome));
}

}  // namespace

bool is_comparison_folder(const fs::path& folder) { return fs::exists(folder / kFileName); }

void refuse_foreign_results(const fs::path& folder) {
  if (is_ours(folder / kFileName)) return;
  const auto refuse = [](const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(file, ignored))) return;
    throw std::runtime_error(file.string() +
                             ": is there already, which no comparison has left; choose another "
                             "folder, or --overwrite");
  };
  for (const char* name : kResults) refuse(folder / name);
  for (const char* name : kFigures) {
    for (const char* ending : {".svg", ".pdf", ".png"}) {
      refuse(folder / "figures" / (std::string(name) + ending));
    }
  }
}

void add_comparison(const fs::path& folder, runs::ReportMaker& maker) {
  const fs::path file = folder / kFileName;
  try {
    std::ifstream stream(file);
    const Json json = Json::parse(stream);
    if (json.at("format") != kFormat || json.at("format_version") != 1) {
      throw io::ReadError("expected format surefoot-comparison, version 1");
    }
    for (const Json& note : json.at("notes")) maker.add_note(note);
    for (const Json& table : json.at("tables")) maker.add_table(table_of(table));
    for (const Json& recording : json.at("recordings")) {
      for (const Json& result : recording.at("results")) {
        add_result(folder, recording, result, maker);
      }
    }
  } catch (const Json::exception& error) {
    throw io::ReadError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

}  // namespace surefoot::experiments
