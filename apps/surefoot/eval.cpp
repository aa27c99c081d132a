// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot eval: how far estimated trajectories are from a reference.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "command_line/option_checks.hpp"
#include "commands.hpp"
#include "evaluation/tables.hpp"
#include "evaluation_options.hpp"
#include "experiments/estimate_evaluation.hpp"
#include "piped_input.hpp"
#include "process/exit_codes.hpp"

namespace surefoot::app {
namespace {

using evaluation::Evaluation;
using runs::TrajectoryFormat;

enum class TableFormat { text, json, csv, latex };

struct EvalOptions {
  experiments::EvaluationRequest request;
  TableFormat table = TableFormat::text;
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

/// An estimate that cannot be evaluated is told and left out.
int evaluate_all(const EvalOptions& options) {
  take_piped_text(options.request.reference.path);
  for (const auto& estimate : options.request.estimates) take_piped_text(estimate);
  const std::vector<Evaluation> evaluations = experiments::evaluate_estimates(
      options.request,
      {[](const std::string& text) { fmt::print(stderr, "note: {}\n", text); },
       [](const std::string& text) { fmt::print(stderr, "surefoot: {}\n", text); }});
  if (evaluations.empty()) return process::kBadInput;
  fmt::print("{}", table_of(evaluations, options.table));
  return evaluations.size() == options.request.estimates.size() ? process::kDone
                                                                : process::kSomeFailed;
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
  experiments::EvaluationRequest& request = options->request;
  CLI::App* command =
      app.add_subcommand("eval", "Compare trajectories with a reference (TUM or KITTI files)");
  command
      ->add_option("reference", request.reference.path,
                   "The true trajectory, or a recording with a gt.tum")
      ->required();
  command
      ->add_option(
          "estimates", request.estimates,
          "One trajectory or more (TUM, KITTI, EuRoC, a bag), or folders that surefoot run "
          "has written")
      ->required();
  add_format_option(*command, request.reference.format);
  command
      ->add_option("--dataset", request.reference.dataset,
                   "The reference is this data set's: its file, its columns, and where what it "
                   "tells sits on the LiDAR; 'surefoot datasets' tells of each")
      ->check(command_line::one_of(io::dataset_names()))
      ->type_name("NAME");
  command->add_option("--truth-topic", request.reference.topic,
                      "Topic of the reference, where that is a bag");
  command->add_option("--topic", request.estimate_topic,
                      "Topic of the estimates, where those are bags");
  add_pairing_options(*command, request.evaluation.association);
  add_error_options(*command, request.evaluation);
  command
      ->add_option("--figure", request.figures,
                   "Draw the aligned trajectories to this .svg, .pdf or .png file; may be repeated")
      ->allow_extra_args(false);
  command->add_option("--pose-errors", request.pose_errors,
                      "Write every pose's errors after alignment to this .csv file");
  command->add_flag("--overwrite", request.overwrite,
                    "Write also where a file is that no eval has made");
  const auto add_table = [&](const char* flag, TableFormat format, const char* help) {
    return command->add_flag_callback(
        flag, [options, format] { options->table = format; }, help);
  };
  CLI::Option* json = add_table("--json", TableFormat::json, "Print every figure as JSON");
  CLI::Option* csv =
      add_table("--csv", TableFormat::csv, "Print a line for each estimate and error");
  add_table("--latex", TableFormat::latex, "Print a table for a paper")->excludes(json, csv);
  csv->excludes(json);
  command->callback([options, &exit_code] { exit_code = evaluate_all(*options); });
}

}  // namespace surefoot::app
