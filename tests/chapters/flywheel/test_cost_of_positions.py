"""What the number of positions costs a flywheel: proven by a closed form, told wherever its results are."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.boards import in_usual_size
from support.readable import texts
from support.scenes import slider_crank, written

from graphic_tmm.chapters.flywheel.views import flywheel_views
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.note.document import Paragraph, walk
from graphic_tmm.note.note import note
from graphic_tmm.readers import position_count as finer_rows
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.position_count import FINE, SHARE, USUAL, Finer, finer
from graphic_tmm.readers.table import table
from graphic_tmm.scene.read import read

CRANK, ROD, FORCE, MASS, DELTA, OMEGA = 0.08, 0.26, 1500.0, 12.0, 0.05, 20.0
PRESS = slider_crank(
    """
speed = "20 rad/s"
turns = "counterclockwise"
positions = 8
zero = "20 deg"
[effects]
gravity = false
inertia = false
[[load]]
link = 3
point = "B"
force = "1500 N"
[forces]
[flywheel]
constant = "driving"
delta = 0.05
D_e = "0.5 m"
[[sheet]]
format = "A1"
place = ["positions", "flywheel"]
""",
    crank=CRANK,
    rod=ROD,
    of_slider='mass = "12 kg"\ncentre = "B"\n',
)
ENGINE = slider_crank(
    """
