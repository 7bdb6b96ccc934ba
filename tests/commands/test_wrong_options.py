"""A tour of wrong names, options, readings and minutes: each is refused, and nothing is written."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from support.command import invoke
from support.gallery import ROOT
from support.refusals import SCENE, refused, run


def in_english(arguments: tuple[str, ...]) -> tuple[str, ...]:
    """Return the arguments of a command that is asked to speak English, whatever scene it is given."""
    return (arguments[0], "-l", "en", *arguments[1:])


# names


@pytest.mark.turns(6)
@pytest.mark.slow
@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("draw", "/dev/zero"), ["/dev/zero", "a device or a pipe", "name a scene file"]),
        (("draw", "pipe"), ["pipe: ", "a device or a pipe", "name a scene file"]),
        (("draw", "."), ["scene.toml", "there is no such file; name a scene file"]),
        (("draw", "none.toml"), ["none.toml", "there is no such file; name a scene file"]),
        (("table", "windrowr"), ["windrowr", 'did you mean the scene "windrower"?']),
        (("steps", "crankpress"), ["crankpress", 'did you mean the scene "crank-press"?']),
        (("steps", "four-bar-linkage"), ['"graphic-tmm scenes" lists']),
        (("check", "cam", "pipe"), ["pipe: ", "a device or a pipe", "name a CSV or xlsx file"]),
        (("check", "cam", "/dev/zero"), ["/dev/zero", "name a CSV or xlsx file of readings"]),
        (("check", "cam", "."), ["this is a folder; name a CSV or xlsx file of readings"]),
        (("check", "cam", "none.csv"), ["none.csv", "there is no such file; name a CSV"]),
        (("accuracy", "cam", "--minutes", "pipe"), ["pipe", "name a TOML file"]),
        (("accuracy", "cam", "--minutes", "."), ["this is a folder; name a TOML file"]),
        (("accuracy", "cam", "--minutes", "none"), ["there is no such file; name a TOML file"]),
        (("new", "out", "--like", "none"), ["none: there is no such file"]),
        (("new", "wall"), ["cannot write into", "name another folder"]),
        (("draw", "cam", "-o", "wall"), ["cannot write into wall", "with -o"]),
        (("draw", "cam", "-o", "wall/out"), ["cannot write into wall/out", "with -o"]),
        (("draw", "cam", "-o", "/proc/none"), ["cannot write into", "with -o"]),
    ],
    ids=" ".join,
)
def test_a_name_that_is_wrong(arguments: tuple[str, ...], words: list[str], tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "wall").write_text("a file")
    before = sorted(path.name for path in tmp_path.iterdir())
    home = os.getcwd()
    os.chdir(tmp_path)
    try:
        done = invoke(*in_english(arguments))
    finally:
        os.chdir(home)
    refused(done, *words)
    assert sorted(path.name for path in tmp_path.iterdir()) == before


# options


OPTIONS = [
    (("draw", "cam", "-f", "bmp"), ["--format", "no bmp; choose from svg, pdf, png, dxf"]),
    (("draw", "cam", "-f", "svg,"), ["--format", "choose from"]),
    (("draw", "cam", "-f", ""), ["--format", "choose from"]),
    (("draw", "cam", "--hand", "left"), ["--hand", "student"]),
    (("draw", "cam", "--seed", "-1"), ["--seed", "0<=x"]),
    (("draw", "cam", "--seed", "1.5"), ["--seed", "integer"]),
    (("draw", "cam", "--budget", "0"), ["--budget", "write --budget 2%"]),
    (("draw", "cam", "--budget", "much"), ["--budget", "write --budget 2%"]),
    (("draw", "cam", "--bugdet", "2"), ["--bugdet", "--budget"]),
    (("draw", "cam", "cam"), ["extra argument"]),
    (("drow", "cam"), ["No such command", "drow"]),
    (("table", "cam", "-f", "xml"), ["-f", "json"]),
    (("table", "cam", "--trials", "0"), ["--trials", "1<=x"]),
    (("table", "cam", "--trials", "100001"), ["--trials", "100000"]),
    (("table", "cam", "--trials"), ["--trials", "argument"]),
    (("steps", "cam", "-p", "speed"), ["-p", "velocities"]),
    (
        ("steps", "cam", "-p", "velocities"),
        ["--plan", "the scene has no plan velocities (Velocity plan); it has scales", "cam (Cam)"],
    ),
    (
        ("steps", "crank-rocker", "-p", "cam"),
        ["the scene has no plan cam (Cam); it has", "positions"],
    ),
    (("steps", "crank-rocker", "-n", "99"), ["--position", "there is no 99; there are"]),
    (("steps", "cam", "-l", "de"), ["-l", "ru"]),
    (
        ("check", "cam"),
        ["name the file of READINGS; template writes one", "photo judges a photograph"],
    ),
    (("check", "cam", "x.csv", "--hand", "exact"), ["--hand", "student"]),
    (("check", "cam", "x.csv", "--doubtful", "2"), ["--doubtful", "0.5"]),
    (("check", "cam", "x.csv", "--wrong", "nan"), ["--wrong", "finite"]),
    (("check", "cam", "x.csv", "--doubtful", "nan"), ["--doubtful", "finite"]),
    (("check", "cam", "x.csv", "--enlarge", "nan"), ["--enlarge", "finite"]),
    (("check", "cam", "x.csv", "--enlarge", "0"), ["--enlarge", "1.0"]),
    (("check", "cam", "x.csv", "--sheet", "1"), ["--sheet; it is an option of photo"]),
    (("photo", "cam", "x.png", "--corners", "1,1"), ["--corners", "four corners"]),
    (("check",), ["SCENE"]),
    (("draw", "cam", "--marks", "m.toml"), ["--marks; it is an option of mark"]),
    (("accuracy", "cam", "--trials", "9"), ["--trials", "10<=x"]),
    (("accuracy", "cam", "-f", "xlsx"), ["-f", "json"]),
    (("new",), ["FOLDER"]),
    (("scenes", "cam"), ["extra argument"]),
]


@pytest.mark.parametrize(("arguments", "words"), OPTIONS, ids=[" ".join(a) for a, _ in OPTIONS])
def test_a_wrong_option(arguments: tuple[str, ...], words: list[str], tmp_path: Path) -> None:
    refused(run(tmp_path, *in_english(arguments)), *words)


# readings


HEAD = "plan,position,segment,mm,value,unit,x,y\n"
READINGS = {
    "empty": ("", ["r.csv", "the file is empty; its first row names plan"]),
    "no plan": ("position,segment,mm\n", ["plan", "the column plan is missing; add it"]),
    "no segment": ("plan,position,mm\n", ["segment", "is missing; add it"]),
    "no figure": ("plan,position,segment\n", ["mm", "add it, or value and unit, or x and y"]),
    "x alone": ("plan,position,segment,x\n", ["y", "a point needs both x and y"]),
    "a title twice": ("plan,plan,position,segment,mm\n", ["plan", "stands twice; take one out"]),
    "a title misspelt": ("plan,positoin,segment,mm\n", ["position", 'mean it by "positoin"']),
    "torn": (HEAD + 'velocities,"1,pb,5\n', [":2", "a quoted cell ends with its quote"]),
    "surplus": (HEAD + "velocities,1,pb,5,,,,,7\n", [":2", "has 9 cells", "quote a number"]),
    "one cell": (HEAD + "velocities;1;pb;17.5\n", [":2", "separate its cells by a comma"]),
    "no number": (HEAD + "velocities,1,pb,long\n", [":2: mm", "write millimetres, such as 17.5"]),
    "two ways": (HEAD + 'velocities,1,pb,"1,234"\n', [":2: mm", "two ways; write 1.234 or 1234"]),
    "in pieces": (HEAD + "velocities,1,pb,1 234\n", [":2: mm", "in one piece"]),
    "too large": (HEAD + "velocities,1,pb,1e5000\n", [":2: mm", "too large a number"]),
    "not mm": (HEAD + "velocities,1,pb,5 kg\n", [":2: mm", "write it in mm"]),
    "no unit": (HEAD + "velocities,1,pb,,5\n", [":2: value", "has no unit; write it into"]),
    "two units": (HEAD + "velocities,1,pb,,5 m/s,mm/s\n", [":2: value", "another; keep one"]),
    "half a point": (HEAD + "velocities,1,b,,,,5\n", [":2: y", "needs both x and y"]),
    "no name": (HEAD + "velocities,1,,5\n", [":2: segment", "the cell is empty"]),
    "twice": (HEAD + "velocities,1,pb,5\nvelocities,1,pb,6\n", [":3: mm", "keep one of the two"]),
    "no such plan": (HEAD + "rates,1,pb,5\n", [":2", "rates"]),
    "no such position": (HEAD + "velocities,99,pb,5\n", [":2", "99"]),
    "no such segment": (HEAD + "velocities,1,pz,5\n", [":2", "pz"]),
    "a picture": ("\x89PNG\0", ["this is not a text; save the table as CSV"]),
    "a workbook": ("PK\x03\x04\0\0", ["no xlsx workbook", "save the sheet as CSV"]),
    "too long": ("#" * 8_000_001, ["too large", "at most 8 MB; name a CSV or xlsx file"]),
}


@pytest.mark.parametrize("what", READINGS)
def test_wrong_readings(what: str, tmp_path: Path) -> None:
    text, words = READINGS[what]
    (tmp_path / "scene.toml").write_text(SCENE, encoding="utf-8")
    (tmp_path / "r.csv").write_bytes(text.encode("latin-1", "replace"))
    refused(run(tmp_path, "check", "scene.toml", "r.csv", "--trials", "20"), "r.csv", *words)


MINUTES = {
    "no such name": ("R9 = 1", ["R9", "no such elementary operation; there are"]),
    "less than none": ("R1 = -1", ["R1", "a number 0 to"]),
    "a text": ('R1 = "long"', ["R1", "a number 0 to"]),
    "nothing": ("R1 =", [":1: R1", "a value is missing"]),
    "too much": ("R1 = 1e300", ["R1", "a number 0 to"]),
    "far too much": (f"R1 = {10**400}", ["R1", "a number 0 to"]),
    "digits": ("R1 = " + "9" * 5000, ["a value cannot be read"]),
    "deep": ("R1 = " + "[" * 5000, ["nested too deep"]),
    "too long": ("#" * 100_001, ["too large: a table of minutes has at most 100 kB"]),
}


@pytest.mark.parametrize("what", MINUTES)
def test_wrong_minutes(what: str, tmp_path: Path) -> None:
    text, words = MINUTES[what]
    (tmp_path / "m.toml").write_text(text, encoding="utf-8")
    asked = in_english(("accuracy", "cam", "--minutes", "m.toml", "-o", "out"))
    done = run(tmp_path, *asked)
    refused(done, "m.toml", *words)


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize(
    "arguments",
    [("draw", "windrowr"), ("check", "cam", "/dev/zero"), ("draw", "s.toml", "-o", "out")],
    ids=" ".join,
)
def test_a_process_of_its_own_tells_the_same(arguments: tuple[str, ...], tmp_path: Path) -> None:
    (tmp_path / "s.toml").write_bytes(b"a." * 3000 + b"b = 1")
    command = [sys.executable, "-m", "graphic_tmm", *arguments]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, env=environment, text=True)
    inside = run(tmp_path, *arguments)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", inside.stderr)
