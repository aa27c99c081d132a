// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot sweep: what a parameter's value does to the error, over several recordings with truth.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "compare_options.hpp"
#include "experiments/sweep.hpp"
#include "experiments/variation_results.hpp"

namespace surefoot::app {

namespace {

struct SweepOptions {
  experiments::CompareOptions comparison;
  std::string method = "surefoot";
  std::vector<std::string> variations;
};

int sweep(const SweepOptions& options) {
  const experiments::SweepPlan plan = experiments::sweep_plan(options.method, options.variations);
  return run_comparison(
      options.comparison, plan.variants, [&](const experiments::CompareResults& results) {
        fmt::print("{}", experiments::write_sweep(options.comparison, plan, results));
        if (options.comparison.quiet) return;
        fmt::print(stderr, "results: {}\n", options.comparison.output.string());
      });
}

}  // namespace

void add_sweep_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<SweepOptions>();
  options->comparison.output = "results/sweep";
  options->comparison.no_map = true;
  options->comparison.needs_every_truth = true;
  options->comparison.evaluation.association.method = evaluation::AssociationMethod::interpolate;
  options->comparison.evaluation.stretches = {};  // from scan to scan
  CLI::App* command = app.add_subcommand(
      "sweep", "Try values of parameters, one at a time, on recordings with truth");
  command
      ->add_option("--vary", options->variations,
                   "key=value,value,... or key=first:last:step; may be repeated")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--method", options->method, "Whose parameters are varied")
      ->capture_default_str();
  add_shared_options(*command, options->comparison);
  command->callback([options, &exit_code] {
    options->comparison.passed.emplace_back("--no-report");
    exit_code = sweep(*options);
  });
}

}  // namespace surefoot::app
