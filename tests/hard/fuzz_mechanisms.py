"""Mechanisms drawn at random, by every command: each is drawn, or refused with one message; nothing else.

    python tests/hard/fuzz_mechanisms.py 300 [--seed 0] [--first 0] [--jobs 2]

A mechanism is told by the seed and its number alone: ``--only N`` prints its scene and what every command said.
"""

from __future__ import annotations

import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from fuzz import Case, command, run
from fuzz_options import CSV, OUT, SCENE
from fuzz_tasks import Task

from graphic_tmm.checking.cells import cells
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.one_letter import GROUPS, scene

TEMPLATE = "t.csv"
DRAW = ("draw", SCENE, "-o", OUT, "-f", "svg,dxf", "--composition")
"""What is run of every mechanism first; the composition that it writes is used by what follows."""
BLANK = ("template", SCENE, "-o", f"{OUT}/{TEMPLATE}")
IN_TURN: tuple[tuple[tuple[str, ...], ...], ...] = (
    (("page", SCENE, "-o", OUT),),
    (("table", SCENE, "-f", "json", "--exact"), BLANK, ("check", SCENE, CSV, "--trials", "20")),
    (("steps", SCENE, "--why"), ("steps", SCENE, "--sheets", "-o", OUT)),
    (("note", SCENE, "-f", "md", "-o", OUT),),
    (("table", SCENE, "-f", "csv", "--hand", "student", "--trials", "3"), ("table", SCENE)),
    (("accuracy", SCENE, "-f", "json", "--trials", "10", "--no-time"),),
    (("page", SCENE, "--practice", "-o", OUT),),
    ((*BLANK, "--short"), ("steps", SCENE, "-p", "scales", "-l", "ru")),
    (("task", SCENE, "-o", OUT, "-j", "0", "--keys", "sheets,table,page", "--readings"),),
    (("batch", SCENE, CSV, "-o", OUT, "--make", "draw,table,scene", "--jobs", "1"),),
    (("note", SCENE, "-f", "html", "-l", "ru", "-o", OUT), ("steps", SCENE)),
)
"""What is run of one mechanism each, in turn."""
VARIANTS = "variant,drive.speed\n1,7 rad/s\n2,600 rpm\n"
UNDEFINED = re.compile(r"(?<![\w.-])-?(nan|inf|None)(?![\w-])")
"""What no file and no line holds."""


class Told(NamedTuple):
    """What a command came to: its line, exit status, seconds, what is wrong, what it printed."""

    line: tuple[str, ...]
    status: int
    seconds: float
    fault: str


def lines_of(number: int) -> tuple[tuple[str, ...], ...]:
    """Return what is run of a mechanism: in time every command on every kind of groups."""
    return (DRAW, *IN_TURN[(number + number // len(GROUPS)) % len(IN_TURN)])


def told(text: str, folder: Path, lines: tuple[tuple[str, ...], ...]) -> Iterator[Told]:
    """Run commands on a scene, in a folder in which each leaves what those behind it use."""
    out, readings = folder / "out", b""
    for line in lines:
        shutil.rmtree(out, ignore_errors=True)
        given = VARIANTS.encode() if line[0] == "batch" else readings
        status, seconds, fault = run(Task("", "", text, given, line=line), folder)
        yield Told(line, status, seconds, fault or (_undefined(out) if status == 0 else ""))
        if line is DRAW and status == 2:
            return  # the scene itself is refused
        if (drawn := out / "composition.toml").exists():
            shutil.copy(drawn, folder)
        if (template := out / TEMPLATE).exists() and not readings:
            readings = filled(template.read_text("utf-8-sig"), folder / "scene.toml")


def _undefined(out: Path) -> str:
    """Return what is written that is no figure and no word."""
    for path in out.rglob("*") if out.exists() else ():
        if path.suffix in (".svg", ".md", ".csv", ".json"):
            found = UNDEFINED.search(path.read_text("utf-8-sig"))
            if found:
                return f"{path.name} holds {found[0]}"
    return ""


def filled(template: str, file: Path) -> bytes:
    """Return a template with what an exact drawing has; every fifth figure is half as large again."""
    due = cells(make(read(file), exact=True))
    lines = template.splitlines()
    head = next(k for k, line in enumerate(lines) if line.endswith(("x,y", "x;y")))
    sign = lines[head][-2]
    for k, line in enumerate(lines[head + 1 :], head + 1):
        plan, position, segment, *_, unit = line.split(sign)[:6]
        found, times = due.get((plan, segment, position)), 1.5 if k % 5 == 4 else 1.0
        if found is None or (found.mm is None and found.value is None):
            continue
        mm = "" if found.mm is None else f"{abs(found.mm) * times:.1f}"
        value = f"{found.value * times:.6g}" if found.mm is None and found.value else ""
        lines[k] = sign.join([plan, position, segment, mm, value, unit, "", ""])
    return "\n".join(lines).encode()


def task(seed: int, number: int) -> Task:
    """Return the scene of a case."""
    return Task("", "", scene(number, seed), None)


def case(number: int, seed: int = 0) -> Case:
    """Run every command on one mechanism; the first fault of them, the largest status, all seconds."""
    folder = Path(tempfile.mkdtemp())
    try:
        found = list(told(scene(number, seed), folder, lines_of(number)))
    finally:
        shutil.rmtree(folder)
    faults = [f"{' '.join(one.line)}: {one.fault}" for one in found if one.fault]
    most = max(one.status for one in found)
    return Case(number, "", "", most, sum(one.seconds for one in found), "\n".join(faults))


if __name__ == "__main__":
    sys.exit(command("Draw mechanisms at random by every command.", task, case, 300))
