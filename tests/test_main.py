"""The command line: what it writes and prints, its exit status, its messages to people."""

from __future__ import annotations

import csv
import json
import os
import re
import subprocess
import sys
from pathlib import Path

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
