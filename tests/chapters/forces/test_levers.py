"""The lever of each of several drives: it agrees with the groups, and knows nothing of them."""

from __future__ import annotations

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import composed
from support.words_of_drives import SCENES

import graphic_tmm
from graphic_tmm.board.execute import needed
from graphic_tmm.chapters.forces.lever import VIEW
from graphic_tmm.chapters.forces.loads import VIEW as LOADS
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.views import lever_views
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import BY_DRIVE
from graphic_tmm.drawn import Drawn

SEVERAL = [name for name in SCENES if name.endswith("forces") and len(SCENES[name].drives) > 1]
PAIR = """
[[load]]
link = 2
moment = "12 N*m"
[[spring]]
between = ["O", "{end}"]
rate = "2 kN/m"
free = "100 mm"
"""
WAYS = {
    "direct": "",
    "turned": '[plans]\nvelocities = "turned"\n',
    "pairs of forces": "",
    "at rest": "",
}


def drawn(name: str, way: str = "direct") -> Drawn:
    tables = SCENES[name].tables
    if way == "pairs of forces":
        tables = tables.replace("[forces]\n", '[forces]\ncouples = "pair"\n')
    if way == "at rest":
        for rate in ('"0.05 m/s"', '"0.02 m/s"', "5\n", '"0.2 m/s"', "10\n"):
            tables = tables.replace(
                f"speed = {rate}", "speed = 0\n" if "\n" in rate else "speed = 0"
            )
        tables = tables.replace("inertia = true\n", "").replace('accelerations = "all"\n', "")
    tables = WAYS[way] + tables + PAIR.format(end="T" if "cylinders" in name else "B")
    sheet = '[[sheet]]\nformat = "A1"\nplace = ["lever"]\n'
    return drawn_of(
        graphic_tmm.read(f'title = "S"\nlanguage = "en"\n{tables}\n{sheet}'), exact=True
    )


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("name", SEVERAL)
def test_each_agrees_with_the_groups(name: str, way: str) -> None:
    made = drawn(name, way)
    forces = FORCES_PLAN.on(made)
    assert len(forces.balanced) == 2
    for one in forces.balanced:
        groups, lever = made.reading[one.balance], made.reading[one.lever.balance]
        assert np.isfinite(groups).all()
        assert np.abs(groups).max() > 1.0
        np.testing.assert_allclose(lever, groups, rtol=1e-8)


@pytest.mark.parametrize("name", SEVERAL)
def test_none_knows_of_groups_or_of_another_drive(name: str) -> None:
    made = drawn(name)
    for one in FORCES_PLAN.on(made).balanced:
        link = one.driven.pair.link
        views = {step.it.view for step in needed(made.construction, [one.lever.balance])}
        others = {view for view in views if view.startswith((VIEW, BY_DRIVE, "forces", "group"))}
        assert others == {f"{VIEW} {link}", f"{BY_DRIVE} {link}"}
        assert LOADS in views


@pytest.mark.parametrize("name", SEVERAL)
def test_the_first_drive_at_rest_takes_the_plan_of_possible_velocities(name: str) -> None:
    made = drawn(name, "at rest")
    plans = KINEMATICS_PLAN.on(made)
    assert plans.by_drive[0].motion is plans.velocities
    assert [one.mu.view for one in plans.apart] == [f"{BY_DRIVE} {plans.by_drive[1].link}"]


def test_letters_names_and_columns_tell_the_levers_apart() -> None:
    made = drawn("two cylinders forces")
    forces = FORCES_PLAN.on(made)
    assert [one.lever.balance.name for one in forces.balanced] == ["P_{bl3}", "P_{bl6}"]
    table = graphic_tmm.draw("excavator").table("forces")
    due = ["forces", "lever", "difference", "6", "6_lever", "6_difference"]
    assert [name for name in table.columns if "bal" in name] == [f"P_bal_{name}" for name in due]


def test_a_couple_on_a_link_that_one_drive_does_not_move_is_left_out() -> None:
    """Of the excavator's boom, on the plan of the arm's cylinder: 0 N·mm is no term and no arrow."""
    views = {view.name: view for view in lever_views(composed("excavator")[0].boards[0], True)}
    for name in ("lever-6-1", "equations-lever-6-1"):
        assert "M_{и4}′" in "".join(label.text for label in views[name].labels)
        assert "M_{и1}′" not in "".join(label.text for label in views[name].labels)
    assert "M_{и1}′" in "".join(label.text for label in views["lever-3-1"].labels)
