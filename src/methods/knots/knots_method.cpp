// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include <cmath>

#include "config/field_text.hpp"
#include "config/method.hpp"
#include "methods/knots/knot_segments.hpp"
#include "methods/registry.hpp"

namespace surefoot {

namespace {

#define SLOT(member) [](Config& c) { return field_slot(c.member); }

constexpr const char* kMethod = "docs/method.md";

const ConfigField kFields[] = {
    {"knots.segments", SLOT(knots.segments), "8", "", 1, 64,
     "K: segments of constant velocity in a scan", kMethod},
    {"knots.points", SLOT(knots.points), "2000", "", 100, 1e6,
     "points to be registered, about; the cubes they are thinned to follow the scene", kMethod},
    {"knots.map_points", SLOT(knots.map_points), "3000", "", 100, 1e6,
     "points of a scan that enter the map, about: one per cube, and the cubes follow the scene, up "
     "to the finest voxel, or farther where more than four times as many were left",
     kMethod},
    {"knots.map_voxel", SLOT(knots.map_voxel), "0.1", "m", 0.01, 10.0, "finest of those cubes",
     kMethod},
    {"knots.finest_voxel", SLOT(knots.finest_voxel), "0.2", "m", 0.05, 10.0,
     "voxel of the map's finest grid", kMethod},
    {"knots.levels", SLOT(knots.levels), "5", "", 1, 8,
     "grids of the map, each twice as coarse as the one before", kMethod},
    {"knots.divided_at", SLOT(knots.divided_at), "12", "", 0, 1e6,
     "the finest grid divides voxels of the next one that have so many points, and empties what "
     "that "
     "one empties; 0: it takes all points, and asks the beams itself",
     kMethod},
    {"knots.points_per_voxel", SLOT(knots.points_per_voxel), "800", "", 3, 1e6,
     "a full voxel takes no more points", kMethod},
    {"knots.min_points", SLOT(knots.min_points), "6", "", 3, 1000, "points that a surfel needs",
     kMethod},
    {"knots.breadth", SLOT(knots.breadth), "0.15", "voxels", 0.0, 0.5,
     "a surfel's points spread at least so far along it (standard deviation)", kMethod},
    {"knots.flatness", SLOT(knots.flatness), "0.06", "", 0.0, 1.0,
     "variance across a plane at most, as a share of that along it", kMethod},
    {"knots.slenderness", SLOT(knots.slenderness), "0.1", "", 0.0, 1.0,
     "variance across a pole at most, as a share of that along it", kMethod},
    {"knots.edge_on", SLOT(knots.edge_on), "0.06", "", 0.0, 1.0,
     "sine of the angle to a plane at which its points were seen, at least (RMS): below, it is the "
     "plane that one ring sweeps",
     kMethod},
    {"knots.ring_gap", SLOT(knots.ring_gap), "0.035", "rad", 0.0, 1.0,
     "angle between a LiDAR's rings, about: a cloud (neither plane nor pole) is widened across the "
     "rings by what may lie that far on either side",
     kMethod},
    {"knots.cloud_weight", SLOT(knots.cloud_weight), "0.5", "", 0.0, 1.0,
     "weight of a cloud's residuals, those of planes and poles being 1; 0: no clouds", kMethod},
    {"knots.gone_after", SLOT(knots.gone_after), "2", "scans", 0, 1000,
     "what so many scans' beams, and knots.gone_share as many as ever hit it, went through since "
     "one last hit it has moved away and is forgotten; 0: never",
     kMethod},
    {"knots.noise", SLOT(knots.noise), "0.02", "m", 1e-4, 1.0,
     "standard deviation of a point's distance to its surfel", kMethod},
    {"knots.independence", SLOT(knots.independence), "0.1", "", 1e-6, 1.0,
     "share of the residuals that count as independent", kMethod},
    {"knots.correlation_time", SLOT(knots.correlation_time), "0.1", "s", 1e-3, 10.0,
     "time after which the velocity's fluctuation is forgotten", kMethod},
    {"knots.learning_rate", SLOT(knots.learning_rate), "0.05", "", 0.0, 1.0,
     "how fast the velocity's fluctuation is learnt, per scan", kMethod},
    {"knots.mean_rate", SLOT(knots.mean_rate), "0.1", "", 0.0, 1.0,
     "how fast the mean velocity is learnt, per scan", kMethod},
    {"knots.memory", SLOT(knots.memory), "0.3", "", 0.0, 1.0,
     "share of what is known of the last knots that the next scan relies on", kMethod},
    {"knots.kernel_start", SLOT(knots.kernel_start), "1.5", "m", 1e-3, 10.0,
     "the first iterations' kernel is wider than the last ones' by this over knots.kernel_end, and "
     "asks for no finer voxels than this",
     kMethod},
    {"knots.kernel_end", SLOT(knots.kernel_end), "0.1", "m", 1e-3, 10.0, "see knots.kernel_start",
     kMethod},
    {"knots.kernel_decay", SLOT(knots.kernel_decay), "0.8", "", 0.0, 0.99,
     "factor on the kernel's width per iteration, twice where nothing moves", kMethod},
    {"knots.max_iterations", SLOT(knots.max_iterations), "100", "", 1, 1000,
     "iterations at most: where nothing is flat points change their surfels for long", kMethod},
    {"knots.convergence", SLOT(knots.convergence), "0.001", "m, rad", 1e-9, 1.0,
     "stop when no knot moves by more, once the kernel is at its end", kMethod},
    {"knots.second_attempt", SLOT(knots.second_attempt), "true", "", 0, 0,
     "try a registration with an unusual misfit again, more slowly", kMethod},
    {"knots.suspicious", SLOT(knots.suspicious), "1.25", "", 1.0, 100.0,
     "a registration whose misfit or disagreement is so many times the usual is tried again; fewer "
     "where clouds hold it",
     kMethod},
    {"knots.misfit_margin", SLOT(knots.misfit_margin), "0.15", "", 0.0, 1.0,
     "beyond twice the usual misfit to what was seen and this, a registration is tried again with "
     "knots.looser",
     kMethod},
    {"knots.usual_rate", SLOT(knots.usual_rate), "0.1", "", 0.0, 1.0,
     "how fast the usual misfit and what the covariance is made of are learnt, per scan", kMethod},
    {"knots.unseen_weight", SLOT(knots.unseen_weight), "0.2", "", 0.0, 1.0,
     "among attempts, a point where the map has no surfel counts as this: who climbs a stair sees "
     "much that is new, and a wrong pose that brings some of it near an old wall must not win",
     kMethod},
    {"knots.swing", SLOT(knots.swing), "2", "rad/s", 0.0, 100.0,
     "attempts begin with so much more roll or pitch, or twice the pitch: at the foot of a stair a "
     "body pitches by some degrees within a scan",
     kMethod},
    {"knots.swing_kernel", SLOT(knots.swing_kernel), "0.2", "m", 1e-3, 10.0,
     "their first kernel, narrow enough to leave each where it is", kMethod},
    {"knots.turn", SLOT(knots.turn), "1", "rad/s", 0.0, 100.0,
     "attempts begin with so much more turning, two and three times as much", kMethod},
    {"knots.looser", SLOT(knots.looser), "3", "", 1.0, 1000.0,
     "attempts that turn, and the last ones, take the velocity to fluctuate by so many times the "
     "usual",
     kMethod},
    {"knots.gone_share", SLOT(knots.gone_share), "0.25", "", 0.0, 1000.0,
     "see knots.gone_after: share of the scans that ever hit it", kMethod},
    {"knots.lost_probability", SLOT(knots.lost_probability), "0.1", "", 0.0, 1.0,
     "it is lost when its pose is wrong with a greater probability: a wrong pose taken for right "
     "costs nine times what a right one taken for wrong does; 1: never",
     kMethod},
    {"knots.search_scans", SLOT(knots.search_scans), "60", "scans", 0, 1e6,
     "so long a lost one searches for itself, until a new segment with a map of its own begins",
     kMethod},
};

#undef SLOT

constexpr const char* kAlsoReads[] = {"map.radius", "motion_prior.", "health.min_information",
                                      "health.restart_after"};
// To it the share of matches is evidence, and none is too small by itself.
constexpr const char* kDoesNotRead[] = {"health.min_match_ratio"};

void check(const Config& config) {
  if (config.knots.points_per_voxel < 2 * config.knots.min_points) {
    throw ConfigError("knots.points_per_voxel (" + number_text(config.knots.points_per_voxel) +
                      ") must be at least twice knots.min_points (" +
                      number_text(config.knots.min_points) + "), which a pole needs");
  }
  const double narrowing = config.knots.kernel_start / config.knots.kernel_end;
  const int at_most = 2 * (config.knots.max_iterations - 1);  // twice where nothing moves
  if (std::pow(config.knots.kernel_decay, at_most) * narrowing > 1.0) {
    throw ConfigError("knots.kernel_decay (" + number_text(config.knots.kernel_decay) +
                      ") does not narrow the kernel from knots.kernel_start (" +
                      number_text(config.knots.kernel_start) + " m) to knots.kernel_end (" +
                      number_text(config.knots.kernel_end) + " m) within knots.max_iterations (" +
                      number_text(config.knots.max_iterations) +
                      "): no registration would end converged");
  }
}

}  // namespace

const Method& knots_method() {
  static const Method method = {
      .name = "surefoot",
      .fields = kFields,
      .also_reads = kAlsoReads,
      .does_not_read = kDoesNotRead,
      .check = check,
      .presets =
          [] {
            return std::vector<Preset>{{"surefoot", Config()}};
          },
      .make_front_end = make_front_end<KnotSegments>,
  };
  return method;
}

}  // namespace surefoot
