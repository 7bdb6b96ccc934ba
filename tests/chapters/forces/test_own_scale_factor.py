"""A position whose forces are far smaller is drawn to a μ_F of its own, and every reader reads that one."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
import pytest
from support.gallery import SHEETS

from graphic_tmm import motion
from graphic_tmm.accuracy.drawing import pinned
from graphic_tmm.board.execute import execute
from graphic_tmm.board.scales import MANTISSAS, Scale
from graphic_tmm.chapters.forces.ink_polygons import spot
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.scales import ALIKE, READABLE
from graphic_tmm.chapters.forces.views import force_views
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.fitting.choice import choices
from graphic_tmm.language.numbers import number
from graphic_tmm.page.dense import dense
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.position_count import finer
from graphic_tmm.readers.table import scales_of
from graphic_tmm.scene.read import otherwise, read
from graphic_tmm.studio import make

SCENE = read(SHEETS / "lever" / "scene.toml")
VIEW, KEY = "forces 1", "mu_F_1"


@cache
def everywhere() -> DrawnScene:
    """Return the lever's mechanism with the forces of all positions: its load acts in some of them only."""
    return make(otherwise(SCENE, {"forces.positions": "all"}))


def board() -> Drawn:
    found = everywhere().mechanism
    assert found is not None
    return found


def own() -> Scale:
    found = board().scales[VIEW]
    assert found.own, "all positions are drawn to one scale factor"
    return found


def polygon(place: int) -> Drawing:
    name = f"forces-1-{board().names[place]}"
    return next(view for view in force_views(board(), True) if view.name == name)


def reach(place: int, view: str = VIEW) -> float:
    """Return how far a polygon reaches on paper, mm, by its vertices."""
    made = next(one for one in FORCES_PLAN.on(board()).polygons if one.view == view)
    spots = np.array([spot(board().reading, tail, place) for _, tail, _ in made.sides])
    return float(max(np.ptp(spots.real), np.ptp(spots.imag)))


@pytest.mark.parametrize("view", ["forces 4-5", "forces 2-3", VIEW])
def test_no_polygon_is_too_short_to_measure(view: str) -> None:
    """The next standard μ may draw it by the widest step of mantissas smaller than its room allows."""
    steps = [two / one for one, two in pairwise((*MANTISSAS, 10.0))]
    assert min(reach(k, view) for k in board().all) >= READABLE / max(steps)


def test_forces_of_one_size_have_one_scale_factor() -> None:
    for view in ("forces 4-5", "forces 2-3", VIEW):
        scale = board().scales[view]
        reaches = np.array([reach(k, view) * scale.at(k).value for k in board().all])
        assert bool(scale.own) == (reaches.max() / reaches.min() > ALIKE)


@pytest.mark.slow
def test_caption_tells_what_the_polygon_is_drawn_to() -> None:
    for place, value in [(own().own[0][0], own().own[0][1]), (0, own().value)]:
        told = f"μ_F = {number(value, SCENE.language)} Н/мм"
        assert any(told in label.text for label in polygon(place).labels), polygon(place).labels


def test_size_and_length_agree_at_every_position() -> None:
    made = FORCES_PLAN.on(board()).driven[0].alone.reaction
    lengths, sizes = (board().reading[mark][0] for mark in (made.length, made.value))
    mu = np.array([own().at(k).value for k in board().all])
    np.testing.assert_allclose(lengths * mu, sizes, rtol=1e-9)


@pytest.mark.slow
def test_forces_are_those_of_one_scale_factor() -> None:
    single, free = (
        make(otherwise(SCENE, {"forces.positions": "all", **more}), exact=True).boards[0]
        for more in ({"forces.mu_F": "25 N/mm"}, {})
    )
    assert free.scales[VIEW].own
    assert not single.scales[VIEW].own
    due, found = (
        one.reading[FORCES_PLAN.on(one).driven[0].alone.reaction.value] for one in (single, free)
    )
    np.testing.assert_allclose(found, due, rtol=1e-9)


def test_machines_and_the_choice_read_it_too() -> None:
    told = scales_of(everywhere())[KEY]
    assert told["value"] == own().value
    assert told["positions"] == {board().names[k]: value for k, value in own().own}
    found = choices(board())
    letters = {step.it.name: step.it for step in found.construction.steps}
    marks = [mark for name, mark in letters.items() if name.startswith("μ_F^")]
    numbers = execute(found.construction, found.given, marks)
    values = {float(numbers[mark][0, 0]) for mark in marks}
    assert {value for _, value in own().own} <= values


def test_other_angles_and_other_rows_are_drawn_to_that_of_most_positions() -> None:
    turned = dense(board())
    assert turned is not None
    assert not turned.drawn.scales[VIEW].own
    made = FORCES_PLAN.on(board()).driven[0].alone.reaction
    lengths, sizes = (turned.drawn.reading[mark][0] for mark in (made.length, made.value))
    np.testing.assert_allclose(lengths * own().value, sizes, rtol=1e-9)
    scales = [value for key, value in pinned(everywhere()).items() if key[2].startswith("μ_F")]
    assert scales
    assert all(isinstance(value, float) for value in scales)
    balance = motion(everywhere().scene, [30.0, 60.0], plans="forces").balance
    assert all(np.isfinite(row).all() for row in balance.values())


@pytest.mark.slow
def test_results_of_more_positions_are_told_where_positions_have_their_own() -> None:
    scene = otherwise(read(SHEETS / "windrower" / "scene.toml"), {"forces.positions": "all"})
    drawn = make(scene).mechanism
    assert drawn is not None
    assert any(scale.own for view, scale in drawn.scales.items() if view.startswith("forces"))
    usual = make(read(SHEETS / "windrower" / "scene.toml")).mechanism
    assert usual is not None
    found, due = finer(drawn), finer(usual)
    assert found is not None
    assert due is not None
    for name, (value, _) in due.due.items():
        assert found.due[name][0] == pytest.approx(value, rel=1e-9)
