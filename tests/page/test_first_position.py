"""The position in which the crank of a page stands at first is one that the task asks plans for."""

from __future__ import annotations

from dataclasses import replace

from support import gallery

from graphic_tmm.page.dense import first_asked
from graphic_tmm.page.page import page_data

NAME = "crank-press"
"""Forces are asked for in few of its positions."""


def test_the_crank_stands_where_most_plans_are_drawn() -> None:
    made, sheets = gallery.paper(NAME)
    drawn = made.mechanism
    assert drawn is not None
    plans = [view["position"] for view in page_data(made, sheets)["views"]]
    free = replace(drawn, project=replace(drawn.project, scene=replace(drawn.scene, main=None)))
    first = drawn.names[first_asked(free, plans)]
    forced = {
        view["position"] for view in page_data(made, sheets)["views"] if "forces" in view["plan"]
    }
    assert first in forced
    assert plans.count(first) == max(plans.count(name) for name in drawn.names)
    assert drawn.names[first_asked(drawn, plans)] == drawn.scene.main


def test_the_main_position_comes_first_of_several() -> None:
    drawn = gallery.paper("crank-rocker")[0].mechanism
    assert drawn is not None
    assert first_asked(drawn, []) == drawn.main
    other = next(name for k, name in enumerate(drawn.names) if k != drawn.main)
    assert drawn.names[first_asked(drawn, [other])] == other
    assert first_asked(drawn, [other, drawn.names[drawn.main]]) == drawn.main
