"""Lines of pencil and places taken together: crossings, exchanges, what a hand carries past its neighbours."""

from __future__ import annotations

import numpy as np
import pytest

from graphic_tmm.checking.pencil.expected import ExpectedLine, ExpectedPlace, View
from graphic_tmm.checking.pencil.fitting import DOUBT, Fit, Swaps, crossing
from graphic_tmm.checking.pencil.lines import Track
from graphic_tmm.checking.pencil.points import Signs
from graphic_tmm.checking.pencil.web import Solved, Web

NO_INK = np.empty((0, 2), dtype=np.complex128)
DRAWINGS = 50


def view(
    at: list[complex],
    lines: list[tuple[int, int]],
    of: list[int | None] | None = None,
    astray: float = 0.0,
) -> View:
    """Return a view whose lines go from place to place, which drawings scatter by ``astray``, mm."""
    random = np.random.default_rng(3)
    scatter = random.normal(0, 1, (DRAWINGS, len(at))) + 1j * random.normal(
        0, 1, (DRAWINGS, len(at))
    )
    return View(
        "velocities",
        tuple(ExpectedPlace(one, ()) for one in at),
        tuple(ExpectedLine(at[a], at[b], (a, b)) for a, b in lines),
        {},
        (NO_INK,) * len(at),
        tuple([None, *[0] * (len(at) - 1)] if of is None else of),
        astray * scatter,
    )


def test_a_foot_is_told_as_a_share_of_its_line() -> None:
    """A line of 3, 4, 5: what stands 2 mm along it and 7 mm aside has its foot at two fifths."""
    line = ExpectedLine(1 + 1j, 4 + 5j, (0, 1))
    way = 0.6 + 0.8j
    spots = np.array([1 + 1j + (2 + 7j) * way, 1 + 1j + (-5 - 3j) * way])
    assert [line.share(at) for at in spots] == pytest.approx([0.4, -1.0])
    assert line.shares(spots) == pytest.approx([0.4, -1.0])


def fitted(one: View, tracks: list[Track]) -> Fit:
    count = len(one.places)
    return Fit(
        tuple(tracks),
        np.zeros(count, dtype=np.complex128),
        np.eye(2 * count),
        (None,) * len(tracks),
    )


def star(moved: complex) -> tuple[View, list[Track]]:
    """Return five vectors from a pole, and their lines when the pole is ``moved``."""
    ends = [60 * np.exp(1j * np.radians(angle)) for angle in (10, 80, 150, 220, 300)]
    one = view([0j, *ends], [(0, k) for k in range(1, 6)])
    off = [(moved / line.way).imag for line in one.lines]
    return one, [Track(start, 0.0, 1.0, 0.05) for start in off]


def test_lines_of_a_pole_that_agree_outvote_one_that_passes_it() -> None:
    one, tracks = star(0.6 - 0.3j)
    tracks[2] = tracks[2]._replace(start=tracks[2].start + 2.0)
    cross = crossing(one, fitted(one, tracks), 0)
    assert abs(cross.moved - (0.6 - 0.3j)) < 0.1
    assert cross.misfit < 0.1


def test_of_two_lines_neither_is_outvoted() -> None:
    one = view([0j, 40 + 0j, 40j], [(0, 1), (0, 2)])
    cross = crossing(
        one, fitted(one, [Track(0.5, 0.5, 1.0, 0.05), Track(-0.4, -0.4, 1.0, 0.05)]), 0
    )
    assert cross.moved == pytest.approx(0.4 + 0.5j, abs=0.01)


PITCH = 3.0


def combed(spare: bool) -> Swaps:
    """Return five upright lines side by side, each where it should be, that a hand scatters by 1.5 mm.

    Each sees its neighbours' pencil; ``spare``: the first sees a line of nobody's, too.
    """
    at = [0j, *[k * PITCH + y * 1j for k in range(5) for y in (0, 60)]]
    one = view(at, [(1 + 2 * k, 2 + 2 * k) for k in range(5)], astray=1.5)
    own = Track(0.0, 0.0, 1.0, 0.1)
    found = []
    for k in range(5):
        beside = [n for n in (k - 1, k + 1) if 0 <= n < 5] + ([-1] if spare and k == 0 else [])
        aside = [PITCH * (k - n) for n in beside]  # to the left of a line upward
        found.append([own, *(Track(off, off, 1.0, 0.1) for off in aside)])
    web = Web(one, {})
    told = Solved(np.zeros(2 * len(at)), web.solved([own] * 5).scatter)
    return Swaps(web, found, told, [tracks[0] for tracks in found])


def test_a_neighbours_line_is_no_doubt_while_the_neighbour_needs_it() -> None:
    swaps = combed(spare=False)
    assert all(loses[0][0] < DOUBT for loses in swaps.loses)  # by itself it might well be there
    assert [swaps.doubt(k) for k in range(5)] == [None] * 5


def test_a_line_of_nobodys_beside_it_is_a_doubt() -> None:
    assert combed(spare=True).doubt(0) == (PITCH, PITCH)


@pytest.mark.parametrize(
    ("of", "astray", "crowded"),
    [
        ([None, 0, 0], 3.0, False),
        ([None, 0, 1], 1.0, False),
        ([None, 0, 1], 3.0, True),
    ],
)
def test_in_a_fan_a_hand_may_carry_a_point_past_its_neighbours(
    of: list[int | None], astray: float, crowded: bool
) -> None:
    one = view([0j, 30 + 0j, 35 + 5j], [(0, 1), (0, 2)], of, astray)
    signs = Signs(one, fitted(one, [Track(0, 0, 1.0), Track(0, 0, 1.0)]), 0j)
    assert signs.crowded(1) is crowded
    assert signs.crowded(0) is False


def test_of_two_points_in_one_place_neither_is_told() -> None:
    one = view([0j, 30 + 0j, 30.2 + 0j], [(0, 1), (0, 2)], [None, 0, 1], 0.5)
    assert Signs(one, fitted(one, [Track(0, 0, 1.0)] * 2), 0j).crowded(1)


def test_how_far_aside_a_hand_has_a_line_is_measured_across_it() -> None:
    one = view([0j, 40 + 0j], [(0, 1)], astray=2.0)
    along = one._replace(astray=one.astray.real + 0j)
    assert one.sideways_scatter(one.lines[0]) == pytest.approx(2.0, rel=0.3)
    assert along.sideways_scatter(one.lines[0]) == 0.0
