"""A tour of wrong scenes: each is refused with its file, its key and the remedy, and nothing is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.command import invoke
from support.refusals import SCENE, refused, run
from support.scenes import written

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
    ('"A1"', '"A9"', ["sheet 1, format", 'one of "A1"']),
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


@pytest.mark.parametrize(("old", "new", "words"), CASES, ids=range(len(CASES)))
def test_a_wrong_scene(old: str, new: str, words: list[str], tmp_path: Path) -> None:
    assert old in SCENE
    file = written(tmp_path, SCENE.replace(old, new, 1))
    done = run(tmp_path, "draw", str(file), "-o", "out", "-f", "svg,dxf")
    refused(done, str(file) if "assembles" not in "".join(words) else "", *words)


def test_the_scene_that_is_made_wrong_is_right(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text(SCENE, encoding="utf-8")
    assert invoke("draw", tmp_path, "-o", tmp_path / "o").exit_code == 0


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
