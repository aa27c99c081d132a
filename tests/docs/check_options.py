#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""Whether README.md or a page in docs names every option that a sub-command's --help lists. Of
options that are one (`--x,--no-x`) one name is enough.

    check_options.py PROGRAM
"""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SUB_COMMAND = re.compile(r"^  ([a-z]+) {2,}", re.MULTILINE)
OPTION = re.compile(r"^ +((?:-\w,)?--[a-z][\w,-]*)", re.MULTILINE)


def help_of(program, *words):
    return subprocess.run([program, *words, "--help"], text=True, check=True,
                          stdout=subprocess.PIPE).stdout


def main():
    program = sys.argv[1]
    pages = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
    named = set(re.findall(r"(?<![\w-])--[a-z][\w-]*", "\n".join(page.read_text() for page in pages)))
    sub_commands = SUB_COMMAND.findall(help_of(program).split("Subcommands:")[1])
    options = [(command, option) for command in sub_commands
               for option in OPTION.findall(help_of(program, command)) if "--help" not in option]
    unnamed = [f"{command} {option}" for command, option in options
               if not named & set(re.findall(r"--[\w-]+", option))]
    if len(sub_commands) < 10 or len(options) < 100:
        unnamed.append(f"of {len(sub_commands)} sub-commands {len(options)} options were found, too few")
    print("\n".join(f"no page names: {one}" for one in unnamed)
          or f"all {len(options)} options are named")
    return 1 if unnamed else 0


if __name__ == "__main__":
    sys.exit(main())
