// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/compare_results.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "evaluation/comparison_json.hpp"
#include "evaluation/comparison_tables.hpp"
#include "experiments/run_record.hpp"
#include "experiments/seed_scenes.hpp"
#include "io/file_writer.hpp"
#include "io/trajectory_files.hpp"
#include "process/machine.hpp"
#include "runs/run_files.hpp"
#include "runs/run_truth.hpp"
#include "runs/scans_csv.hpp"
#include "runs/trajectory_inputs.hpp"
#include "surefoot/seconds.hpp"
#include "text/printable.hpp"
#ifdef SUREFOOT_HAS_PICTURES
#include "experiments/compare_figures.hpp"
#endif

namespace surefoot::experiments {

namespace fs = std::filesystem;
using evaluation::ComparedMethod;
using evaluation::ComparedRecording;
using evaluation::Comparison;
using evaluation::MethodResult;

namespace {

std::string file_bytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// The part of the truth between a run's first scan and its last, by their stamps, and a pose just
/// behind either end, which these may be paired with; at either end no more than `most` [ns] is
/// left out.
Trajectory between_scans(const Trajectory& truth, const std::vector<std::int64_t>& stamps,
                         const evaluation::AssociationOptions& association, std::int64_t most) {
  if (stamps.empty() || truth.empty()) return truth;
  const auto [earliest, latest] = std::minmax_element(stamps.begin(), stamps.end());
  const std::int64_t begin = truth.front().stamp_ns, end = truth.back().stamp_ns;
  const std::int64_t offset_ns = std::llround(1e9 * association.offset);
  const std::int64_t first_scan = *earliest + offset_ns, last_scan = *latest + offset_ns;
  const std::int64_t first = first_scan - begin > most ? begin : first_scan;
  const std::int64_t last = end - last_scan > most ? end : last_scan;
  constexpr std::int64_t kJustBehind = 10'000'000;  // [ns] so that it counts for no part to cover
  const auto earlier = [](const StampedPose& pose, std::int64_t ns) { return pose.stamp_ns < ns; };
  auto from = std::lower_bound(truth.begin(), truth.end(), first, earlier);
  auto to = std::lower_bound(from, truth.end(), last + 1, earlier);
  if (from != truth.begin() && first - std::prev(from)->stamp_ns <= kJustBehind) --from;
  if (to != truth.end() && to->stamp_ns - last <= kJustBehind) ++to;
  return to - from < 2 ? truth : Trajectory(from, to);
}

constexpr std::int64_t kAll = std::int64_t{1} << 62;  // [ns]

bool clips_truth(const CompareOptions& options) {
  if (options.cover != Cover::automatic) return options.cover == Cover::recording;
  return options.start > 0 || options.count > 0;
}

/// Everything about one method on one recording.
class ResultMaker {
 public:
  ResultMaker(const CompareOptions& options, const CompareInput& input, const Trajectory& truth)
      : options_(options), input_(input), truth_(truth) {}

  /// `path` becomes the aligned estimate, `truth_part` what it was compared with.
  [[nodiscard]] MethodResult make(const MethodVariant& variant, Trajectory& path,
                                  Trajectory& truth_part) const {
    MethodResult result;
    for (int repeat = 1; repeat <= options_.repeats; ++repeat) {
      result.runs.push_back(measure(run_folder(input_, variant, repeat)));
    }
    const bool failed = std::any_of(result.runs.begin(), result.runs.end(),
                                    [](const auto& run) { return !run.error.empty(); });
    if (!failed) evaluate(variant, result, path, truth_part);
    if (result.verdict.outcome == evaluation::Outcome::failed) result.verdict.text = "failed";
    return result;
  }

 private:
  [[nodiscard]] evaluation::MeasuredRun measure(const fs::path& folder) const {
    evaluation::MeasuredRun run{.error = "was not run"};
    if (const auto record = read_record(options_.output / folder)) {
      run = measured_run(options_.output / folder, *record);
    }
    run.folder = folder.string();
    return run;
  }

  void evaluate(const MethodVariant& variant, MethodResult& result, Trajectory& path,
                Trajectory& truth_part) const {
    const fs::path folder = options_.output / run_folder(input_, variant, 1);
    const std::string bytes = file_bytes(folder / runs::kTrajectoryFile);
    for (int repeat = 2; repeat <= options_.repeats; ++repeat) {
      const fs::path other = options_.output / run_folder(input_, variant, repeat);
      result.repeats_agree &= file_bytes(other / runs::kTrajectoryFile) == bytes;
    }
    try {
      const Trajectory estimate = io::read_tum(folder / runs::kTrajectoryFile);
      evaluation::EvaluationOptions how = options_.evaluation;
      const std::vector<std::int64_t> stamps =
          runs::read_scans_csv(folder / runs::kScansFile).stamps_ns;
      how.usual_step_ns = evaluation::median_step_ns(stamps);
      const Trajectory truth =
          clips_truth(options_) ? between_scans(truth_, stamps, how.association, kAll) : truth_;
      result.evaluation = evaluation::evaluate(variant.label, truth, estimate, how);
      evaluation::EvaluationOptions from_start = how;
      from_start.alignment = evaluation::AlignmentMethod::origin;
      result.from_start = evaluation::evaluate(variant.label, truth, estimate, from_start);
      result.verdict = judge(truth, estimate, *result.evaluation, how, stamps);
      truth_part = truth;
      path = evaluation::aligned(estimate, result.evaluation->alignment);
    } catch (const std::exception& error) {
      result.runs.front().error = "not evaluated: " + text::printable(error.what());
    }
  }

