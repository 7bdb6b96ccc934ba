"""The command line: what it writes and prints, its exit status, its messages to people."""

from __future__ import annotations

import json
import re
import tomllib
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from support.command import column, invoke, printed, rows, tabled
from support.each import each
from support.gallery import ROOT
from support.scenes import edited, source, written


def test_csv_has_a_line_for_every_figure() -> None:
    found = rows(printed("table", "engine", "--format", "csv"))
    assert {row["segment"] for row in found} >= {"pa", "pb", "ab", "ps2", "omega2", "epsilon2"}
    first = next(r for r in found if (r["segment"], r["position"]) == ("pb", "2"))
    assert (first["mm"], first["unit"]) == ("42.5", "m/s")


def test_the_text_table_speaks_the_language_of_the_scene() -> None:
    text = invoke("table", "engine").stdout
    assert "План скоростей" in text
    assert "42,5" in text


@pytest.mark.slow
def test_steps_number_the_protocol_and_put_numbers_in() -> None:
    text = invoke("steps", "engine", "--plan", "velocities", "--position", "2").stdout
    assert "План скоростей, положение 2" in text
    assert "v_A = ω_1·l_OA = 50·0,3 = 15 м/с" in text
    assert "ω_2 = ab·μ_v/(AB·μ_l) = (−53,5)·0,25/(128·0,005) = −20,9 с⁻¹" in text
    numbers = [int(n) for n in re.findall(r"^ *(\d+)\. ", text, re.MULTILINE)]
    assert numbers == list(range(1, len(numbers) + 1))
    english = invoke("steps", "engine", "-p", "velocities", "-n", "2", "-l", "en").stdout
    assert "Where (pb) and (ab) meet, mark b." in english


@pytest.mark.slow
def test_steps_tell_synthesis_and_extremes_of_the_windrower() -> None:
    text = invoke("steps").stdout
    assert "θ = 180°·(K_v − 1)/(K_v + 1) = 180°·(1,45 − 1)/(1,45 + 1) = 33,06°" in text
    assert "крайнее левое положение точки D" in text
    assert "План ускорений, положение 2" in text


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("steps", "engine", "-n", "13"), ["there is no 13", "1, 2, 3"]),
        (("steps", "engine", "-p", "accelerations", "-n", "3"), ["accelerations", "2, 5"]),
        (("draw", "no-such-scene"), ["no-such-scene", "no such file"]),
        (("draw", "engine", "-f", "bmp"), ["bmp", "svg, pdf, png, dxf"]),
    ],
)
def test_a_wrong_call_is_told_with_its_remedy(arguments: tuple[str, ...], words: list[str]) -> None:
    result = invoke(*arguments, "-l", "en")
    assert result.exit_code == 2
    assert all(word in result.stderr for word in words), result.stderr
    assert "Traceback" not in result.output


BAD = {
    "unknown key": ([('mass   = "2.4 kg"', 'mas = "2.4 kg"')], ["mas", "did you mean", ":2"]),
    "wrong unit": ([('"0.3 m"', '"0.3 kg"')], ["lengths.r", "is a mass", "length is wanted"]),
    "zero length": ([('"0.3 m"', '"0 m"')], ["OA is zero"]),
    "a letter twice": (
        [("points = { A = [0, 0], B", "points = { A = [0, 0], A = [1, 0], B")],
        ['"A"', "twice"],
    ),
    "a pole's letter": ([("S2", "P")], ["pole", "choose another letter"]),
    "no drive": ([("[drive]", "[dri]")], ["drive", "missing"]),
    "never assembles": (
        [("x = { through = [0, 0]", 'x = { through = [0, "2 m"]')],
        ["group 2-3 never assembles", "1060 mm", "change AB"],
    ),
    "no side": ([(', side = "right"', "")], ["group 2-3", "side ="]),
    "change point": (
        [('l  = "0.64 m"', 'l  = "0.3 m"')],
        ["change point", "90", "270", "flips_at"],
    ),
    "a pair missing": (
        [('slides = { on = "frame", along = "x", side = "right" }\n', "")],
        ["W = 3·3 − 2·3 = 3", "a pair is missing", "B(2,3)"],
    ),
}


