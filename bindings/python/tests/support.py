# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""What the tests share: where things are, and a small recording."""

import os
import subprocess
import tempfile
import unittest
from functools import lru_cache
from pathlib import Path

import surefoot

SOURCES = Path(os.environ["SUREFOOT_SOURCES"])
SHARED_DATA = Path(os.environ["SUREFOOT_SHARED_DATA"])
PROGRAM = os.environ.get("SUREFOOT_PROGRAM", "")

_scratch = tempfile.TemporaryDirectory(prefix="surefoot-python-")
needs_program = unittest.skipUnless(PROGRAM, "built without the program")
needs_simulation = unittest.skipUnless(hasattr(surefoot, "simulate"), "built without simulation")


def scratch(name):
    """A path that is not there yet."""
    return Path(tempfile.mkdtemp(dir=_scratch.name)) / name


@lru_cache(maxsize=None)
def walk():
    """A simulated walk and the folder with its recording in all formats."""
    simulation = surefoot.simulate("corridor", scans=12, footprint=False)
    folder = scratch("walk")
    simulation.write(folder, ["pcd", "pcap", "mcap"])
    return simulation, folder


def program(*arguments):
    """What the program prints."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"surefoot {arguments}: {done.stderr}")
    return done.stdout


def lines(file):
    """The poses of a trajectory, without the comment."""
    return [line for line in file.read_text().splitlines() if not line.startswith("#")]
