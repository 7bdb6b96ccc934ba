"""What is run: a command, a scene, readings, minutes; one of them changed, or the command line itself."""

from __future__ import annotations

import random
from typing import NamedTuple

from fuzz_changes import changed_scene, scenes
from fuzz_options import (
    CSV,
    LINES,
    MINUTES,
    OUT,
    SCENE,
    TABLE,
    changed_minutes,
    changed_options,
)
from fuzz_readings import changed_readings, readings

HANDS = ("--hand", "student", "--seed", "3")
COMMANDS: dict[str, tuple[tuple[str, ...], int]] = {
    "draw": (("draw", "-o"), 3),
    "draw by hand": (("draw", *HANDS, "-o"), 1),
    "table": (("table", "-f", "json"), 4),
    "table by hand": (("table", "-f", "csv", *HANDS), 1),
    "table of trials": (("table", "-f", "json", *HANDS, "--trials", "20"), 1),
    "steps": (("steps",), 3),
    "template": (("template",), 1),
    "short template": (("template", "--short"), 1),
    "check": (("check", "-f", "json", "--trials", "20"), 3),
    "minutes": (("accuracy", "-f", "json", "--trials", "10", "--no-time", "--minutes"), 1),
    "options": ((), 3),
}
"""A command's words before its files, and how often it is run."""
QUICKEST = "cam"
"""The scene whose accuracy is found soonest."""


class Task(NamedTuple):
    """The scene it comes from, the command's name, the text of the scene, the readings and the minutes.

    None: there is no such file. ``line``: the words of the command line, with the names of files to be put in.
    ``files``: what else stands in the folder.
    """

    scene: str
    command: str
    text: str
    readings: bytes | None
    minutes: bytes | None = None
    line: tuple[str, ...] = ()
    photo: bytes | None = None
    files: tuple[tuple[str, bytes], ...] = ()


def unchanged(name: str, command: str) -> Task:
    """Return a command on a scene as it comes."""
    csv = readings(name).encode() if command in ("check", "options") else None
    minutes = TABLE.encode() if command in ("minutes", "options") else None
    return Task(name, command, scenes()[name], csv, minutes, _line(command))


def _line(command: str) -> tuple[str, ...]:
    """Return the words of a command line, with what stands for its files."""
    if command == "options":
        return LINES[0]
    verb, *options = COMMANDS[command][0]
    behind = {"draw": [OUT], "accuracy": [MINUTES]}.get(verb, [])
    return (verb, SCENE, *([CSV] if command == "check" else []), *options, *behind)


def task(seed: int, number: int, names: tuple[str, ...] = ()) -> Task:
    """Return the task of a case: told by the seed and its number alone."""
    source = random.Random(f"{seed}:{number}")
    name = source.choice(names or sorted(scenes()))
    command = source.choices(list(COMMANDS), [often for _, often in COMMANDS.values()])[0]
    if command == "minutes":
        return unchanged(QUICKEST, command)._replace(minutes=changed_minutes(source))
    if command == "options":
        return unchanged(name, command)._replace(line=changed_options(source))
    of_readings = command == "check" and source.random() < 0.7
    whole = unchanged(name, command)
    if of_readings:
        return whole._replace(readings=changed_readings(source, name))
    return whole._replace(text=changed_scene(source, name))
