"""Radii of curvature as quantities of accuracy: which are read, where, against what; what they scatter by."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from mpmath import mp
from support.tasks import by, drawing, measure, quantity, scene

import graphic_tmm
from graphic_tmm.accuracy.quantities import quantities
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.curvature.accuracy import BOBILLIER, PLANS
from graphic_tmm.chapters.curvature.task import ASKED
from graphic_tmm.readers.position_count import at_count

NAME = "coupler-curvature"


def due() -> float:
    """ρ of K in position 1, m: the triangle of A, B and D as the crank turns, derived with 40 digits."""
    a, b, c, d, own = 0.1, 0.23, 0.25, 0.21, mp.mpc(0.05, 0.05)

    def way(phi: object) -> object:
        pin = a * mp.expj(phi)
        far = d - pin
        reach = abs(far)
        cosine = (reach**2 + b**2 - c**2) / (2 * b * reach)
        return pin + own * far / reach * mp.mpc(cosine, mp.sqrt(1 - cosine**2))

    with mp.workdps(40):
        first, second = (mp.diff(way, mp.pi / 6, n) for n in (1, 2))
        return float(abs(first) ** 3 / abs((mp.conj(first) * second).imag))


def test_both_ways_are_read_in_the_positions_that_are_drawn() -> None:
    drawn = drawing(NAME)
    assert [one.name for one in quantities(drawn)] == ["v", "a", PLANS, BOBILLIER]
    for name in (PLANS, BOBILLIER):
        mine = quantity(drawn, name)
        reading = execute(drawn.construction, drawn.given, mine.marks)
        for truth in (False, True):
            value = mine.read(reading, 1, due=truth)
            assert value.shape == (1, 1), "position 1 alone"
            assert value[0, 0] == pytest.approx(due(), rel=1e-9)
        assert mine.position(0) == 1
        assert WORDS["ru"][name].startswith("ρ ")


def test_the_constructions_stay_where_they_are_when_the_row_is_finer() -> None:
    finer = at_count(scene(NAME), 24)
    assert finer is not None
    order = ASKED.of(finer)
    assert order is not None
    assert order.positions == ("2",)
    own = ASKED.of(scene(NAME))
    assert own is not None
    odd = ASKED.put(scene(NAME), replace(own, positions=("1", "2")))
    assert at_count(odd, 18) is None, "30° is no position of 18"
    for count in (24, 36):
        drawn = drawing(NAME, at_count(scene(NAME), count))
        mine = quantity(drawn, BOBILLIER)
        value = mine.read(execute(drawn.construction, drawn.given, mine.marks), 1)
        assert value[0, 0] == pytest.approx(due(), rel=1e-9)


def test_what_is_measured_is_how_drawings_by_hand_scatter() -> None:
    """Nine of ten of the drawings that `draw` makes by a careful hand are off as `accuracy` says."""
    found = measure(NAME)
    told = {run.quantity: run for run in found.runs(by(NAME, "careful", 400), "hand", "careful")}
    sheet = graphic_tmm.draw(NAME, hand="careful", trials=400)
    table = sheet.table("curvature")
    for name, column in ((PLANS, "rhoK"), (BOBILLIER, "KK0′")):
        row = table[column].value[:, table.positions.index("1")]
        off = 100.0 * np.abs(row - due()) / due()
        assert math.isfinite(told[name].error)
        assert told[name].error == pytest.approx(float(np.quantile(off, 0.9)), rel=0.25)
