"""The command line: what it writes and prints, its exit status, its messages to people."""

from __future__ import annotations

import csv
import json
import math
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner, Result

from graphic_tmm.__main__ import main

ROOT = Path(__file__).parent.parent
ENGINE = (ROOT / "sheets" / "engine" / "scene.toml").read_text(encoding="utf-8")
# reference A2: exact mm at positions 1..12
X = [0, 42.53, 65.29, 60, 38.64, 17.47, 0, 17.47, 38.64, 60, 65.29, 42.53]
S = [39.38, 48.37, 59.87, 60, 51.31, 42.70, 39.38, 42.70, 51.31, 60, 59.87, 48.37]
H = [60, 53.45, 32.83, 0, 32.83, 53.45, 60, 53.45, 32.83, 0, 32.83, 53.45]


def run(*arguments: str) -> Result:
    return CliRunner().invoke(main, [str(a) for a in arguments])


def made(*arguments: str) -> dict:
    result = run("table", *arguments, "--format", "json")
    assert result.exit_code == 0, result.output
    return json.loads(result.stdout)


def column(document: dict, plan: str, segment: str) -> dict:
    return next(c for c in document["columns"] if (c["plan"], c["segment"]) == (plan, segment))


def scene(folder: Path, *edits: tuple[str, str], source: str = ENGINE) -> Path:
    text = source
    for old, new in edits:
        assert old in text
        text = text.replace(old, new)
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_exact_table_of_the_engine_is_the_reference() -> None:
    document = made("engine", "--exact")
    assert [p["number"] for p in document["positions"]] == [str(k) for k in range(1, 13)]
    assert [p["angle_deg"] for p in document["positions"]] == [30.0 * k for k in range(12)]
    for segment, due in (("pb", X), ("ps2", S), ("ab", H)):
        found = column(document, "velocities", segment)
        assert found["mm"] == pytest.approx(due, abs=0.01)
        assert found["value"] == pytest.approx(
            [0.25 * mm for mm in found["mm"]], rel=1e-9, abs=1e-12
        )
    assert document["scales"]["mu_v"] == {"value": 0.25, "unit": "(m/s)/mm"}
    assert document["results"] == {"W": 1, "formula": "I(1) → II(2-3)"}


def test_the_default_table_differs_by_the_rulers_rounding_only() -> None:
    exact, read = made("engine", "--exact"), made("engine")
    for segment in ("pa", "pb", "ps2", "ab"):
        pairs = zip(
            column(exact, "velocities", segment)["mm"],
            column(read, "velocities", segment)["mm"],
            strict=True,
        )
        for due, found in pairs:
            assert abs(due - found) <= 0.05 + 1e-9
            assert found * 10 == pytest.approx(round(found * 10), abs=1e-6)
    # ω2 = ab·μ_v/(AB·μ_l): only ab is read
    bound = 0.05 * 0.25 / (128 * 0.005) + 1e-9
    pairs = zip(*(column(d, "velocities", "omega2")["value"] for d in (exact, read)), strict=True)
    assert all(abs(due - found) <= bound for due, found in pairs)


def test_null_where_a_position_has_no_acceleration_plan() -> None:
    found = column(made("engine"), "accelerations", "nab")
    assert [k + 1 for k, mm in enumerate(found["mm"]) if mm is not None] == [2, 5]
    assert found["unit"] == "m/s²"


def test_the_windrower_stands_as_its_task_says() -> None:
    document = made()
    assert document["scene"] == "windrower"
    assert [p["number"] for p in document["positions"]][-1] == "7*"
    assert document["results"]["formula"] == "I(1) → II(2-3) → II(4-5)"
    assert column(document, "velocities", "omega3")["value"][0] == 0
    assert column(document, "velocities", "pd")["mm"][0] == 0
    assert column(document, "velocities", "pd")["mm"][-1] == 0


