# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""What mypy and its stubtest find in the package, its stubs and its examples: nothing."""
import importlib.util
import os
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
HERE = Path(__file__).resolve().parent
SOURCES = Path(os.environ["SUREFOOT_SOURCES"])


def passes(*command):
    print("$", *command, flush=True)
    return subprocess.run([sys.executable, "-m", *map(str, command)]).returncode == 0


def main():
    if importlib.util.find_spec("mypy") is None:
        print("SKIPPED: no mypy here (Debian: mypy)")
        return SKIPPED
    built = Path(importlib.util.find_spec("surefoot").origin).parents[1]
    os.environ["MYPYPATH"] = str(built)
    settings = SOURCES / "pyproject.toml"
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        good = passes("mypy", "--config-file", settings, "-p", "surefoot")
        good &= passes("mypy", "--config-file", settings, *sorted(SOURCES.glob("examples/python/*.py")))
        good &= passes("mypy.stubtest", "surefoot._core", "--mypy-config-file", settings, "--concise",
                       "--allowlist", HERE / "stubtest_allowed.txt")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
