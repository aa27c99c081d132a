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
#include "experiments/ablation_plan.hpp"
#include "experiments/variation_results.hpp"

namespace surefoot::app {

namespace {

struct AblateOptions {
  experiments::CompareOptions comparison;
  std::string method = "paper";
};

int ablate(const AblateOptions& options) {
  const experiments::AblationPlan plan = experiments::ablation_plan(options.method);
  return run_comparison(
      options.comparison, plan.variants, [&](const experiments::CompareResults& results) {
        fmt::print("{}\nresults: {}\n",
                   experiments::write_ablation(options.comparison, options.method, plan, results),
                   options.comparison.output.string());
      });
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