def test_csv_has_a_line_for_every_figure() -> None:
    rows = list(csv.DictReader(run("table", "engine", "--format", "csv").stdout.splitlines()))
    assert {row["segment"] for row in rows} >= {"pa", "pb", "ab", "ps2", "omega2", "epsilon2"}
    first = next(r for r in rows if (r["segment"], r["position"]) == ("pb", "2"))
    assert (first["mm"], first["unit"]) == ("42.5", "m/s")


def test_the_text_table_speaks_the_language_of_the_scene() -> None:
    text = run("table", "engine").stdout
    assert "План скоростей" in text
    assert "42,5" in text


def test_steps_number_the_protocol_and_put_numbers_in() -> None:
    text = run("steps", "engine", "--plan", "velocities", "--position", "2").stdout
    assert "План скоростей, положение 2" in text
    assert "v_A = ω_1·l_OA = 50·0,3 = 15 м/с" in text
    assert "ω_2 = ab·μ_v/(AB·μ_l) = (−53,5)·0,25/(128·0,005) = −20,9 1/с" in text
    numbers = [int(n) for n in re.findall(r"^ *(\d+)\. ", text, re.MULTILINE)]
    assert numbers == list(range(1, len(numbers) + 1))
    english = run("steps", "engine", "-p", "velocities", "-n", "2", "-l", "en").stdout
    assert "Where (pb) and (ab) meet, mark b." in english


def test_steps_tell_synthesis_and_extremes_of_the_windrower() -> None:
    text = run("steps").stdout
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
    result = run(*arguments)
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


@pytest.mark.parametrize("what", BAD)
def test_bad_input_is_refused_and_nothing_written(what: str, tmp_path: Path) -> None:
    edits, words = BAD[what]
    path, out = scene(tmp_path, *edits), tmp_path / "out"
    result = run("draw", str(path), "-o", str(out))
    assert result.exit_code == 2, result.output
    assert all(word in result.stderr for word in words), result.stderr
    assert str(path) in result.stderr
    assert "Traceback" not in result.output
    assert not out.exists()


