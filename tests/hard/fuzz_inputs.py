"""Files beside a scene, changed at random: each command is done, or refused with one message; nothing else.

    python tests/hard/fuzz_inputs.py 5000 [--seed 0] [--first 0] [--jobs 2]

Compositions, rules for marks, ranges, tables of variants, readings of a class, workbooks, minutes: each case
begins with files that are good and are judged (`unchanged`), and changes one. It is told by the seed and its
number alone: ``--only N`` runs it again and prints its files.
"""

from __future__ import annotations

import random
import re
import sys
from functools import cache

from fuzz import Case, cased, command
from fuzz_changes import (
    NUMBER,
    STRANGE,
    Change,
    amount,
    at_one,
    bytes_of,
    cut_off,
    double_line,
    drop_block,
    drop_line,
    move_line,
    number,
    shuffle_blocks,
    strange,
)
from fuzz_options import CSV, FOLDER, MINUTES, OUT, SCENE, TABLE
from fuzz_readings import CHANGES as OF_READINGS
from fuzz_readings import as_workbook, cell, readings
from fuzz_tasks import QUICKEST, Task
from support.gallery import SHEETS
from support.workbooks import workbook

from graphic_tmm.fitting.composition import text as composition_text
from graphic_tmm.scene.read import read
from graphic_tmm.studio import composed_sheets

NAME = "crank-rocker"
"""The scene of most cases: it has ranges, is soon drawn, and all of it is read off plans."""
MARKS = """# a rule that says every thing that one may say
[mark]
steps = { 5 = 85, 4 = 70, 3 = 50 }
below = "2"
[points]
wrong = 4
segment = 12
mistake = 10
doubtful = 0.5
doubtful_most = 5
plan = 20
reading = 1
variant = 60
[asked]
plans = ["velocities"]
"""
VARIANTS = """variant,"link 1, points.A[1]",drive.speed
01,20 mm,1200 rpm
02,18 mm,1000 rpm
"""
CHANGES: tuple[tuple[Change, int], ...] = (
    *((number, 5), (amount, 2), (strange, 5), (drop_line, 2), (double_line, 2), (move_line, 1)),
    *((drop_block, 1), (shuffle_blocks, 1), (bytes_of, 3), (cut_off, 1)),
)
KEYS = ("", "x", "[x]", "[[x]]", '"x y"', "x.y.z", "π")


@cache
def composition() -> str:
    """Return how a scene is composed, as its file says it."""
    found = composed_sheets(read(SHEETS / NAME))[1]
    return composition_text(found.composition, found.scales)


def key(source: random.Random, text: str) -> str:
    """Call a key otherwise, or give it something else."""
    lines = text.split("\n")
    at = source.randrange(len(lines))
    name, sign, value = lines[at].partition(" = ")
    if source.random() < 0.5:
        name = source.choice(KEYS)
    else:
        value = source.choice((*STRANGE, "9" * 400, "[" * 3000, "{ a = 1 }", "{}", "[{}]"))
    lines[at] = f"{name}{sign or ' = '}{value}"
    return "\n".join(lines)


def changed(source: random.Random, text: str, ways: tuple[tuple[Change, int], ...]) -> bytes:
    """Return a text with one to three changes, some of its bytes torn."""
    names, weights = zip(*ways, strict=True)
    for way in source.choices(names, weights, k=source.choice((1, 1, 2, 3))):
        text = way(source, text)
    data = text.encode("utf-8", "surrogatepass")
    if source.random() < 0.05:
        at = source.randrange(len(data) + 1)
        data = data[:at] + source.randbytes(3) + data[at + 1 :]
    return data


# ---------------------------------------------------------------- what is run


@cache
def plain_workbook() -> bytes:
    """Return good readings as a workbook."""
    rows = [line.split(",") for line in readings(NAME).split("\n")]
    typed = [[float(one) if NUMBER.fullmatch(one) else one or None for one in row] for row in rows]
    return workbook({"readings": typed})


def handed() -> dict[str, bytes]:
    """Return what a class of one hands in, which is judged in this process, and what is no hand-in."""
    return {"handed/Ivanov-01.csv": readings(NAME).encode(), "handed/readme.md": b"no hand-in"}


