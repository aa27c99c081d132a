#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""What cibuildwheel is told in pyproject.toml fits the project: its options, its packages, its files.

    wheel_settings_test.py SOURCES
"""
import pathlib
import re
import sys

try:
    import tomllib
except ImportError:  # before Python 3.11
    print("SKIPPED: no tomllib in this Python")
    sys.exit(77)

# What AlmaLinux calls Debian's packages of the group "build"; None: not in a wheel.
NAMES = {
    "libeigen3-dev": "eigen3-devel", "libtbb-dev": None, "libcli11-dev": None, "libfmt-dev": "fmt-devel",
    "libyaml-cpp-dev": "yaml-cpp-devel", "nlohmann-json3-dev": "json-devel", "libpcap-dev": "libpcap-devel",
    "liblzf-dev": "liblzf-devel", "libsqlite3-dev": "sqlite-devel", "liblz4-dev": "lz4-devel",
    "libzstd-dev": "libzstd-devel", "libbz2-dev": "bzip2-devel", "libdeflate-dev": "libdeflate-devel",
    "libembree-dev": "embree-devel", "libceres-dev": None, "libcairo2-dev": "cairo-devel",
    "libboost-dev": None, "zlib1g-dev": "zlib-devel",
}  # fmt: skip


def main() -> int:
    root = pathlib.Path(sys.argv[1])
    project = tomllib.loads((root / "pyproject.toml").read_text())
    linux = project["tool"]["cibuildwheel"]["linux"]
    wrong = []

    lists = (root / "CMakeLists.txt").read_text()
    known = set(re.findall(r"(?:option|set)\((SUREFOOT_\w+) ", lists))
    for option in linux["environment"]["SUREFOOT_CMAKE_OPTIONS"].split():
        name = re.fullmatch(r"-D(\w+)=(ON|OFF)", option)
        if name is None or name[1] not in known:
            wrong.append(f"{option} is no option of CMakeLists.txt")

    installed = set(linux["before-all"].split())
    rows = [line.split() for line in (root / "cmake/packages.txt").read_text().splitlines()]
    for row in rows:
        if row[:1] != ["build"] or row[2] == "-":
            continue
        if row[1] not in NAMES:
            wrong.append(f"{row[1]} has no name for the wheels here")
        elif NAMES[row[1]] not in installed | {None}:
            wrong.append(f"{NAMES[row[1]]} is not installed before wheels are built")

    example = project["tool"]["cibuildwheel"]["test-command"].split("{project}/")[1]
    if not (root / example).is_file():
        wrong.append(f"{example} is not there")
    print("\n".join(wrong) or "as it should be")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
