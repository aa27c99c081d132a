// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/comparison_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>

namespace surefoot::experiments {

void check_passed(const std::vector<std::string>& passed) {
  constexpr std::array<std::string_view, 12> kOwn = {
      "--set",    "--config", "--method", "--threads", "--start",      "--count",
      "--stride", "--output", "--no-map", "--quiet",   "--no-picture", "--overwrite"};
  for (const std::string& argument : passed) {
    const std::string_view name = std::string_view(argument).substr(0, argument.find('='));
    const bool is_short = name.starts_with("-o") || name.starts_with("-q");  // also -oFOLDER
    if (!is_short && std::find(kOwn.begin(), kOwn.end(), name) == kOwn.end()) continue;
    throw std::invalid_argument(fmt::format(
        "--pass={}: is set for every run by the comparison itself, by its own flags and variants",
        argument));
  }
}

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
