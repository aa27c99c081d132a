#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""The program asks the network for nothing: no command opens a socket but those that are told to listen.

    no_network_test.py PROGRAM
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

SKIPPED = 77


def sockets(folder, *command, fails=False):
    """The sockets of the network that it and its children ask for, as strace tells them."""
    trace = folder / "trace"
    done = subprocess.run(
        ["strace", "-f", "-qq", "-e", "trace=socket", "-o", trace, *command],
        capture_output=True, text=True, cwd=folder, timeout=300)
    if done.returncode != 0 and not fails:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}\n{done.stderr}")
    return [line for line in trace.read_text().splitlines() if "socket(AF_INET" in line]


def main():
    if not shutil.which("strace"):
        print("SKIPPED: no strace here (Debian: strace)")
        return SKIPPED
    program = str(pathlib.Path(sys.argv[1]).resolve())
    opened = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        commands = [
            ["simulate", "corridor", "-o", "walk", "--scans", "12"],
            ["run", "walk", "-o", "out"],
            ["report", "out"],
            ["map", "walk", "-o", "map"],
        ]
        for command in commands:
            found = sockets(folder, program, *command)
            print(f"surefoot {' '.join(command)}: {len(found)} sockets")
            opened += len(found)
        # What it is told to listen to is seen: else nothing above would tell anything.
        listening = [program, "live", "--udp", "23687", "-o", "live"]  # and hears nothing, which is an error
        heard = sockets(folder, "timeout", "--signal", "INT", "3", *listening, fails=True)
        print(f"surefoot live --udp: {len(heard)} sockets")
    return 1 if opened or not heard else 0


if __name__ == "__main__":
    sys.exit(main())
