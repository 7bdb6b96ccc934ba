"""What is run: a command, the text of a scene, and for ``check`` a file of readings; one of them changed."""

from __future__ import annotations

import random
from typing import NamedTuple

from fuzz_changes import changed_scene, scenes
from fuzz_readings import changed_readings, readings

HANDS = ("--hand", "student", "--seed", "3")
COMMANDS: dict[str, tuple[tuple[str, ...], int]] = {
    "draw": (("draw", "-o"), 3),
    "draw by hand": (("draw", *HANDS, "-o"), 1),
    "table": (("table", "-f", "json"), 4),
    "table by hand": (("table", "-f", "csv", *HANDS), 1),
    "table of trials": (("table", "-f", "json", *HANDS, "--trials", "20"), 1),
    "steps": (("steps",), 3),
    "template": (("check", "--template"), 1),
    "check": (("check", "-f", "json", "--trials", "20"), 3),
}
"""A command's words before its files, and how often it is run."""


class Task(NamedTuple):
    """The scene it comes from, the command's name, the text of the scene, the readings (None: no file)."""

    scene: str
    command: str
    text: str
    readings: bytes | None


def unchanged(name: str, command: str) -> Task:
    """Return a command on a scene as it comes."""
    csv = readings(name).encode() if command == "check" else None
    return Task(name, command, scenes()[name], csv)


def task(seed: int, number: int, names: tuple[str, ...] = ()) -> Task:
    """Return the task of a case: told by the seed and its number alone."""
    source = random.Random(f"{seed}:{number}")
    name = source.choice(names or sorted(scenes()))
    command = source.choices(list(COMMANDS), [often for _, often in COMMANDS.values()])[0]
    of_readings = command == "check" and source.random() < 0.7
    whole = unchanged(name, command)
    if of_readings:
        return whole._replace(readings=changed_readings(source, name))
    return whole._replace(text=changed_scene(source, name))
