// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/run_record.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "evaluation/statistics.hpp"
#include "experiments/fingerprint.hpp"
#include "io/file_writer.hpp"
#include "runs/run_files.hpp"
#include "runs/run_yaml.hpp"
#include "runs/scans_csv.hpp"
#include "surefoot/quantile.hpp"
#include "text/printable.hpp"

namespace surefoot::experiments {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

namespace {

constexpr const char* kRecordName = "compare_run.json";

std::string text_of(const OrderedJson& json) {
  return json.dump(2, ' ', false, OrderedJson::error_handler_t::replace);
}

/// Why a run failed, by its log: the program's last error, what is wrong with its command line, or
/// the last line that says something.
std::string last_words(const fs::path& log) {
  std::ifstream stream(log);
  std::string last, error;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("Run with --help")) break;
    if (line.starts_with("surefoot: ")) error = line;
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return error.empty() ? last : error;
}

/// As run.yaml says, which a run that did not come to its end does not have.
std::size_t unreadable_scans(const fs::path& folder) {
  const fs::path file = folder / runs::kDescriptionFile;
  return fs::exists(file) ? std::stoul('0' + runs::read_run_yaml(file).unreadable) : 0;
}

/// Of the files that arguments name, as --stamps=FILE does, and of the maps in folders.
OrderedJson marks_of_files(const std::vector<std::string>& arguments) {
  OrderedJson marks = OrderedJson::object();
  for (const std::string& argument : arguments) {
    const std::size_t value = argument.starts_with('-') ? argument.find('=') + 1 : 0;  // npos + 1
    fs::path named = argument.substr(value);
    std::error_code ignored;
    if (fs::is_directory(named, ignored)) named /= runs::kSavedMapFile;
    const std::string file = named.string();
    if (fs::is_regular_file(file, ignored)) marks[file] = mark_of(file).fingerprint;
  }
  return marks;
}

}  // namespace

std::string run_key(const CompareInput& input, const MethodVariant& variant, const Config& config,
                    const std::vector<std::string>& arguments, const std::string& build) {
  OrderedJson values = OrderedJson::object();
  for (const ParameterInfo& info : parameters()) {
    values[info.name] = get_parameter(config, info.name);
  }
  return text_of({{"recording", input.path.string()},
                  {"fingerprint", input.mark.fingerprint},
                  {"method", variant.method},
                  {"parameters", values},
                  {"arguments", arguments},
                  {"files", marks_of_files(arguments)},
                  {"version", SUREFOOT_VERSION},
                  {"build", build}});
}

void write_record(const fs::path& folder, const RunRecord& record) {
  const OrderedJson json = {{"key", OrderedJson::parse(record.key)},
                            {"exit_code", record.end.exit_code},
                            {"signal", record.end.signal},
                            {"wall_s", record.end.wall_seconds},
                            {"processor_s", record.end.processor_seconds},
                            {"peak_memory_bytes", record.end.peak_memory_bytes},
                            {"jobs", record.jobs}};
  io::write_whole_file(folder / kRecordName, text_of(json) + '\n');
}

std::optional<RunRecord> read_record(const fs::path& folder) {
  std::ifstream stream(folder / kRecordName);
  const OrderedJson json = OrderedJson::parse(stream, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    return RunRecord{text_of(json.at("key")),
                     {json.at("exit_code").get<int>(), json.at("signal").get<int>(),
                      json.at("wall_s").get<double>(), json.at("processor_s").get<double>(),
                      json.at("peak_memory_bytes").get<std::uint64_t>()},
                     json.at("jobs").get<int>()};
  } catch (const OrderedJson::exception&) {
    return std::nullopt;  // not what write_record() writes: the run is done anew
  }
}

fs::path log_file(const fs::path& folder) { return folder / "run.log"; }

void clear_run_folder(const fs::path& folder) {
  const bool in_use = fs::exists(folder) && !(fs::is_directory(folder) && fs::is_empty(folder));
  if (in_use && !fs::exists(log_file(folder))) {
    throw std::runtime_error(folder.string() +
                             ": holds files that no comparison has left; choose another -o");
  }
  fs::remove_all(folder);
  fs::create_directories(folder);
}

evaluation::MeasuredRun measured_run(const fs::path& folder, const RunRecord& record) {
  evaluation::MeasuredRun run{.exit_code = record.end.exit_code,
                              .signal = record.end.signal,
                              .wall_seconds = record.end.wall_seconds,
                              .processor_seconds = record.end.processor_seconds,
                              .peak_memory_bytes = record.end.peak_memory_bytes,
                              .jobs = record.jobs};
  if (!record.end.is_done()) {
    const std::string words = last_words(log_file(folder));
    run.error = words.empty() ? process::describe(record.end)
                              : fmt::format("{}: {}", process::describe(record.end), words);
  }
  try {
    const fs::path file = folder / runs::kScansFile;
    const report::ScanTable scans = runs::read_scans_csv(file);
    const std::vector<double> milliseconds = runs::scan_milliseconds(scans, file);
    run.scans = scans.size();
    run.statuses = runs::count_statuses(scans);
    run.median_ms = quantile(milliseconds, 0.5);
    run.p99_ms = quantile(milliseconds, 0.99);
    run.unreadable = unreadable_scans(folder);
  } catch (const std::exception& error) {
    if (run.error.empty()) run.error = error.what();
  }
  run.error = text::printable(run.error);
  return run;
}

}  // namespace surefoot::experiments
