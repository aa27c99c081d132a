// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot eval: how far estimated trajectories are from a reference.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "commands.hpp"
#include "dataset/trajectory_files.hpp"
#include "evaluation/evaluate.hpp"
#include "evaluation/tables.hpp"
#include "option_checks.hpp"

namespace surefoot::app {
namespace {

namespace fs = std::filesystem;
using evaluation::AlignmentMethod;
using evaluation::AssociationMethod;
using evaluation::DeltaUnit;
using evaluation::Evaluation;

constexpr int kSomeFailed = 1;
constexpr int kAllFailed = 2;

enum class FileFormat { kAuto, kTum, kKitti };
enum class TableFormat { kText, kJson, kCsv, kLatex };

struct EvalOptions {
  fs::path reference;
  std::vector<fs::path> estimates;
  FileFormat format = FileFormat::kAuto;
  evaluation::EvaluationOptions evaluation;
  TableFormat table = TableFormat::kText;
};

/// By the number of values in the first row: TUM has 8, KITTI 12.
FileFormat format_of(const fs::path& file) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return FileFormat::kTum;  // its reader says what it is
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::size_t count = 0;
    bool comment = false;
    for (std::string word; words >> word && !comment; ++count) comment = word.front() == '#';
    if (count > 0 && !comment) return count == 12 ? FileFormat::kKitti : FileFormat::kTum;
  }
  return FileFormat::kTum;  // its reader says what is wrong with the file
}

/// KITTI's poses have no stamps; they get their row's number, which is never compared.
Trajectory read_trajectory(const fs::path& file, FileFormat format) {
  if (format == FileFormat::kTum) return dataset::read_tum(file);
  Trajectory trajectory;
  for (const Pose& pose : dataset::read_kitti_poses(file)) {
    trajectory.push_back({static_cast<std::int64_t>(trajectory.size()), pose});
  }
  return trajectory;
}

/// The files' names without extension, or the whole paths if these are not unique.
std::vector<std::string> names_of(const std::vector<fs::path>& files) {
  std::map<std::string, int> uses;
  for (const fs::path& file : files) ++uses[file.stem().string()];
  std::vector<std::string> names;
  for (const fs::path& file : files) {
    const std::string stem = file.stem().string();
    names.push_back(uses[stem] == 1 ? stem : file.string());
  }
  return names;
}

std::string table_of(const std::vector<Evaluation>& evaluations, TableFormat format) {
  switch (format) {
    case TableFormat::kJson:
      return evaluation::to_json(evaluations);
    case TableFormat::kCsv:
      return evaluation::to_csv(evaluations);
    case TableFormat::kLatex:
      return evaluation::to_latex(evaluations);
    case TableFormat::kText:
      break;
  }
  return evaluation::to_text(evaluations);
}

/// An estimate that cannot be evaluated is told and left out; the others go on.
int evaluate_all(EvalOptions options) {
  const bool find_format = options.format == FileFormat::kAuto;
  const FileFormat format = find_format ? format_of(options.reference) : options.format;
  if (format == FileFormat::kKitti) {
    options.evaluation.association.method = AssociationMethod::kIndex;
    if (options.evaluation.stretches.unit == DeltaUnit::kSeconds) {
      throw std::runtime_error("--delta-unit s needs stamps, which KITTI's files do not have");
    }
  }
  const Trajectory reference = read_trajectory(options.reference, format);
  const std::vector<std::string> names = names_of(options.estimates);
  std::vector<Evaluation> evaluations;
  for (std::size_t i = 0; i < options.estimates.size(); ++i) {
    try {
      const Trajectory estimate = read_trajectory(options.estimates[i], format);
      evaluations.push_back(
          evaluation::evaluate(names[i], reference, estimate, options.evaluation));
    } catch (const std::exception& error) {
      fmt::print(stderr, "surefoot: {}: {}\n", names[i], error.what());
    }
  }
  if (evaluations.empty()) return kAllFailed;
  fmt::print("{}", table_of(evaluations, options.table));
  return evaluations.size() == options.estimates.size() ? 0 : kSomeFailed;
}

