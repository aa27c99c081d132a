// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "experiments/ablation_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>

namespace surefoot::experiments {

namespace {

struct Change {
  const char* contribution;
  const char* change;
  const char* equations;
  const char* settings;  ///< "key=value+key=value"
};

constexpr const char* kControl = "Nothing (control)";

// A limit that is never met switches off what is limited: no scan moves 10 m or turns 3 rad, no
// residual comes near 100 m.
const Change kPaperChanges[] = {
    {kControl, "source cubes 1.45 m", "", "downsample.source_voxel=1.45"},
    {kControl, "source cubes 1.475 m", "", "downsample.source_voxel=1.475"},
    {kControl, "source cubes 1.525 m", "", "downsample.source_voxel=1.525"},
    {kControl, "source cubes 1.55 m", "", "downsample.source_voxel=1.55"},

    {"Deskewing", "none", "(5)-(12)", "deskew.mode=none"},
    {"Deskewing", "constant velocity", "(6)-(9)", "deskew.mode=constant_velocity"},
    {"Deskewing", "no clamps", "(6)",
     "deskew.clamp_z=10+deskew.clamp_roll=3.2+deskew.clamp_pitch=3.2"},
    {"Deskewing", "clamps at zero", "(6)",
     "deskew.clamp_z=0+deskew.clamp_roll=0+deskew.clamp_pitch=0"},
    {"Deskewing", "K = 1", "(8)-(11)", "deskew.segments=1"},
    {"Deskewing", "K = 8", "(8)-(11)", "deskew.segments=8"},
    {"Deskewing", "K = 16", "(8)-(11)", "deskew.segments=16"},

    {"Two stages", "coupled, point to point", "(3)-(4)", "registration.mode=coupled"},
    {"Two stages", "coupled, point to plane", "(3)-(4)",
     "registration.mode=coupled+registration.coupled_residual=point_to_plane"},
    {"Two stages", "no vertical stage", "(21)-(34)", "vertical.sub_iterations=0"},
    {"Two stages", "one vertical update", "Alg. 1, 19", "vertical.sub_iterations=1"},
    {"Two stages", "vertical point to point", "(23)-(24)", "vertical.residual=point_to_point"},
    {"Two stages", "vertical from walls, too", "Alg. 1, 21", "vertical.min_normal_z=0"},

    {"Matches", "no relaxed radius", "(20)", "registration.early_iterations=0"},
    {"Matches", "on the map's surface", "(13)", "registration.target=surface"},
    {"Matches", "no horizontal kernel", "(19)", "horizontal.kernel_scale=100"},

    {"Vertical weights", "no weights at all", "(28)-(32)",
     "vertical.distance_decay=0+vertical.normal_power=0+vertical.near_suppression=1+"
     "vertical.kernel_scale=100"},
    {"Vertical weights", "no Omega", "(28)-(30)",
     "vertical.distance_decay=0+vertical.normal_power=0"},
    {"Vertical weights", "gamma: off", "(28)", "vertical.distance_decay=0"},
    {"Vertical weights", "gamma: half beta", "(28)", "vertical.distance_decay=0.05"},
    {"Vertical weights", "gamma: double beta", "(28)", "vertical.distance_decay=0.2"},
    {"Vertical weights", "eta: off", "(29)", "vertical.normal_power=0"},
    {"Vertical weights", "eta: root", "(29)", "vertical.normal_power=0.5"},
    {"Vertical weights", "eta: square", "(29)", "vertical.normal_power=2"},
    {"Vertical weights", "rho: off", "(31)",
     "vertical.near_suppression=1+vertical.kernel_scale=100"},
    {"Vertical weights", "rho: half scales", "(31)",
     "vertical.near_gate=0.15+vertical.kernel_scale=0.05"},
    {"Vertical weights", "rho: double scales", "(31)",
     "vertical.near_gate=0.6+vertical.kernel_scale=0.2"},

    {"Trust region", "off", "(34)", "vertical.trust_region=10"},
};

const Change kSurefootChanges[] = {
    {kControl, "1900 points", "", "knots.points=1900"},
    {kControl, "1950 points", "", "knots.points=1950"},
    {kControl, "2050 points", "", "knots.points=2050"},
    {kControl, "2100 points", "", "knots.points=2100"},

    {"Knots", "K = 1", "(9)-(11)", "knots.segments=1"},
    {"Knots", "K = 2", "(9)-(11)", "knots.segments=2"},
    {"Knots", "K = 4", "(9)-(11)", "knots.segments=4"},
    {"Knots", "K = 16", "(9)-(11)", "knots.segments=16"},

    {"Stiffness", "fluctuation not learnt", "", "knots.learning_rate=0"},
    {"Stiffness", "last scan forgotten", "", "knots.memory=0"},
    {"Stiffness", "last scan in full", "", "knots.memory=1"},
    {"Stiffness", "all residuals independent", "", "knots.independence=1"},

    {"Convergence", "narrow kernel from the start", "", "knots.kernel_start=0.1"},
    {"Convergence", "no second attempt", "", "knots.second_attempt=false"},

    {"Map", "finest grid alone", "", "knots.levels=1"},
    {"Map", "coarsest grid alone", "", "knots.levels=1+knots.finest_voxel=3.2"},
    {"Map", "full at 200 points a voxel", "", "knots.points_per_voxel=200"},
    {"Map", "no poles", "", "knots.slenderness=0"},
    {"Map", "no clouds", "", "knots.cloud_weight=0"},
    {"Map", "a ring's own plane, too", "", "knots.edge_on=0"},
};

struct Ablated {
  std::string method;
  std::span<const Change> changes;
};

const Ablated kAblated[] = {{"paper", kPaperChanges}, {"surefoot", kSurefootChanges}};

}  // namespace

const std::vector<std::string>& ablated_methods() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const Ablated& ablated : kAblated) result.push_back(ablated.method);
    return result;
  }();
  return names;
}

AblationPlan ablation_plan(const std::string& method) {
  for (const Ablated& ablated : kAblated) {
    if (method != ablated.method) continue;
    AblationPlan plan{{parse_variant(method)}, {{kControl, "as it is", ""}}, 1};
    for (const Change& change : ablated.changes) {
      plan.variants.push_back(parse_variant(method + '+' + change.settings));
      plan.changes.push_back({change.contribution, change.change, change.equations});
      if (plan.changes.back().contribution == kControl) ++plan.references;
    }
    return plan;
  }
  throw ConfigError(fmt::format("--method: nothing is known to ablate of '{}'; of {} there is",
                                method, fmt::join(ablated_methods(), ", ")));
}

}  // namespace surefoot::experiments
