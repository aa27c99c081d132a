// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot eval: how far estimated trajectories are from a reference.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "evaluation/evaluate.hpp"
#include "evaluation/tables.hpp"
#include "evaluation_options.hpp"
#include "process/exit_codes.hpp"
#include "runs/trajectory_inputs.hpp"
#ifdef SUREFOOT_HAS_PICTURES
#include "experiments/compare_figures.hpp"
#endif

namespace surefoot::app {
namespace {

namespace fs = std::filesystem;
using evaluation::AssociationMethod;
using evaluation::DeltaUnit;
using evaluation::Evaluation;
using runs::TrajectoryFormat;

enum class TableFormat { text, json, csv, latex };

struct EvalOptions {
  runs::ReferenceRequest reference;
  std::vector<fs::path> estimates;
  evaluation::EvaluationOptions evaluation;
  TableFormat table = TableFormat::text;
  std::vector<fs::path> figures;  ///< to draw: .svg or .png
};

std::string table_of(const std::vector<Evaluation>& evaluations, TableFormat format) {
  switch (format) {
    case TableFormat::json:
      return evaluation::to_json(evaluations);
    case TableFormat::csv:
      return evaluation::to_csv(evaluations);
    case TableFormat::latex:
      return evaluation::to_latex(evaluations);
    case TableFormat::text:
      break;
  }
  return evaluation::to_text(evaluations);
}

void draw_figures([[maybe_unused]] const EvalOptions& options,
                  [[maybe_unused]] const Trajectory& reference,
                  [[maybe_unused]] const std::vector<Evaluation>& evaluations,
                  [[maybe_unused]] const std::vector<Trajectory>& paths) {
#ifdef SUREFOOT_HAS_PICTURES
  std::vector<std::string> names;
  for (const Evaluation& evaluation : evaluations) names.push_back(evaluation.name);
  for (const fs::path& file : options.figures) {
    experiments::draw_views(reference, names, paths, file);
  }
#else
  if (!options.figures.empty()) {
    throw std::runtime_error("--figure: this program was built without pictures");
  }
#endif
}

/// What the reference does not have is not asked of it.
void adapt(evaluation::EvaluationOptions& options, const runs::Reference& reference) {
  options.positions_only = !reference.truth.has_rotations;
  if (reference.format != TrajectoryFormat::kitti) return;
  options.association.method = AssociationMethod::index;
  if (options.stretches.unit == DeltaUnit::seconds) {
    throw std::runtime_error("--delta-unit s needs stamps, which KITTI's files do not have");
  }
}

/// An estimate that cannot be evaluated is told and left out; the others go on.
int evaluate_all(EvalOptions options) {
  const runs::Reference reference = runs::read_reference(options.reference);
  if (reference.is_foreign) {
    fmt::print(stderr, "note: {}: {}\n", reference.file.string(), reference.truth.what);
  }
  adapt(options.evaluation, reference);
  const std::vector<std::string> names = runs::estimate_names(options.estimates);
  std::vector<Evaluation> evaluations;
  std::vector<Trajectory> paths;  // aligned
  for (std::size_t i = 0; i < options.estimates.size(); ++i) {
    try {
      const Trajectory estimate = runs::read_estimate(options.estimates[i], reference);
      evaluations.push_back(
          evaluation::evaluate(names[i], reference.truth.poses, estimate, options.evaluation));
      paths.push_back(evaluation::aligned(estimate, evaluations.back().alignment));
    } catch (const std::exception& error) {
      fmt::print(stderr, "surefoot: {}: {}\n", names[i], error.what());
    }
  }
  if (evaluations.empty()) return process::kBadInput;
  draw_figures(options, reference.truth.poses, evaluations, paths);
  fmt::print("{}", table_of(evaluations, options.table));
  return evaluations.size() == options.estimates.size() ? process::kDone : process::kSomeFailed;
}

void add_format_option(CLI::App& command, TrajectoryFormat& format) {
  command_line::add_choice<TrajectoryFormat>(command, "--format", format,
                                             "Of all files: auto, tum or kitti",
                                             {{"auto", TrajectoryFormat::automatic},
                                              {"tum", TrajectoryFormat::tum},
                                              {"kitti", TrajectoryFormat::kitti}});
}

}  // namespace

void add_eval_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<EvalOptions>();
  CLI::App* command =
      app.add_subcommand("eval", "Compare trajectories with a reference (TUM or KITTI files)");
  command
      ->add_option("reference", options->reference.path,
                   "The true trajectory, or a recording with a gt.tum")
      ->required();
  command
      ->add_option("estimates", options->estimates,
                   "One trajectory or more, or folders that surefoot run has written")
      ->required();
  add_format_option(*command, options->reference.format);
  command
      ->add_option("--dataset", options->reference.dataset,
                   "The reference is this data set's: its file, its columns, and where what it "
                   "tells sits on the LiDAR; 'surefoot datasets' tells of each")
      ->check(command_line::one_of(io::dataset_names()))
      ->type_name("NAME");
  command->add_option("--truth-topic", options->reference.topic,
                      "Topic of the reference, where that is a bag");
  add_pairing_options(*command, options->evaluation.association);
  add_error_options(*command, options->evaluation);
  command
      ->add_option("--figure", options->figures,
                   "Draw the aligned trajectories to this .svg, .pdf or .png file; may be repeated")
      ->allow_extra_args(false);
  CLI::Option_group* output = command->add_option_group("output");
  const auto add_table = [&](const char* flag, TableFormat format, const char* help) {
    output->add_flag_callback(
        flag, [options, format] { options->table = format; }, help);
  };
  add_table("--json", TableFormat::json, "Print every figure as JSON");
  add_table("--csv", TableFormat::csv, "Print a line for each estimate and error");
  add_table("--latex", TableFormat::latex, "Print a table for a paper");
  output->require_option(0, 1);
  command->callback([options, &exit_code] { exit_code = evaluate_all(*options); });
}

}  // namespace surefoot::app
