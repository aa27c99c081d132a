// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/variation_results.hpp"

#include "evaluation/ablation_tables.hpp"
#include "io/file_writer.hpp"
#ifdef SUREFOOT_HAS_PICTURES
#include "experiments/ablation_figure.hpp"
#endif

namespace surefoot::experiments {

namespace {

/// Dozens of paths in one panel show nothing.
void write_without_figures(CompareOptions options, const CompareResults& results) {
  options.figures = false;
  write_results(options, results);
}

}  // namespace

std::string write_ablation(const CompareOptions& options,
                           [[maybe_unused]] const std::string& method, const AblationPlan& plan,
                           const CompareResults& results) {
  const evaluation::Comparison& comparison = results.comparison;
  const evaluation::Ablation ablation =
      evaluation::ablate(comparison, plan.changes, plan.references);
  write_without_figures(options, results);
#ifdef SUREFOOT_HAS_PICTURES
  if (options.figures) draw_ablation(ablation, method, options.output / "figures");
#endif
  std::string markdown = evaluation::ablation_markdown(ablation, comparison);
  io::write_whole_file(options.output / "ablation.md", markdown);
  io::write_whole_file(options.output / "ablation.csv", evaluation::ablation_csv(ablation));
  io::write_whole_file(options.output / "ablation.json",
                       evaluation::ablation_json(ablation, comparison));
  return markdown;
}

std::string write_sweep(const CompareOptions& options, const SweepPlan& plan,
                        const CompareResults& results) {
  const SweepResult table = sweep_of(results.comparison, plan.labels);
  write_without_figures(options, results);
  std::string markdown = sweep_markdown(table);
  io::write_whole_file(options.output / "sweep.md", markdown);
  io::write_whole_file(options.output / "sweep.csv", sweep_csv(table));
  io::write_whole_file(options.output / "sweep.json", sweep_json(table, results.comparison));
  return markdown;
}

}  // namespace surefoot::experiments
