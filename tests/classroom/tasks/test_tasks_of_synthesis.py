"""What the sheet of a task gives where lengths are to be found: never one of these; sums of them."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import SHEETS
from support.scenes import written

from graphic_tmm.classroom.tasks.given import disguised, told_rows
from graphic_tmm.mechanism.synthesis import lengths_found
from graphic_tmm.scene.read import read

PARTLESS = """title = "T"
language = "en"
[task]
{task}
[synthesis]
[[sheet]]
format = "A3"
"""


def rows(path: Path, board: str = "mechanism") -> dict[str, object]:
    return {row.symbol: row.value for row in told_rows(read(path), path.read_text("utf-8"), board)}


def test_the_places_of_pivots_that_are_sought_are_told_by_them() -> None:
    told = rows(SHEETS / "three-positions" / "scene.toml")
    assert (told["x_{OC}"], told["y_{OC}"]) == ("−xO + xC", "−yO + yC")
    assert not {"l_{OA}", "l_{BC}"} & told.keys()
    assert (told["X_{A3}"], told["α_3"], told["l_{AB}"]) == (-43.0, 12.5, 120.0)


def test_a_crank_and_a_rod_that_are_sought_are_not_given() -> None:
    told = rows(SHEETS / "found-slider" / "scene.toml")
    assert not {"l_{OA}", "l_{AB}"} & told.keys()
    assert (told["K_v"], told["S"], told["e"]) == (1.2, 100.0, 30.0)


@pytest.mark.parametrize("name", ["found-slider", "three-positions", "windrower"])
def test_no_length_that_is_sought_can_be_taken_from_the_scheme(name: str) -> None:
    path = SHEETS / name / "scene.toml"
    shown, own = disguised(read(path), path.read_text("utf-8")), read(path)
    assert shown is not None
    assert shown.task is not None
    assert own.task is not None
    other, due = (lengths_found(one.task.kind, one.task.given) for one in (shown, own))
    for length in due.keys() - own.task.given.keys():
        assert abs(other[length] - due[length]) > 0.02 * abs(due[length]), length


FUNCTION = """kind = "function"
x = [1, 2]
power = 1.5
crank = [30, 120]
rocker = [60, 120]
OA = 0.04
OC = 0.1"""
GIVEN = {"l_{OC}": 100.0, "l_{OA}": 40.0, "x_0": 1.0, "x_n": 2.0, "p": 1.5}
ANGLES = {"φ_0": 30.0, "φ_n": 120.0, "ψ_0": 60.0, "ψ_n": 120.0}
PISTON = 'kind = "slider-crank"\nv_m = 3\nn = "600 rpm"\npressure = 18'


@pytest.mark.parametrize(
    ("task", "due"),
    [
        ('kind = "cylinder"\nstroke = "100 mm"\npsi = "40 deg"', {"S": 100.0, "ψ": 40.0}),
        (PISTON, {"v_m": 3.0, "n_1": 600.0, "[α]": 18.0}),
        (FUNCTION, GIVEN | ANGLES),
    ],
)  # fmt: skip
def test_without_a_mechanism_all_is_given_on_the_board_of_the_synthesis(
    tmp_path: Path, task: str, due: dict[str, float]
) -> None:
    assert rows(written(tmp_path, PARTLESS.format(task=task)), "synthesis") == pytest.approx(due)
