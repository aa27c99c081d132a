// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
//
// surefoot compare: methods against each other, on recordings with truth.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "compare_options.hpp"
#include "evaluation/comparison_tables.hpp"
#include "experiments/method_variant.hpp"

namespace surefoot::app {

namespace {

void print_results(const experiments::CompareOptions& options,
                   const evaluation::Comparison& comparison) {
  const bool terminal = isatty(STDOUT_FILENO) != 0;
  fmt::print("{}",
             evaluation::tables_markdown(comparison, terminal ? evaluation::terminal_marks()
                                                              : evaluation::markdown_marks()));
  fmt::print("\nresults: {}\n", options.output.string());
}

int compare(const experiments::CompareOptions& options) {
  return run_comparison(options, experiments::parse_variants(options.methods),
                        [&](const experiments::CompareResults& results) {
                          experiments::write_results(options, results);
                          print_results(options, results.comparison);
                        });
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<experiments::CompareOptions>();
  CLI::App* command =
      app.add_subcommand("compare", "Run methods on recordings with truth; tables and figures");
  add_compare_options(*command, *options);
  command->callback([options, &exit_code] { exit_code = compare(*options); });
}

}  // namespace surefoot::app
