// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/method_parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace surefoot::runs {

namespace {

std::vector<std::string> readers_of(std::string_view parameter) {
  std::vector<std::string> names;
  for (const std::string& name : methods()) {
    const Config config = method_config(name);
    const bool variant = config.method != name;  // reads what its method does
    if (!variant && reads_parameter(config, parameter)) names.push_back(name);
  }
  return names;
}

}  // namespace

void require_parameter(const Config& config, std::string_view parameter) {
  if (reads_parameter(config, parameter)) return;
  const std::vector<std::string> readers = readers_of(parameter);
  if (readers.empty()) return;
  throw ConfigError(fmt::format(
      "{}: method {} does not read it; what reads it: {}. 'surefoot config --method {}' shows what "
      "{} reads",
      parameter, config.method, fmt::join(readers, ", "), config.method, config.method));
}

}  // namespace surefoot::runs
