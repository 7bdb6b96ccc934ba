"""What a scene gives stands on its first sheet, letter by letter, as the sheet of the task has it."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

import pytest
from support.drives import BOOM, LEVER, RACK, SLIDER, rated
from support.each import each
from support.gallery import NAMES, SHEETS, paper, scene
from support.mechanisms import sample
from support.rewritten import relettered, text_of
from support.scenes import slider_crank

import graphic_tmm as tmm
from graphic_tmm.readers.task_sheet import Given, given_rows, given_table
from graphic_tmm.scene.read import read

TAIL = '[[sheet]]\nformat = "A1"\nplace = ["positions"]\n'
LARGE = [name for name in NAMES if scene(name).sheets[0].format.startswith("A1")]


def rows(name: str) -> dict[str, tuple[object, str]]:
    return {row.symbol: (row.value, row.unit) for row in given_rows(scene(name))}


def test_a_task_sheet_is_told_as_its_author_wrote_it() -> None:
    told = rows("windrower-published")
    assert told["l_{OA}"] == (pytest.approx(117.6), "mm")
    assert told["l_{OB}"] == (480.0, "mm")
    assert told["e_{y}"] == (pytest.approx(722.25), "mm")
    assert told["n_1"] == (380.0, "rpm")
    assert told["J_{S3}"] == (0.323, "kg·m²")
    assert rows("windrower")["K_v"] == (1.45, "")
    assert rows("windrower")["S"] == (pytest.approx(95.0), "mm")
    assert rows("scotch-yoke")["ω_1"] == (20.0, "1/s")
    assert rows("accelerating-crank")["ε_1"] == (30.0, "1/s²")
    assert (rows("project")["δ"], rows("project")["D_e"]) == ((0.04, ""), (600.0, "mm"))


@pytest.mark.parametrize(("written", "told"), [("135", 135.0), ("-45", -45.0), ("495", 135.0)])
def test_a_guide_is_told_at_the_angle_that_the_author_gives(
    written: str, told: float, tmp_path: Path
) -> None:
    """135° is no -45°: the sense of a guide is the author's."""
    text = slider_crank('speed = "100 rpm"\n').replace("angle = 0", f'angle = "{written} deg"')
    path = tmp_path / "scene.toml"
    path.write_text(text + TAIL, encoding="utf-8")
    assert {row.symbol: row.value for row in given_rows(read(path))}["α_{x}"] == told


@pytest.mark.parametrize("name", NAMES)
def test_every_mass_and_moment_of_the_file_is_there(name: str) -> None:
    text = tomllib.loads((SHEETS / name / "scene.toml").read_text(encoding="utf-8"))
    told = [row.unit for row in given_rows(scene(name))]
    assert told.count("kg") == sum("mass" in link for link in text["link"])
    assert told.count("kg·m²") == sum("J" in link for link in text["link"])


@pytest.mark.parametrize("name", LARGE)
def test_it_stands_on_the_first_sheet_that_shows_the_positions(name: str) -> None:
    _, papers = paper(name)
    seen = [{view.name for view in sheet.drawings} for sheet in papers]
    first = next(there for there in seen if "positions" in there)
    assert "table-given" in first
    assert sum("table-given" in there for there in seen) == 1


def test_a_sheet_that_names_it_has_it_and_a_small_one_only_then(tmp_path: Path) -> None:
    text = (SHEETS / "scotch-yoke" / "scene.toml").read_text(encoding="utf-8")
    head = text.partition("[[sheet]]")[0]
    path = tmp_path / "scene.toml"

    def places(*orders: str) -> list[tuple[str, ...]]:
        path.write_text(head + "\n".join(f"[[sheet]]\n{one}" for one in orders), "utf-8")
        return [sheet.place for sheet in read(path).sheets]

    large, small = 'place = ["positions"]', 'format = "A4"\nplace = ["positions"]'
    assert places(large) == [("positions", "given")]
    assert places(small, large) == [("positions",), ("positions", "given")]
    assert places(small) == [("positions",)]
    assert places(large, 'place = ["given"]') == [("positions",), ("given",)]
    assert places('place = ["velocities"]') == [("velocities",)]


