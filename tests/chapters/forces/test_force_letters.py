"""Letters of arrows and couples: where they lead to, and whose they are."""

from __future__ import annotations

import cmath

import pytest
import shapely
from support.gallery import drawn

from graphic_tmm.chapters.forces.ink_arrows import Arrows, ArrowText
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.views import force_table
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.readers.equations import polygon


@pytest.mark.parametrize("value", [-3.0, 2.0])
@pytest.mark.parametrize("turn", [0.0, 1.2, 2.9, -2.0])
def test_the_letter_of_a_couple_is_led_to_its_arc(value: float, turn: float) -> None:
    arrows = Arrows(0, 5.0)
    arrows.couple(1 + 2j, 9.0, "M_{f}", ArrowText("M_f", value, "N·m", (3,)), cmath.rect(1.0, turn))
    (one,) = arrows.wanted
    assert shape(arrows.strokes[0]).distance(shapely.Point(one.at.real, one.at.imag)) < 0.1
    assert one.radius < 1.0


def test_a_letter_stands_nearer_to_its_own_arrow_than_to_another() -> None:
    """The heads of two arrows nearly touch."""
    arrows = Arrows(0, 5.0)
    arrows.put(0j, 1 + 0j, 30.0, "P_1", ArrowText("P_1", 3.0, "N", (1,)))
    arrows.put(38 + 24j, cmath.rect(1.0, -1.9), 25.0, "P_2", ArrowText("P_2", 2.0, "N", (2,)))
    view = finished(Drawing("lever", "", tuple(arrows.strokes), wanted=tuple(arrows.wanted)))
    for label in view.labels:
        away = {s.of: shape(s).distance(box(label)) for s in arrows.strokes if s.data}
        assert min(away, key=lambda of: away[of]) == label.of


def test_the_line_along_a_link_is_lettered_as_the_side_that_lies_on_it() -> None:
    """Beside a tangential component that is the normal one: the whole reaction lies along no link."""
    work, found = drawn("windrower"), list[str]()
    for group in FORCES_PLAN.on(work).groups:
        *_, first, second = polygon(work.construction, group.polygon.view)
        found += [one.line.letter for one in (first, second) if one.line is not None]
    assert found == ["(R_{65})", "(R_{34})", "(R_{63}^{n})", "(R_{23})"]


def test_a_table_with_a_couple_below_nothing_says_how_sums_take_it() -> None:
    """−8,59 in the table and "− M" in the sum would else be one sign too many."""

    def said(name: str) -> bool:
        (table,) = force_table(drawn(name), True)
        return any(one.text.startswith(("A couple", "Пара сил")) for one in table.labels)

    assert said("lever")
    assert not said("gripper")
