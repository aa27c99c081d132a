#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""reproducible_test.py SOURCES WORK [--packages]: the same sources in two folders give the same bytes.

Copies the sources to two folders below WORK, of which one has a longer name, builds both as the
preset package does, without a compiler's cache, and compares what is left: by default the libraries
for C++ and for C, with --packages the Debian packages (a quarter of an hour or more).
"""
import argparse
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys

FOLDERS = ["a", "another-name-of-it/b"]
LIBRARIES = ["-DSUREFOOT_APP=OFF", "-DSUREFOOT_COMPONENTS=OFF", "-DSUREFOOT_PYTHON_MODULE=OFF"]


def build(sources, folder, packages, jobs):
    """What was built there, by name."""
    shutil.rmtree(folder, ignore_errors=True)
    leave = shutil.ignore_patterns("build", "results", ".git", "__pycache__", "node_modules")
    shutil.copytree(sources, folder, ignore=leave)
    surroundings = os.environ | {"SOURCE_DATE_EPOCH": "1700000000", "CCACHE_DISABLE": "1"}

    def run(*command, where=folder):
        subprocess.run(command, check=True, cwd=where, env=surroundings, stdout=subprocess.DEVNULL)

    run("cmake", "--preset", "package", *([] if packages else LIBRARIES))
    run("cmake", "--build", "--preset", "package", "-j", str(jobs))
    built = folder / "build" / "package"
    if packages:
        run("cpack", where=built)
        found = list(built.glob("*.deb"))
    else:
        run("cmake", "--install", str(built), "--prefix", str(folder / "installed"), "--strip")
        found = [file for file in (folder / "installed").rglob("*")
                 if not file.is_symlink() and file.name.startswith("libsurefoot")]
    return {file.name: file.read_bytes() for file in found}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sources", type=pathlib.Path)
    parser.add_argument("work", type=pathlib.Path)
    parser.add_argument("--packages", action="store_true")
    parser.add_argument("--jobs", type=int, default=1)
    given = parser.parse_args()
    first, second = (
        build(given.sources, given.work.resolve() / folder, given.packages, given.jobs) for folder in FOLDERS)
    assert first.keys() == second.keys() and len(first) >= 2, (sorted(first), sorted(second))
    for name in sorted(first):
        same = first[name] == second[name]
        print(name, hashlib.sha256(first[name]).hexdigest(), "same bytes" if same else "DIFFER")
    return 0 if first == second else 1


if __name__ == "__main__":
    sys.exit(main())