@each("k", range(12))
def test_the_lengths_of_random_mechanisms_fix_their_links(k: int, tmp_path: Path) -> None:
    """Each point of a link is told by its distances from the first two, or from one of them in line."""
    (one,) = sample(1, seed=400 + k)
    mechanism = relettered(one.mechanism, k)
    path = tmp_path / "scene.toml"
    path.write_text(text_of(mechanism, one.phi, 4, TAIL), encoding="utf-8")
    told = {row.symbol: row.value for row in given_rows(read(path))}
    for link in mechanism.links:
        for letter, at in list(link.points.items())[1:]:
            first = next(iter(link.points))
            due = abs(at - link.points[first]) * 1000.0
            if due > 1e-6:
                assert told[f"l_{{{first}{letter}}}"] == pytest.approx(due, rel=1e-9)
    assert all(math.isfinite(value) for value in told.values() if not isinstance(value, str))


def test_a_long_list_stands_side_by_side_and_derived_lengths_have_a_figure_less() -> None:
    made = given_table(scene("windrower"))
    texts = [label.text for label in made.labels]
    assert texts[-1] == "Исходные данные"
    assert texts.count("Обозначение") == 2
    assert {"136,57", "1,45", "380", "об/мин", "0,323", "кг·м²"} <= set(texts)
    assert given_rows(scene("windrower"))[0] == Given("K_v", 1.45)


def of_drive(text: str) -> dict[str, tuple[object, str]]:
    return {row.symbol: (row.value, row.unit) for row in given_rows(tmm.read(text))}


def test_what_a_drive_lists_by_positions_is_given_as_a_list() -> None:
    given = of_drive(rated(BOOM))
    assert given["v_r"] == ("0.1; 0.2; 0.3; 0.4; 0.5; 0.6", "m/s")
    assert given["a_r"] == ("−0.4; −0.2; 0; 0.2; 0.4; 0.6", "m/s²")
    turns = ["60 rpm", "90 rpm", "120 rpm", "0 rpm", "10 rpm", "20 rpm"]
    lever = LEVER.replace('"2 rad/s"', str(turns).replace("'", '"'))
    assert of_drive(lever)["n_1"] == ("60; 90; 120; 0; 10; 20", "rpm")
    assert of_drive(lever.replace("20 rpm", "2 rad/s"))["ω_1"][1] == "1/s"


def test_places_that_are_listed_are_given() -> None:
    places = LEVER.replace("positions = 6", 'positions = ["20 deg", "50 deg"]')
    places = places.replace('from = "20 deg"\nto = "75 deg"\n', "")
    assert of_drive(places)["φ"] == ("20; 50", "°")


def test_of_an_arm_without_a_point_of_its_own_no_angle_is_given() -> None:
    text = LEVER.replace(
        "[drive]",
        "[[link]]\nnumber = 4\npoints = { B = [0, 0] }\n"
        'weld = { to = 3, angle = "30 deg" }\n[drive]',
    )
    assert not [symbol for symbol in of_drive(text) if "4" in symbol]
    assert "l_{BC}" in of_drive(text)


@each("text", [BOOM, SLIDER, LEVER, RACK])
def test_of_a_long_list_it_is_given_from_where_to_where_it_goes(text: str) -> None:
    many = rated(text).replace("positions = 6", "positions = 9")
    many = many.replace("speed = [", "speed = [0, 0, 0, ").replace("tion = [", "tion = [0, 0, 0, ")
    assert {"0…0.6", "−0.4…0.6"} <= {value for value, _ in of_drive(many).values()}


@each("text", [BOOM, SLIDER, LEVER, RACK])
@each("turns", ["counterclockwise", "clockwise"])
@each("gain", [-0.25, 0.25])
def test_what_slows_down_is_given_so_in_either_sense(text: str, turns: str, gain: float) -> None:
    rest = "\n".join(line for line in text.splitlines() if not line.startswith("acceleration ="))
    unit = "rad" if text == LEVER else "m"
    drive = f'\nacceleration = "{gain} {unit}/s^2"\nturns = "{turns}"\n'
    told = of_drive(f"{rest}{drive}")
    assert [value for value, unit in told.values() if unit.endswith("/s²")] == [gain]
    listed = f'{rated(text)}turns = "{turns}"\n'
    assert {"0.1; 0.2; 0.3; 0.4; 0.5; 0.6", "−0.4; −0.2; 0; 0.2; 0.4; 0.6"} <= {
        value for value, _ in of_drive(listed).values()
    }
