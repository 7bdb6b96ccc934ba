"""A tour of wrong inputs: each is refused with its file, its key and the remedy, and nothing is written."""

from __future__ import annotations

import os
import subprocess
import sys
from hashlib import sha256
from pathlib import Path

import pytest
from support.command import invoke
from support.gallery import ROOT
from support.scenes import written

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

KEYS = [
    # what is replaced, by what, words of the message: the key, what is wrong, what to do
    ("title", "titel", ["titel", 'did you mean "title"']),
    ('title = "Rocker"\n', "", ["title", "is missing; write for example"]),
    ("language", "lang", ["lang", "means nothing here"]),
    ("[lengths]", "[length]", ["length", "means nothing here"]),
    ("[frame]", "[fram]", ["fram", 'did you mean "frame"']),
    ("[frame]", "[[frame]]", ["frame", "a section is wanted: [frame]"]),
    ("number = 0", "numer = 0", ["frame.numer", 'did you mean "number"']),
    ("points = { O", "point = { O", ["link 1, point", 'did you mean "points"']),
    ('centre = "S2"', 'centre = "S5"', ["link 2, centre", '"S5" is not a letter of this link']),
    ("mass =", "Mass =", ["link 2, Mass", 'did you mean "mass"']),
    ("mass =", "weight =", ["link 2, weight", "means nothing here"]),
    ("J =", "inertia =", ["link 2, inertia", "keys here are"]),
    ("side =", "syde =", ["link 3, syde", 'did you mean "side"']),
    ("[drive]", "[driver]", ["driver", 'did you mean "drive"']),
    ("link = 1", "links = 1", ["drive.links", 'did you mean "link"']),
    ("link = 1\n", "", ["drive.link", "is missing; write for example link = 1"]),
    ('speed = "120 rpm"\n', "", ["drive.speed", "is missing"]),
    ("turns =", "turn =", ["drive.turn", 'did you mean "turns"']),
    ("positions = 12", "position = 12", ["drive.position", 'did you mean "positions"']),
    ("accelerations =", "acelerations =", ["drive.acelerations", 'did you mean "accelerations"']),
    ("zero =", "null =", ["drive.null", "keys here are"]),
    ("trajectories =", "paths =", ["plans.paths", "keys here are"]),
    ("mu_l =", "mul =", ["scales.mul", 'did you mean "mu_l"']),
    ("mu_l =", "μ_l =", ["μ_l", 'a key that is not Latin stands in quotes: "μ_l"']),
    ('name = "exact"', 'hand = "exact"', ["hand.hand", "keys here are"]),
    ("ruler =", "rule =", ["hand.rule", 'did you mean "ruler"']),
    ("[[sheet]]", "[sheet]", ["sheet", "write [[sheet]] in double brackets"]),
    ("[[sheet]]", "[[sheets]]", ["sheets", 'did you mean "sheet"']),
    ("format =", "fromat =", ["sheet 1, fromat", 'did you mean "format"']),
    ("place =", "plan =", ["sheet 1, plan", 'did you mean "place"']),
    ("[title_block]", "[titleblock]", ["titleblock", 'did you mean "title_block"']),
    ("[hand]", "[drive]", ["drive", "the section [drive] stands twice; put its keys into one"]),
    ("[[link]]\nnumber = 2", "[link]\nnumber = 2", ["link", "write [[link]] in double brackets"]),
    ("C = [", "P = [", ["frame.P", "kept for the pole", "such as K, or number it"]),
    ("C = [", "Ax = [", ["frame.Ax", "is not a letter", "such as A, S2"]),
    ("C = [", "a = [", ["link 1, points.A", "would both be", "rename one"]),
]
VALUES = [
    ('"Rocker"', "5", ["title", "a text in quotes is wanted"]),
    ('"en"', '"fr"', ["language", 'one of "ru", "en"']),
    ('"0.1 m"', "true", ["lengths.r", "true (yes or no)", "a length is wanted"]),
    ('"0.1 m"', "nan", ["lengths.r", "not a finite number"]),
    ('"0.1 m"', "1e13", ["lengths.r", "too large a number"]),
    ('"0.1 m"', '"0 m"', ["link 1, points.A", "OA is zero", "move"]),
    ('["r", 0] }', '[0, 0] }\nmass = "1 kg"\ncentre = "O"', ["link 1, points.A", "OA is zero"]),
    ('"0.1 m"', '"1 000 mm"', ["lengths.r", "two ways", "in one piece"]),
    ('"0.1 m"', '"1,000 mm"', ["lengths.r", "a thousand or a decimal comma"]),
    ('"0.1 m"', '"1/10 m"', ["lengths.r", "is a fraction; write it as a decimal"]),
    ("O = [0, 0]\nC", "O = [0]\nC", ["frame.O", "list of two lengths"]),
    ("O = [0, 0]\nC", "O = 0\nC", ["frame.O", "stands here", "a point, O = [0, 0]"]),
    ("O = [0, 0]\nC", 'O = [0, "x"]\nC', ["frame.O", "y: ", "named lengths are r"]),
    ("number = 0", "number = -1", ["frame.number", "whole number 0 to 999"]),
    ("number = 0", "number = 2", ["link 2, number", "number of the frame; write"]),
    ("number = 2", "number = 1", ["number of another link; write 2"]),
    ("number = 2", 'number = "2"', ["number", "a whole number is wanted, without quotes"]),
    ("number = 2", "number = 2.0", ["number", "a whole number is wanted"]),
    ('["r", 0]', '["R", 0]', ["link 1, points.A", "named lengths are r"]),
    ('B = ["0.3 m"', 'B = ["0 m"', ["link 2, points.B", "AB is zero"]),
    ('"2 kg"', '"-2 kg"', ["link 2, mass", "is less than 0"]),
    ('"2 kg"', "{}", ["link 2, mass", "a table { }", "a mass is wanted"]),
    ('"left of AC"', '"left of AX"', ["link 3, side", '"X" is not a letter of the mechanism']),
    ('"left of AC"', '"over AC"', ["link 3, side", 'write "left of AC"']),
    ("link = 1\n", "link = 4\n", ["drive.link", "no link 4; links are 0, 1, 2, 3"]),
    ("link = 1\n", "link = 0\n", ["drive.link", "is the frame", "name the crank"]),
    ('"120 rpm"', "0", ["drive.speed", "stands still", 'as small as "0.001 rad/s"']),
    ('"120 rpm"', '"-120 rpm"', ["drive.speed", 'write it positive and turns = "clockwise"']),
    ('"counterclockwise"', '"left"', ["drive.turns", 'one of "counterclockwise"']),
    ("positions = 12", "positions = 0", ["drive.positions", "whole number 1 to"]),
    ("positions = 12", 'positions = "12"', ["drive.positions", "without quotes"]),
    ("[2, 6]", "[2, 13]", ["drive.accelerations[2]", "no position 13; the row goes"]),
    ("[2, 6]", "[2, 2]", ["drive.accelerations[2]", "named twice; leave one out"]),
    ("[2, 6]", '"some"', ["drive.accelerations", 'or "all"']),
    ('"0 deg"', '{ point = "O", at = "left" }', ["drive.zero.point", "name a moving point"]),
    ('"0 deg"', '{ point = "B", at = "north" }', ["drive.zero.at", "left"]),
    ('"0 deg"', '"0 deg"\nextra = ["other extreme"]', ["drive.extra", "write zero = {"]),
    ('["B"]', '["Q"]', ["plans.trajectories[1]", '"Q" is not a letter of the mechanism']),
    ('["B"]', '["C"]', ["plans.trajectories[1]", "does not move; name a moving point"]),
    ('"0.002 m/mm"', '"1:0"', ["scales.mu_l", "cannot be a scale factor"]),
    ('"0.002 m/mm"', '"0.002 m/mm"\nOA = "50 mm"', ["scales.OA", "leave one of them out"]),
    ('"exact"', '"nobody"', ["hand.name", "one of"]),
    ('"0.1 mm"', '"5 m"', ["hand.ruler", 'is no ruler; write "0.1 mm"']),
    ('"A1"', '"A3"', ["sheet 1, format", 'one of "A1"']),
    ('["positions", "velocities"]', "[]", ["sheet 1, place", "a list of plans is wanted"]),
    ('["positions", "velocities"]', '["plans"]', ["sheet 1, place", "one of"]),
    ('name = "Rocker"', "name = []", ["title_block.name", "a text in quotes is wanted"]),
    ('B = ["0.25 m", 0]', 'B = ["0.9 m", 0]', ["never assembles", "change"]),
    ('"0.35 m"', '"9 m"', ["never assembles", "short by", "change"]),
    ('side = "left of AC"\n', "", ["group 2-3", "side"]),
    ('"0.002 m/mm"', '"0.0001 m/mm"', ["does not fit", "mu_l"]),
]
UNITS = [
    ('"0.1 m"', '"0.1 kg"', ["lengths.r", "is a mass; a length is wanted"]),
    ('"0.1 m"', '"0.1"', ["lengths.r", 'has no unit; write "0.1 mm"']),
    ('"0.1 m"', '"0.1 furlong"', ["lengths.r", "is not known", "units of a length are mm"]),
    ('"0.1 m"', '"0.1 мm"', ["lengths.r", "mixes Latin and Russian letters"]),
    ('"0.1 m"', '"m"', ["lengths.r", "not a number with a unit"]),
    ('"0.1 m"', '"0.1 m 2"', ["lengths.r"]),
    ('"2 kg"', '"2 kgs"', ["link 2, mass", 'did you mean "kg"']),
    ('"2 kg"', '"2 N"', ["link 2, mass", "is a force; a mass is wanted"]),
    ('"0.02 kg*m^2"', '"0.02 kg*m"', ["link 2, J", "units of a moment of inertia are"]),
    ('"0.02 kg*m^2"', '"0.02 kg"', ["link 2, J", "is a mass; a moment of inertia"]),
    ('"120 rpm"', '"120 m/s"', ["drive.speed", "is a speed; an angular speed is wanted"]),
    ('"120 rpm"', '"120"', ["drive.speed", 'write "120 rpm"']),
    ('"120 rpm"', '"120 rpm 5"', ["drive.speed"]),
    ('"0 deg"', '"0 mm"', ["drive.zero", "is a length; an angle is wanted"]),
    ('"0 deg"', '"0 degs"', ["drive.zero", "did you mean"]),
    ('"0.002 m/mm"', '"0.002 mm"', ["scales.mu_l", "a scale of lengths is wanted"]),
    ('"0.002 m/mm"', '"2"', ["scales.mu_l"]),
    ('"0.1 mm"', '"0.1 kg"', ["hand.ruler", "is a mass"]),
    ('speed = "120 rpm"', 'speed = "120 rpm"\nacceleration = "5 1/s"', ["drive.acceleration"]),
]
SYNTAX = [
    ('"120 rpm"', "120 rpm", [":24: speed", 'stands in quotes: speed = "120 rpm"']),
    ('"120 rpm"', "12,5", [":24: speed", "a point: 12.5"]),
    ('"120 rpm"', "«120 rpm»", [":24:", "straight quotes"]),
    ('"120 rpm"', "fast", [":24: speed", 'a text stands in quotes: speed = "fast"']),
    ('"120 rpm"', "", [":24: speed", "a value is missing, speed = ..."]),
    ("[drive]", "[drive", [":22:", "a section is written [frame]"]),
    ("[drive]", "drive", [":22:", "write key = value"]),
    ("points = { O = [0, 0], A", "points = {\n O = [0, 0], A", ["stands on one line"]),
    ("link = 1\n", "link = 1\nlink = 1\n", ['"link" stands twice', "take one out"]),
    ("O = [0, 0]\nC", "Ф = [0, 0]\nC", ["Ф", 'in quotes: "Ф"']),
    ('"Rocker"', '"Rocker', [":1: title", "this is not TOML"]),
    ('"Rocker"', '"Ro\\cker"', [":1: title", "this is not TOML"]),
]
CASES = [*KEYS, *VALUES, *UNITS, *SYNTAX]


