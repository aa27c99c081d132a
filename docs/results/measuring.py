# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""What the scripts beside this share, which measure what the documents' tables show: calling
surefoot, reading what it wrote, judging it by the exact truth, keeping the table. A pose is
T_world_lidar: a position [m] and a quaternion x y z w; stamps are in seconds."""
import argparse
import array
import bisect
import csv
import functools
import math
import os
import pathlib
import subprocess

HERE = pathlib.Path(__file__).parent
BARE = ("--no-map", "--no-report", "--no-picture", "-q")  # of a run: figures and trajectories alone
RMSE = 6  # in a row of what eval says: after the name, the unit, max, mean, median and min
FALSE_METRES, FALSE_DEGREES = 0.2, 2.0  # of a loop
WRONG_METRES, WRONG_DEGREES, BEFORE = 0.2, 3.0, 10  # of a pose, against that so many scans before


def commit_here():
    """That is checked out; none: there is no repository here, or no git."""
    try:
        return call("git", "-C", HERE, "rev-parse", "--short", "HEAD").strip()
    except (OSError, subprocess.CalledProcessError):
        return None


def parser_of(text, *paths, compares=False):
    """A script's arguments: its paths, by their order, and the commit that it measures; one that
    compares commits is told of each. It adds its options."""
    parser = argparse.ArgumentParser(description=text,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    for path in paths:
        parser.add_argument(path, type=pathlib.Path)
    if not compares:
        here = commit_here()
        parser.add_argument("--commit", default=here, required=here is None,
                            help="that is measured; else the one that is checked out")
    return parser


def keep(name, head, rows, **about):
    """Writes NAME.csv beside this: what made it (commit, command, machine, note), then a table."""
    with (HERE / f"{name}.csv").open("w", newline="") as out:
        for key, value in about.items():
            out.write(f"# {key}: {value}\n")
        csv.writer(out, lineterminator="\n").writerows([head, *rows])


def call(*words):
    """What a program prints."""
    return subprocess.run([str(word) for word in words], check=True, text=True,
                          capture_output=True).stdout


def call_unless(file, *words):
    """A call that leaves the file, unless it is there."""
    if not file.exists():
        call(*words)


def simulate(program, recording, *words):
    """The folder of a recording, made unless it is there; `words`: the scene and options."""
    call_unless(recording / "gt.tum", program, "simulate", *words, "-q", "-o", recording)
    return recording


def cost_of(words, said=None, fine=(0,)):
    """Runs a program; its processor time [s] and peak memory [MB]. `fine`: exit codes."""
    child = subprocess.Popen([str(word) for word in words], stdout=said, stderr=said)
    _, status, usage = os.wait4(child.pid, 0)
    if os.waitstatus_to_exitcode(status) not in fine:
        raise RuntimeError(f"{words}: ended with {status}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024.0


def rows_of(text):
    """Of CSV with a head."""
    return list(csv.DictReader(text.splitlines()))


def rows_in(file):
    """Of a file of CSV with a head."""
    with file.open(newline="") as lines:
        return list(csv.DictReader(lines))


def trusted(scan):
    """Of a row of scans.csv: whether its pose is in trajectory.tum."""
    return scan["status"] in ("ok", "degenerate", "first_scan")


def errors_of(program, truth, trajectory):
    """Eval's row of each error, after alignment."""
    told = call(program, "eval", "--pair", "interpolate", "--csv", truth, trajectory)
    return {row["error"]: row for row in rows_of(told)}


def ape(program, truth, trajectory):
    """RMSE of the translation after alignment [m]."""
    return float(errors_of(program, truth, trajectory)["ape_translation"]["rmse"])


def apes_of_map(program, truth, run):
    """APE [m] before its loops were closed, and after."""
    return [f"{ape(program, truth, run / name):.3f}"
            for name in ("trajectory.tum", "trajectory_optimized.tum")]


def rmse_told(told, *names):
    """The RMSE of each of these errors, as eval says it without --csv."""
    rows = {words[0]: words for words in map(str.split, told.splitlines()) if words}
    return [rows[name][RMSE] for name in names]


def taken(loops):
    """Of rows of loops.csv: those that became loops."""
    return [row for row in loops if row["verdict"] == "taken"]


def true_gap(loop):
    """Between a loop and the truth [m], [deg]."""
    return float(loop["true_gap_m"]), float(loop["true_gap_deg"])


def is_false(gap):
    """Whether a loop with this gap to the truth is wrong."""
    return gap[0] >= FALSE_METRES or gap[1] >= FALSE_DEGREES


def judged_map(run):
    """Way [m]; pieces that lie where the way led before, and how many of these found it; places
    compared; gaps [m], [deg] of the loops that were taken."""
    pieces, loops = rows_in(run / "revisits.csv"), rows_in(run / "loops.csv")
    found = [row["found"] == "1" for row in pieces if row["revisit"] == "1"]
    gaps = [true_gap(row) for row in taken(loops)]
    return float(pieces[-1]["way_m"]), len(found), sum(found), len(loops), gaps


@functools.lru_cache(maxsize=None)
def numbers_in(file):
    """Of a TUM file: stamps, and all of its numbers, eight a row; in arrays, for a truth has 400
    rows a second."""
    numbers = array.array("d")
    with file.open() as lines:
        for line in lines:
            if not line.startswith("#"):
                numbers.extend(map(float, line.split()))
    return numbers[::8], numbers


