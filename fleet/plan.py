# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""From settings to runs, each with a key of whatever decides on its result.

A plan is what the workflow and its jobs read, on whatever machine: the settings and

    runs    by their marks, FOLDER/KEY: "arguments" of surefoot, "then" those of a further call,
            "recording", "method", "folder" within the output, files that it "leaves" there
    report  the key of all runs together
"""
import collections
import hashlib
import json
import os
import pathlib
import re
import subprocess

from settings import SettingsError

COMPARISONS = ("compare", "ablate", "sweep")
NOT_FOR_RUNS = ("fleet", "joint")  # folders that are ours


def digest(value):
    return hashlib.sha256(json.dumps(value).encode()).hexdigest()


def write_whole(file, text):
    """Whoever reads it meanwhile sees the old one or the new one."""
    fresh = file.with_name(f"{file.name}.{os.getpid()}")
    fresh.write_text(text)
    fresh.replace(file)


def files_beside(recording):
    """What surefoot may read with a file: its truth, and by their names its sensor's calibration."""
    begin = recording.name.split(".")[0]
    named = [file for file in sorted(recording.parent.glob("*.json"))
             if file.stem.startswith(begin) or recording.name.startswith(file.stem)]
    truths = [recording.parent / "gt.tum"]
    if (recording.parent / "metadata.yaml").is_file():
        truths.append(recording.parent.parent / "gt.tum")  # beside the folder of a rosbag2
    return [file for file in (*truths, *named) if file.is_file()]


def files_above(folder):
    """In the folder above: stamps of a folder's scans, as KITTI's are, and the truth of a rosbag2."""
    names = ["times.txt", "timestamps.txt", "stamps.txt"]
    if (folder / "metadata.yaml").is_file():
        names.append("gt.tum")
    return [folder.parent / name for name in names if (folder.parent / name).is_file()]


class Hashes:
    """SHA-256 of files and folders; read again when a size or a time of change is another."""

    def __init__(self, file):
        self.file = file
        self.known = json.loads(file.read_text()) if file.exists() else {}

    def of(self, path):
        path = pathlib.Path(path).resolve()
        files = [path] if path.is_file() else sorted(f for f in path.rglob("*") if f.is_file())
        if not files:
            raise SettingsError(f"{path}: there is no file in it")
        states = [(f, f.stat()) for f in files]
        mark = digest([[str(f), state.st_size, state.st_mtime_ns] for f, state in states])
        kept = self.known.get(str(path))
        if kept is None or kept[0] != mark:
            content = [[str(f.relative_to(path)), self.content(f)] for f in files]
            kept = self.known[str(path)] = [mark, digest(content)]
        return kept[1]

    @staticmethod
    def content(file):
        with file.open("rb") as stream:
            found = hashlib.sha256()
            while block := stream.read(1 << 20):
                found.update(block)
        return found.hexdigest()

    def of_recording(self, path):
        recording = pathlib.Path(path)
        beside = files_beside(recording) if recording.is_file() else files_above(recording)
        return [self.of(path), [[file.name, self.of(file)] for file in beside]]

    def of_option(self, word):
        """Of a file that is named in it, or of the map in a folder that is; else nothing."""
        name = file_named_in(word)
        if not name:
            return ""
        file = pathlib.Path(name)
        if file.is_dir():
            file = file / "map.surefoot"
        return self.of(file) if file.is_file() else ""

    def keep(self):
        write_whole(self.file, json.dumps(self.known, indent=1))


def folder_names(paths):
    """As surefoot compare calls its recordings: the last part, after its parent's if need be."""
    def fit(text):  # byte by byte
        name = re.sub(rb"[^A-Za-z0-9_.+=-]", b"_", os.fsencode(text)).decode()
        return "_" + name if not name or name[0] == "." else name

    paths = [pathlib.Path(path) for path in paths]
    uses = collections.Counter(fit(path.name) for path in paths)
    names, taken = [], set(NOT_FOR_RUNS)
    for path in paths:
        stem = fit(path.name)
        if uses[stem] > 1:
            stem = fit(path.parent.name) + "-" + stem
        name, number = stem, 2
        while name in taken:
            name, number = f"{stem}-{number}", number + 1
        taken.add(name)
        names.append(name)
    return names


def comparison_arguments(settings):
    words = [settings["command"], *settings["recordings"]]
    if settings["methods"]:
        words += ["--methods", ",".join(settings["methods"])]
    if settings["method"]:
        words += ["--method", settings["method"]]
    for variation in settings["vary"]:
        words += ["--vary", variation]
    return [*words, *settings["options"], "--quiet", "-o", settings["output"]]


def comparison_runs(settings):
    """As surefoot itself counts them: it knows what an ablation or a sweep consists of."""
    call = [settings["program"], *comparison_arguments(settings), "--list-runs"]
    listed = subprocess.run(call, text=True, capture_output=True, check=False)
    if listed.returncode != 0:
        said = listed.stderr.strip().splitlines()
        raise SettingsError(said[0] if said else f"{settings['command']} ended with exit code "
                                                 f"{listed.returncode}")
    again = ["--retry-failed"] if settings["retry_failed"] else []
    for line in listed.stdout.splitlines():
        run = json.loads(line)
        yield {"arguments": ["--part", run["part"], *again], "then": [], "folder": run["folder"],
               "recording": run["recording"], "method": run["method"], "leaves": ["run.yaml"]}


def single_runs(settings):
    for recording, name in zip(settings["recordings"], folder_names(settings["recordings"])):
        folder = os.path.join(settings["output"], name)
        tiles = settings["tiles"] and not settings["merge"]
        leaves = ["run.yaml"] + ["map.surefoot"] * (settings["command"] == "map")
        yield {"arguments": [settings["command"], recording, *settings["options"], "--quiet", "-o",
                             folder],
               "then": ["export", folder, "--tiles", folder + "/tiles"] if tiles else [],
               "folder": name, "recording": recording, "method": settings["command"],
               "leaves": leaves + ["tiles/tileset.json"] * tiles}


def file_named_in(word):
    """Of --config=walk.yaml, or --pass=--stamps=times.txt, the file; else the word, which may be one."""
    word = word.removeprefix("--pass=")
    return word.partition("=")[2] if word.startswith("-") else word


def make(settings, hashes):
    """Throws SettingsError."""
    comparison = settings["command"] in COMPARISONS
    program = hashes.of(settings["program"])
    options = [[word, hashes.of_option(word)] for word in settings["options"]]
    contents = {path: hashes.of_recording(path) for path in settings["recordings"]}
    runs = {}
    for run in comparison_runs(settings) if comparison else single_runs(settings):
        if run["recording"] not in contents:
            raise SettingsError(f"options: they add {run['recording']}, which is none of 'recordings'")
        decides = [settings["command"], run["recording"], contents[run["recording"]],
                   run["method"], run["folder"], run["then"], options, program]
        runs[f"{run['folder']}/{digest(decides)}"] = run
    return {**settings, "runs": runs,
            "common": comparison_arguments(settings) if comparison else [],
            "report": digest([settings, list(runs)])}