@each("what", BAD)
def test_bad_input_is_refused_and_nothing_written(what: str, tmp_path: Path) -> None:
    edits, words = BAD[what]
    path, out = edited(tmp_path, *edits), tmp_path / "out"
    result = invoke("draw", str(path), "-o", str(out), "-l", "en")
    assert result.exit_code == 2, result.output
    assert all(word in result.stderr for word in words), result.stderr
    assert str(path) in result.stderr
    assert "Traceback" not in result.output
    assert not out.exists()


@pytest.mark.slow
def test_lengths_that_assemble_in_part_are_drawn_in_part(tmp_path: Path) -> None:
    path = edited(tmp_path, ('l  = "0.64 m"', 'l  = "0.25 m"'))
    result = invoke("draw", str(path), "-o", str(tmp_path / "out"), "-l", "en")
    assert result.exit_code == 0
    assert "positions 3, 4, 5, 9, 10, 11 cannot be drawn" in result.stderr
    assert "123.56° to 236.44°" in result.stderr  # sin φ = 0.25/0.3
    assert len(list((tmp_path / "out").glob("*.svg"))) == 1
    found = column(tabled(str(path)), "velocities", "pb")
    assert [k + 1 for k, mm in enumerate(found["mm"]) if mm is None] == [3, 4, 5, 9, 10, 11]


def test_scenes_and_schema() -> None:
    listed = invoke("scenes").stdout
    assert "windrower " in listed
    assert "Двигатель" in listed
    assert json.loads(invoke("schema").stdout)["properties"]["drive"]


# every command, on names, folders and files


COMMANDS = {
    "table": (),
    "table json": ("-f", "json"),
    "table csv": ("-f", "csv", "--exact"),
    "steps": (),
    "steps velocities": ("-p", "velocities", "-n", "3", "-l", "en"),
    "draw": ("-o", "OUT"),
}


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", ["scotch-yoke", "crank-rocker"])
@pytest.mark.parametrize("what", COMMANDS)
def test_a_scene_is_named_by_name_folder_or_file(what: str, name: str, tmp_path: Path) -> None:
    folder = ROOT / "sheets" / name
    said = []
    for number, scene_name in enumerate((name, folder, folder / "scene.toml")):
        out = tmp_path / str(number)
        options = [str(out) if o == "OUT" else o for o in COMMANDS[what]]
        result = invoke(what.split()[0], str(scene_name), *options)
        assert result.exit_code == 0
        assert "error" not in result.stderr
        files = {p.name: p.read_bytes() for p in out.iterdir()} if out.exists() else {}
        said.append((result.stdout.replace(str(out), ""), files, result.stderr))
    assert said[0] == said[1] == said[2]
    assert bool(said[0][1]) == (what == "draw")


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("what", ["table", "steps", "draw"])
def test_the_windrower_is_the_scene_left_out(what: str, tmp_path: Path) -> None:
    options = ("-o", str(tmp_path)) if what == "draw" else ()
    assert invoke(what, *options).stdout == invoke(what, "windrower", *options).stdout


# bad input


ENGINE = source("engine")
DRIVE = ENGINE[ENGINE.index("[drive]") : ENGINE.index("[plans]")]
MORE_BAD = {
    "no drive at all": ([(DRIVE, "")], ["drive: it is missing", "[drive]"]),
    "two drives": ([("[plans]", "[drive]\nlink = 1\n[plans]")], [":", "drive"]),
    "an unknown position": (
        [("[2, 5]", "[2, 50]")],
        ["drive.accelerations[2]", "no position 50", "from 1 to 12"],
    ),
    "an unknown trajectory": ([('["S2"]', '["S9"]')], ["trajectories", "S9"]),
    "no title": ([('title    = "Двигатель одноцилиндровый"\n', "")], ["title", "missing"]),
    "a format": ([('format = "A1"', 'format = "A7"')], ["format", "A7", "A4"]),
    "not TOML": ([("[frame]", "[frame")], ["scene.toml:12"]),
    "a view larger than the paper": (
        [('pa   = "60 mm"', 'pa   = "700 mm"')],
        ["scales.pa", "does not fit on A1", 'write pa = "', "leave it out"],
    ),
    "a character without a letter": ([("кривошип", "克")], ["克"]),
}


