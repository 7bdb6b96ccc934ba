"""Command lines and tables of minutes, changed at random."""

from __future__ import annotations

import random

from fuzz_changes import (
    STRANGE,
    Change,
    bytes_of,
    cut_off,
    double_line,
    drop_line,
    move_line,
    number,
    strange,
)

SCENE, CSV, MINUTES, OUT, PHOTO = "{scene}", "{csv}", "{minutes}", "{out}", "{photo}"
FOLDER = "{folder}"
"""What stands in a command line for the files of its case, for its folder of output, for the folder of all."""
LINES: tuple[tuple[str, ...], ...] = (
    ("draw", SCENE, "-o", OUT, "-f", "svg,dxf", "--hand", "student", "--seed", "3"),
    ("draw", SCENE, "-o", OUT, "--budget", "5%"),
    ("table", SCENE, "-f", "csv", "--trials", "3", "--hand", "careful", "--exact"),
    ("table", SCENE, "-f", "json", "--seed", "0"),
    ("steps", SCENE, "-p", "velocities", "-n", "1", "-l", "en", "--exact"),
    ("check", SCENE, CSV, "-f", "json", "--trials", "20", "--hand", "cad", "--wrong", "5"),
    ("check", SCENE, CSV, "--trials", "20", "--overlay", OUT + "/o.svg", "--enlarge", "3"),
    ("check", SCENE, "--template", "--doubtful", "0.9"),
    ("mark", SCENE, FOLDER, "--trials", "20", "-f", "csv"),
    ("photo", SCENE, CSV, "--corners", "0,0 9,0 9,9 0,9", "--sheet", "1"),
    (
        "template",
        SCENE,
        "--only",
        "velocities:pb",
        "--position",
        "1",
        "-o",
        OUT + "/t.xlsx",
    ),
    ("new", OUT, "--like", SCENE),
    ("scenes",),
    ("schema",),
)
WORDS = (
    *("", " ", "-", "--", "-1", "0", "1", "2.5", "1e9", "nan", "inf", "99999999999999999999", "x"),
    *(
        "svg",
        "png,",
        ",",
        "json",
        "html",
        "student",
        "exact",
        "all",
        "cam",
        "forces",
        "6*",
        "%",
        "2%",
    ),
    *("1,2 3,4", "\u202e", "\x1b[31m", "я", "a" * 300, "../..", "/dev/null", "/dev/zero", ".", "~"),
    *(
        "--exact",
        "--template",
        "--short",
        "--only",
        "--position",
        "--help",
        "--version",
        "--seed",
        "--hand",
        "-o",
        "-f",
        "--nonsense",
    ),
    *("--sheet", "--photo", "--corners", "--overlay", "--minutes", "--no-time", "-n", "-p", "-l"),
    *(SCENE, CSV, MINUTES),
)


def changed_options(source: random.Random) -> tuple[str, ...]:
    """Return a command line with one to three words more, less, or others."""
    line = list(source.choice(LINES))
    for _ in range(source.choice((1, 1, 2, 3))):
        at = source.randrange(1, len(line) + 1)
        way = source.random()
        if way < 0.5 and at < len(line):
            line[at] = source.choice(WORDS)
        elif way < 0.75:
            line.insert(at, source.choice(WORDS))
        elif len(line) > 1:
            line.pop(min(at, len(line) - 1))
    return tuple(line)


TABLE = "# minutes of a careful hand\nR1 = 0.1\nR2 = 0.15\nC1 = 0.1\nC2 = 0.2\nC3 = 0.1\nN1 = 2.0\n"
NAMES = ("R1", "R2", "R9", "C1", '"R1"', "R1.C1", "[R1]", "[[R1]]", "π", "N1", "S1")


def _rename(source: random.Random, text: str) -> str:
    lines = text.split("\n")
    at = source.randrange(len(lines))
    lines[at] = f"{source.choice(NAMES)} = {source.choice(STRANGE)}"
    return "\n".join(lines)


def _deep(source: random.Random, text: str) -> str:
    deep = source.choice((3, 30, 3000))
    made = (f"R1 = {'[' * deep}{']' * deep}", f"{'R1.' * deep}R1 = 1", f"R1 = {'9' * deep}")
    return f"{source.choice(made)}\n{text}"


CHANGES: tuple[tuple[Change, int], ...] = (
    *((number, 4), (strange, 6), (_rename, 4), (_deep, 2), (drop_line, 1), (double_line, 2)),
    *((move_line, 1), (bytes_of, 3), (cut_off, 2)),
)


def changed_minutes(source: random.Random) -> bytes:
    """Return a table of minutes with one to three changes."""
    text, (ways, weights) = TABLE, zip(*CHANGES, strict=True)
    for way in source.choices(ways, weights, k=source.choice((1, 2, 3))):
        text = way(source, text)
    return text.encode("utf-8", "surrogatepass")