def test_an_unreadable_file_and_an_unwritable_folder(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_bytes(b"\xff\xfe\x00")
    result = run("draw", str(tmp_path), "-o", str(tmp_path / "out"))
    assert (result.exit_code, "UTF-8" in result.stderr) == (2, True)
    wall = tmp_path / "wall"
    wall.write_text("a file")
    result = run("draw", "engine", "-o", str(wall / "out"))
    assert result.exit_code == 2
    assert "cannot write into" in result.stderr
    assert "-o" in result.stderr
    assert wall.read_text() == "a file"


def test_lengths_that_assemble_in_part_are_drawn_in_part(tmp_path: Path) -> None:
    path = scene(tmp_path, ('l  = "0.64 m"', 'l  = "0.25 m"'))
    result = run("draw", str(path), "-o", str(tmp_path / "out"))
    assert result.exit_code == 0
    assert "positions 3, 4, 5, 9, 10, 11 cannot be drawn" in result.stderr
    assert "123.56° to 236.44°" in result.stderr  # sin φ = 0.25/0.3
    assert len(list((tmp_path / "out").glob("*.svg"))) == 1
    found = column(made(str(path)), "velocities", "pb")
    assert [k + 1 for k, mm in enumerate(found["mm"]) if mm is None] == [3, 4, 5, 9, 10, 11]


def test_text_of_a_scene_is_data(tmp_path: Path) -> None:
    nasty = "<script>alert(1)</script> & [red]../../x[/red] 'quoted'"
    title = ENGINE.replace('title    = "Двигатель одноцилиндровый"', f'title = "{nasty}"')
    path = scene(tmp_path, source=title)
    result = run("draw", str(path), "-o", str(tmp_path / "out"))
    assert result.exit_code == 0, result.output
    text = next((tmp_path / "out").glob("*.svg")).read_text(encoding="utf-8")
    assert "<script" not in text
    assert "&lt;script&gt;" in text
    assert "[red]" in run("table", str(path)).stdout


def test_new_begins_a_scene_and_never_overwrites(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    assert run("new", str(folder), "--like", "engine").exit_code == 0
    assert run("table", str(folder)).exit_code == 0
    again = run("new", str(folder))
    assert again.exit_code == 2
    assert "exists already" in again.stderr


def test_scenes_and_schema() -> None:
    listed = run("scenes").stdout
    assert "windrower " in listed
    assert "Двигатель" in listed
    assert json.loads(run("schema").stdout)["properties"]["drive"]


def test_the_same_bytes_whatever_the_hash_and_the_locale(tmp_path: Path) -> None:
    written = []
    for seed, locale in (("0", "C"), ("1", "C.UTF-8")):
        out = tmp_path / seed
        environment = {**os.environ, "PYTHONHASHSEED": seed, "LC_ALL": locale}
        command = [sys.executable, "-m", "graphic_tmm", "draw", "crank-rocker", "-o", str(out)]
        subprocess.run(command, check=True, env=environment, capture_output=True, cwd=ROOT)
        written.append({p.name: p.read_bytes() for p in out.iterdir()})
    assert written[0] == written[1]
    assert len(written[0]) == 3


def test_help_is_light() -> None:
    code = (
        "import sys; from click.testing import CliRunner; from graphic_tmm.__main__ import main;"
        "assert CliRunner().invoke(main, ['--help']).exit_code == 0;"
        "heavy = {'numpy', 'shapely', 'matplotlib', 'svgwrite', 'pydantic', 'rich'} & set(sys.modules);"
        "assert not heavy, heavy"
    )
    subprocess.run([sys.executable, "-c", code], check=True, cwd=ROOT)


# every command, on names, folders and files


def outcome(*arguments: str, **environment: str) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-m", "graphic_tmm", *arguments],
        cwd=ROOT,
        env={**os.environ, **environment},
        capture_output=True,
        check=False,
    )


COMMANDS = {
    "table": (),
    "table json": ("-f", "json"),
    "table csv": ("-f", "csv", "--exact"),
    "steps": (),
    "steps velocities": ("-p", "velocities", "-n", "3", "-l", "en"),
    "draw": ("-o", "OUT"),
}


@pytest.mark.parametrize("name", ["windrower", "engine"])
@pytest.mark.parametrize("what", COMMANDS)
def test_a_scene_is_named_by_name_folder_or_file(what: str, name: str, tmp_path: Path) -> None:
    folder = ROOT / "sheets" / name
    said = []
    for number, scene_name in enumerate((name, folder, folder / "scene.toml")):
        out = tmp_path / str(number)
        options = [str(out) if o == "OUT" else o for o in COMMANDS[what]]
        result = run(what.split()[0], str(scene_name), *options)
        assert (result.exit_code, result.stderr) == (0, "")
        files = {p.name: p.read_bytes() for p in out.iterdir()} if out.exists() else {}
        said.append((result.stdout.replace(str(out), ""), files))
    assert said[0] == said[1] == said[2]
    assert bool(said[0][1]) == (what == "draw")


@pytest.mark.parametrize("what", ["table", "steps", "draw"])
def test_the_windrower_is_the_scene_left_out(what: str, tmp_path: Path) -> None:
    options = ("-o", str(tmp_path)) if what == "draw" else ()
    assert run(what, *options).stdout == run(what, "windrower", *options).stdout


def test_draw_writes_every_format_asked_for(tmp_path: Path) -> None:
    result = run("draw", "crank-rocker", "-o", str(tmp_path), "-f", "svg, PDF,png,dxf")
    assert result.exit_code == 0, result.output
    starts = {"svg": b"<svg", "pdf": b"%PDF", "png": b"\x89PNG", "dxf": b"  0"}
    found = sorted(path.name for path in tmp_path.iterdir())
    due = [f"crank-rocker-{k}.{form}" for k in (1, 2, 3) for form in ("svg", "png", "dxf")]
    assert found == sorted([*due, "crank-rocker.pdf"])
    assert sorted(Path(line).name for line in result.stdout.splitlines()) == found
    for path in tmp_path.iterdir():
        assert path.read_bytes().startswith(starts[path.suffix[1:]]), path.name


def test_a_scene_that_is_a_file_of_another_name_names_its_sheet(tmp_path: Path) -> None:
    path = scene(tmp_path).rename(tmp_path / "мой двигатель.toml")
    assert run("draw", str(path), "-o", str(tmp_path / "out")).exit_code == 0
    assert [p.name for p in (tmp_path / "out").iterdir()] == ["мой двигатель.svg"]
    assert made(str(path))["scene"] == "мой двигатель"


def test_the_document_is_as_written_down() -> None:
    document = made("engine")
    assert list(document) == ["scene", "scales", "positions", "columns", "results"]
    assert document["scene"] == "engine"
    assert list(document["scales"]) == ["mu_l", "mu_v", "mu_a"]
    assert document["scales"]["mu_l"] == {"value": 0.005, "unit": "m/mm"}
    assert document["scales"]["mu_a"]["unit"] == "(m/s²)/mm"
    assert document["positions"][3] == {"number": "4", "angle_deg": 90.0}
    assert {tuple(c) for c in document["columns"]} == {("plan", "segment", "unit", "mm", "value")}
    segments = [c["segment"] for c in document["columns"] if c["plan"] == "velocities"]
    assert segments == ["pa", "ab", "pb", "ps2", "omega1", "omega2"]
    assert all(len(c["mm"]) == len(c["value"]) == 12 for c in document["columns"])
    assert column(document, "velocities", "omega2")["mm"] == [None] * 12


def test_an_angle_is_the_direction_of_the_crank_whatever_its_zero(tmp_path: Path) -> None:
    clockwise = [
        ('"counterclockwise"', '"clockwise"'),
        ('zero          = "0 deg"', 'zero = "90 deg"'),
    ]
    document = made(str(scene(tmp_path, *clockwise)))
    assert [p["angle_deg"] for p in document["positions"]][:5] == [90.0, 60.0, 30.0, 0.0, 330.0]
    assert column(document, "velocities", "omega1")["value"][0] == -50


def test_positions_that_cannot_be_drawn_are_null_in_every_column(tmp_path: Path) -> None:
    path = scene(tmp_path, ('l  = "0.64 m"', 'l  = "0.25 m"'), ("[2, 5]", "[2, 5]"))
    result = run("table", str(path), "--format", "json", "--exact")
    assert result.exit_code == 0
    assert "warning: positions 3, 4, 5, 9, 10, 11 cannot be drawn" in result.stderr
    document = json.loads(result.stdout)  # the warning is not in it
    gone = [2, 3, 4, 8, 9, 10]
    for one in document["columns"]:
        assert all(one["value"][k] is None and one["mm"][k] is None for k in gone), one["segment"]
    accelerated = column(document, "accelerations", "πb")
    assert [k for k, mm in enumerate(accelerated["mm"]) if mm is not None] == [1]
    # by the vector loop: x = r·cos φ + √(l² − r²·sin² φ), 30° further than the dead centre
    r, h, phi = 0.3, 0.25, math.radians(30)
    beam = math.sqrt(h**2 - (r * math.sin(phi)) ** 2)
    speed = 50 * (r * math.sin(phi) + r * r * math.sin(phi) * math.cos(phi) / beam)
    assert column(document, "velocities", "pb")["value"][1] == pytest.approx(speed, rel=1e-9)


# bad input


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
        ["does not fit on A1", "larger format", "larger μ"],
    ),
    "a character without a letter": ([("кривошип", "克")], ["克"]),
}


