// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "runs/method_parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <vector>

namespace surefoot::runs {

namespace {

/// Groups ("knots.") or single parameters ("map.radius").
using Names = std::span<const std::string_view>;

constexpr std::string_view kShared[] = {"preprocess.", "level.", "health."};
constexpr std::string_view kSurefoot[] = {"knots.", "map.radius", "motion_prior."};
constexpr std::string_view kPaper[] = {"motion_prior.", "deskew.",     "downsample.", "map.",
                                       "registration.", "horizontal.", "vertical."};
constexpr std::string_view kKissIcp[] = {"kiss_icp."};
constexpr std::string_view kIcp[] = {"icp."};
constexpr std::string_view kGenzIcp[] = {"genz_icp."};
constexpr std::string_view kFloam[] = {"floam."};
constexpr std::string_view kCtIcp[] = {"ct_icp."};

Names own_parameters(Method method) {
  switch (method) {
    case Method::surefoot:
      return kSurefoot;
    case Method::paper:
      return kPaper;
    case Method::kiss_icp:
      return kKissIcp;
    case Method::icp:
      return kIcp;
    case Method::genz_icp:
      return kGenzIcp;
    case Method::floam:
      return kFloam;
    case Method::ct_icp:
      break;
  }
  return kCtIcp;
}

bool is_among(std::string_view parameter, Names names) {
  return std::any_of(names.begin(), names.end(), [&](std::string_view name) {
    return name.ends_with('.') ? parameter.starts_with(name) : parameter == name;
  });
}

/// The plainest name of each method that reads it.
std::vector<std::string> readers_of(std::string_view parameter) {
  std::vector<std::string> names;
  std::vector<Method> seen;
  for (const std::string& name : methods()) {
    const Method method = method_config(name).method;
    if (std::find(seen.begin(), seen.end(), method) != seen.end()) continue;
    seen.push_back(method);
    if (reads_parameter(method, parameter)) names.push_back(name);
  }
  return names;
}

std::string name_of(Method method) {
  for (const std::string& name : methods()) {
    if (method_config(name).method == method) return name;
  }
  return {};
}

}  // namespace

bool reads_parameter(Method method, std::string_view parameter) {
  // Its own share of matches takes this one's place.
  if (method == Method::surefoot && parameter == "health.min_match_ratio") return false;
  return is_among(parameter, kShared) || is_among(parameter, own_parameters(method));
}

void require_parameter(Method method, std::string_view parameter) {
  const std::vector<std::string> readers = readers_of(parameter);
  // What nobody reads does not exist, which set_parameter() says better.
  if (readers.empty() || reads_parameter(method, parameter)) return;
  throw ConfigError(fmt::format(
      "{}: method {} does not read it; what reads it: {}. 'surefoot config --method {}' shows what "
      "{} reads",
      parameter, name_of(method), fmt::join(readers, ", "), name_of(method), name_of(method)));
}

}  // namespace surefoot::runs
