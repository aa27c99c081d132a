// SPDX-FileCopyrightText: 2026 The Surefoot authors
// SPDX-License-Identifier: MIT
#include "odometry/config_fields.hpp"

namespace surefoot {

namespace {

#define SLOT(member) [](Config& c) -> FieldSlot { return &c.member; }

// "sweep": docs/config.md names the command and the recordings. "paper": its section.
constexpr const char* kPaper = "paper, section 3.2";
constexpr const char* kSweep = "sweep";
constexpr const char* kChosen = "chosen";
constexpr const char* kMethod = "docs/method.md";

const ConfigField kFields[] = {
    {"preprocess.min_range", SLOT(preprocess.min_range), "0.5", "m", 0.0, 100.0,
     "nearer points are the robot's own body", kChosen},
    {"preprocess.max_range", SLOT(preprocess.max_range), "100", "m", 1.0, 1000.0,
     "farther points are left out", "VLP-16 manual: range 100 m"},
    {"preprocess.min_points", SLOT(preprocess.min_points), "100", "", 1, 1e6,
     "a scan with fewer valid points is rejected", kChosen},
    {"preprocess.min_extent", SLOT(preprocess.min_extent), "0.5", "m", 0.0, 100.0,
     "a cloud with a smaller diagonal is rejected", kChosen},

    {"level.mode", SLOT(level.mode), "ground", "", 0, 0,
     "where the level frame comes from: the ground in the first scan, the mount, or the LiDAR's z",
     kChosen},
    {"level.max_tilt_deg", SLOT(level.max_tilt_deg), "45", "deg", 0.0, 80.0,
     "a plane steeper than this in the LiDAR's frame is not taken for the ground", kChosen},
    {"level.mount_x", SLOT(level.mount_x), "0", "m", -100, 100, "T_base_lidar, for mode mount",
     "user"},
    {"level.mount_y", SLOT(level.mount_y), "0", "m", -100, 100, "T_base_lidar", "user"},
    {"level.mount_z", SLOT(level.mount_z), "0", "m", -100, 100, "T_base_lidar", "user"},
    {"level.mount_roll_deg", SLOT(level.mount_roll_deg), "0", "deg", -180, 180,
     "T_base_lidar = Rz(yaw) Ry(pitch) Rx(roll)", "user"},
    {"level.mount_pitch_deg", SLOT(level.mount_pitch_deg), "0", "deg", -90, 90, "T_base_lidar",
     "user"},
    {"level.mount_yaw_deg", SLOT(level.mount_yaw_deg), "0", "deg", -180, 180, "T_base_lidar",
     "user"},

    {"motion_prior.max_extrapolation", SLOT(motion_prior.max_extrapolation), "0.5", "s", 0.0, 10.0,
     "after a longer gap the last velocity is carried on for this long only", kChosen},

    {"deskew.mode", SLOT(deskew.mode), "piecewise", "", 0, 0,
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
    {"downsample.source_voxel", SLOT(downsample.source_voxel), "2.5", "m", 0.01, 10.0,
     "one point per cube of this size is registered", kSweep},
    {"downsample.min_points", SLOT(downsample.min_points), "400", "", 0, 1e6,
     "where fewer points would be registered, both cubes are halved, four times at most", kSweep},

    {"map.voxel_size", SLOT(map.voxel_size), "1.0", "m", 0.05, 10.0,
     "cell of the local map; normals are taken over 3 x 3 x 3 cells, eq. (21)", kSweep},
    {"map.points_per_voxel", SLOT(map.points_per_voxel), "12", "", 1, 64,
     "a full cell takes no more points", kSweep},
    {"map.min_spacing", SLOT(map.min_spacing), "0.15", "m", 0.0, 10.0,
     "a point nearer than this to one in its cell does not enter", kSweep},
    {"map.radius", SLOT(map.radius), "100", "m", 5.0, 1000.0,
     "cells farther from the sensor leave the map", "preprocess.max_range"},

    {"registration.mode", SLOT(registration.mode), "decoupled", "", 0, 0,
     "Algorithm 1's two stages, or one 6-DoF problem to compare with", "paper, section 3.3"},
    {"registration.coupled_residual", SLOT(registration.coupled_residual), "point_to_point", "", 0,
     0, "residual of the coupled registration: eq. (13) or eq. (23)", kChosen},
    {"registration.target", SLOT(registration.target), "surface", "", 0, 0,
     "q_i: the nearest map point, or the nearest place on the flat surface about it",
     "docs/sweeps.md"},
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

    {"horizontal.kernel_scale", SLOT(horizontal.kernel_scale), "0.3", "m", 1e-4, 100.0,
     "kappa_H: scale of the robust weight, eq. (19)", kSweep},

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
    {"vertical.near_gate", SLOT(vertical.near_gate), "0.3", "m", 1e-4, 10.0,
     "epsilon_0: larger near residuals are suppressed, eq. (31)", kSweep},
    {"vertical.near_suppression", SLOT(vertical.near_suppression), "0.05", "", 0.0, 1.0,
     "epsilon_s: weight of a suppressed near residual, eq. (31)", kSweep},
    {"vertical.kernel_scale", SLOT(vertical.kernel_scale), "0.1", "m", 1e-4, 100.0,
     "kappa_V: scale of the far residuals' Cauchy weight, eq. (31)", kSweep},
    {"vertical.trust_region", SLOT(vertical.trust_region), "0.2", "m, rad", 1e-6, 10.0,
     "zeta_V: norm of a vertical update at most, eq. (34)", kSweep},

    {"knots.segments", SLOT(knots.segments), "8", "", 1, 64,
     "K: segments of constant velocity in a scan", kMethod},
    {"knots.points", SLOT(knots.points), "2000", "", 100, 1e6,
     "points to be registered, about; the cubes they are thinned to follow the scene", kMethod},
    {"knots.map_voxel", SLOT(knots.map_voxel), "0.2", "m", 0.01, 10.0,
     "one point of a scan per cube of this size enters the map", kMethod},
    {"knots.finest_voxel", SLOT(knots.finest_voxel), "0.4", "m", 0.05, 10.0,
     "voxel of the map's finest grid", kMethod},
    {"knots.levels", SLOT(knots.levels), "4", "", 1, 8,
     "grids of the map, each twice as coarse as the one before", kMethod},
    {"knots.points_per_voxel", SLOT(knots.points_per_voxel), "200", "", 3, 1e6,
     "a full voxel takes no more points", kMethod},
    {"knots.min_points", SLOT(knots.min_points), "6", "", 3, 1000, "points that a surfel needs",
     kMethod},
    {"knots.breadth", SLOT(knots.breadth), "0.1", "voxels", 0.0, 0.5,
     "a surfel's points spread at least so far along it (standard deviation)", kMethod},
    {"knots.flatness", SLOT(knots.flatness), "0.06", "", 0.0, 1.0,
     "variance across a plane at most, as a share of that along it", kMethod},
    {"knots.slenderness", SLOT(knots.slenderness), "0.1", "", 0.0, 1.0,
     "variance across a pole at most, as a share of that along it", kMethod},
    {"knots.min_match_ratio", SLOT(knots.min_match_ratio), "0.1", "", 0.0, 1.0,
     "share of the registered points that must lie on a surfel; a first scan of a forest has few",
     kMethod},
    {"knots.noise", SLOT(knots.noise), "0.03", "m", 1e-4, 1.0,
     "standard deviation of a point's distance to its surfel", kMethod},
    {"knots.independence", SLOT(knots.independence), "0.1", "", 1e-6, 1.0,
     "share of the residuals that count as independent", kMethod},
    {"knots.correlation_time", SLOT(knots.correlation_time), "0.1", "s", 1e-3, 10.0,
     "time after which the velocity's fluctuation is forgotten", kMethod},
    {"knots.learning_rate", SLOT(knots.learning_rate), "0.05", "", 0.0, 1.0,
     "how fast mean velocity and fluctuation are learnt, per scan", kMethod},
    {"knots.memory", SLOT(knots.memory), "0.3", "", 0.0, 1.0,
     "share of what is known of the last knots that the next scan relies on", kMethod},
    {"knots.kernel_start", SLOT(knots.kernel_start), "1.5", "m", 1e-3, 10.0,
     "scale of the robust kernel in the first iteration", kMethod},
    {"knots.kernel_end", SLOT(knots.kernel_end), "0.1", "m", 1e-3, 10.0,
     "scale of the robust kernel at the end", kMethod},
    {"knots.kernel_decay", SLOT(knots.kernel_decay), "0.8", "", 0.01, 0.99,
     "factor on the kernel's scale per iteration", kMethod},
    {"knots.max_iterations", SLOT(knots.max_iterations), "25", "", 1, 1000, "iterations at most",
     kMethod},
    {"knots.convergence", SLOT(knots.convergence), "0.001", "m, rad", 0.0, 1.0,
     "stop when no knot moves by more, once the kernel is at its end", kMethod},

    {"health.min_matches", SLOT(health.min_matches), "30", "", 6, 1e6,
     "fewer correspondences: the scan is not registered", kChosen},
    {"health.min_match_ratio", SLOT(health.min_match_ratio), "0.3", "", 0.0, 1.0,
     "share of the registered points that must have a correspondence at the end", kChosen},
    {"health.max_correction", SLOT(health.max_correction), "3", "m", 0.0, 100.0,
     "a registration farther from the prediction has diverged", kChosen},
    {"health.max_correction_deg", SLOT(health.max_correction_deg), "45", "deg", 0.0, 180.0,
     "a registration turned farther from the prediction has diverged", kChosen},
    {"health.min_information", SLOT(health.min_information), "0.01", "", 0.0, 1.0,
     "a direction with a smaller share of an even scene's information is degenerate", kChosen},
    {"health.restart_after", SLOT(health.restart_after), "10", "", 1, 1e6,
     "scans lost in a row after which the map is begun anew", kChosen},
};

#undef SLOT

}  // namespace

std::span<const ConfigField> config_fields() { return kFields; }

}  // namespace surefoot
