// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot ablate: what each contribution of a method is worth, switched one by one.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "ablation_plan.hpp"
#include "commands.hpp"
#include "comparison_engine.hpp"
#include "dataset/file_writer.hpp"
#include "evaluation/ablation_tables.hpp"
#ifdef SUREFOOT_HAS_PICTURES
#include "ablation_figure.hpp"
#endif

namespace surefoot::app {

namespace {

struct AblateOptions {
  CompareOptions comparison;
  std::string method = "paper";
};

/// The files of the ablation, beside those of the comparison that it stands on.
void write_ablation(const AblateOptions& ablate_options, const evaluation::Ablation& ablation,
                    const evaluation::Comparison& comparison) {
  const CompareOptions& options = ablate_options.comparison;
  const auto write = [&](const char* name, const std::string& text) {
    dataset::write_whole_file(options.output / name, text);
  };
#ifdef SUREFOOT_HAS_PICTURES
  if (options.figures) draw_ablation(ablation, ablate_options.method, options.output / "figures");
#endif
  write("ablation.md", evaluation::ablation_markdown(ablation, comparison));
  write("ablation.csv", evaluation::ablation_csv(ablation));
  write("ablation.json", evaluation::ablation_json(ablation, comparison));
}

int ablate(const AblateOptions& options) {
  const AblationPlan plan = ablation_plan(options.method);
  for (const MethodVariant& variant : plan.variants) {
    (void)variant_config(variant, options.comparison.settings);
  }
  const auto inputs = prepare_inputs(options.comparison);
  if (!inputs) return kInterrupted;
  for (const CompareInput& input : *inputs) (void)read_truth(input);  // throws where there is none
  const auto results = run_comparison(options.comparison, *inputs, plan.variants);
  if (!results) return kInterrupted;
  const evaluation::Comparison& comparison = results->comparison;
  const evaluation::Ablation ablation =
      evaluation::ablate(comparison, plan.changes, plan.references);
  CompareOptions without_figures = options.comparison;
  without_figures.figures = false;  // dozens of paths in one panel show nothing
  write_results(without_figures, *results);
  write_ablation(options, ablation, comparison);
  fmt::print("{}\nresults: {}\n", evaluation::ablation_markdown(ablation, comparison),
             options.comparison.output.string());
  return exit_code_of(comparison);
}

}  // namespace

void add_ablate_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<AblateOptions>();
  options->comparison.output = "results/ablation";
  options->comparison.no_map = true;
  CLI::App* command = app.add_subcommand(
      "ablate", "Switch a method's contributions one by one, on recordings with truth");
  command
      ->add_option("--method", options->method,
                   fmt::format("One of {}", fmt::join(ablated_methods(), ", ")))
      ->capture_default_str();
  add_shared_options(*command, options->comparison);
  command->callback([options, &exit_code] {
    options->comparison.passed.emplace_back("--no-report");
    exit_code = ablate(*options);
  });
}

}  // namespace surefoot::app