def refused(done: object, *words: str) -> None:
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


def run(folder: Path, *arguments: str) -> object:
    """Run a command in a folder; nothing in it may change."""
    before, home = stands(folder), os.getcwd()
    os.chdir(folder)
    try:
        done = invoke(*arguments)
    finally:
        os.chdir(home)
    assert stands(folder) == before
    return done


@pytest.mark.parametrize(("old", "new", "words"), CASES, ids=range(len(CASES)))
def test_a_wrong_scene(old: str, new: str, words: list[str], tmp_path: Path) -> None:
    assert old in SCENE
    file = written(tmp_path, SCENE.replace(old, new, 1))
    done = run(tmp_path, "draw", str(file), "-o", "out", "-f", "svg,dxf")
    refused(done, str(file) if "assembles" not in "".join(words) else "", *words)


def test_the_scene_that_is_made_wrong_is_right(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text(SCENE, encoding="utf-8")
    assert invoke("draw", tmp_path, "-o", tmp_path / "o").exit_code == 0


# files


FILES = {
    "empty": (b"", ["title", "is missing"]),
    "zeros": (b"\0" * 100, ["not TOML"]),
    "latin-1": ('title = "Größe"'.encode("latin-1"), [":1:", "not in UTF-8; save it"]),
    "windows-1251": ('a = 1\ntitle = "Вал"'.encode("cp1251"), [":2:", "not in UTF-8; save it"]),
    "utf-16": (SCENE.encode("utf-16"), ["not in UTF-8; save it with the encoding UTF-8"]),
    "a workbook": (b"PK\x03\x04\xff", ["not in UTF-8"]),
    "a picture": (b"\x89PNG\r\n\x1a\n", ["not in UTF-8"]),
    "too large": (b"#" * 256_001, ["too large: a scene has at most 256 kB; name a scene file"]),
    "lists too deep": (b"a = " + b"[" * 5000, ["nested too deep"]),
    "lists rather deep": (b"a = " + b"[" * 50 + b"]" * 50, ["nested too deep"]),
    "keys too deep": (b"a." * 3000 + b"b = 1", ["nested too deep"]),
    "quoted keys too deep": (b'"a" . ' * 3000 + b"b = 1", ["nested too deep"]),
    "tables too deep": (b"[" + b"a." * 3000 + b"b]", ["nested too deep"]),
    "digits": (b"a = " + b"9" * 5000, ["a value cannot be read"]),
    "JSON": (b'{"title": "T"}', [":1:", "not TOML"]),
}


@pytest.mark.parametrize("what", FILES)
@pytest.mark.parametrize("command", [("draw", "-o", "out"), ("check", "--template")])
def test_a_file_that_is_no_scene(command: tuple[str, ...], what: str, tmp_path: Path) -> None:
    data, words = FILES[what]
    (tmp_path / "s.toml").write_bytes(data)
    refused(run(tmp_path, command[0], "s.toml", *command[1:]), "s.toml", *words)


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
        (("check", "cam", "pipe"), ["pipe: ", "a device or a pipe", "name a CSV file"]),
        (("check", "cam", "/dev/zero"), ["/dev/zero", "name a CSV file of readings"]),
        (("check", "cam", "."), ["this is a folder; name a CSV file of readings"]),
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
        done = invoke(*arguments)
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
        ["--plan", "the scene has no plan velocities; it has cam"],
    ),
    (("steps", "crank-rocker", "-p", "cam"), ["the scene has no plan cam; it has", "positions"]),
    (("steps", "crank-rocker", "-n", "99"), ["--position", "there is no 99; there are"]),
    (("steps", "cam", "-l", "de"), ["-l", "ru"]),
    (("check", "cam"), ["name the file of READINGS, or ask for --template"]),
    (("check", "cam", "x.csv", "--hand", "exact"), ["--hand", "student"]),
    (("check", "cam", "x.csv", "--doubtful", "2"), ["--doubtful", "0.5"]),
    (("check", "cam", "x.csv", "--wrong", "nan"), ["--wrong", "finite"]),
    (("check", "cam", "x.csv", "--doubtful", "nan"), ["--doubtful", "finite"]),
    (("check", "cam", "x.csv", "--enlarge", "nan"), ["--enlarge", "finite"]),
    (("check", "cam", "x.csv", "--enlarge", "0"), ["--enlarge", "1.0"]),
    (("check", "cam", "x.csv", "--sheet", "1"), ["add --photo FILE"]),
    (("check", "cam", "--photo", "x.png", "--corners", "1,1"), ["--corners", "four corners"]),
    (("check",), ["SCENE"]),
    (("accuracy", "cam", "--trials", "9"), ["--trials", "10<=x"]),
    (("accuracy", "cam", "-f", "csv"), ["-f", "json"]),
    (("new",), ["FOLDER"]),
    (("scenes", "cam"), ["extra argument"]),
]


