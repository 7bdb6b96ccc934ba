"""Which mutations may be drawn at a clicked pole, and how pencil agrees with lines."""

from __future__ import annotations

import functools
from pathlib import Path

import numpy as np
import pytest

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.own_sheet.alternatives import Alternatives, agreement, moved
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import View
from graphic_tmm.paper.ruled import Box
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

CASES = Path(__file__).parents[2] / "cases" / "check"
DOTS, POLE = 8.0, 110 + 100j


@functools.cache
def others() -> Alternatives:
    board = make(read(CASES / "sc.toml"), exact=True).mechanism
    assert board is not None
    return Alternatives(board, HANDS["student"])


def pencilled(view: View) -> Flat:
    """A paper of 220 × 200 mm with the lines of a view about the pole, 0.4 mm wide."""
    x, y = np.meshgrid((np.arange(1760) + 0.5) / DOTS, 200 - (np.arange(1600) + 0.5) / DOTS)
    z = x + 1j * y - POLE
    far = np.full(z.shape, np.inf)
    for line in view.lines:
        along = np.clip(((z - line.start) / (line.end - line.start)).real, 0, 1)
        far = np.minimum(far, abs(z - line.start - along * (line.end - line.start)))
    image = np.where(far < 0.2, 90, 230).astype(np.uint8)
    return Flat(np.repeat(image[..., None], 3, axis=2), Box(0.0, 0.0, 220.0, 200.0), DOTS)


def spots(view: View) -> dict[str, complex]:
    return {name[1]: place.at for place in view.places for name in place.names}


@pytest.mark.parametrize("turn", [1.0, 1j])
@pytest.mark.slow
def test_what_is_due_agrees_best_with_its_own_pencil(turn: complex) -> None:
    due = others().due("accelerations", "1").turned(turn)
    flat = pencilled(due)
    whole = agreement(flat, *(POLE + due.ends))
    assert whole.covered > 0.99
    for _, view in others().near(flat, due, "accelerations", "1", POLE):
        assert agreement(flat, *(POLE + view.ends)).worth < whole.worth


@pytest.mark.parametrize("says", ["from {now} instead", "away from the centre"])
@pytest.mark.slow
def test_a_mutation_is_found_by_its_pencil(says: str) -> None:
    due = others().due("accelerations", "1")
    rows = [
        k
        for k, one in enumerate(others().mutations)
        if one.at is not None and one.at.it.view == "accelerations" and says in one.says
    ]
    drawn = [view for k in rows if (view := others().view(k, "accelerations", "1", 1.0))]
    moves = [v for v in drawn if max(abs(spots(v)[k] - z) for k, z in spots(due).items()) > 6]
    view = next(v for v in moves if np.isfinite(v.at).all() and abs(v.at).max() < 95)
    near = [v for _, v in others().near(pencilled(view), due, "accelerations", "1", POLE)]
    off = [max(abs(spots(v)[k] - z) for k, z in spots(view).items()) for v in near]
    assert min(off) < 1.0


def test_lines_go_with_their_places() -> None:
    due = others().due("velocities", "1")
    starts, ends = moved(due, np.array([due.at, due.at + 10]))
    assert starts[0] == pytest.approx(due.ends[0])
    assert ends[1] == pytest.approx(due.ends[1] + 10)


def test_a_line_without_length_is_nowhere_and_counts_nothing() -> None:
    due = others().due("velocities", "1")
    starts, ends = moved(due, np.zeros((1, len(due.places)), np.complex128))
    assert np.isnan(starts[0]).any()
    flat = pencilled(due)
    kept = np.isfinite(starts[0] + ends[0])
    assert agreement(flat, starts[0], ends[0]) == agreement(flat, starts[0][kept], ends[0][kept])
