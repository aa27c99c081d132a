// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// What a comparison keeps of each of its runs, beside the run's own output: by it a run that was
// done is known again, and not done twice.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "evaluation/comparison.hpp"
#include "experiments/compare_inputs.hpp"
#include "experiments/method_variant.hpp"
#include "process/child_process.hpp"

namespace surefoot::experiments {

struct RunRecord {
  std::string key;  ///< JSON: everything that decides what the run gives
  process::ProcessEnd end;
  int jobs = 1;  ///< runs at the same time
};

/// Recording (path and fingerprint), method, all parameters as used, arguments and marks of the
/// files that they name, program.
[[nodiscard]] std::string run_key(const CompareInput& input, const MethodVariant& variant,
                                  const Config& config, const std::vector<std::string>& arguments,
                                  const std::string& build);

/// Written when a run has ended. Throws io::WriteError.
void write_record(const std::filesystem::path& folder, const RunRecord& record);
/// Nothing if there is none, or none that can be read.
[[nodiscard]] std::optional<RunRecord> read_record(const std::filesystem::path& folder);

/// The log of a run's two output streams, in its folder.
[[nodiscard]] std::filesystem::path log_file(const std::filesystem::path& folder);

/// Empties the folder of a run, or makes it. Throws std::runtime_error for a folder with files that
/// no run of a comparison has left.
void clear_run_folder(const std::filesystem::path& folder);

/// The run as the comparison tells it: from its record, its log, its scans.csv and run.yaml. Never
/// throws for what is in these; what is wrong becomes the run's `error`.
[[nodiscard]] evaluation::MeasuredRun measured_run(const std::filesystem::path& folder,
                                                   const RunRecord& record);

}  // namespace surefoot::experiments
