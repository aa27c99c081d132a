#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Builds the library for aarch64, runs its tests under qemu, and compares walks with this machine's."""
import argparse
import shutil
import subprocess
import sys

SKIPPED = 77
TESTS = ["unit_geometry", "unit_core", "unit_config"]  # those of whole runs take too long under qemu


def walks(output):
    lines = [line.split() for line in output.splitlines()]
    return [(line[0], line[1], [float(value) for value in line[2:]]) for line in lines]


def compare(here, there):
    """Prints how far apart they are, and says whether they are the same to the bit."""
    good = len(here) == len(there) > 0
    methods = list(dict.fromkeys(method for method, _, _ in here))
    for method in methods:
        pairs = [(a, b) for a, b in zip(here, there) if a[0] == method]
        distance = max(sum((x - y) ** 2 for x, y in zip(a[2][:3], b[2][:3])) ** 0.5 for a, b in pairs)
        turn = max(2 * sum((x - y) ** 2 for x, y in zip(a[2][3:], b[2][3:])) ** 0.5 for a, b in pairs)
        same = sum(a == b for a, b in pairs)
        print(f"{method}: {len(pairs)} poses, {same} of the same bits, at most {distance:.3g} m and {turn:.3g} rad apart")
        good = good and same == len(pairs)
    return good


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--source", required=True)
    parser.add_argument("--build", required=True)
    parser.add_argument("--here", required=True, help="print_walks of this machine")
    arguments = parser.parse_args()
    for tool in ["aarch64-linux-gnu-g++", "qemu-aarch64"]:
        if not shutil.which(tool):
            print(f"SKIPPED: no {tool} here (Debian: g++-aarch64-linux-gnu, qemu-user)")
            return SKIPPED
    run = lambda *command: subprocess.run(command, check=True, cwd=arguments.source)
    run("cmake", "--preset", "aarch64", "-B", arguments.build)
    run("cmake", "--build", arguments.build, "--target", "print_walks", *TESTS)
    run("ctest", "--test-dir", arguments.build, "--output-on-failure", "-R", "^(" + "|".join(TESTS) + ")$")
    there = subprocess.run(
        ["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu", arguments.build + "/bin/print_walks"],
        check=True, capture_output=True, text=True).stdout
    here = subprocess.run([arguments.here], check=True, capture_output=True, text=True).stdout
    return 0 if compare(walks(here), walks(there)) else 1


if __name__ == "__main__":
    sys.exit(main())
