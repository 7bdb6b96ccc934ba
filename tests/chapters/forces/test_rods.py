"""The force that drives a rod as a sheet shows it: read off the SVG, against what else acts on the rod."""

from __future__ import annotations

import pytest
from support.boards import drawn_of
from support.driven_scenes import BOOM, OUT, scene
from support.force_views import views_of
from support.sheet_reader import Told, View, lines, plain, result, views

from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.views import force_table
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.write.svg import svg

STATIC = "[effects]\ngravity = true\n[forces]\npositions = [3]\n"
WEIGHT = 'mass = "40 kg"\ncentre = "C"\nJ = 0\n'
OF_CYLINDER = 'points = {{ G = [0, 0], S2 = [0.2, 0.01] }}\nmass = "30 kg"\ncentre = "S2"\nJ = 0\n'
OF_ROD = 'points = {{ N = [0, 0], S3 = [-0.1, 0] }}\nmass = "10 kg"\ncentre = "S3"\nJ = 0\n'
HEAVY = BOOM.replace("points = {{ G = [0, 0] }}\n", OF_CYLINDER).replace(
    "points = {{ N = [0, 0] }}\n", OF_ROD
)
TURNED = (
    HEAVY.replace("G = [0, 0]", "H = [0, 0]")
    .replace("points = {{ N =", "points = {{ G =")
    .replace("points = {{ H =", "points = {{ N =")
)
"""The rod turns on the frame, the cylinder on the boom."""


def work(text: str) -> Drawn:
    return drawn_of(scene(text, OUT + STATIC, WEIGHT), exact=True)


def arrow(one: Told) -> complex:
    """A vector as it is drawn: its shaft ends within the arrowhead."""
    return one.way * one.number("mm")


def sheet(drawn: Drawn) -> dict[str, View]:
    """The views of forces as they are written to a file, by what they show; of the lever its figure."""
    placed = tuple(view.moved(complex(600.0 * k)) for k, view in enumerate(views_of(drawn)))
    found = views(svg(Sheet("s", "s", "A1", 841.0, 594.0, placed, drawn.scene.language)))
    return {name.partition("-")[0]: found[name] for name in reversed(found)}


def letters(view: View) -> list[str]:
    return [plain(word) for word in view.words]


@pytest.mark.parametrize("boom", [1, 4], ids=["second leg", "first leg"])
@pytest.mark.parametrize(
    ("text", "upper", "lower"), [(HEAVY, 3, 2), (TURNED, 2, 3)], ids=["rod above", "rod below"]
)
def test_what_drives_a_heavy_rod_and_what_holds_it_across_carry_it(
    text: str, upper: int, lower: int, boom: int
) -> None:
    """With the weight and the reaction of the pin they close the polygon of the upper link alone."""
    drawn = work(text.replace("number = 1\n", f"number = {boom}\n"))
    view = sheet(drawn)["forces"]
    drives, across = view.named("Pb"), view.named(f"R{lower}{upper}")
    assert (drives.pen, across.pen) == ("thin", "thin")
    assert abs(drives.start + arrow(drives) - across.start) < 0.01
    assert abs((drives.way * across.way.conjugate()).real) < 1e-3
    pins = [s for s in view.strokes if s.data["segment"] in (f"R{boom}{upper}", f"R{upper}{boom}")]
    assert len(pins) == 1
    sign = 1 if pins[0].data["segment"] == f"R{boom}{upper}" else -1
    weight = view.named(f"G{upper}")
    acting = [*map(arrow, (drives, across, weight)), sign * arrow(pins[0])]
    assert abs(sum(acting)) < 0.02
    (driven,) = FORCES_PLAN.on(drawn).driven
    due = abs(drawn.reading[driven.balance][0, 3])
    assert drives.number("value") == pytest.approx(due, rel=1e-5)
    assert {"Pb", f"R{lower}{upper}"} <= {*letters(view)}


def test_a_weightless_rod_names_the_side_that_is_there_and_adds_no_step() -> None:
    drawn = work(BOOM)
    view = sheet(drawn)["forces"]
    assert letters(view).count("Pb") == 1
    assert "Pb" not in [stroke.data["segment"] for stroke in view.strokes]
    (group,) = FORCES_PLAN.on(drawn).groups
    steps = [one for one in drawn.construction.steps if one.it.view == group.polygon.view]
    assert [step.op.name for step in steps].count("meet") == 1


def test_a_rod_that_pulls_is_printed_with_its_sign_in_equation_table_and_lever() -> None:
    drawn = work(BOOM)
    (driven,) = FORCES_PLAN.on(drawn).driven
    pulls = drawn.reading[driven.balance][0, 3]
    assert pulls < 0.0
    found = sheet(drawn)
    equation = next(one for one in lines(found["equations"]) if one.startswith("P_b = "))
    mm, force = equation.removeprefix("P_b = ").split(" mm·")
    assert mm.startswith("−")
    told = result(force)
    assert abs(told.value - pulls) <= told.half
    both = next(one for one in lines(found["lever"]) if one.startswith("P_b = ")).split(", ")
    assert [round(result(one).value, 1) for one in both] == 2 * [round(pulls, 1)]
    (table,) = force_table(drawn, lettered=True)
    texts = [label.text for label in table.labels]
    # both reactions of the leg by their sizes, the force by the polygon and by the lever
    assert [texts.count(f"{sign}{-pulls:.0f}") for sign in ("", "−")] == [2, 2]
