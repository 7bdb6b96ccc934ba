"""A chapter written in one file is read, drawn, tabulated, told, checked and costed as those of the book."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest
from support import triangle
from support.command import invoke, printed, tabled
from support.leftovers import data_of

from graphic_tmm.scene.chapter import added

SCENE = (
    'title = "T"\nlanguage = "{}"\n[[sheet]]\nformat = "A4"\n[triangle]\na = "60 mm"\nb = "50 mm"\n'
)


@pytest.fixture(autouse=True)
def the_chapter() -> Iterator[None]:
    with added(triangle.CHAPTER):
        yield


@pytest.fixture
def scene(tmp_path: Path) -> Path:
    return written(tmp_path)


def written(folder: Path, text: str = SCENE.format("en")) -> Path:
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_it_is_written_in_eighty_lines() -> None:
    assert len(Path(triangle.__file__).read_text(encoding="utf-8").splitlines()) <= 80


def test_its_keys_are_refused_with_line_and_remedy(tmp_path: Path) -> None:
    done = invoke("draw", written(tmp_path, SCENE.format("en") + 'd = "1 mm"\n'), "-o", tmp_path)
    assert done.exit_code == 2
    assert "scene.toml:8: triangle.d" in done.stderr
    assert not list(tmp_path.glob("*.svg"))


def test_it_is_drawn_on_a_sheet(scene: Path, tmp_path: Path) -> None:
    printed("draw", scene, "-o", tmp_path)
    (sheet,) = tmp_path.glob("*.svg")
    ink = ElementTree.fromstring(sheet.read_text(encoding="utf-8"))
    (sides,) = [one.get("d", "") for one in ink.iter() if one.get("data-part") == "triangle"]
    spots = [complex(*map(float, one.split())) for one in re.findall(r"[\d.]+ [\d.]+", sides)]
    lengths = [abs(end - start) for start, end in zip(spots, spots[1:] + spots[:1], strict=True)]
    assert lengths == pytest.approx([120.0, 80.0, 100.0], abs=2e-3)  # thousandths in an SVG


def test_it_is_tabulated(scene: Path) -> None:
    told = tabled(scene, "--exact")
    (column,) = told["columns"]
    assert (column["plan"], column["segment"], column["unit"]) == ("triangle", "CA", "m")
    assert column["mm"] == pytest.approx([100.0], abs=1e-9)
    assert column["value"] == pytest.approx([0.05], abs=1e-12)
    assert told["scales"]["mu_triangle"] == {"value": 0.0005, "unit": "m/mm"}
    assert "T. Triangle by its sides" in printed("table", scene)


@pytest.mark.parametrize(("language", "arc"), [("en", "strike the arc"), ("ru", "провести дугу")])
def test_it_is_told_in_two_languages(language: str, arc: str, tmp_path: Path) -> None:
    text = printed("steps", written(tmp_path, SCENE.format(language)), "-p", "triangle")
    assert text.count(arc) == 2
    assert "l_AC/μ_l" in text
    assert text.startswith("Triangle by its sides")


def test_a_hand_drawing_of_it_is_checked(scene: Path, tmp_path: Path) -> None:
    readings = tmp_path / "hand.csv"
    for mm, verdict in ((100.3, "fine"), (80.0, "wrong")):
        readings.write_text(f"plan,position,segment,mm\ntriangle,1,CA,{mm}\n", encoding="utf-8")
        found = json.loads(invoke("check", scene, readings, "-f", "json").stdout)
        assert [one["verdict"] for one in found["readings"]] == [verdict]


def test_what_it_costs_is_told(scene: Path) -> None:
    told = json.loads(printed("accuracy", scene, "-f", "json", "--hand", "student"))
    (run, *_) = [run for run in told["runs"] if run["hand"] == "student"]
    assert run["quantity"] == "CA"
    assert run["minutes"] > 0.0
    assert run["error_percent"] > 0.0


def test_its_note_has_what_is_given_its_figure_its_steps_and_its_table(
    scene: Path, tmp_path: Path
) -> None:
    printed("note", scene, "-f", "md", "-o", tmp_path)
    (file,) = tmp_path.glob("*.md")
    text = file.read_text(encoding="utf-8")
    assert [head[2:] for head in text.splitlines() if head.startswith("# ")][:3] == [
        "1 Task",
        "2 Scale factors",
        "3 Triangle by its sides",
    ]
    given, _, own = text.partition("# 3")
    assert re.findall(r"\| \$`(\w)`\$ +\| +(\d+) +\| +mm", given) == [
        ("a", "60"),
        ("b", "50"),
        ("c", "40"),
    ]
    assert "Figure 1 — Triangle by its sides" in own
    assert "0.06/0.0005 = 120" in own
    assert re.search(r"\| \$`CA`\$ +\| +m +\| 0\.0500 \|", own)


@pytest.mark.parametrize("language", ["en", "ru"])
def test_its_task_is_set_without_its_solution(language: str, tmp_path: Path) -> None:
    printed("task", written(tmp_path, SCENE.format(language)), "-j", 0, "-o", tmp_path / "out")
    (sheet,) = (tmp_path / "out" / "tasks").glob("*.svg")
    text = sheet.read_text(encoding="utf-8")
    assert "1. Triangle by its sides." in text
    assert text.count('id="s-task-1-table-given-triangle"') == 1
    assert 'id="s-task-1-triangle"' not in text


def test_its_page_plays_its_plan_step_by_step(scene: Path, tmp_path: Path) -> None:
    printed("page", scene, "-o", tmp_path)
    (page,) = tmp_path.glob("*.html")
    data = data_of(page.read_text(encoding="utf-8"))
    (view,) = data["views"]
    assert view["title"] == "Triangle by its sides"
    told = [line["op"] for picture in view["pictures"] for line in picture["lines"]]
    assert [op for op in told if op != "to_board"] == [
        *("ray", "lay_off", "strike", "strike", "cross", "measure")
    ]


def test_without_it_its_section_is_unknown(scene: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("graphic_tmm.scene.chapter._ADDED", [])
    done = invoke("table", scene)
    assert done.exit_code == 2
    assert "triangle" in done.stderr
