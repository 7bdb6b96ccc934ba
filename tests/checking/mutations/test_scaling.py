"""A multiple is no sure name where it may be a scale factor of the student's own."""

from __future__ import annotations

import numpy as np
import pytest
from support.gallery import exact
from support.own_told import kind_of, report_of, told, with_mistake

from graphic_tmm.checking.mutations.hypotheses import UNSURE, Hypothesis
from graphic_tmm.checking.mutations.mutation import FACTOR, Mutation
from graphic_tmm.checking.mutations.scaling import Scaling
from graphic_tmm.checking.records import OwnScale


def test_it_is_known_who_says_a_scale_factor() -> None:
    def scale(plan: str, by: str) -> OwnScale:
        return OwnScale(plan, plan, "μ", 0.1, 0.2, "m", by)

    by = ("stated", "rows", "lengths", "round", "rates")
    known = Scaling.of([scale(what, what) for what in by])
    assert known == Scaling(
        frozenset({"stated"}), frozenset({"lengths", "round"}), frozenset({"rows"})
    )
    assert [what for what in by if known.free(what)] == ["lengths", "round", "rates"]


@pytest.mark.turns(2)
@pytest.mark.parametrize(
    "name",
    [
        "omega not squared in πa",
        "t along the link in accelerations",
        "OB misread",
        "S from another zero",
    ],
)
@pytest.mark.slow
def test_no_false_multiple_in_an_unstated_scale_is_sure(name: str) -> None:
    """Each was named falsely, and sure, in the student's own scale factors."""
    drawing = with_mistake(kind_of(name), 0)
    report = report_of(drawing)
    assert not isinstance(report, str)
    one = told(report, drawing)
    assert one.named
    assert one.name or not one.sure


@pytest.mark.parametrize(("stated", "sure"), [("velocities", 0.9), ("accelerations", UNSURE)])
def test_two_names_are_sure_where_somebody_states_the_scale(stated: str, sure: float) -> None:
    (board,) = exact("crank-rocker").boards
    step = next(one for one in board.construction.steps if one.it.view == "velocities")
    what = Mutation(FACTOR, "", {}, {}, step)
    one = Hypothesis(what, 0, None, 0.0, np.zeros(1), 0, 0, np.zeros(1))
    said = (((one,), 0.9), ((one,), 0.9))
    assert [chance for _, chance in Scaling(frozenset({stated})).weighed(said)] == [sure, sure]


@pytest.mark.slow
def test_a_graph_whose_rows_say_its_scale_factor_has_no_other() -> None:
    """S is half as long as due, its mm and values agree: that is a mistake."""
    drawing = with_mistake(kind_of("S not scaled"), 1, 83000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    assert told(report, drawing).name
