"""What a command that refuses its input tells, and that it touches nothing."""

from __future__ import annotations

import os
from hashlib import sha256
from pathlib import Path

from click.testing import Result

from support.command import invoke

SCENE = """title = "Rocker"
language = "en"
[lengths]
r = "0.1 m"
[frame]
number = 0
O = [0, 0]
C = ["0.35 m", 0]
[[link]]
number = 1
points = { O = [0, 0], A = ["r", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["0.3 m", 0], S2 = ["0.15 m", 0] }
mass = "2 kg"
J = "0.02 kg*m^2"
centre = "S2"
[[link]]
number = 3
points = { C = [0, 0], B = ["0.25 m", 0] }
side = "left of AC"
[drive]
link = 1
speed = "120 rpm"
turns = "counterclockwise"
positions = 12
accelerations = [2, 6]
zero = "0 deg"
[plans]
trajectories = ["B"]
[scales]
mu_l = "0.002 m/mm"
[hand]
name = "exact"
ruler = "0.1 mm"
[[sheet]]
format = "A1"
place = ["positions", "velocities"]
[title_block]
name = "Rocker"
"""
"""A scene that is right, to be made wrong."""


def refused(done: Result, *words: str) -> None:
    """Hold what a refusal is: status 2, a message for people with these words, nothing else."""
    assert done.exit_code == 2, done.output
    assert isinstance(done.exception, SystemExit)
    assert done.stdout == ""
    assert all(word in done.stderr for word in words), done.stderr
    assert done.stderr.startswith(("graphic-tmm: ", "Usage: ", "Error: "))
    assert all(line.isprintable() for line in done.stderr.split("\n"))
    assert len(done.stderr) < 4000


def stands(folder: Path) -> dict[str, str]:
    """Return what stands in a folder, of each file a few letters that tell its bytes."""
    return {
        str(p.relative_to(folder)): sha256(p.read_bytes()).hexdigest()[:16] if p.is_file() else ""
        for p in folder.rglob("*")
    }


def run(folder: Path, *arguments: str) -> Result:
    """Run a command in a folder; nothing in it may change."""
    before, home = stands(folder), os.getcwd()
    os.chdir(folder)
    try:
        done = invoke(*arguments)
    finally:
        os.chdir(home)
    assert stands(folder) == before
    return done
