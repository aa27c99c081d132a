// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "comparison_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "compare_runs.hpp"
#include "fingerprint.hpp"

namespace surefoot::app {

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

bool has_truth(const CompareInput& input) {
  try {
    (void)read_truth(input);
    return true;
  } catch (const std::exception&) {
    return false;  // collect_results() tells why
  }
}

/// Every recording by every method as often as asked for. The repeats are the outermost loop: what
/// disturbs the machine for a while does not meet all repeats of one run.
std::vector<RunTask> make_tasks(const CompareOptions& options,
                                const std::vector<CompareInput>& inputs,
                                const std::vector<MethodVariant>& variants,
                                const std::string& build) {
  std::vector<CompareInput> usable;
  std::copy_if(inputs.begin(), inputs.end(), std::back_inserter(usable), has_truth);
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

}  // namespace

std::optional<std::vector<CompareInput>> prepare_inputs(const CompareOptions& options) {
  if (!make_suites(options)) {
    say_interrupted(options, "nothing of an unfinished suite");
    return std::nullopt;
  }
  return find_inputs(options);
}

std::optional<CompareResults> run_comparison(const CompareOptions& options,
                                             const std::vector<CompareInput>& inputs,
                                             const std::vector<MethodVariant>& variants) {
  const std::string build = build_fingerprint();
  RunQueue queue(make_tasks(options, inputs, variants, build), options.jobs, options.quiet);
  queue.skip_done(options.retry_failed);
  say(options, fmt::format("{} runs: {} recordings, {} methods; {} done before", queue.tasks(),
                           inputs.size(), variants.size(), queue.done()));
  if (!queue.work()) {
    say_interrupted(options,
                    fmt::format("what was done, {} of {} runs,", queue.done(), queue.tasks()));
    return std::nullopt;
  }
  return collect_results(options, inputs, variants, build);
}

int exit_code_of(const evaluation::Comparison& comparison) {
  for (const evaluation::ComparedRecording& recording : comparison.recordings) {
    for (const evaluation::MethodResult& result : recording.results) {
      if (result.verdict.outcome == evaluation::Outcome::kFailed || !result.repeats_agree) {
        return kSomeFailed;
      }
    }
  }
  return 0;
}

}  // namespace surefoot::app
