// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot ablate: what each contribution of a method is worth, switched one by one.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "compare_options.hpp"
#include "evaluation/ablation_tables.hpp"
#include "experiments/ablation_plan.hpp"
#include "experiments/comparison_engine.hpp"
#include "io/file_writer.hpp"
#include "process/exit_codes.hpp"
#ifdef SUREFOOT_HAS_PICTURES
#include "experiments/ablation_figure.hpp"
#endif

namespace surefoot::app {

namespace {

struct AblateOptions {
  experiments::CompareOptions comparison;
  std::string method = "paper";
};

/// The files of the ablation, beside those of the comparison that it stands on.
void write_ablation(const AblateOptions& ablate_options, const evaluation::Ablation& ablation,
                    const evaluation::Comparison& comparison) {
  const experiments::CompareOptions& options = ablate_options.comparison;
  const auto write = [&](const char* name, const std::string& text) {
    io::write_whole_file(options.output / name, text);
  };
#ifdef SUREFOOT_HAS_PICTURES
  if (options.figures) {
    experiments::draw_ablation(ablation, ablate_options.method, options.output / "figures");
  }
#endif
  write("ablation.md", evaluation::ablation_markdown(ablation, comparison));
  write("ablation.csv", evaluation::ablation_csv(ablation));
  write("ablation.json", evaluation::ablation_json(ablation, comparison));
}

int ablate(const AblateOptions& options) {
  const experiments::AblationPlan plan = experiments::ablation_plan(options.method);
  const auto results = experiments::compare_variants(options.comparison, plan.variants);
  if (!results) return process::kInterrupted;
  const evaluation::Comparison& comparison = results->comparison;
  const evaluation::Ablation ablation =
      evaluation::ablate(comparison, plan.changes, plan.references);
  experiments::CompareOptions without_figures = options.comparison;
  without_figures.figures = false;  // dozens of paths in one panel show nothing
  experiments::write_results(without_figures, *results);
  write_ablation(options, ablation, comparison);
  fmt::print("{}\nresults: {}\n", evaluation::ablation_markdown(ablation, comparison),
             options.comparison.output.string());
  return experiments::exit_code_of(comparison);
}

}  // namespace

void add_ablate_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<AblateOptions>();
  options->comparison.output = "results/ablation";
  options->comparison.no_map = true;
  options->comparison.needs_every_truth = true;
  CLI::App* command = app.add_subcommand(
      "ablate", "Switch a method's contributions one by one, on recordings with truth");
  command
      ->add_option("--method", options->method,
                   fmt::format("One of {}", fmt::join(experiments::ablated_methods(), ", ")))
      ->capture_default_str();
  add_shared_options(*command, options->comparison);
  command->callback([options, &exit_code] {
    options->comparison.passed.emplace_back("--no-report");
    exit_code = ablate(*options);
  });
}

}  // namespace surefoot::app