@pytest.mark.turns(4)
@pytest.mark.slow
@pytest.mark.parametrize("what", MORE_BAD)
def test_more_bad_input_is_refused_and_nothing_written(what: str, tmp_path: Path) -> None:
    edits, words = MORE_BAD[what]
    path, out = edited(tmp_path, *edits), tmp_path / "out"
    result = invoke("draw", str(path), "-o", str(out), "-l", "en")
    assert result.exit_code == 2, result.output
    assert all(word in result.stderr for word in words), result.stderr
    assert result.stdout == ""
    assert "Traceback" not in result.stderr
    assert not out.exists()


@pytest.mark.parametrize("what", ["change point", "never assembles", "no side", "wrong unit"])
@pytest.mark.parametrize("command", ["table", "steps", "draw"])
def test_every_command_tells_a_bad_scene_alike(command: str, what: str, tmp_path: Path) -> None:
    edits, words = BAD[what]
    path = edited(tmp_path, *edits)
    options = ("-o", str(tmp_path / "out")) if command == "draw" else ()
    result = invoke(command, str(path), *options, "-l", "en")
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith("graphic-tmm: ")
    assert all(word in result.stderr for word in words), result.stderr


def test_a_parallelogram_is_refused_with_its_change_points(tmp_path: Path) -> None:
    path = written(tmp_path, PARALLELOGRAM)
    result = invoke("draw", str(path), "-o", str(tmp_path / "out"))
    assert result.exit_code == 2, result.output
    assert "change point" in result.stderr
    assert "flips_at" in result.stderr
    assert not (tmp_path / "out").exists()


PARALLELOGRAM = """
title = "Parallelogram"
language = "en"
[frame]
O = [0, 0]
C = ["0.4 m", 0]
[[link]]
number = 1
points = { O = [0, 0], A = ["0.1 m", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["0.4 m", 0] }
[[link]]
number = 3
points = { C = [0, 0], B = ["0.1 m", 0] }
side = "left of AC"
[drive]
link = 1
speed = "10 1/s"
turns = "counterclockwise"
positions = 12
zero = "0 deg"
"""


@pytest.mark.parametrize(
    "name", ["", ".", "no/such/folder", "engine/scene.toml", "a\x01b", "x" * 300, "~", "/dev/null"]
)
def test_a_name_that_is_no_scene(name: str, tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.chdir(tmp_path)
    for command in ("table", "steps", "draw"):
        result = invoke(command, name)
        assert (result.exit_code, result.stdout) == (2, ""), result.output
        assert result.stderr.startswith("graphic-tmm: ")
    assert list(tmp_path.iterdir()) == []


# text is data


NASTY = "<b onload='x'>&amp; &lt;/svg&gt; [red]r[/red] [/] {0} %s \\\\ ${HOME} ]]> --> \\\"q\\\""


@pytest.mark.slow
def test_whatever_a_scene_says_is_data_on_the_sheet_and_in_the_tables(tmp_path: Path) -> None:
    edits = [
        ('"Двигатель одноцилиндровый"', f'"{NASTY}"'),
        ('"шатун"', f'"{NASTY}"'),
        ('"Динамическое исследование двигателя"', f'"{NASTY}"'),
    ]
    text = edited(tmp_path, *edits).read_text(encoding="utf-8")
    text = re.sub(r"(?s)\nplace *= \[.*?\]", '\nplace = ["positions", "structure"]', text, count=1)
    path = written(tmp_path, text)
    meant = tomllib.loads(path.read_text(encoding="utf-8"))["title"]
    result = invoke("draw", str(path), "-o", str(tmp_path / "out"))
    assert result.exit_code == 0, result.output
    sheets = [ElementTree.parse(p).getroot() for p in sorted((tmp_path / "out").iterdir())]
    elements = [e for sheet in sheets for e in sheet.iter()]
    assert {e.tag.rpartition("}")[2] for e in elements} <= {
        "svg",
        "title",
        "desc",
        "rect",
        "g",
        "path",
        "text",
        "tspan",
        "circle",
        "line",
        "polyline",
    }
    assert not [k for e in elements for k in e.attrib if k.lower().startswith("on")]
    assert {sheet.find("{http://www.w3.org/2000/svg}title").text for sheet in sheets} == {meant}
    words = ["".join(sheet.itertext()) for sheet in sheets]
    assert words[0].count(meant) >= 2
    text = " ".join(invoke("table", str(path)).stdout.split())
    assert meant in text
    english = invoke("steps", str(path), "-l", "en")
    assert english.exit_code == 0


# lightness and bytes
