#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""completion_test.py PROGRAM: bash's completion of the program, by bash itself.

Every option that a command's help names is offered and on its manual page, and no other; and keys that are typed into an
interactive bash become what a user expects.
"""
import os
import pathlib
import pty
import re
import select
import subprocess
import sys
import tempfile
import time

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
TYPED = [  # what is typed before the tabulator, and what the program is then called with
    ("surefoot simu", ["simulate"]),
    ("surefoot run --pose-of b", ["run", "--pose-of", "base"]),
    ("surefoot run --pose-of=b", ["run", "--pose-of=base"]),
    ("surefoot run --method kiss", ["run", "--method", "kiss-icp"]),
    ("surefoot run --stamp-at e", ["run", "--stamp-at", "end"]),
    ("surefoot eval --align-p", ["eval", "--align-poses"]),
    ("surefoot info walk", ["info", "walk in the hall.pcap"]),
    ("surefoot run --output wa", ["run", "--output", "walk in the hall.pcap"]),
]
SECONDS = 60  # that bash may take for a line on a machine with other work


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def offered(script, *words):
    call = (f'source "{script}"; COMP_WORDS=({" ".join(words)}); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1));'
            '_surefoot; printf "%s\\n" "${COMPREPLY[@]}"')
    return set(output("bash", "--norc", "-c", call).split())


def check_offers(script):
    commands = re.findall(r"^  ([a-z]+) ", output(PROGRAM, "--help").split("Subcommands:")[1], re.M)
    assert {"run", "live", "map"} <= set(commands), commands
    assert set(commands) == offered(script, "surefoot", '""') - {"--help", "--version"}
    for command in commands:
        names = re.findall(r"^ +((?:-\w,)?--[\w,-]+)", output(PROGRAM, command, "--help"), re.M)
        known = {name for line in names for name in line.split(",") if name.startswith("--")}
        assert known == offered(script, "surefoot", command, "--"), command
        page = output(PROGRAM, "manual", command).replace("\\-", "-")
        heads = re.findall(r"^\.TP\n\.B ([-\w, ]+)", page, re.M)
        told = {name.strip() for line in heads for name in line.split(",")}
        assert known == {name for name in told if name.startswith("--")}, command


class Terminal:
    """An interactive bash in which `surefoot` says what it is called with."""

    def __init__(self, script, folder):
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(folder)
            os.environ.update(TERM="dumb", INPUTRC="/dev/null", HISTFILE="/dev/null")
            os.execvp("bash", ["bash", "--norc", "--noprofile", "-i"])
        self.call(f'source "{script}"; surefoot() {{ printf "<%s>\\n" "$@"; }}')

    def call(self, line):
        """What is printed until the line is done."""
        os.write(self.terminal, (line + '\necho "do""ne"\n').encode())
        said, until = b"", time.monotonic() + SECONDS
        while b"\ndone\r" not in said:
            if time.monotonic() > until:
                raise AssertionError(f"{line!r}: {said.decode()}")
            if select.select([self.terminal], [], [], 0.2)[0]:
                said += os.read(self.terminal, 65536)
        return said.decode()

    def close(self):
        os.close(self.terminal)
        os.waitpid(self.process, 0)


def main():
    with tempfile.TemporaryDirectory() as folder:
        script = pathlib.Path(folder) / "completion"
        script.write_text(output(PROGRAM, "manual", "--completion"))
        check_offers(script)
        (pathlib.Path(folder) / "walk in the hall.pcap").touch()
        bash = Terminal(script, folder)
        for typed, expected in TYPED:
            said = bash.call(typed + "\t")
            called = re.findall(r"^<(.*)>\r$", said, re.M)
            assert called == expected, f"{typed!r}: {called}, expected {expected}\n{said}"
        bash.close()


if __name__ == "__main__":
    main()
