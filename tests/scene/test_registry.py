"""What stands on which sheet: what is said of a plan stands with it."""

from __future__ import annotations

import pytest

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
