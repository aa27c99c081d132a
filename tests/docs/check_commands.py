#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Whether each `docs/results/measure_X ARGUMENTS` of the documents and of the kept results is taken
by that script as it stands there, in capital letters whatever a reader puts in. Nothing is measured.
"""
import argparse
import importlib.machinery
import importlib.util
import pathlib
import re
import shlex
import sys
import unittest.mock

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
IN_A_PAGE = re.compile(r"`(docs/results/measure_\w+ [^`]+)`")
OF_A_RESULT = re.compile(r"^# command: (docs/results/measure_\w+ .+)$", re.MULTILINE)
PARSE = argparse.ArgumentParser.parse_args


class Taken(Exception):
    """The arguments were, and the script need not go on."""


def parse_only(parser, words=None, namespace=None):
    PARSE(parser, words, namespace)
    raise Taken


def commands_in(file, pattern):
    """Without the words that may follow a command: in brackets or after a comma."""
    return [re.split(r", | \(", command)[0].replace("...", "") for command in
            pattern.findall(file.read_text())]


def why_not(command):
    """None if the script takes it."""
    name, *words = shlex.split(command)
    loader = importlib.machinery.SourceFileLoader(pathlib.Path(name).name, str(ROOT / name))
    script = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    try:
        loader.exec_module(script)
        with unittest.mock.patch.object(sys, "argv", [name, *words]), \
                unittest.mock.patch.object(argparse.ArgumentParser, "parse_args", parse_only):
            script.main()
    except Taken:
        return None
    except (OSError, SystemExit) as error:
        return f"ended with {error}"
    return "parsed no arguments"


def main():
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(ROOT / "docs/results"))
    import measuring
    measuring.commit_here = lambda: "a commit"  # what is unpacked without git has none
    places = [(file, IN_A_PAGE) for file in [ROOT / "README.md", *sorted(ROOT.glob("docs/*.md"))]]
    places += [(file, OF_A_RESULT) for file in sorted(ROOT.glob("docs/results/*.csv"))]
    commands = [(file, command) for file, pattern in places for command in commands_in(file, pattern)]
    problems = [f"{file.relative_to(ROOT)}: {command}: {reason}" for file, command in commands
                if (reason := why_not(command))]
    if not commands:
        problems.append("no command was found")
    print("\n".join(problems) or f"{len(commands)} commands are taken")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