@pytest.mark.parametrize(("arguments", "words"), OPTIONS, ids=[" ".join(a) for a, _ in OPTIONS])
def test_a_wrong_option(arguments: tuple[str, ...], words: list[str], tmp_path: Path) -> None:
    refused(run(tmp_path, *arguments), *words)


# readings


HEAD = "plan,position,segment,mm,value,unit,x,y\n"
READINGS = {
    "empty": ("", ["r.csv", "the file is empty; its first row names plan"]),
    "no plan": ("position,segment,mm\n", ["plan", "the column plan (план) is missing; add it"]),
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
    "no such plan": (HEAD + "velocity,1,pb,5\n", [":2", "velocity"]),
    "no such position": (HEAD + "velocities,99,pb,5\n", [":2", "99"]),
    "no such segment": (HEAD + "velocities,1,pz,5\n", [":2", "pz"]),
    "a picture": ("\x89PNG\0", ["this is not a text; save the table as CSV"]),
    "a workbook": ("PK\x03\x04\0\0", ["a workbook or an archive", "save the sheet as CSV"]),
    "too long": ("#" * 8_000_001, ["too large", "at most 8 MB; name a CSV file"]),
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
    done = run(tmp_path, "accuracy", "cam", "--minutes", "m.toml", "-o", "out")
    refused(done, "m.toml", *words)


def test_the_tour_is_long_enough() -> None:
    parts = (CASES, FILES, OPTIONS, READINGS, MINUTES)
    assert sum(map(len, parts)) >= 150


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
