# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""A job of the workflow: one run, or what is made of all of them.

    work.py PLAN run MARK
    work.py PLAN report
"""
import contextlib
import csv
import fcntl
import json
import pathlib
import shutil
import signal
import subprocess
import sys
import time

from plan import COMPARISONS, write_whole

INTERRUPTED = (130, -signal.SIGINT, -signal.SIGTERM)
WORKED = (0, 1)  # 1: but for what is named
OURS = "this folder is the fleet's"  # in a run's lock
MOST_SHOWN = 100  # runs on one page: a thousand are 140 MB, which no browser likes


def call(plan, arguments, lock=None):
    """surefoot's exit code, output and errors; a signal for us is one for it."""
    held = [lock.fileno()] if lock else []
    child = subprocess.Popen([plan["program"], *arguments], text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.PIPE, errors="replace", pass_fds=held)
    signal.signal(signal.SIGTERM, lambda *_: child.terminate())
    output, errors = child.communicate()
    if child.returncode in INTERRUPTED:
        sys.exit(130)
    return child.returncode, output, errors


def worse(code, other):
    """Of two exit codes; less than zero: a signal ended it."""
    return min(code, other) if min(code, other) < 0 else max(code, other)


def last_words(plan, run, errors):
    """Why it failed: what it said itself, or, of a comparison's run, its log."""
    log = pathlib.Path(plan["output"], run["folder"], "run.log")
    if not errors.strip() and log.exists():
        errors = log.read_text(errors="replace")
    return "; ".join(errors.strip().splitlines()[-2:])


def outcome(plan, code):
    """A comparison's part is one run: if that failed, all has."""
    partly = "failed" if plan["command"] in COMPARISONS else "partly"
    return {0: "ok", 1: partly}.get(code, "failed")


def remove_tiles(folder):
    if (folder / "tileset.json").exists():
        shutil.rmtree(folder)


def is_filled(folder):
    return folder.is_dir() and any(folder.iterdir())


def make_ours(lock):
    """Known before the run, which may be killed."""
    lock.write(OURS)
    lock.flush()


def do_run(plan, mark):
    """Leaves its mark, also of a run that failed: it would fail again. A folder that a fleet has
    made or filled it fills again, whatever map is there; another's map is no fleet's to lose."""
    run = plan["runs"][mark]
    folder = pathlib.Path(plan["output"], run["folder"])
    done = pathlib.Path(plan["output"], "fleet/done", mark)
    with (done.parent / "lock").open("a+") as lock:
        # What a fleet that was killed has left running is waited for.
        with contextlib.suppress(OSError):
            fcntl.flock(lock, fcntl.LOCK_EX)
        if done.exists():
            return
        for other in done.parent.iterdir():  # what was in the run's folder up to now
            if other.name != "lock":
                other.unlink()
        remove_tiles(folder / "tiles")
        lock.seek(0)
        is_ours = lock.read() == OURS
        if not is_ours and not is_filled(folder):
            make_ours(lock)
            is_ours = True
        again = ["--overwrite"] if is_ours and plan["command"] not in COMPARISONS else []
        begin = time.monotonic()
        code, _, errors = call(plan, [*plan["common"], *run["arguments"], *again], lock)
        if code in WORKED and not is_ours:
            make_ours(lock)
        if code in WORKED and run["then"]:
            further, _, more = call(plan, run["then"], lock)
            code, errors = worse(code, further), errors + more
        sys.stderr.write(errors)
        write_whole(done, json.dumps({"outcome": outcome(plan, code), "exit_code": code,
                                      "words": last_words(plan, run, errors) if code else "",
                                      "seconds": round(time.monotonic() - begin, 3)}))


def results(plan):
    """Of each run that was done: itself and its mark's content."""
    for mark, run in plan["runs"].items():
        done = pathlib.Path(plan["output"], "fleet/done", mark)
        if done.exists():
            yield run, json.loads(done.read_text())


def report_file(plan):
    return pathlib.Path(plan["output"], "fleet", "report_" + plan["report"])


def write_table(plan):
    with pathlib.Path(plan["output"], "fleet/runs.csv").open("w", newline="") as file:
        table = csv.writer(file)
        table.writerow(["recording", "method", "folder", "outcome", "exit_code", "seconds", "said"])
        for run, result in results(plan):
            table.writerow([run["recording"], run["method"], run["folder"], result["outcome"],
                            result["exit_code"], result["seconds"], result["words"]])


def join_maps(plan, folders):
    """One map of all that can be joined to the first; (exit code, what was said)."""
    joint = pathlib.Path(plan["output"], "joint")
    (joint / "map.surefoot").unlink(missing_ok=True)
    remove_tiles(joint / "tiles")
    if len(folders) < 2:
        return 1, f"nothing to join: {len(folders)} of {len(plan['runs'])} maps are there\n"
    code, output, errors = call(plan, ["merge", *folders, "-o", joint, "--overwrite",
                                       "--leave-out"])
    text = output + errors
    if plan["tiles"] and (joint / "map.surefoot").exists():
        further, output, errors = call(plan, ["export", joint, "--tiles", joint / "tiles"])
        code, text = worse(code, further), text + output + errors
    return code, text


def do_report(plan):
    """Tables, pages and whatever is made of all runs; what was said goes to its file."""
    write_table(plan)
    code, text = 0, ""
    if plan["command"] in COMPARISONS:
        code, text, errors = call(plan, plan["common"])
        if code not in WORKED:
            sys.exit(errors.strip() or f"{plan['command']} ended with exit code {code}")
        shown, count = [plan["output"]], len(plan["runs"])
    else:
        shown = [str(pathlib.Path(plan["output"], run["folder"]))
                 for run, result in results(plan) if result["outcome"] != "failed"]
        count = len(shown)
        if plan["merge"]:
            code, text = join_maps(plan, shown)
    page = pathlib.Path(plan["output"], "report.html")
    page.unlink(missing_ok=True)
    if 0 < count <= MOST_SHOWN:
        text += call(plan, ["report", *shown, "-o", page])[2]
    write_whole(report_file(plan), json.dumps({"exit_code": code, "text": text}, indent=1))


def main(plan_file, what, *mark):
    plan = json.loads(pathlib.Path(plan_file).read_text())
    try:
        return do_run(plan, *mark) if what == "run" else do_report(plan)
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
