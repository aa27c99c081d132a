# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""What the scripts beside this share, which measure what the documents' tables show: calling
surefoot, reading what it wrote, judging it by the exact truth, keeping the table. A pose is
T_world_lidar: a position [m] and a quaternion x y z w; stamps are in seconds."""
import argparse
import csv
import pathlib
import subprocess

HERE = pathlib.Path(__file__).parent
BARE = ("--no-map", "--no-report", "--no-picture", "-q")  # of a run: figures and trajectories alone
RMSE = 6  # in a row of what eval says: after the name, the unit, max, mean, median and min


def parser_of(text, *paths):
    """A script's arguments: its paths, by their order; it adds its options."""
    parser = argparse.ArgumentParser(description=text,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    for path in paths:
        parser.add_argument(path, type=pathlib.Path)
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


def rmse_told(told, *names):
    """The RMSE of each of these errors, as eval says it without --csv."""
    rows = {words[0]: words for words in map(str.split, told.splitlines()) if words}
    return [rows[name][RMSE] for name in names]
