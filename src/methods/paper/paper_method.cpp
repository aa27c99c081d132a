// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "config/field_text.hpp"
#include "config/method.hpp"
#include "methods/paper/paper_front_end.hpp"
#include "methods/paper/paper_parameters.hpp"
#include "methods/registry.hpp"

namespace surefoot {

namespace {

constexpr const char* kDeskewModes[] = {"none", "constant_velocity", "piecewise"};
constexpr const char* kRegistrationModes[] = {"decoupled", "coupled"};
constexpr const char* kTargetKinds[] = {"point", "surface"};
constexpr const char* kResiduals[] = {"point_to_point", "point_to_plane"};

#define SLOT(member) [](Config& c) { return field_slot(own_parameters<PaperParameters>(c).member); }
#define WORDS(member, words) \
  [](Config& c) { return field_slot(own_parameters<PaperParameters>(c).member, words); }

// "sweep": docs/config.md names the command and the recordings. "paper": its section.
constexpr const char* kPaper = "paper, section 3.2";
constexpr const char* kSweep = "sweep";

const ConfigField kFields[] = {
    {"deskew.mode", WORDS(deskew.mode, kDeskewModes), "piecewise", "", 0, 0,
     "how points are brought to the mid-scan instant", kPaper},
    {"deskew.segments", SLOT(deskew.segments), "4", "", 1, 64, "K: segments of a scan", kPaper},
    {"deskew.clamp_z", SLOT(deskew.clamp_z), "0.5", "m", 0.0, 10.0,
     "zeta_z: limit of the prior's vertical motion over a scan, eq. (6)", kPaper},
    {"deskew.clamp_roll", SLOT(deskew.clamp_roll), "0.2", "rad", 0.0, 3.2,
     "zeta_r: limit of the prior's roll over a scan, eq. (6)", kPaper},
    {"deskew.clamp_pitch", SLOT(deskew.clamp_pitch), "0.2", "rad", 0.0, 3.2,
     "zeta_p: limit of the prior's pitch over a scan, eq. (6)", kPaper},

    {"downsample.map_voxel", SLOT(downsample.map_voxel), "0.2", "m", 0.01, 10.0,
     "one point per cube of this size enters the map", kSweep},
    {"downsample.source_voxel", SLOT(downsample.source_voxel), "1.5", "m", 0.01, 10.0,
     "one point per cube of this size is registered", kSweep},
    {"downsample.min_points", SLOT(downsample.min_points), "400", "", 0, 1e6,
     "where fewer points would be registered, both cubes are halved, four times at most", kSweep},

    {"map.voxel_size", SLOT(map.voxel_size), "1.0", "m", 0.05, 10.0,
     "cell of the local map; normals are taken over 3 x 3 x 3 cells, eq. (21)", kSweep},
    {"map.points_per_voxel", SLOT(map.points_per_voxel), "12", "", 1, 64,
     "a full cell takes no more points", kSweep},
    {"map.min_spacing", SLOT(map.min_spacing), "0.15", "m", 0.0, 10.0,
     "a point nearer than this to one in its cell does not enter", kSweep},
    {"map.radius", [](Config& c) { return field_slot(c.map.radius); }, "100", "m", 5.0, 1000.0,
     "cells farther from the sensor leave the map", "preprocess.max_range"},

    {"registration.mode", WORDS(registration.mode, kRegistrationModes), "decoupled", "", 0, 0,
     "Algorithm 1's two stages, or one 6-DoF problem to compare with", "paper, section 3.3"},
    {"registration.coupled_residual", WORDS(registration.coupled_residual, kResiduals),
     "point_to_point", "", 0, 0, "residual of the coupled registration: eq. (13) or eq. (23)",
     kChosen},
    {"registration.target", WORDS(registration.target, kTargetKinds), "point", "", 0, 0,
     "q_i: the nearest map point, or the nearest place on the flat surface about it (method "
     "paper-surface)",
     "paper, section 3.3"},
    {"registration.max_iterations", SLOT(registration.max_iterations), "50", "", 1, 1000,
     "outer iterations at most", kSweep},
    {"registration.max_distance", SLOT(registration.max_distance), "1.0", "m", 0.01, 20.0,
     "d_max: correspondence distance, eq. (20)", kSweep},
    {"registration.relaxed_distance", SLOT(registration.relaxed_distance), "2.0", "m", 0.01, 20.0,
     "d_relaxed: correspondence distance of the early iterations, eq. (20)", kSweep},
    {"registration.early_iterations", SLOT(registration.early_iterations), "3", "", 0, 1000,
     "T_early: iterations with the relaxed distance, eq. (20)", kSweep},
    {"registration.convergence", SLOT(registration.convergence), "0.001", "m, rad", 0.0, 1.0,
     "stop when an outer iteration's whole update is below this", kSweep},

    {"horizontal.kernel_scale", SLOT(horizontal.kernel_scale), "0.6", "m", 1e-4, 100.0,
     "kappa_H: scale of the robust weight, eq. (19)", kSweep},

    {"vertical.residual", WORDS(vertical.residual, kResiduals), "point_to_plane", "", 0, 0,
     "residual of the vertical stage: eq. (23), or to compare with eq. (13)", "paper, section 3.3"},
    {"vertical.sub_iterations", SLOT(vertical.sub_iterations), "2", "", 0, 50,
     "U_V: vertical updates per outer iteration", kSweep},
    {"vertical.min_neighbours", SLOT(vertical.min_neighbours), "8", "", 3, 1000,
     "N_min: map points that a normal needs", kSweep},
    {"vertical.min_normal_z", SLOT(vertical.min_normal_z), "0.5", "", 0.0, 1.0,
     "tau_n: least |n_z| of a vertical constraint", kSweep},
    {"vertical.max_range", SLOT(vertical.max_range), "60", "m", 1.0, 1000.0,
     "r_max: farthest vertical constraint", kSweep},
    {"vertical.near_distance", SLOT(vertical.near_distance), "10", "m", 0.0, 1000.0,
     "d_0: up to here a point counts in full, eqs. (28), (31)", kSweep},
    {"vertical.distance_decay", SLOT(vertical.distance_decay), "0.1", "1/m^2", 0.0, 100.0,
     "beta: decay of the weight beyond d_0, eq. (28)", kSweep},
    {"vertical.normal_power", SLOT(vertical.normal_power), "1", "", 0.0, 10.0,
     "power of |n_z| in eta, eq. (29); 0: every normal counts alike", "paper, section 3.4"},
    {"vertical.near_gate", SLOT(vertical.near_gate), "0.3", "m", 1e-4, 10.0,
     "epsilon_0: larger near residuals are suppressed, eq. (31)", kSweep},
    {"vertical.near_suppression", SLOT(vertical.near_suppression), "0.05", "", 0.0, 1.0,
     "epsilon_s: weight of a suppressed near residual, eq. (31)", kSweep},
    {"vertical.kernel_scale", SLOT(vertical.kernel_scale), "0.1", "m", 1e-4, 100.0,
     "kappa_V: scale of the far residuals' Cauchy weight, eq. (31)", kSweep},
    {"vertical.trust_region", SLOT(vertical.trust_region), "0.2", "m, rad", 1e-6, 10.0,
     "zeta_V: norm of a vertical update at most, eq. (34)", kSweep},
};

#undef WORDS
#undef SLOT

constexpr const char* kAlsoReads[] = {"motion_prior.", "health.min_information",
                                      "health.restart_after"};

// A search looks at the cube of voxels within its radius; this bounds their number.
constexpr double kMaxSearchVoxels = 8.0;

void check(const Config& config) {
  const PaperParameters::Registration& registration =
      own_parameters<PaperParameters>(config).registration;
  const double voxel_size = own_parameters<PaperParameters>(config).map.voxel_size;
  if (registration.relaxed_distance < registration.max_distance) {
    throw ConfigError("registration.relaxed_distance (" +
                      number_text(registration.relaxed_distance) +
                      " m) must not be less than registration.max_distance (" +
                      number_text(registration.max_distance) + " m)");
  }
  if (registration.relaxed_distance > kMaxSearchVoxels * voxel_size) {
    throw ConfigError("registration.relaxed_distance (" +
                      number_text(registration.relaxed_distance) + " m) must not be more than " +
                      number_text(kMaxSearchVoxels) + " times map.voxel_size (" +
                      number_text(voxel_size) + " m)");
  }
}

/// The paper, but for what `change` does to its parameters.
Config paper(void (*change)(PaperParameters&) = [](PaperParameters&) {}) {
  Config config;
  config.method = "paper";
  change(own_parameters<PaperParameters>(config));
  return config;
}

std::vector<Preset> presets() {
  return {
      {"paper", paper()},
      {"paper-cv",
       paper([](PaperParameters& p) { p.deskew.mode = DeskewMode::constant_velocity; })},
      {"paper-no-deskew", paper([](PaperParameters& p) { p.deskew.mode = DeskewMode::none; })},
      {"paper-coupled",
       paper([](PaperParameters& p) { p.registration.mode = RegistrationMode::coupled; })},
      // A departure from the paper that follows smooth walks: docs/equations.md.
      {"paper-surface",
       paper([](PaperParameters& p) { p.registration.target = TargetKind::surface; })},
  };
}

}  // namespace

const Method& paper_method() {
  static const Method method = {
      .name = "paper",
      .fields = kFields,
      .make_parameters = [] { return std::any(PaperParameters{}); },
      .also_reads = kAlsoReads,
      .check = check,
      .presets = presets,
      .make_front_end = make_front_end<PaperFrontEnd>,
  };
  return method;
}

}  // namespace surefoot