@pytest.mark.parametrize("what", MORE_BAD)
def test_more_bad_input_is_refused_and_nothing_written(what: str, tmp_path: Path) -> None:
    edits, words = MORE_BAD[what]
    path, out = scene(tmp_path, *edits), tmp_path / "out"
    result = run("draw", str(path), "-o", str(out))
    assert result.exit_code == 2, result.output
    assert all(word in result.stderr for word in words), result.stderr
    assert result.stdout == ""
    assert "Traceback" not in result.stderr
    assert not out.exists()


@pytest.mark.parametrize("what", ["change point", "never assembles", "no side", "wrong unit"])
@pytest.mark.parametrize("command", ["table", "steps", "draw"])
def test_every_command_tells_a_bad_scene_alike(command: str, what: str, tmp_path: Path) -> None:
    edits, words = BAD[what]
    path = scene(tmp_path, *edits)
    options = ("-o", str(tmp_path / "out")) if command == "draw" else ()
    result = run(command, str(path), *options)
    assert (result.exit_code, result.stdout) == (2, "")
    assert result.stderr.startswith("graphic-tmm: ")
    assert all(word in result.stderr for word in words), result.stderr


def test_a_parallelogram_is_refused_with_its_change_points(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(PARALLELOGRAM, encoding="utf-8")
    result = run("draw", str(path), "-o", str(tmp_path / "out"))
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
        result = run(command, name)
        assert (result.exit_code, result.stdout) == (2, ""), result.output
        assert result.stderr.startswith("graphic-tmm: ")
    assert list(tmp_path.iterdir()) == []


def test_a_name_in_no_encoding_is_told_without_a_traceback(tmp_path: Path) -> None:
    for what in (b"\xff", "\ud83d".encode("utf-8", "surrogatepass")):
        done = outcome("draw", os.fsdecode(what), "-o", str(tmp_path / "out"))
        assert done.returncode == 2
        assert b"Traceback" not in done.stderr
        assert b"there is no such file" in done.stderr
    place = os.fsdecode(bytes(tmp_path) + b"/\xff")
    done = outcome("draw", "engine", "-o", place)
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout == bytes(tmp_path) + b"/\xff/engine.svg\n"


@pytest.mark.parametrize("stand", ["file", "file/below", "proc"])
def test_a_folder_that_cannot_be_written(stand: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("a file")
    out = "/proc/nothing/here" if stand == "proc" else str(tmp_path / stand)
    for command in (("draw", "engine", "-o", out), ("new", out, "--like", "engine")):
        result = run(*command)
        assert result.exit_code == 2, result.output
        assert "cannot write into" in result.stderr
        assert "name another folder" in result.stderr
        # -o is an option of draw, not of new
        assert ("with -o" in result.stderr) == (command[0] == "draw")
        assert result.stdout == ""
    assert (tmp_path / "file").read_text() == "a file"
    assert [p.name for p in tmp_path.iterdir()] == ["file"]


def test_new_copies_nothing_that_is_no_scene(tmp_path: Path) -> None:
    bad = scene(tmp_path, ("[drive]", "[drivel]"))
    for like in ("no-such-scene", str(bad)):
        result = run("new", str(tmp_path / "mine"), "--like", like)
        assert result.exit_code == 2
        assert not (tmp_path / "mine").exists()


def test_new_is_a_copy_to_the_byte_and_leaves_a_scene_that_is_there(tmp_path: Path) -> None:
    assert run("new", str(tmp_path)).stdout == f"{tmp_path / 'scene.toml'}\n"
    due = (ROOT / "sheets" / "windrower" / "scene.toml").read_bytes()
    assert (tmp_path / "scene.toml").read_bytes() == due
    (tmp_path / "scene.toml").write_text("mine")
    result = run("new", str(tmp_path), "--like", "engine")
    assert (result.exit_code, (tmp_path / "scene.toml").read_text()) == (2, "mine")


def test_a_broken_pipe_leaves_no_traceback() -> None:
    for arguments in (("table", "engine"), ("steps", "engine"), ("table", "engine", "-f", "json")):
        reader, writer = os.pipe()
        os.close(reader)
        done = subprocess.run(
            [sys.executable, "-m", "graphic_tmm", *arguments],
            cwd=ROOT,
            stdout=writer,
            stderr=subprocess.PIPE,
            check=False,
        )
        os.close(writer)
        assert done.returncode != 0
        assert done.stderr == b""


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no device that is always full")
def test_a_full_device_is_told() -> None:
    with open("/dev/full", "wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "graphic_tmm", "table", "engine", "-f", "csv"],
            cwd=ROOT,
            stdout=full,
            stderr=subprocess.PIPE,
            check=False,
        )
    assert done.returncode != 0
    assert b"Traceback" not in done.stderr
    assert b"No space left" in done.stderr


# text is data


NASTY = "<b onload='x'>&amp; &lt;/svg&gt; [red]r[/red] [/] {0} %s \\\\ ${HOME} ]]> --> \\\"q\\\""


def test_whatever_a_scene_says_is_data_on_the_sheet_and_in_the_tables(tmp_path: Path) -> None:
    edits = [
        ('"Двигатель одноцилиндровый"', f'"{NASTY}"'),
        ('"шатун"', f'"{NASTY}"'),
        ('"Динамическое исследование двигателя"', f'"{NASTY}"'),
    ]
    path = scene(tmp_path, *edits)
    meant = tomllib.loads(path.read_text(encoding="utf-8"))["title"]
    result = run("draw", str(path), "-o", str(tmp_path / "out"))
    assert result.exit_code == 0, result.output
    root = ElementTree.parse(tmp_path / "out" / f"{tmp_path.name}.svg").getroot()
    assert {e.tag.rpartition("}")[2] for e in root.iter()} <= {
        *("svg", "title", "rect", "g", "path", "text", "tspan", "circle", "line", "polyline")
    }
    assert not [k for e in root.iter() for k in e.attrib if k.lower().startswith("on")]
    assert root.find("{http://www.w3.org/2000/svg}title").text == meant
    words = "".join(root.itertext())
    assert words.count(meant) >= 2
    text = " ".join(run("table", str(path)).stdout.split())
    assert meant in text
    english = run("steps", str(path), "-l", "en")
    assert english.exit_code == 0


# lightness and bytes


@pytest.mark.parametrize(
    "arguments", [["--help"], ["draw", "--help"], ["table", "-h"], ["--version"], ["scenes"]]
)
def test_help_and_scenes_import_nothing_heavy(arguments: list[str]) -> None:
    code = (
        "import sys; from click.testing import CliRunner; from graphic_tmm.__main__ import main;"
        f"done = CliRunner().invoke(main, {arguments!r});"
        "assert done.exit_code == 0, done.output;"
        "print(*sorted({'shapely', 'matplotlib', 'svgwrite', 'pydantic', 'rich'} & set(sys.modules)))"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, check=True, text=True
    )
    assert done.stdout.strip() == ""


@pytest.mark.parametrize("arguments", [("table", "engine"), ("steps", "engine"), ("scenes",)])
def test_what_is_printed_does_not_depend_on_hash_or_locale(arguments: tuple[str, ...]) -> None:
    first, second = (
        outcome(*arguments, PYTHONHASHSEED=seed, LC_ALL=locale, PYTHONIOENCODING=coding)
        for seed, locale, coding in (("0", "C", "ascii"), ("1", "C.UTF-8", "utf-8"))
    )
    assert (first.returncode, first.stderr) == (0, b"")
    assert first.stdout == second.stdout
    assert "Двигатель" in first.stdout.decode("utf-8") or arguments[0] == "steps"
