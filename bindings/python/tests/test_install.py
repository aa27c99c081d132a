# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""pip install . gives a package that works; the compiled part is the one that was built already."""
import importlib.util
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

from support import SOURCES, scratch

import surefoot

NEEDED = ("pip", "setuptools", "wheel")


@unittest.skipUnless(all(map(importlib.util.find_spec, NEEDED)), "needs pip, setuptools and wheel")
class InstallTest(unittest.TestCase):
    def test_pip_installs_the_package(self):
        sources, target = scratch("sources"), scratch("site")
        shutil.copytree(SOURCES / "bindings/python/surefoot", sources / "bindings/python/surefoot")
        for name in ("pyproject.toml", "setup.py", "README.md", "VERSION", "LICENSE"):
            shutil.copy(SOURCES / name, sources)
        built = Path(surefoot.__file__).parents[2]
        options = ["--no-build-isolation", "--no-deps", "--no-index", "--quiet"]
        done = subprocess.run(
            [sys.executable, "-m", "pip", "install", *options, "--target", target, sources],
            env={**os.environ, "SUREFOOT_BUILD_FOLDER": str(built), "PYTHONPATH": ""},
            capture_output=True,
            text=True,
        )
        self.assertEqual(done.returncode, 0, done.stderr)
        installed = {p.name for p in (target / "surefoot").iterdir()}
        self.assertLessEqual({"__init__.py", "_core.pyi", "py.typed", "evalio.py"}, installed)
        said = subprocess.run(
            [sys.executable, "-c", "import surefoot as s; print(s.__file__, s.__version__)"],
            env={**os.environ, "PYTHONPATH": str(target)},
            capture_output=True,
            text=True,
        ).stdout.split()
        self.assertEqual(said, [str(target / "surefoot/__init__.py"), surefoot.__version__])


if __name__ == "__main__":
    unittest.main()
