// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "report/map_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "report/base64.hpp"
#include "report/map_thinning.hpp"
#include "surefoot/quantile.hpp"

namespace surefoot::report {

namespace {

using Json = nlohmann::ordered_json;

struct Interval {
  double low = 0.0, high = 0.0;
};

/// The value in steps of `Step`'s whole range over the interval; what lies outside goes to the
/// ends, what is no number to the lower one.
template <typename Step>
Step quantised(double value, const Interval& interval) {
  constexpr double kSteps = std::numeric_limits<Step>::max();
  const double width = interval.high - interval.low;
  const double at = width > 0.0 ? (value - interval.low) / width : 0.0;
  return static_cast<Step>(at > 0.0 ? std::lround(kSteps * std::min(at, 1.0)) : 0);
}

template <typename T>
std::vector<T> chosen(const std::vector<T>& values, const std::vector<std::uint32_t>& at) {
  std::vector<T> result;
  result.reserve(at.size());
  for (const std::uint32_t i : at) result.push_back(values[i]);
  return result;
}

/// Between the quantiles, so that a few glaring returns do not make all others dark.
Interval between_quantiles(std::vector<float> values, double low, double high) {
  std::erase_if(values, [](float value) { return !std::isfinite(value); });
  if (values.empty()) return {};
  return {quantile(values, low), quantile(values, high)};
}

template <typename Step>
Json series_json(const std::vector<float>& values, const Interval& interval) {
  std::vector<Step> steps;
  steps.reserve(values.size());
  for (const float value : values) steps.push_back(quantised<Step>(value, interval));
  return {{"low", interval.low},
          {"high", interval.high},
          {"values", base64_of(std::span<const Step>(steps))}};
}

}  // namespace

Json points_json(const std::vector<Eigen::Vector3f>& points) {
  Eigen::Vector3f low = points.front(), high = low;
  for (const Eigen::Vector3f& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  std::vector<std::uint16_t> steps;
  steps.reserve(3 * points.size());
  for (const Eigen::Vector3f& point : points) {
    for (int axis = 0; axis < 3; ++axis) {
      steps.push_back(quantised<std::uint16_t>(point[axis], {low[axis], high[axis]}));
    }
  }
  return {{"low", {low.x(), low.y(), low.z()}},
          {"high", {high.x(), high.y(), high.z()}},
          {"values", base64_of(std::span<const std::uint16_t>(steps))}};
}

Json map_json(const MapCloud& map, std::size_t budget) {
  for (const std::vector<float>* values : {&map.intensities, &map.first_seen}) {
    if (!values->empty() && values->size() != map.points.size()) {
      throw std::invalid_argument("a map of " + std::to_string(map.points.size()) +
                                  " points with " + std::to_string(values->size()) +
                                  " intensities or times");
    }
  }
  const ThinnedCloud thinned = thin_cloud(map.points, budget);
  if (thinned.kept.empty()) return nullptr;
  Json json = {
      {"points", map.points.size()}, {"shown", thinned.kept.size()},
      {"cube_m", thinned.cube},      {"positions", points_json(chosen(map.points, thinned.kept))},
      {"intensity", nullptr},        {"first_seen_s", nullptr}};
  if (!map.intensities.empty()) {
    const std::vector<float> values = chosen(map.intensities, thinned.kept);
    json["intensity"] = series_json<std::uint8_t>(values, between_quantiles(values, 0.01, 0.98));
  }
  if (!map.first_seen.empty()) {
    const std::vector<float> values = chosen(map.first_seen, thinned.kept);
    json["first_seen_s"] = series_json<std::uint16_t>(values, between_quantiles(values, 0.0, 1.0));
  }
  return json;
}

}  // namespace surefoot::report
