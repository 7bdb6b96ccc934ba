"""What stands on which sheet: what is said of a plan with it; on one that does not say, what no other names."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import SHEETS
from support.scenes import written

from graphic_tmm.scene.read import read
from graphic_tmm.scene.registry import attended

FIRST, SECOND = ("positions", "given", "velocities"), ("accelerations", "equations", "results")


def test_the_equations_of_a_plan_stand_on_the_sheet_that_shows_it() -> None:
    found = attended([FIRST, SECOND], ["A1", "A1"], set())
    assert found == (
        (*FIRST, "velocity equations"),
        ("accelerations", "acceleration equations", "results"),
    )


@pytest.mark.parametrize(
    ("orders", "formats"),
    [
        ([(*FIRST, "accelerations", "equations")], ["A1"]),  # all on one sheet
        ([FIRST, SECOND], ["A4", "A1"]),  # the smallest hold nothing but what they are asked for
        ([FIRST, ("equations",)], ["A4", "A1"]),
        ([("positions", "given", "equations")], ["A1"]),  # no plan is shown
    ],
)
def test_equations_stay_where_they_are_asked_for(
    orders: list[tuple[str, ...]], formats: list[str]
) -> None:
    assert attended(orders, formats, set()) == tuple(orders)


def test_equations_that_a_sheet_names_by_themselves_are_not_there_twice() -> None:
    orders = [(*FIRST, "velocity equations"), SECOND]
    found = attended(orders, ["A1", "A1"], set())
    assert found == (orders[0], ("accelerations", "acceleration equations", "results"))


HEAD = (SHEETS / "crank-rocker" / "scene.toml").read_text("utf-8").partition("[[sheet]]")[0]


@pytest.mark.parametrize(
    ("named", "gone"),
    [
        ('["velocities"]', {"velocities"}),
        ('["velocities", "structure"]', {"velocities", "structure"}),
        ('["velocity table", "acceleration table"]', {"results"}),  # both its parts
        ('["velocity table"]', set()),  # the other part is shown nowhere else
    ],
)
def test_it_leaves_out_what_another_sheet_names(named: str, gone: set[str], tmp_path: Path) -> None:
    alone = read(written(tmp_path, f'{HEAD}[[sheet]]\nformat = "A3"\n')).sheets[0].place
    text = f'{HEAD}[[sheet]]\nformat = "A3"\n[[sheet]]\nformat = "A4"\nplace = {named}\n'
    rest = read(written(tmp_path, text)).sheets[0].place
    assert set(alone) - set(rest) == gone
    assert [place for place in alone if place not in gone] == list(rest)


def test_it_shows_all_where_others_name_all(tmp_path: Path) -> None:
    alone = read(written(tmp_path, f"{HEAD}[[sheet]]\n")).sheets[0].place
    listed = ", ".join(f'"{place}"' for place in alone)
    both = read(written(tmp_path, f"{HEAD}[[sheet]]\n[[sheet]]\nplace = [{listed}]\n")).sheets
    assert both[0].place == both[1].place == alone