def stamps_in(file):
    return numbers_in(file)[0]


def pose_in(file, i):
    row = numbers_in(file)[1][8 * i:8 * i + 8]
    return row[1:4], row[4:8]


def places_in(file):
    """Positions alone [m]."""
    return [pose_in(file, i)[0] for i in range(len(stamps_in(file)))]


def nearest(file, stamp):
    """Which pose is nearest in time."""
    stamps = stamps_in(file)
    i = min(max(bisect.bisect_left(stamps, stamp), 1), len(stamps) - 1)
    return i - (stamp - stamps[i - 1] < stamps[i] - stamp)


def pose_at(file, stamp):
    """The nearest in time; none: it is not within 10 ms."""
    i = nearest(file, stamp)
    return pose_in(file, i) if abs(stamps_in(file)[i] - stamp) < 0.01 else None


def true_places(truth, trajectory):
    """Where a trajectory's poses really are [m]."""
    return [pose_in(truth, nearest(truth, stamp))[0] for stamp in stamps_in(trajectory)]


def product(p, q):
    (px, py, pz, pw), (qx, qy, qz, qw) = p, q
    return (pw * qx + px * qw + py * qz - pz * qy, pw * qy - px * qz + py * qw + pz * qx,
            pw * qz + px * qy - py * qx + pz * qw, pw * qw - px * qx - py * qy - pz * qz)


def inverse(q):
    return (-q[0], -q[1], -q[2], q[3])


def relative(one, other):
    """T_one_other of two poses."""
    apart = [b - a for a, b in zip(one[0], other[0])]
    back = inverse(one[1])
    return product(product(back, (*apart, 0.0)), one[1])[:3], product(back, other[1])


def gap_between(one, other):
    """[m], [deg]"""
    turned = product(inverse(one[1]), other[1])
    angle = 2.0 * math.atan2(math.hypot(*turned[:3]), abs(turned[3]))
    return math.dist(one[0], other[0]), math.degrees(angle)


def judged_poses(run, truth):
    """How many poses are called ok, and how many of these are false."""
    scans = [(row["status"], row["segment"]) for row in rows_in(run / "scans.csv") if trusted(row)]
    trajectory = run / "trajectory.tum"
    stamps = stamps_in(trajectory)
    assert len(scans) == len(stamps), run
    poses = [pose_in(trajectory, i) for i in range(len(stamps))]
    truths = [pose_at(truth, stamp) for stamp in stamps]
    ok = false = 0
    for i in range(BEFORE, len(scans)):
        if scans[i][0] != "ok" or scans[i][1] != scans[i - BEFORE][1]:
            continue
        ok += 1
        metres, degrees = gap_between(relative(poses[i - BEFORE], poses[i]),
                                      relative(truths[i - BEFORE], truths[i]))
        false += metres > WRONG_METRES or degrees > WRONG_DEGREES
    return ok, false


def mean(places):
    return [sum(place[axis] for place in places) / len(places) for axis in range(3)]


def rigid(from_places, to_places):
    """Rotation (rows) and shift that bring one to the other: Horn's quaternion."""
    middle, target = mean(from_places), mean(to_places)
    s = [[sum((p[i] - middle[i]) * (q[k] - target[k]) for p, q in zip(from_places, to_places))
          for k in range(3)] for i in range(3)]
    n = [[s[0][0] + s[1][1] + s[2][2], s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]],
         [0, s[0][0] - s[1][1] - s[2][2], s[0][1] + s[1][0], s[2][0] + s[0][2]],
         [0, 0, s[1][1] - s[0][0] - s[2][2], s[1][2] + s[2][1]],
         [0, 0, 0, s[2][2] - s[0][0] - s[1][1]]]
    shift = max(sum(abs(n[min(i, k)][max(i, k)]) for k in range(4)) for i in range(4))
    q = [0.5, 0.5, 0.5, 0.51]
    for _ in range(3000):  # the largest eigenvalue's vector
        q = [sum(n[min(i, k)][max(i, k)] * q[k] for k in range(4)) + shift * q[i]
             for i in range(4)]
        size = math.sqrt(sum(value * value for value in q))
        q = [value / size for value in q]
    w, x, y, z = q
    rotation = [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]
    return rotation, [target[i] - sum(rotation[i][k] * middle[k] for k in range(3))
                      for i in range(3)]


def markers(file, which):
    """Points 10 m above, ahead of and beside poses of these indices: a straight way alone does not
    tell how it lies."""
    places = []
    for i in which:
        t, (x, y, z, w) = pose_in(file, i)
        axes = [[1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)],
                [2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
                [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]]
        places += [[t[k] + 10.0 * axis[k] for k in range(3)] for axis in axes]
    return places


def laid_on_truth(truth, trajectory, which=None):
    """T_truth_map that brings a map's poses (all, or those of these indices) to the truth."""
    stamps = stamps_in(trajectory)
    which = range(len(stamps)) if which is None else which
    return rigid(markers(trajectory, which),
                 markers(truth, [nearest(truth, stamps[i]) for i in which]))


def farthest_off(T_truth_map, truth, trajectory):
    """How far a trajectory in a map's frame ever is from the truth [m]."""
    rotation, shift = T_truth_map
    moved = ([sum(rotation[i][k] * place[k] for k in range(3)) + shift[i] for i in range(3)]
             for place in places_in(trajectory))
    return max(map(math.dist, moved, true_places(truth, trajectory)))