@cache
def unchanged(kind: str) -> Task:
    """Return the task of a kind, its files good."""
    own = QUICKEST if kind == "minutes" else NAME
    scene = (SHEETS / own / "scene.toml").read_text("utf-8")
    marking = ("mark", SCENE, f"{FOLDER}/handed", "--trials", "20", "-o", OUT)
    by_table = (*marking, "--variants", f"{FOLDER}/variants.csv")
    table = {"variants.csv": VARIANTS.encode()}
    at_once = ("-f", "json", "--trials", "10", "--no-time")
    drawing = ("draw", SCENE, "-o", OUT)
    ranging = ("variants", SCENE, "-n", "2", "--ranges", f"{FOLDER}/ranges.toml")
    lines: dict[str, tuple[tuple[str, ...], dict[str, bytes]]] = {
        "composition": (drawing, {"composition.toml": composition().encode()}),
        "marks": (
            (*by_table, "--marks", f"{FOLDER}/marks.toml"),
            {**handed(), **table, "marks.toml": MARKS.encode()},
        ),
        "ranges": (ranging, {"ranges.toml": (SHEETS / NAME / "ranges.toml").read_bytes()}),
        "variants": (by_table, {**handed(), **table}),
        "class": (marking, handed()),
        "workbook": (
            ("check", SCENE, f"{FOLDER}/r.xlsx", "-f", "json", "--trials", "20"),
            {"r.xlsx": plain_workbook()},
        ),
        "readings": (("check", SCENE, CSV, "-f", "json", "--trials", "20"), {}),
        "minutes": (("accuracy", SCENE, *at_once, "--minutes", MINUTES), {}),
    }
    line, files = lines[kind]
    csv = readings(NAME).encode() if kind == "readings" else None
    minutes = TABLE.encode() if kind == "minutes" else None
    return Task(own, kind, scene, csv, minutes, line, None, tuple(files.items()))


KINDS = {
    **{"composition": 5, "marks": 4, "ranges": 3, "variants": 3},
    **{"class": 2, "workbook": 4, "readings": 5, "minutes": 2},
}
"""How often each kind is run."""


def task(seed: int, number: int) -> Task:
    """Return the task of a case: told by the seed and its number alone."""
    source = random.Random(f"inputs:{seed}:{number}")
    kind = source.choices(list(KINDS), list(KINDS.values()))[0]
    whole = unchanged(kind)
    ways = (*CHANGES, (key, 8))
    if kind == "readings":
        return whole._replace(readings=changed(source, readings(NAME), OF_READINGS))
    if kind == "minutes":
        return whole._replace(minutes=changed(source, TABLE, ways))
    files = dict(whole.files)
    if kind == "workbook":
        text = changed(source, readings(NAME), OF_READINGS).decode("utf-8", "replace")
        files["r.xlsx"] = _torn(source, as_workbook(source, text))
        return whole._replace(files=tuple(files.items()))
    name = {"class": "handed/Ivanov-01.csv", "variants": "variants.csv"}.get(kind, f"{kind}.toml")
    by = {"class": OF_READINGS, "variants": ((cell, 6), (at_cell, 4), *CHANGES)}.get(kind, ways)
    files[name] = changed(source, files[name].decode(), by)
    return whole._replace(files=tuple(files.items()))


def at_cell(source: random.Random, text: str) -> str:
    """Put something strange in the place of a word or a number of a table."""
    return at_one(source, text, re.compile(r"[\w.]+"), lambda _: source.choice(STRANGE))


def _torn(source: random.Random, data: bytes) -> bytes:
    if source.random() < 0.7:
        return data
    torn = bytearray(data)
    for _ in range(source.choice((1, 3, 30))):
        torn[source.randrange(len(torn))] = source.randrange(256)
    return bytes(torn) if source.random() < 0.7 else data[: source.randrange(len(data))]


def case(number: int, seed: int = 0) -> Case:
    """Run one case."""
    return cased(number, task(seed, number))


if __name__ == "__main__":
    sys.exit(command("Change the files beside a scene at random.", task, case, 5000))