  /// A truth often goes on a little before the first scan and after the last: a short recording is
  /// whole all the same.
  [[nodiscard]] evaluation::RunVerdict judge(const Trajectory& truth, const Trajectory& estimate,
                                             const evaluation::Evaluation& found,
                                             const evaluation::EvaluationOptions& how,
                                             const std::vector<std::int64_t>& scan_stamps) const {
    constexpr std::int64_t kALittle = 1'000'000'000;  // [ns]
    const auto verdict = evaluation::judge(truth, estimate, found, how, options_.rules);
    const bool lacks = verdict.outcome == evaluation::Outcome::stopped ||
                       verdict.outcome == evaluation::Outcome::partial;
    if (!lacks || options_.cover != Cover::automatic || clips_truth(options_) ||
        how.association.method == evaluation::AssociationMethod::index) {
      return verdict;
    }
    const Trajectory asked = between_scans(truth, scan_stamps, how.association, kALittle);
    return evaluation::judge(asked, estimate, evaluation::evaluate("", asked, estimate, how), how,
                             options_.rules);
  }

  const CompareOptions& options_;
  const CompareInput& input_;
  const Trajectory& truth_;
};

/// Without a truth nothing was run: every method has failed for the same reason.
MethodResult without_truth(const CompareOptions& options, const CompareInput& input,
                           const MethodVariant& variant, const std::string& reason) {
  evaluation::MeasuredRun run{.folder = run_folder(input, variant, 1).string(), .error = reason};
  return {.verdict = {evaluation::Outcome::failed, "failed"},
          .runs = std::vector(static_cast<std::size_t>(options.repeats), run)};
}

ComparedRecording compare_recording(const CompareOptions& options, const CompareInput& input,
                                    const std::vector<MethodVariant>& variants,
                                    ComparedPaths& paths) {
  ComparedRecording recording{.name = input.title,
                              .path = input.path.string(),
                              .truth = input.truth.string(),
                              .fingerprint = input.mark.fingerprint};
  paths.estimates.resize(variants.size());
  paths.begins.resize(variants.size());
  std::string no_truth;
  Trajectory truth;
  try {
    truth = read_truth(input);
  } catch (const std::exception& error) {
    no_truth = text::printable(error.what());
  }
  if (no_truth.empty()) {
    recording.truth_length = evaluation::path_lengths(truth).back();
    recording.truth_duration = seconds(truth.back().stamp_ns) - seconds(truth.front().stamp_ns);
  }
  paths.truth = truth;
  const ResultMaker maker(options, input, truth);
  for (std::size_t m = 0; m < variants.size(); ++m) {
    recording.results.push_back(no_truth.empty()
                                    ? maker.make(variants[m], paths.estimates[m], paths.truth)
                                    : without_truth(options, input, variants[m], no_truth));
    if (paths.estimates[m].empty()) continue;
    paths.begins[m] = runs::segment_begins(options.output / run_folder(input, variants[m], 1));
  }
  return recording;
}

ComparedMethod method_of(const MethodVariant& variant, const Config& config) {
  ComparedMethod method{variant.label, variant.method, {}};
  for (const ParameterInfo& info : parameters()) {
    method.parameters.emplace_back(info.name, get_parameter(config, info.name));
  }
  return method;
}

}  // namespace

fs::path run_folder(const CompareInput& input, const MethodVariant& variant, int repeat) {
  return fs::path("runs") / input.name / folder_name(variant.label) / std::to_string(repeat);
}

Trajectory read_truth(const CompareInput& input) {
  Trajectory truth = runs::read_truth_poses(input.truth);
  if (truth.empty()) throw std::runtime_error(input.truth.string() + ": holds no poses");
  return truth;
}

CompareResults collect_results(const CompareOptions& options,
                               const std::vector<CompareInput>& inputs,
                               const std::vector<MethodVariant>& variants,
                               const std::string& build) {
  CompareResults results;
  Comparison& comparison = results.comparison;
  comparison.version = SUREFOOT_VERSION;
  comparison.build = build;
  comparison.processor = process::processor_name();
  comparison.processor_cores = process::processor_cores();
  comparison.repeats = options.repeats;
  comparison.run_arguments = run_arguments(options);
  comparison.options = options.evaluation;
  comparison.rules = options.rules;
  comparison.cover = evaluation::name_of(kCoverNames, options.cover);
  for (const MethodVariant& variant : variants) {
    comparison.methods.push_back(method_of(variant, variant_config(variant, options.settings)));
  }
  std::vector<fs::path> recordings;
  for (const CompareInput& input : inputs) recordings.push_back(input.path);
  const std::vector<std::string> scenes = seed_scenes(recordings);
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    results.paths.emplace_back();
    comparison.recordings.push_back(
        compare_recording(options, inputs[i], variants, results.paths.back()));
    comparison.recordings.back().scene = scenes[i];
  }
  return results;
}

void write_results(const CompareOptions& options, const CompareResults& results) {
  const Comparison& comparison = results.comparison;
  fs::create_directories(options.output);
  const auto write = [&](const char* name, const std::string& text) {
    io::write_whole_file(options.output / name, text);
  };
  write("compare.json", evaluation::to_json(comparison));  // first: by it the others are ours
  write("tables.md", evaluation::tables_markdown(comparison));
  write("tables.csv", evaluation::tables_csv(comparison));
  write("tables.tex", evaluation::tables_latex(comparison));
#ifdef SUREFOOT_HAS_PICTURES
  if (options.figures) draw_comparison(results, options.output / "figures");
#endif
}

}  // namespace surefoot::experiments
