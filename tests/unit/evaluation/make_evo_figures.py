# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Computes the figures that evo_agreement_test.cpp compares with, by evo itself.

usage: make_evo_figures.py <folder with evo's test data> > evo_figures.csv

Needs numpy and scipy. The test names the version of evo that the stored file was made with.
"""

import copy
import itertools
import pathlib
import sys

from evo import EvoException, __version__
from evo.core import metrics, sync
from evo.core.trajectory import PosePath3D
from evo.core.units import Unit
from evo.tools import file_interface

RELATIONS = {
    "translation": metrics.PoseRelation.translation_part,
    "rotation_angle": metrics.PoseRelation.rotation_angle_deg,
    "rotation_part": metrics.PoseRelation.rotation_part,
    "full": metrics.PoseRelation.full_transformation,
}
DISTANCES = {
    "distance": metrics.PoseRelation.point_distance,
    "distance_percent": metrics.PoseRelation.point_distance_error_ratio,
}
ALIGNMENTS = [("none", 0), ("origin", 0), ("rigid", 0), ("rigid", 100), ("similarity", 0),
              ("similarity", 100), ("scale", 0)]
UNITS = {"frames": Unit.frames, "metres": Unit.meters, "degrees": Unit.degrees}
STATISTICS = ["max", "mean", "median", "min", "rmse", "std", "sse"]


def kitti(path):
    """Poses with proper rotations: the files' matrices are orthonormal to seven digits only."""
    poses = file_interface.read_kitti_poses_file(path)
    return PosePath3D(poses.positions_xyz, poses.orientations_quat_wxyz)


def pairs(folder):
    """Name, reference and estimate, pose by pose."""
    for name in ("ORB", "SPTAM"):
        yield (f"kitti_{name}", kitti(folder / "KITTI_00_gt.txt"),
               kitti(folder / f"KITTI_00_{name}.txt"))
    tum = file_interface.read_tum_trajectory_file
    for name, reference, estimate in (
            ("fr2_desk", "fr2_desk_groundtruth.txt", "fr2_desk_ORB.txt"),
            ("fr1_xyz", "freiburg1_xyz-groundtruth.txt", "freiburg1_xyz-rgbdslam.txt"),
            ("fr1_drift", "freiburg1_xyz-groundtruth.txt", "freiburg1_xyz-rgbdslam_drift.txt")):
        yield name, *sync.associate_trajectories(tum(folder / reference), tum(folder / estimate))
    yield "v102", *sync.associate_trajectories(
        file_interface.read_euroc_csv_trajectory(folder / "V102_groundtruth.csv"),
        tum(folder / "V102.txt"))
    # One trajectory five thousand kilometres off the origin: each pose against the next one.
    far = tum(folder / "georeferenced.tum")
    positions, rotations = far.positions_xyz, far.orientations_quat_wxyz
    yield ("georeferenced", PosePath3D(positions[:-1], rotations[:-1]),
           PosePath3D(positions[1:], rotations[1:]))


def aligned(reference, estimate, method, poses):
    estimate = copy.deepcopy(estimate)
    if method == "origin":
        estimate.align_origin(reference)
    elif method != "none":
        estimate.align(reference, correct_scale=method == "similarity",
                       correct_only_scale=method == "scale", n=poses or -1)
    return estimate


def write(metric, reference, estimate, *keys):
    try:
        metric.process_data((reference, estimate))
    except EvoException:  # no stretch of that length
        return
    statistics = metric.get_all_statistics()
    values = [f"{float(statistics[name]):.12g}" for name in STATISTICS]
    print(*keys, len(metric.error), *values, sep=",")


def main():
    folder = pathlib.Path(sys.argv[1])
    print(f"# evo {__version__}")
    print("data,metric,relation,alignment,alignment_poses,delta,unit,all_pairs,from_reference,count",
          *STATISTICS, sep=",")
    for name, reference, estimate in pairs(folder):
        for (method, poses), (relation, evo_relation) in itertools.product(
                ALIGNMENTS, RELATIONS.items()):
            write(metrics.APE(evo_relation), reference,
                  aligned(reference, estimate, method, poses),
                  name, "ape", relation, method, poses, 0, "", 0, 0)
        stretches = [(1, "frames"), (10, "frames"), (0.5, "metres"), (10, "metres"),
                     (5, "degrees"), (20, "degrees")]
        for (delta, unit), all_pairs, (relation, evo_relation) in itertools.product(
                stretches, (False, True), (RELATIONS | DISTANCES).items()):
            if unit == "degrees" and all_pairs and len(reference.positions_xyz) > 1000:
                continue  # evo takes minutes
            for method, from_reference in (("none", True), ("similarity", False)):
                write(metrics.RPE(evo_relation, delta, UNITS[unit], all_pairs=all_pairs,
                                  pairs_from_reference=from_reference),
                      reference, aligned(reference, estimate, method, 0),
                      name, "rpe", relation, method, 0, delta, unit, int(all_pairs),
                      int(from_reference))


main()
