#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Whether the tests find small defects: those of mutants.txt, one after the other.

    run_mutants.py --list                 checks that the list fits the sources (quick, a test)
    run_mutants.py --work FOLDER          copies the sources there, builds all mutants into one set
                                          of test programs, and runs the named tests for each
                                          (--only WORD: those whose file or program holds WORD)

All mutants are compiled at once: each place becomes a choice between what stands there and the
defect, by the environment's SUREFOOT_MUTANT. So a mutant costs a run of its tests and no build.
Exit code 1 if one survives that the list does not explain, or is found although it does.
"""
import argparse
import dataclasses
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SWITCH = '''#pragma once
#include <cstdlib>
inline bool surefoot_mutant(int number) {
  static const char* const chosen = std::getenv("SUREFOOT_MUTANT");
  static const int active = chosen != nullptr ? std::atoi(chosen) : 0;
  return active == number;
}
'''
LONGEST = 600  # [s] of one run of tests; a defect that never ends is found, too


@dataclasses.dataclass
class Mutant:
    number: int
    file: str
    program: str
    tests: str
    search: str
    replace: str
    survives: str = ""

    def __str__(self):
        return f"{self.number:3} {self.file}: {self.search}  ->  {self.replace}"


def read_list():
    mutants = []
    for line in (ROOT / "tests/mutants/mutants.txt").read_text().splitlines():
        if line.startswith("survives:"):
            mutants[-1].survives = line[len("survives:"):].strip()
        elif line and not line.startswith("#"):
            file, tests, search, replace = [part.strip().replace("\\|", "|")
                                            for part in re.split(r"(?<!\\) \| ", line)]
            program, _, pattern = tests.partition(" ")
            mutants.append(Mutant(len(mutants) + 1, file, program, pattern, search, replace))
    return mutants


def misfits(mutants):
    """Mutants whose place is not there, or there more than once."""
    found = []
    for mutant in mutants:
        path = ROOT / mutant.file
        times = path.read_text().count(mutant.search) if path.exists() else 0
        if times != 1:
            found.append(f"{mutant}: stands there {times} times, expected once")
    return found


def choice(mutant):
    test = f"surefoot_mutant({mutant.number})"
    if mutant.search.endswith(";"):
        return f"if ({test}) {{ {mutant.replace} }} else {{ {mutant.search} }}"
    return f"({test} ? ({mutant.replace}) : ({mutant.search}))"


def sources():
    """Every file of the project, but for what builds and runs leave."""
    left_out = {".git", "build", "recordings", "results", "node_modules"}
    for top in sorted(ROOT.iterdir()):
        if top.name in left_out:
            continue
        for path in [top] if top.is_file() else sorted(top.rglob("*")):
            if path.is_file() and "node_modules" not in path.parts:
                yield path.relative_to(ROOT)


def copy_mutated(mutants, source):
    for name in sources():
        target = source / name
        target.parent.mkdir(parents=True, exist_ok=True)
        text = (ROOT / name).read_bytes()
        here = [mutant for mutant in mutants if mutant.file == str(name)]
        if here:
            mutated = text.decode()
            for mutant in here:
                mutated = mutated.replace(mutant.search, choice(mutant))
            text = ('#include "mutant_switch.hpp"\n' + mutated).encode()
        if not target.exists() or target.read_bytes() != text:
            target.write_bytes(text)
    (source / "src/mutant_switch.hpp").write_text(SWITCH)
    shared = source.parent / "shared"
    if (ROOT.parent / "shared").exists() and not shared.exists():
        shared.symlink_to((ROOT.parent / "shared").resolve())


def build(mutants, source, folder):
    subprocess.run(["cmake", "-G", "Ninja", "-S", source, "-B", folder,
                    "-DCMAKE_BUILD_TYPE=Release", "-DSUREFOOT_TESTS=ON", "-DSUREFOOT_WEB=OFF",
                    "-DSUREFOOT_BENCHMARKS=OFF", "-DSUREFOOT_INSTALL=OFF",
                    f"-DCMAKE_CXX_COMPILER_LAUNCHER={shutil.which('ccache') or ''}"],
                   check=True, stdout=subprocess.DEVNULL)
    programs = sorted({mutant.program for mutant in mutants})
    # All that do not compile at once.
    subprocess.run(["cmake", "--build", folder, "--target", *programs, "--", "-k", "0"], check=True)


def passes(folder, program, tests, number):
    command = [folder / "tests" / program, f"--gtest_filter={tests}", "--gtest_fail_fast",
               "--gtest_brief=1"]
    environment = dict(os.environ, SUREFOOT_MUTANT=str(number))
    try:
        run = subprocess.run(command, env=environment, timeout=LONGEST, capture_output=True)
    except subprocess.TimeoutExpired:
        return False
    # A filter that names no test passes without a test; that is no test of anything.
    return run.returncode == 0 and b"[  PASSED  ] 0 tests" not in run.stdout


def run(mutants, folder):
    for program, tests in sorted({(mutant.program, mutant.tests) for mutant in mutants}):
        if not passes(folder, program, tests, 0):
            sys.exit(f"{program} --gtest_filter={tests} fails (or has no test) without a mutant")
    wrong = 0
    for mutant in mutants:
        killed = not passes(folder, mutant.program, mutant.tests, mutant.number)
        expected = killed != bool(mutant.survives)
        wrong += not expected
        verdict = "killed" if killed else "survives"
        print(f"{verdict:9}{'' if expected else 'UNEXPECTED '}{mutant}", flush=True)
    print(f"{len(mutants)} mutants, {wrong} not as expected")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--work", type=pathlib.Path)
    parser.add_argument("--only", default="", metavar="WORD")
    options = parser.parse_args()
    mutants = read_list()
    if problems := misfits(mutants):
        sys.exit("\n".join(problems))
    if options.list:
        print(f"{len(mutants)} mutants")
        return 0
    if not options.work:
        parser.error("--work FOLDER or --list")
    mutants = [mutant for mutant in mutants
               if options.only in mutant.file or options.only in mutant.program]
    if not mutants:
        parser.error(f"--only {options.only}: no mutant's file or program holds it")
    source, folder = options.work / "source", options.work / "build"
    copy_mutated(mutants, source)
    build(mutants, source, folder)
    return run(mutants, folder)


if __name__ == "__main__":
    sys.exit(main())
