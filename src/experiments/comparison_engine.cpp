// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/comparison_engine.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <utility>

#include "experiments/compare_inputs.hpp"
#include "experiments/compare_runs.hpp"
#include "experiments/fingerprint.hpp"
#include "process/exit_codes.hpp"
#include "process/folder_lock.hpp"

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

/// Those whose truth can be read; for the others collect_results() tells why not, but that is long
/// after they could have been put in order. Throws std::runtime_error if there is none.
std::vector<CompareInput> with_truth(const CompareOptions& options,
                                     const std::vector<CompareInput>& inputs) {
  std::vector<CompareInput> usable;
  for (const CompareInput& input : inputs) {
    try {
      (void)read_truth(input);
      usable.push_back(input);
    } catch (const std::exception& error) {
      if (options.needs_every_truth) throw;
      fmt::print(stderr, "surefoot: {}: no truth to compare with: {}\n", input.name, error.what());
    }
  }
  if (usable.empty()) throw std::runtime_error("none of the recordings has a truth");
  return usable;
}

/// Every recording by every method as often as asked for. The repeats are the outermost loop: what
/// disturbs the machine for a while does not meet all repeats of one run.
std::vector<RunTask> make_tasks(const CompareOptions& options,
                                const std::vector<CompareInput>& inputs,
                                const std::vector<MethodVariant>& variants,
                                const std::string& build) {
  const std::vector<CompareInput> usable = with_truth(options, inputs);
  std::vector<RunTask> tasks;
  for (int repeat = 1; repeat <= options.repeats; ++repeat) {
    for (const CompareInput& input : usable) {
      for (const MethodVariant& variant : variants) {
        const fs::path folder = options.output / run_folder(input, variant, repeat);
        const Config config = variant_config(variant, options.settings);
        const std::string again = repeat == 1 ? "" : fmt::format(", repeat {}", repeat);
        tasks.push_back({fmt::format("{}, {}{}", input.name, variant.label, again), folder,
                         task_arguments(options, input, variant, folder),
                         run_key(input, variant, config, run_arguments(options), build),
                         static_cast<double>(input.mark.bytes)});
      }
    }
  }
  return tasks;
}

void say(const CompareOptions& options, const std::string& text) {
  if (!options.quiet) fmt::print(stderr, "{}\n", text);
}

void say_interrupted(const CompareOptions& options, const std::string& what_is_done) {
  say(options, fmt::format("interrupted; {} is kept in {}: the same command again goes on from "
                           "there",
                           what_is_done, options.output.string()));
}

std::vector<RunTask> share_of(std::vector<RunTask> tasks, const ComparePart& part) {
  std::vector<RunTask> share;
  for (std::size_t i = part.number - 1; i < tasks.size(); i += part.of) share.push_back(tasks[i]);
  return share;
}

/// Whatever was not done before; false if it was interrupted.
bool work_through(const CompareOptions& options, RunQueue& queue, const std::string& what) {
  queue.skip_done(options.retry_failed);
  say(options, fmt::format("{} runs: {}; {} done before", queue.tasks(), what, queue.done()));
  if (queue.work()) return true;
  say_interrupted(options,
                  fmt::format("what was done, {} of {} runs,", queue.done(), queue.tasks()));
  return false;
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

std::optional<CompareResults> compare_variants(const CompareOptions& options,
                                               const std::vector<MethodVariant>& variants) {
  for (const MethodVariant& variant : variants) (void)variant_config(variant, options.settings);
  if (!make_suites(options)) {
    say_interrupted(options, "nothing of an unfinished suite");
    return std::nullopt;
  }
  const std::vector<CompareInput> inputs = find_inputs(options);
  const std::string build = build_fingerprint();
  // Before there is a folder: a recording without truth is told here.
  RunQueue queue(
      share_of(make_tasks(options, inputs, variants, build), options.part.value_or(ComparePart{})),
      options.jobs, options.quiet);
  fs::create_directories(options.output);
  const process::FolderLock lock(options.output, options.part.has_value());
  const std::string what = fmt::format("{} recordings, {} methods", inputs.size(), variants.size());
  if (!work_through(options, queue, what)) return std::nullopt;
  if (options.part) return CompareResults{};
  return collect_results(options, inputs, variants, build);
}

int exit_code_of(const evaluation::Comparison& comparison) {
  for (const evaluation::ComparedRecording& recording : comparison.recordings) {
    for (const evaluation::MethodResult& result : recording.results) {
      if (result.verdict.outcome == evaluation::Outcome::failed || !result.repeats_agree) {
        return process::kSomeFailed;
      }
    }
  }
  return process::kDone;
}

}  // namespace surefoot::experiments
