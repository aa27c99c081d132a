# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
#
# The compiled part of the Python package is built by CMake; all else stands in pyproject.toml.
# SUREFOOT_CMAKE_OPTIONS: more options of CMake's. SUREFOOT_BUILD_FOLDER: a folder that CMake has
# configured already, whose module is taken.
import os
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        given = os.environ.get("SUREFOOT_BUILD_FOLDER")
        built = Path(given or self.build_temp).resolve()
        if not given:
            self.configure(built)
        subprocess.run(["cmake", "--build", built, "--target", "surefoot_python"], check=True)
        target = Path(self.get_ext_fullpath(ext.name)).resolve()
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(built / "python" / "surefoot" / target.name, target)

    def configure(self, folder):
        options = [
            f"-DPython3_EXECUTABLE={sys.executable}",
            "-DCMAKE_BUILD_TYPE=Release",
            "-DSUREFOOT_PYTHON_MODULE=ON",
            "-DSUREFOOT_APP=OFF",
            "-DSUREFOOT_TESTS=OFF",
            "-DSUREFOOT_BENCHMARKS=OFF",
            *os.environ.get("SUREFOOT_CMAKE_OPTIONS", "").split(),
        ]
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", *options], check=True)


setup(ext_modules=[Extension("surefoot._core", sources=[])], cmdclass={"build_ext": CMakeBuild})