void add_pairing_options(CLI::App& command, EvalOptions& options) {
  auto& association = options.evaluation.association;
  const std::map<std::string, FileFormat> formats = {
      {"auto", FileFormat::kAuto}, {"tum", FileFormat::kTum}, {"kitti", FileFormat::kKitti}};
  command.add_option("--format", options.format, "Of all files: auto, tum or kitti")
      ->transform(CLI::CheckedTransformer(formats));
  const std::map<std::string, AssociationMethod> methods = {
      {"nearest", AssociationMethod::kNearest}, {"interpolate", AssociationMethod::kInterpolate}};
  command
      .add_option("--pair", association.method,
                  "nearest: poses with the nearest stamps; interpolate: the reference at the "
                  "estimate's stamps")
      ->transform(CLI::CheckedTransformer(methods));
  command
      .add_option("--max-diff", association.max_difference,
                  "Largest difference of two stamps that are paired [s]")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command
      .add_option("--max-gap", association.max_gap,
                  "Longest gap of the reference that is interpolated [s]")
      ->check(CLI::Range(0.0, 1e6))
      ->capture_default_str();
  command.add_option("--offset", association.offset, "Added to the estimates' stamps [s]")
      ->check(CLI::Range(-1e9, 1e9))
      ->capture_default_str();
}

void add_error_options(CLI::App& command, evaluation::EvaluationOptions& options) {
  const std::map<std::string, AlignmentMethod> alignments = {
      {"none", AlignmentMethod::kNone},          {"origin", AlignmentMethod::kOrigin},
      {"yaw", AlignmentMethod::kYawTranslation}, {"se3", AlignmentMethod::kRigid},
      {"sim3", AlignmentMethod::kSimilarity},    {"scale", AlignmentMethod::kScale}};
  command
      .add_option("--align", options.alignment,
                  "none, origin, yaw (and translation), se3 (the default), sim3 or scale")
      ->transform(CLI::CheckedTransformer(alignments));
  command
      .add_option("--align-poses", options.alignment_poses, "Align the first poses only; 0: all")
      ->check(whole_number(0));
  auto& stretches = options.stretches;
  command.add_option("--delta", stretches.delta, "Length of a stretch of the relative error")
      ->capture_default_str();
  const std::map<std::string, DeltaUnit> units = {{"frames", DeltaUnit::kFrames},
                                                  {"m", DeltaUnit::kMetres},
                                                  {"s", DeltaUnit::kSeconds},
                                                  {"deg", DeltaUnit::kDegrees}};
  command.add_option("--delta-unit", stretches.unit, "Of --delta: frames, m, s or deg")
      ->transform(CLI::CheckedTransformer(units));
  command.add_flag("--all-pairs", stretches.all_pairs,
                   "A stretch from every pose, not one after the other");
  command
      .add_option("--delta-tolerance", stretches.tolerance,
                  "With --all-pairs: accepted deviation as a share of --delta")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  command.add_flag("--pairs-from-reference", options.stretches_from_reference,
                   "Measure the stretches along the reference");
  command
      .add_option("--segments", options.segment_lengths,
                  "Lengths of KITTI's segment error [m], such as 10,20,50")
      ->delimiter(',');
}

}  // namespace

void add_eval_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<EvalOptions>();
  CLI::App* command =
      app.add_subcommand("eval", "Compare trajectories with a reference (TUM or KITTI files)");
  command->add_option("reference", options->reference, "The true trajectory")->required();
  command->add_option("estimates", options->estimates, "One trajectory or more")->required();
  add_pairing_options(*command, *options);
  add_error_options(*command, options->evaluation);
  CLI::Option_group* output = command->add_option_group("output");
  const auto add_table = [&](const char* flag, TableFormat format, const char* help) {
    output->add_flag_callback(
        flag, [options, format] { options->table = format; }, help);
  };
  add_table("--json", TableFormat::kJson, "Print every figure as JSON");
  add_table("--csv", TableFormat::kCsv, "Print a line for each estimate and error");
  add_table("--latex", TableFormat::kLatex, "Print a table for a paper");
  output->require_option(0, 1);
  command->callback([options, &exit_code] { exit_code = evaluate_all(*options); });
}

}  // namespace surefoot::app
