"""What is recorded of kinematic diagrams: their plan; aside a turn, an interval, its middles."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.formula import formula
from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.graphs import standing
from graphic_tmm.board.operations.instruments import measure, measure_along
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.diagrams import words as why
from graphic_tmm.chapters.diagrams.plan import DIAGRAMS_PLAN, Kinematic, record
from graphic_tmm.chapters.diagrams.task import CALCULATED, DIAGRAMS
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans
from graphic_tmm.chapters.kinematics.task import FULL_TURN, VELOCITIES
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded, aside

WHOLE = 1e-9
"""An extra position that is nearer to one of the row, in intervals, stands on its boundary."""


@formula(why=said("The crank turns evenly: a turn of 2π rad takes the time 2π/ω."))
def time_of_turn(omega: Number) -> Number:
    """2π/{omega}"""


@formula(why=said("The base is divided into as many equal parts as the row has intervals."))
def interval_of(base: Length, intervals: Number) -> Length:
    """{base}/{intervals}"""


@formula(
    holds="{whole} ≠ 0",
    fails="the crank pin does not move",
    why=said(
        "Equal angles of the crank are equal parts of the base. Within one interval arcs are nearly as their "
        "chords: the interval is divided as the chord {whole} is by {part}."
    ),
)
def place_between(part: Length, interval: Length, whole: Length) -> Length:
    """{part}·{interval}/{whole}"""


class Place(NamedTuple):
    """Where an extra position stands: its index, that of the one before it, how far behind that (Length)."""

    extra: int
    before: int
    distance: Mark


class Middle(NamedTuple):
    """What chords tell of the middles of the intervals: the ordinate read there (Length), the quantity (SI)."""

    ordinate: Mark
    value: Mark


class Aside(NamedTuple):
    """``time``: of a turn (s), of another row what its base stands for.

    ``interval``: its share of the base (Length). ``middles``: by the symbol of a diagram found by chords;
    ``places``: of the extra positions that stand between two of the row.
    """

    time: Mark
    interval: Mark
    middles: dict[str, Middle]
    places: tuple[Place, ...]


BESIDE: Recorded[Aside] = Recorded(aside(DIAGRAMS))


def record_beside(bench: Bench) -> Aside:
    """Calculate what the diagrams do not need."""
    made, plans, draft = DIAGRAMS_PLAN.on(bench), KINEMATICS_PLAN.on(bench), bench.draft
    assert plans.velocities is not None
    assert plans.velocities.speed is not None
    draft.open(CALCULATED)
    time = made.whole or draft.draw(time_of_turn, "t", plans.velocities.speed, unit="s")
    intervals = draft.take(Number, "N", float(made.base.intervals))
    interval = draft.draw(interval_of, "L_1", made.base.length, intervals)
    middles = {symbol: _middle(bench, made, symbol) for symbol in made.middles}
    return Aside(time, interval, middles, tuple(_places(bench, plans, interval)))


def _middle(bench: Bench, made: Kinematic, symbol: str) -> Middle:
    """Read what the chords gave over the middles of the intervals."""
    draft, chart, (axes, middles) = bench.draft, made.charts[symbol], made.middles[symbol]
    ordinate = draft.draw(
        measure_along, f"[{symbol}_m]", axes.middles, middles.points, axes.up, why=why.MEAN_READ
    )
    return Middle(ordinate, draft.draw(in_si, f"{symbol}_m", ordinate, chart.mu, unit=chart.unit))


def _places(bench: Bench, plans: KinematicPlans, interval: Mark) -> Iterator[Place]:
    """Yield where extra positions stand, measured on the circle of the crank pin."""
    draft, pin, known = bench.draft, plans.led[1], dict[int, Mark]()

    def at(place: int) -> Mark:
        """Return the crank pin in a position; marked once."""
        if place not in known:
            letter = f"{pin.letter}_{{{bench.names[place]}}}"
            known[place] = draft.draw(standing, letter, pin, place=place)
        return known[place]

    for extra, before in _between(np.ravel(plans.numbers), plans.count):
        first, name = at(before), f"{bench.names[before]}÷{bench.names[extra]}"
        part = draft.draw(measure, f"[{name}]′", first, at(extra))
        whole = draft.draw(measure, f"[{name}]″", first, at((before + 1) % plans.count))
        distance = draft.draw(place_between, f"[{name}]", part, interval, whole)
        yield Place(extra, before, distance)


def _between(numbers: np.ndarray, count: int) -> Iterator[tuple[int, int]]:
    """Yield the extra positions that stand between two of the row, each with the one before it."""
    for extra in range(count, numbers.size):
        number = float(numbers[extra])
        if np.isfinite(number) and abs(number - round(number)) > WHOLE:
            yield extra, int(number)


PLAN = Plan(
    needs=lambda scene: {VELOCITIES: True},
    record=record,
    aside=record_beside,
    charts=lambda made: made.charts.values(),
    result=lambda made: [chart.ordinates[0] for chart in made.charts.values()],
    remedy=FULL_TURN,
)