speed = "30 rad/s"
turns = "counterclockwise"
positions = 6
zero = "0 deg"
[indicator]
point = "B"
bore = "0.1 m"
cover = ["400 kPa", "350 kPa", "150 kPa", "40 kPa", "60 kPa", "180 kPa"]
[flywheel]
constant = "resisting"
delta = 0.1
[[sheet]]
format = "A1"
place = ["positions", "flywheel"]
""",
    of_slider='mass = "2 kg"\ncentre = "B"\n',
)


def inertia_due() -> float:
    """J by the change of kinetic energy, in closed form at a hundred thousand angles."""
    phi = np.linspace(0.0, 2 * np.pi, 200_001) + np.radians(20.0)
    under = np.sqrt(ROD**2 - (CRANK * np.sin(phi)) ** 2)
    place = CRANK * np.cos(phi) + under
    slope = -CRANK * np.sin(phi) * (1 + CRANK * np.cos(phi) / under)
    resisting = FORCE * np.concatenate([[0.0], np.cumsum(np.abs(np.diff(place)))])
    gained = resisting[-1] * (phi - phi[0]) / (2 * np.pi) - resisting
    own = gained - MASS * (slope * OMEGA) ** 2 / 2
    return float((own.max() - own.min()) / (DELTA * OMEGA**2))


def drawn(folder: Path, text: str = PRESS, language: str = "en") -> DrawnScene:
    return in_usual_size(replace(read(written(folder, text)), language=language))


def told(made: DrawnScene) -> Finer:
    found = finer(made.boards[0])
    assert found is not None
    return found


def paragraphs(made: DrawnScene) -> str:
    found = (one for one in walk(note(made).blocks) if isinstance(one, Paragraph))
    return " ".join("".join(run[0] for run in one.runs if isinstance(run[0], str)) for one in found)


def exactly(folder: Path, count: int) -> float:
    text = PRESS.replace("positions = 8", f"positions = {count}")
    made = in_usual_size(read(written(folder, text)), exact=True)
    return float(json.loads(table(made, "json"))["results"]["J_fly"]["value"])  # type: ignore[arg-type]


def test_what_a_finer_row_gives_is_the_closed_form(tmp_path: Path) -> None:
    found, due = told(drawn(tmp_path)), inertia_due()
    assert (found.own, found.fine) == (8, FINE)
    assert found.due["J_fly"] == (pytest.approx(due, rel=1e-3), "kg·m²")
    off = exactly(tmp_path, 8) / due - 1.0
    assert abs(off) > SHARE
    assert found.off["J_fly"] == pytest.approx(off, abs=1e-3)


def test_so_many_positions_are_enough_and_no_usual_number_below_is(tmp_path: Path) -> None:
    enough, due = told(drawn(tmp_path)).enough, inertia_due()
    assert enough in USUAL
    assert abs(exactly(tmp_path, enough) / due - 1.0) < SHARE + 1e-3
    made = drawn(tmp_path, PRESS.replace("positions = 8", f"positions = {enough}"))
    assert not told(made).far
    assert not any("positions:" in text for text in warnings(made.boards[0], "en"))


@pytest.mark.parametrize("text", [PRESS, ENGINE])
@pytest.mark.parametrize("pole", ["", '\nH = "33 mm"'])
def test_as_many_positions_give_what_the_sheet_gives(text: str, pole: str, tmp_path: Path) -> None:
    """The base of an A1 is longer than usual: lengths of results are compared over one base."""
    text = text.replace("[flywheel]", f"[flywheel]{pole}")
    board = drawn(tmp_path, text).boards[0]
    assert board.sheet_lengths
    own = finer_rows._results(board.project, board.given)
    same = finer_rows._at(board, board.scene.row.count)
    assert same is not None
    assert {name: value for name, (value, _) in same.items()} == pytest.approx(
        {name: value for name, (value, _) in own.items()}, rel=1e-9
    )
    assert any(unit == "mm" for _, unit in own.values())


@pytest.mark.slow
@pytest.mark.parametrize("language", ["en", "ru"])
def test_it_is_told_on_sheet_table_note_and_to_machines(tmp_path: Path, language: str) -> None:
    made = drawn(tmp_path, language=language)
    found = told(made)
    percent = f"{abs(100 * found.off['J_fly']):.2g}"
    due = f"{found.due['J_fly'][0]:.4g}"
    if language == "ru":
        percent, due = percent.replace(".", ","), due.replace(".", ",")
    words = {"en": "too small by {} %", "ru": "меньше должного на {} %"}[language].format(percent)
    side = {"en": "on the dangerous side", "ru": "в опасную сторону"}[language]
    enough = {"en": f"with {found.enough} positions", "ru": f"при {found.enough} положениях"}
    (warned,) = [one for one in warnings(made.boards[0], language) if "360" in one]
    sheet = " ".join(texts(flywheel_views(made.boards[0], True))).replace(" start ", " ")
    noted = paragraphs(made)
    for text in (warned, sheet, noted):
        assert words in text
        assert due in text
        assert side in text
        assert (enough[language] in text) == (text is not sheet)  # advice is not lettered
    machine = json.loads(table(made, "json"))["results"]["J_fly"]  # type: ignore[arg-type]
    assert machine["due"] == pytest.approx(found.due["J_fly"][0], rel=1e-8)
    assert machine["off_percent"] == pytest.approx(100 * found.off["J_fly"], abs=1e-4)
    assert machine["positions"] == found.enough
    rows = table(made, "text")[-1].rows  # type: ignore[union-attr]
    assert due[:4] in next(row for row in rows if row[0].startswith("J_"))[1]


@pytest.mark.slow
def test_pressures_in_positions_have_nothing_between_them(tmp_path: Path) -> None:
    made = drawn(tmp_path, ENGINE)
    assert finer(made.boards[0]) is None
    assert "given at the positions only" in paragraphs(made)
    assert "due" not in json.loads(table(made, "json"))["results"]["J_fly"]  # type: ignore[arg-type]


def test_nothing_is_drawn_once_more_where_curves_give_no_result(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    text = PRESS.partition("[flywheel]")[0] + '[[sheet]]\nplace = ["positions", "forces"]\n'
    monkeypatch.setattr(finer_rows, "record", lambda *one: pytest.fail("recorded again"))
    made = drawn(tmp_path, text)
    assert not re.search("360", str(table(made, "json")))


def test_lengths_of_the_finer_row_are_to_the_scale_factors_of_each_drawing(tmp_path: Path) -> None:
    """They are cached with the scene, which is drawn to other scale factors afterwards."""
    board = drawn(tmp_path).boards[0]
    first = finer(board)
    mu = next(mark for mark in board.given if mark.name == "μ_A")
    coarser = replace(board, given={**board.given, mu: 2.0 * float(np.squeeze(board.given[mu]))})
    second = finer(coarser)
    assert first is not None
    assert second is not None
    assert second.due["cd"][0] == pytest.approx(first.due["cd"][0] / 2.0, rel=1e-6)
    assert second.due["J_fly"] == first.due["J_fly"]
