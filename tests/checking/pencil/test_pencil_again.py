"""What was seen tells where the lines from there run, and which of them is which."""

from __future__ import annotations

import numpy as np
from support.photographed.rubbed import flat, paper, rubbed

from graphic_tmm.checking.pencil.again import again
from graphic_tmm.checking.pencil.doubting import robbed
from graphic_tmm.checking.pencil.expected import Line, Place, View
from graphic_tmm.checking.pencil.fitting import fit
from graphic_tmm.checking.pencil.lines import Track
from graphic_tmm.checking.pencil.points import SEEN, UNSURE, Spot
from graphic_tmm.checking.pencil.web import Pin, Web

NO_INK = np.empty((0, 2), dtype=np.complex128)
POLE, LEFT, RIGHT = 20 + 20j, 20 + 80j, 110 + 30j


def view(astray: float = 2.0, of: tuple[int | None, ...] = (None, 0, 0)) -> View:
    """Return two points, seen from a pole, and the line between them."""
    random = np.random.default_rng(5)
    scatter = random.normal(0, 1, (60, 3)) + 1j * random.normal(0, 1, (60, 3))
    places = POLE, LEFT, RIGHT
    return View(
        "velocities",
        tuple(Place(at, ()) for at in places),
        (Line(POLE, LEFT, (0, 1)), Line(POLE, RIGHT, (0, 2)), Line(LEFT, RIGHT, (1, 2))),
        {},
        (NO_INK,) * 3,
        of,
        scatter * np.array([0, astray, astray]),
    )


def test_a_point_that_was_seen_stands_where_it_was_seen() -> None:
    moved = 1.5 - 0.5j
    found = fit(view(), [(), (), ()], {1: Pin(moved, 0.2)})
    assert abs(found.moved[1] - moved) < 0.1
    assert found.spread(1, 1.0) < 0.25 < 1.0 < found.spread(2, 1.0)


def test_of_two_lines_the_one_from_where_the_point_was_seen_is_chosen() -> None:
    one = view()
    near, far = Track(0.2, 0.0, 0.95, 0.1), Track(-3.0, 0.0, 0.9, 0.1)
    assert fit(one, [(), (), (near, far)]).tracks[2] is near
    left = 1j * one.lines[2].way
    assert fit(one, [(), (), (near, far)], {1: Pin(-3.0 * left, 0.2)}).tracks[2] is far


def test_a_line_is_followed_again_from_where_its_points_were_seen() -> None:
    one = view()
    moved = 4.0 + 2.0j  # both points are off together: farther than the line was sought at first
    drawn = rubbed(paper(), LEFT + moved, RIGHT + moved)
    seen = [
        Spot(POLE, 0.1, UNSURE),
        Spot(LEFT + moved, 0.1, SEEN),
        Spot(RIGHT + moved, 0.1, SEEN),
    ]
    found = again(flat(drawn), one, 0j, [(), (), ()], seen).tracks[2]
    assert found is not None
    left = 1j * one.lines[2].way
    aside = (moved / left).real
    assert abs(found.start - aside) < 0.2
    assert abs(found.end - aside) < 0.2
    assert (
        again(flat(drawn), one, 0j, [(), (), ()], [Spot(POLE, 0.1, UNSURE)] * 3).tracks[0] is None
    )


def test_a_line_that_has_anothers_pencil_is_doubted_by_how_far_they_should_be_apart() -> None:
    at = [POLE, 90 + 24j, 90 + 20j]
    one = view()._replace(
        places=tuple(Place(z, ()) for z in at),
        lines=(Line(POLE, at[1], (0, 1)), Line(POLE, at[2], (0, 2))),
    )
    mine = Track(0.0, -4.0, 1.0, 0.1)  # the upper line lies where the lower one should be
    own = Track(0.0, 0.0, 1.0, 0.1)
    doubts = robbed(Web(one, {}), [(mine,), (own,)], [mine, None])
    assert set(doubts) == {0}
    assert abs(doubts[0][1]) > 3.5
    assert robbed(Web(one, {}), [(mine,), (own._replace(covered=0.4),)], [mine, None]) == {}
    fan = one._replace(of=(None, 0, 1))
    assert robbed(Web(fan, {}), [(mine,), (own,)], [mine, None]) == {}
