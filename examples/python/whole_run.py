#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""A whole run with all its files, as `surefoot run` makes it, and tables of it."""
import sys
import tempfile
from pathlib import Path

import surefoot


def main(folder: Path) -> None:
    recording = folder / "walk"
    surefoot.simulate("corridor", scans=20, footprint=False).write(recording, ["mcap"])
    run = surefoot.run(recording / "recording.mcap", folder / "run", no_report=True, say=print)
    print(run)

    truth = surefoot.read_tum(recording / "gt.tum")
    figures = surefoot.evaluate(truth, run.trajectory, delta=1.0, delta_unit="m")
    print(f"{figures['pairs']} poses compared")
    slowest = run.scans["ms_solve"].argmax()
    print(f"longest registration: scan {slowest}, {run.scans['ms_solve'][slowest]:.1f} ms")

    try:  # needs matplotlib; pandas.DataFrame(run.scans) works alike
        import matplotlib

        matplotlib.use("Agg")
        run.plot(truth).savefig(folder / "run.png")
        print("drawn:", folder / "run.png")
    except ImportError:
        print("no matplotlib here: not drawn")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(Path(sys.argv[1]))
    else:
        with tempfile.TemporaryDirectory() as scratch:
            main(Path(scratch))
