// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot compare: methods against each other, on recordings with truth.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "comparison_engine.hpp"
#include "evaluation/comparison_tables.hpp"

namespace surefoot::app {

namespace {

void print_results(const CompareOptions& options, const evaluation::Comparison& comparison) {
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  fmt::print("{}",
             evaluation::tables_markdown(comparison, terminal ? evaluation::terminal_marks()
                                                              : evaluation::markdown_marks()));
  fmt::print("\nresults: {}\n", options.output.string());
}

int compare(const CompareOptions& options) {
  const std::vector<MethodVariant> variants = parse_variants(options.methods);
  for (const MethodVariant& variant : variants) (void)variant_config(variant, options.settings);
  const auto inputs = prepare_inputs(options);
  if (!inputs) return kInterrupted;
  const auto results = run_comparison(options, *inputs, variants);
  if (!results) return kInterrupted;
  write_results(options, *results);
  print_results(options, results->comparison);
  return exit_code_of(results->comparison);
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
      app.add_subcommand("compare", "Run methods on recordings with truth; tables and figures");
  add_compare_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = compare(*options); });
}

}  // namespace surefoot::app
