// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "checks/figures.hpp"

#include <cmath>
#include <map>

#include "surefoot/seconds.hpp"

namespace surefoot::checks {
namespace {

using io::PointTimes;
using io::spread_of;

double count_of(std::size_t value) { return static_cast<double>(value); }

/// Those that occur in at least every tenth scan: a stray number is no ring.
std::vector<std::uint16_t> usual_rings(const std::vector<ScanFacts>& scans) {
  constexpr double kUsual = 0.1;
  std::map<std::uint16_t, std::size_t> counts;
  std::size_t readable = 0;
  for (const ScanFacts& scan : scans) {
    for (const std::uint16_t ring : scan.rings) ++counts[ring];
    readable += scan.error.empty() ? 1 : 0;
  }
  std::vector<std::uint16_t> rings;
  for (const auto& [ring, count] : counts) {
    if (count_of(count) >= kUsual * count_of(readable)) rings.push_back(ring);
  }
  return rings;
}

/// One value of every scan that could be read and of which `choose` is true.
template <typename Value, typename Choose>
std::vector<double> values_of(const std::vector<ScanFacts>& scans, Value&& value, Choose&& choose) {
  std::vector<double> values;
  for (const ScanFacts& scan : scans) {
    if (scan.error.empty() && choose(scan)) values.push_back(value(scan));
  }
  return values;
}

void add_stamps(const std::vector<ScanFacts>& scans, Figures& figures) {
  std::vector<double> steps, forward, mended;
  const ScanFacts* last = nullptr;
  for (const ScanFacts& scan : scans) {
    if (!scan.error.empty()) continue;
    if (last != nullptr) {
      steps.push_back(seconds(scan.stamp_ns - last->stamp_ns));
      if (steps.back() > 0.0) forward.push_back(steps.back());
      mended.push_back(seconds(scan.mended_ns.value_or(scan.stamp_ns) -
                               last->mended_ns.value_or(last->stamp_ns)));
    } else {
      figures.first_stamp_ns = scan.stamp_ns;
    }
    figures.last_stamp_ns = scan.stamp_ns;
    last = &scan;
  }
  figures.interval_s = spread_of(steps);
  // Where all stand still, as a run mends them.
  figures.usual_interval_s = io::usual_interval(forward.empty() ? mended : forward);
}

}  // namespace

Figures figures_of(const std::vector<ScanFacts>& scans) {
  Figures figures;
  double points = 0.0, not_finite = 0.0, zero = 0.0;
  for (const ScanFacts& scan : scans) {
    ++(scan.error.empty() ? figures.scans : figures.unreadable);
    points += count_of(scan.points);
    not_finite += count_of(scan.not_finite);
    zero += count_of(scan.zero);
    figures.turned_deg += std::abs(scan.turned_deg);
  }
  figures.not_finite_share = points > 0.0 ? not_finite / points : 0.0;
  figures.zero_share = points > 0.0 ? zero / points : 0.0;
  const auto any = [](const ScanFacts&) { return true; };
  const auto seen = [](const ScanFacts& scan) { return scan.returns > 0; };
  const auto timed = [](const ScanFacts& scan) { return scan.times == PointTimes::there; };
  const auto spread = [&scans](auto&& value, auto&& choose) {
    return spread_of(values_of(scans, value, choose));
  };
  figures.points = spread([](const ScanFacts& s) { return count_of(s.points); }, any);
  figures.returns = spread([](const ScanFacts& s) { return count_of(s.returns); }, any);
  figures.duration_s = spread([](const ScanFacts& s) { return s.last_s - s.first_s; }, timed);
  figures.first_time_s = spread([](const ScanFacts& s) { return s.first_s; }, timed);
  figures.last_time_s = spread([](const ScanFacts& s) { return s.last_s; }, timed);
  figures.around = spread([](const ScanFacts& s) { return s.seen_around; }, seen);
  figures.range_m = spread([](const ScanFacts& s) { return s.middle; }, seen);
  figures.range_m.least = spread([](const ScanFacts& s) { return s.nearest; }, seen).least;
  figures.range_m.greatest = spread([](const ScanFacts& s) { return s.farthest; }, seen).greatest;
  figures.rings = usual_rings(scans);
  add_stamps(scans, figures);
  return figures;
}

}  // namespace surefoot::checks
