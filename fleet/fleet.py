# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""surefoot_fleet: makes the plan, hands it to Snakemake, and says what failed."""
import fcntl
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys

import plan as planning
import settings as reading
import work

HERE = pathlib.Path(__file__).resolve().parent
USAGE = "usage: surefoot_fleet SETTINGS.yaml [--profile slurm] [OPTIONS OF SNAKEMAKE]"
MOST_TOLD = 10  # runs that failed; runs.csv has them all


def forget(plan):
    """Marks of runs whose results are not there any more, or that are to be tried again; and what
    was made of all, unless all are there: Snakemake would be content with it."""
    whole = True
    for mark, run in plan["runs"].items():
        done = pathlib.Path(plan["output"], "fleet/done", mark)
        if done.exists():
            outcome = json.loads(done.read_text())["outcome"]
            folder = pathlib.Path(plan["output"], run["folder"])
            gone = outcome != "failed" and not all((folder / name).exists() for name in run["leaves"])
            if gone or (outcome != "ok" and plan["retry_failed"]):
                done.unlink()
        whole = whole and done.exists()
    if not whole:
        work.report_file(plan).unlink(missing_ok=True)


def make_plan(file):
    """The plan, its file, and the lock that keeps others from this output folder."""
    settings = reading.read(file)
    own = pathlib.Path(settings["output"], "fleet")
    own.mkdir(parents=True, exist_ok=True)
    lock = (own / "lock").open("w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise reading.SettingsError(f"{settings['output']}: another fleet is at work on it") \
            from None
    hashes = planning.Hashes(own / "hashes.json")
    plan = planning.make(settings, hashes)
    hashes.keep()
    plan.update(python=sys.executable, workflow=str(HERE))
    forget(plan)
    planning.write_whole(own / "plan.json", json.dumps(plan, indent=1))
    return plan, own / "plan.json", lock


def snakemake_call(plan_file, words):
    """--profile slurm is ours; without any choice of where, this machine's cores. Marks come into
    being whole, and the lock is ours: it does not outlive a machine that died."""
    words = list(words)
    for i, word in enumerate(words):
        if word == "--profile=slurm" or (word == "slurm" and words[i - 1:i] == ["--profile"]):
            words[i] = word.removesuffix("slurm") + str(HERE / "slurm")
            os.environ["PATH"] = f"{HERE / 'slurm'}:{os.environ['PATH']}"
    where = ("--profile", "--jobs", "--cores", "-j", "-c")
    if not any(word.startswith(where) for word in words):
        words = ["--cores", "all", *words]
    return ["snakemake", "--snakefile", str(HERE / "Snakefile"), "--configfile", str(plan_file),
            "--rerun-triggers", "mtime", "--ignore-incomplete", "--keep-going", "--nolock",
            "--scheduler", "greedy", *words]


def run_workflow(command, lock):
    """Snakemake holds the lock, too: it may outlive us."""
    child = subprocess.Popen(command, pass_fds=[lock.fileno()])
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the terminal tells both of Ctrl-C
    signal.signal(signal.SIGTERM, lambda *_: child.terminate())
    return child.wait()


def tell(plan):
    """What came of the runs; 1 if one of them failed, or what is made of them."""
    lines, done = [], 0
    for run, result in work.results(plan):
        done += 1
        if result["outcome"] != "ok":
            lines.append(f"  {run['folder']}: {result['outcome']}: {result['words']}")
    file = work.report_file(plan)
    report = json.loads(file.read_text()) if file.exists() else {"exit_code": 0, "text": ""}
    if plan["merge"]:
        sys.stderr.write(report["text"])
    print(f"fleet: {done} of {len(plan['runs'])} runs done, {len(lines)} not ok",
          *lines[:MOST_TOLD], sep="\n", file=sys.stderr)
    if len(lines) > MOST_TOLD:
        print(f"  and {len(lines) - MOST_TOLD} more: fleet/runs.csv", file=sys.stderr)
    if not lines and report["exit_code"] != 0 and not plan["merge"]:
        print("  but the tables name some that could not be evaluated", file=sys.stderr)
    print("results:", plan["output"], file=sys.stderr)
    return 1 if lines or report["exit_code"] != 0 else 0


def main(words):
    if words[:1] in (["-h"], ["--help"]):
        print(USAGE)
        return 0
    if not words or words[0].startswith("-"):
        print(USAGE, file=sys.stderr)
        return 2
    if not shutil.which("snakemake"):
        print("fleet: there is no snakemake here (Debian: snakemake)", file=sys.stderr)
        return 2
    try:
        plan, plan_file, lock = make_plan(pathlib.Path(words[0]))
    except (reading.SettingsError, OSError) as error:
        print(f"fleet: {error}", file=sys.stderr)
        return 2
    code = run_workflow(snakemake_call(plan_file, words[1:]), lock)
    told = tell(plan)
    return code or told


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
