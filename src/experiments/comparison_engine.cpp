// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/comparison_engine.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <set>
#include <stdexcept>
#include <utility>

#include "experiments/compare_inputs.hpp"
#include "experiments/compare_runs.hpp"
#include "experiments/comparison_folder.hpp"
#include "experiments/comparison_plan.hpp"
#include "experiments/fingerprint.hpp"
#include "io/counted.hpp"
#include "process/exit_codes.hpp"
#include "process/folder_lock.hpp"
#include "text/printable.hpp"

namespace surefoot::experiments {

namespace fs = std::filesystem;

namespace {

/// How `surefoot run` is to be called for one run.
std::vector<std::string> task_arguments(const CompareOptions& options, const CompareInput& input,
                                        const MethodVariant& variant, const fs::path& folder) {
  std::vector<std::string> arguments = {
      "run",      input.path.string(), "-o",           folder.string(),
      "--method", variant.method,      "--no-picture", "-q"};
  for (const auto* settings : {&options.settings, &variant.settings}) {
    for (const std::string& setting : *settings) {
      arguments.insert(arguments.end(), {"--set", setting});
    }
  }
  const std::vector<std::string> common = run_arguments(options);
  arguments.insert(arguments.end(), common.begin(), common.end());
  return arguments;
}

/// Whether its truth can be read; if not, collect_results() tells why, but that is long after it
/// could have been put in order.
bool has_truth(const CompareOptions& options, const CompareInput& input) {
  try {
    (void)read_truth(input);
    return true;
  } catch (const std::exception& error) {
    if (options.needs_every_truth) throw;
    fmt::print(stderr, "surefoot: {}: no truth to compare with: {}\n", input.title,
               text::printable(error.what()));
    return false;
  }
}

/// The recordings that these runs are of, marked; without those whose truth cannot be read. Throws
/// std::runtime_error if that leaves none.
std::set<std::size_t> usable_inputs(const CompareOptions& options,
                                    const std::vector<PlannedRun>& runs,
                                    std::vector<CompareInput>& inputs) {
  std::set<std::size_t> used, usable;
  for (const PlannedRun& run : runs) used.insert(run.input);
  for (const std::size_t i : used) {
    inputs[i].mark = mark_of(inputs[i].path);
    if (has_truth(options, inputs[i])) usable.insert(i);
  }
  if (usable.empty() && !used.empty()) {
    throw std::runtime_error("none of the recordings has a truth");
  }
  return usable;
}

std::vector<RunTask> make_tasks(const CompareOptions& options, const std::vector<PlannedRun>& runs,
                                std::vector<CompareInput>& inputs,
                                const std::vector<MethodVariant>& variants,
                                const std::string& build) {
  const std::set<std::size_t> usable = usable_inputs(options, runs, inputs);
  std::vector<RunTask> tasks;
  for (const PlannedRun& run : runs) {
    if (!usable.contains(run.input)) continue;
    const CompareInput& input = inputs[run.input];
    const MethodVariant& variant = variants[run.variant];
    const fs::path folder = options.output / run_folder(input, variant, run.repeat);
    const Config config = variant_config(variant, options.settings);
    const std::string again = run.repeat == 1 ? "" : fmt::format(", repeat {}", run.repeat);
    tasks.push_back({fmt::format("{}, {}{}", input.title, variant.label, again), folder,
                     task_arguments(options, input, variant, folder),
                     run_key(input, variant, config, run_arguments(options), build),
                     static_cast<double>(input.mark.bytes)});
  }
  return tasks;
}

void say(const CompareOptions& options, const std::string& text) {
  if (!options.quiet) fmt::print(stderr, "{}\n", text);
}

/// Whatever was not done before; false if it was interrupted.
bool work_through(const CompareOptions& options, RunQueue& queue, const std::string& what) {
  queue.skip_done(options.retry_failed);
  say(options,
      fmt::format("{}: {}; {} done before", io::counted(queue.tasks(), "run"), what, queue.done()));
  if (queue.work()) return true;
  say(options, fmt::format("interrupted; what was done, {} of {} runs, is kept in {}: the same "
                           "command again goes on from there",
                           queue.done(), queue.tasks(), options.output.string()));
  return false;
}

/// Throws for what a run or a variant cannot be.
void check_requests(const CompareOptions& options, const std::vector<MethodVariant>& variants) {
  check_passed(options.passed);
  for (const MethodVariant& variant : variants) (void)variant_config(variant, options.settings);
}

/// Nothing if making a suite was interrupted.
std::optional<std::vector<CompareInput>> inputs_for(const CompareOptions& options) {
  if (make_suites(options)) return find_inputs(options);
  say(options, fmt::format("interrupted; what there is of an unfinished suite stays in {}: the "
                           "same command makes it from the beginning",
                           options.output.string()));
  return std::nullopt;
}

}  // namespace

ComparePart parse_part(const std::string& text) {
  ComparePart part;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%zu/%zu%c", &part.number, &part.of, &rest) == 2 &&
      text.find_first_not_of("0123456789/") == std::string::npos && part.number >= 1 &&
      part.number <= part.of) {
    return part;
  }
  throw std::invalid_argument(fmt::format("--part: '{}'; expected NUMBER/OF, such as 3/8", text));
}

std::string list_runs(const CompareOptions& options, const std::vector<MethodVariant>& variants) {
  check_requests(options, variants);
  const std::vector<CompareInput> inputs = find_inputs(options);
  return runs_text(plan_runs(inputs.size(), variants.size(), options.repeats), inputs, variants);
}

std::optional<CompareResults> compare_variants(const CompareOptions& options,
                                               const std::vector<MethodVariant>& variants) {
  check_requests(options, variants);
  auto inputs = inputs_for(options);
  if (!inputs) return std::nullopt;
  const std::string build = build_fingerprint();
  const std::vector<PlannedRun> runs =
      share_of(plan_runs(inputs->size(), variants.size(), options.repeats),
               options.part.value_or(ComparePart{}));
  if (!options.overwrite) refuse_foreign_results(options.output);
  // Before there is a folder: a recording without truth is told here.
  RunQueue queue(make_tasks(options, runs, *inputs, variants, build), options.jobs, options.quiet);
  fs::create_directories(options.output);
  const process::FolderLock lock(options.output, options.part.has_value());
  const std::string what =
      io::counted(inputs->size(), "recording") + ", " + io::counted(variants.size(), "method");
  if (!work_through(options, queue, what)) return std::nullopt;
  CompareResults results;
  if (!options.part) results = collect_results(options, *inputs, variants, build);
  results.failed = queue.failed();
  return results;
}

int exit_code_of(const CompareResults& results) {
  if (results.failed > 0) return process::kSomeFailed;
  for (const evaluation::ComparedRecording& recording : results.comparison.recordings) {
    for (const evaluation::MethodResult& result : recording.results) {
      if (result.verdict.outcome == evaluation::Outcome::failed || !result.repeats_agree) {
        return process::kSomeFailed;
      }
    }
  }
  return process::kDone;
}

}  // namespace surefoot::experiments
