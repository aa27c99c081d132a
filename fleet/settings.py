# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""fleet.yaml: what may stand in it for which command, and what it asks of surefoot."""
import os
import pathlib
import shutil

import yaml

# Of each command the keys that it alone takes.
COMMANDS = {"compare": ["methods"], "ablate": ["method"], "sweep": ["method", "vary"],
            "map": ["merge", "tiles"], "reference": []}
# Of each key what it has to be, and what it is if nothing is said.
KEYS = {"command": (str, "compare"), "recordings": (list, []), "output": (str, "results/fleet"),
        "options": (list, []), "program": (str, "surefoot"), "retry_failed": (bool, False),
        "methods": (list, []), "method": (str, ""), "vary": (list, []), "merge": (bool, False),
        "tiles": (bool, False)}
KINDS = {str: "a text", list: "a list", bool: "true or false"}


class SettingsError(Exception):
    """What is wrong with the settings, in one line."""


def load(file):
    if not file.is_file():
        raise SettingsError(f"{file}: there is no such file")
    try:
        content = yaml.safe_load(file.read_text())
    except yaml.YAMLError as error:
        raise SettingsError(f"{file}: not YAML: " + " ".join(str(error).split())) from error
    except (OSError, UnicodeDecodeError) as error:
        raise SettingsError(f"{file}: {error}") from error
    if not isinstance(content, dict):
        raise SettingsError(f"{file}: expected keys and values, as in 'recordings: [walks/a]'")
    return content


def check_keys(given, command):
    taken = [key for key in KEYS
             if key in COMMANDS[command] or not any(key in own for own in COMMANDS.values())]
    for key, value in given.items():
        if key not in taken:
            reason = f"is not of {command}" if key in KEYS else "is unknown"
            raise SettingsError(f"key '{key}' {reason}; expected " + ", ".join(taken))
        kind = KEYS[key][0]
        if not isinstance(value, kind):
            raise SettingsError(f"{key}: '{value}'; expected {KINDS[kind]}")
        for word in value if kind is list else [value]:
            if "\0" in str(word):
                raise SettingsError(f"{key}: {word!r}; a text holds no NUL")
        if kind is list:
            for word in value:
                if isinstance(word, bool) or not isinstance(word, (str, int, float)):
                    raise SettingsError(f"{key}: '{word}' in its list; expected a text")


def recordings_of(words):
    if not words:
        raise SettingsError("no recordings; expected 'recordings: [A, B]'")
    # Of a link its own name and neighbours count, as surefoot sees them.
    paths = [pathlib.Path(os.path.abspath(word)) for word in words]
    known = set()
    for path in paths:
        if not path.exists():
            raise SettingsError(f"{path}: no such recording")
        if path in known:
            raise SettingsError(f"recordings: {path} is named twice")
        known.add(path)
    return [str(path) for path in paths]


def read(file):
    """All keys that the file's command takes, with absolute paths. Throws SettingsError."""
    given = load(file)
    command = given.get("command", "compare")
    if not isinstance(command, str) or command not in COMMANDS:
        raise SettingsError(f"command: '{command}'; expected one of " + ", ".join(COMMANDS))
    check_keys(given, command)
    settings = {key: given.get(key, default) for key, (_, default) in KEYS.items()}
    for key in ("recordings", "options", "methods", "vary"):
        settings[key] = [str(word) for word in settings[key]]
    if command == "sweep" and not settings["vary"]:
        raise SettingsError("sweep: nothing to vary; expected 'vary: [knots.points=1000:3000:500]'")
    program = shutil.which(settings["program"])
    if not program:
        raise SettingsError("there is no such program: " + settings["program"])
    settings["program"] = str(pathlib.Path(program).resolve())
    settings["output"] = str(pathlib.Path(settings["output"]).resolve())
    settings["recordings"] = recordings_of(settings["recordings"])
    return settings
