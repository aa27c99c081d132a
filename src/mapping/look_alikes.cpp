// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "mapping/look_alikes.hpp"

#include <algorithm>
#include <numbers>
#include <vector>

#include "mapping/place_search.hpp"

namespace surefoot::mapping {

namespace {

constexpr int kSteps = 4;                // to each side
constexpr double kStep = 3.0;            // [m] what a registration finds its way over
constexpr double kApart = 1.5;           // [m] less is the same place
constexpr std::size_t kSlidRefined = 8;  // of all starts, the best ones

bool elsewhere(const SubmapAlignment& alignment, const Pose& fit) {
  const Eigen::Vector3d moved = alignment.T_target_source.translation - fit.translation;
  return moved.head<2>().norm() > kApart;
}

/// Registrations from starts on a grid about where the places fit, those that look best.
std::vector<SubmapAlignment> slid_about(const Pose& fit, const VerifiableSubmap& place_seen,
                                        const RegistrationSubmap& seen) {
  const RegistrationSubmap& place = place_seen.registration();
  const Eigen::Quaterniond from_slope = place_seen.submap().to_slope.conjugate();
  std::vector<SubmapAlignment> found;
  for (int x = -kSteps; x <= kSteps; ++x) {
    for (int y = -kSteps; y <= kSteps; ++y) {
      Pose start = fit;
      start.translation += from_slope * (kStep * Eigen::Vector3d(x, y, 0.0));
      const SubmapAlignment rough = align_roughly(place, seen, start);
      if (elsewhere(rough, fit)) found.push_back(rough);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.matched > b.matched; });
  if (found.size() > kSlidRefined) found.resize(kSlidRefined);
  for (SubmapAlignment& alignment : found) {
    alignment = align_submaps(place, seen, alignment.T_target_source, 1);
  }
  return found;
}

}  // namespace

bool fits_turned(const LoopCheck& check, const VerifiableSubmap& place,
                 const VerifiableSubmap& seen, const LoopLimits& limits) {
  for (const int quarters : {1, 2, 3}) {
    Pose start = check.alignment.T_target_source;
    start.rotation = start.rotation *
                     Eigen::AngleAxisd(quarters * std::numbers::pi / 2.0, Eigen::Vector3d::UnitZ());
    const LoopCheck turned = check_places(place, seen, turned_both_ways(start), limits);
    const AlignmentGap gap = gap_between(turned.alignment, check.alignment.T_target_source);
    if (turned.verdict == LoopVerdict::taken && gap.degrees > 45.0) return true;
  }
  return false;
}

double overlap_slid(const LoopCheck& check, const VerifiableSubmap& place,
                    const VerifiableSubmap& seen) {
  const Pose& fit = check.alignment.T_target_source;
  double most = 0.0;
  for (const SubmapAlignment& slid : slid_about(fit, place, seen.registration())) {
    if (!elsewhere(slid, fit)) continue;
    most = std::max(
        most, overlap_between(place.registration(), seen.registration(), slid.T_target_source));
  }
  return most;
}

}  // namespace surefoot::mapping
