// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/comparison_options.hpp"

namespace surefoot::experiments {

std::vector<std::string> run_arguments(const CompareOptions& options) {
  std::vector<std::string> arguments = {"--threads", std::to_string(options.threads)};
  const auto add = [&](const char* flag, std::size_t value) {
    arguments.insert(arguments.end(), {flag, std::to_string(value)});
  };
  if (options.start > 0) add("--start", options.start);
  if (options.count > 0) add("--count", options.count);
  if (options.stride > 1) add("--stride", options.stride);
  if (options.no_map) arguments.push_back("--no-map");
  arguments.insert(arguments.end(), options.passed.begin(), options.passed.end());
  return arguments;
}

}  // namespace surefoot::experiments
