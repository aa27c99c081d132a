# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Whole runs: the folder that `surefoot run` leaves, as an object."""

from __future__ import annotations

import html
import os
from functools import cached_property
from pathlib import Path
from typing import Any, Callable, Optional, Union

from . import _core


class Run:
    """What a run left, read from its folder.

    trajectory: the measured poses; scans: a column of scans.csv each (pandas.DataFrame(run.scans));
    map_points: (N, 3) float32 [m]; parameters, facts: by name, as text; notes: what was assumed.
    """

    def __init__(self, folder: Union[str, "os.PathLike[str]"]) -> None:
        self.folder = Path(folder)
        content = _core.read_run_folder(self.folder)
        self._content = content
        self.input: Path = content.input
        self.method: str = content.method
        self.notes: list[str] = content.notes
        self.facts: dict[str, str] = content.facts
        self.parameters: dict[str, str] = content.parameters
        self.trajectory: _core.Trajectory = content.trajectory

    # Arrays, when they are asked for: to import numpy takes as long as to run ten scans.

    @cached_property
    def scans(self) -> dict[str, Any]:
        scans: dict[str, Any] = self._content.scans
        return scans

    @cached_property
    def map_points(self) -> Any:
        return self._content.map_points

    @cached_property
    def map_intensities(self) -> Any:
        return self._content.map_intensities

    def __repr__(self) -> str:
        return f"<Run of method {self.method}: {len(self.scans['stamp_ns'])} scans in {self.folder}>"

    def _repr_html_(self) -> str:
        """What a notebook shows: what was run, and how it went."""
        statuses = [str(status) for status in self.scans["status"]]
        rows = {
            "recording": str(self.input),
            "method": self.method,
            "scans": str(len(statuses)),
            **{status: str(statuses.count(status)) for status in dict.fromkeys(statuses)},
            "poses": str(len(self.trajectory)),
            "map": f"{len(self.map_points):,} points",
            "folder": str(self.folder),
        }
        cells = "".join(
            f"<tr><th>{html.escape(name)}</th><td>{html.escape(value)}</td></tr>" for name, value in rows.items()
        )
        return f"<table>{cells}</table>"

    def plot(self, truth: Optional[_core.Trajectory] = None, map_points: int = 50_000) -> Any:
        """Draws map and path from above and height over time; returns matplotlib's figure.

        truth: drawn besides, as it is; map_points: at most so many. Needs matplotlib.
        """
        import matplotlib.pyplot as plt

        figure, (above, height) = plt.subplots(
            2, 1, figsize=(8, 9), gridspec_kw={"height_ratios": [3, 1]}, constrained_layout=True
        )
        step = max(1, len(self.map_points) // map_points)
        shown = self.map_points[::step]
        above.scatter(shown[:, 0], shown[:, 1], s=0.2, c=shown[:, 2], cmap="Greys", rasterized=True)
        lines = [(self.trajectory, self.method)]
        if truth is not None:
            lines.append((truth, "truth"))
        start = self.trajectory.stamps_ns[0] if len(self.trajectory) else 0
        for path, name in lines:
            seconds = (path.stamps_ns - start) * 1e-9
            above.plot(path.positions[:, 0], path.positions[:, 1], label=name)
            height.plot(seconds, path.positions[:, 2], label=name)
        above.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
        height.set(xlabel="time [s]", ylabel="z [m]")
        above.legend()
        return figure


def read_run(folder: Union[str, "os.PathLike[str]"]) -> Run:
    """The run that left a folder."""
    return Run(folder)


def run(
    input: Union[str, "os.PathLike[str]"],
    output: Union[None, str, "os.PathLike[str]"] = None,
    *,
    config: Union[None, str, _core.Config] = None,
    say: Optional[Callable[[str], None]] = None,
    progress: Optional[Callable[[int, float], None]] = None,
    **options: Any,
) -> Run:
    """Turns a recording into a folder of results, as `surefoot run` does, byte for byte.

    output: the folder; None: results/<input>-<time>
    config: a Config, or a method's name
    say, progress: told what the program would print, and (scans done, share)
    options: the program's, with _ for -: start, count, stride, threads, extrinsic, level, pose_of,
        map_voxel, pose_rate, truth, loop_closure, localize, map, no_map, no_picture, no_report,
        mcap, rosbag2, overwrite; and those of surefoot.open. None: not given.
    """
    return Run(
        _core.run_to_folder(input, output, config=config, say=say, progress=progress, **options)
    )
