"""One setting measured: how far its quantities are off, what it costs at the board and on the machine."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import NamedTuple

import numpy as np

from graphic_tmm.accuracy.cost import BoardWork, count, varying
from graphic_tmm.accuracy.drawing import Pinned, References, draw, tried
from graphic_tmm.accuracy.quantities import Quantity, quantities
from graphic_tmm.accuracy.response import SHARE
from graphic_tmm.accuracy.settings import Setting, dividing
from graphic_tmm.accuracy.timing import Seconds, Stopwatch
from graphic_tmm.board.execute import prepare
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Reals
from graphic_tmm.project import Project

NOISE = 1e-9
"""An error below this, %, is rounding of the machine; plans agree with vector loops to some 1e-11 %."""
GROUPS = 10
"""Number of groups of drawings from which the uncertainty of the error itself is estimated."""
TRIED = 2
"""How often a draughtsman narrows the bracket of a position that he finds by trial."""


class Errors(NamedTuple):
    """The error of a quantity, % of its largest value over the turn: nine readings of ten are within ``error``.

    ``median``: half of them are; ``spread``: standard error of ``error``, NaN for a single drawing;
    ``failed``: % of the readings that could not be taken, as something could not be drawn. An error is NaN if
    too few could.
    """

    error: float
    median: float
    spread: float
    failed: float


@dataclass(frozen=True, eq=False)
class Measurement:
    """One quantity at one setting. ``axis`` and ``value``: what was varied, and to what.

    ``seconds``: of one run of the slice of the log that it needs; see `Measure.timed`.
    """

    axis: str
    value: str
    quantity: str
    positions: int
    hand: str
    enlarged: float
    trials: int
    errors: Errors
    work: BoardWork
    seconds: Seconds | None = None

    @property
    def error(self) -> float:
        """The error, in % of the largest."""
        return self.errors.error


def off(values: Reals, due: Reals, largest: float) -> Errors:
    """Return how far values (trial, value) are off what is due (1, value), in % of the ``largest`` value."""
    there = np.isfinite(due[0])
    if not largest > 0.0 or not there.any():
        return Errors(np.nan, np.nan, np.nan, np.nan)
    deviations = 100.0 * np.abs(values - due)[:, there] / largest
    missing = np.isnan(deviations)
    deviations = np.where(missing, np.inf, np.where(deviations < NOISE, 0.0, deviations))
    spread = _standard_error(deviations)
    failed = 100.0 * float(np.mean(missing))
    return Errors(_within(deviations, SHARE), _within(deviations, 0.5), spread, failed)


def _standard_error(deviations: Reals) -> float:
    """Return the standard error of what most of them keep within, leaving out groups of drawings."""
    groups = np.array_split(np.arange(len(deviations)), min(GROUPS, len(deviations)))
    if len(groups) < 2:
        return float("nan")
    each = np.array([_within(np.delete(deviations, group, axis=0), SHARE) for group in groups])
    if not np.isfinite(each).all():
        return float("nan")
    return float(np.sqrt((len(each) - 1) * np.var(each)))


def _within(deviations: Reals, share: float) -> float:
    """Return what a share of deviations keeps within; NaN if more of them than that is infinite."""
    row = np.sort(deviations, axis=None)
    place = share * (row.size - 1)
    low, high = int(np.floor(place)), int(np.ceil(place))
    if not np.isfinite(row[high]):
        return float("nan")
    return float(row[low] + (row[high] - row[low]) * (place - low))


class Measure:
    """Measures settings of one scene; drawings that several hands share are recorded once.

    ``clock``: whether runs may be timed. ``minutes``: a user's own table of minutes.
    """

    def __init__(
        self,
        scales: Pinned,
        references: References,
        *,
        clock: bool = True,
        minutes: Mapping[str, float] | None = None,
    ) -> None:
        self.scales, self.references = scales, references
        self.clock, self.minutes = clock, minutes
        self._drawn: dict[tuple[int, float, float], tuple[Setting, tuple[Project, ...]]] = {}
        self._worked: dict[tuple[int, float, float, str], BoardWork] = {}
        self._calls: dict[tuple[object, ...], Callable[[], object]] = {}
        self._keys: dict[Measurement, tuple[object, ...]] = {}

    def drawings(self, setting: Setting) -> tuple[Project, ...]:
        """Return the logs of a setting."""
        key = id(setting.scene), setting.enlarged, setting.pole
        if key not in self._drawn:
            made = draw(setting.scene, self.scales, setting.enlarged, setting.pole)
            self._drawn[key] = setting, made  # the setting keeps its scene, and so the key, alive
        return self._drawn[key][1]

    def runs(
        self, setting: Setting, axis: str, value: str, only: Sequence[str] | None = None
    ) -> list[Measurement]:
        """Return a run for each quantity of a setting, or ``only`` for some."""
        found = []
        for drawing in self.drawings(setting):
            asked = [q for q in quantities(drawing) if only is None or q.name in only]
            if not asked:
                continue
            who = setting.who
            marks = [mark for quantity in asked for mark in quantity.marks]
            reading = prepare(drawing.construction, marks).run(drawing.given, hand=who)
            for quantity in asked:
                due = self.references.of(quantity, drawing)
                if due is None:
                    continue
                largest = self.references.largest(quantity, drawing)
                errors = off(quantity.read(reading, who.trials), due, largest)
                work = self.work(setting, drawing, quantity)
                place = (axis, value, quantity.name, drawing.count, setting.hand)
                found.append(Measurement(*place, setting.enlarged, who.trials, errors, work))
                if self.clock and axis in dividing() and not (who.slips or who.digits):
                    self._keep(found[-1], setting, drawing, quantity)
        return found

    def work(self, setting: Setting, drawing: Project, quantity: Quantity) -> BoardWork:
        """Return the work at the board that a quantity takes, at all positions of the row."""
        key = id(setting.scene), setting.enlarged, setting.pole, quantity.name
        if key not in self._worked:
            self.drawings(setting)
            self._worked[key] = work_of(drawing, quantity.marks, self.minutes)
        return self._worked[key]

    def _keep(
        self, run: Measurement, setting: Setting, drawing: Project, quantity: Quantity
    ) -> None:
        """Keep a drawing of a quantity by a hand that does not slip to be timed: laws are of it alone."""
        key = id(setting.scene), quantity.name, setting.who.ruler is not None
        self._keys[run] = key
        if key not in self._calls:
            program = prepare(drawing.construction, quantity.marks)
            self._calls[key] = partial(program.run, drawing.given, hand=setting.who)

    def keep(self, watch: Stopwatch) -> None:
        """Have what has run so far timed, in turns with all that is timed later."""
        watch.keep(self._calls)

    def timed(self, runs: Iterable[Measurement], watch: Stopwatch) -> list[Measurement]:
        """Return the runs with their seconds; `keep` them on the watch now and then before."""
        self.keep(watch)
        seconds = watch.kept()
        return [replace(run, seconds=seconds.get(self._keys.get(run))) for run in runs]


def work_of(
    drawing: Project, wanted: Iterable[Mark], minutes: Mapping[str, float] | None = None
) -> BoardWork:
    """Return the work at the board that the wanted marks of a drawing take, at the positions it draws."""
    return count(
        drawing.construction,
        varying(drawing.given),
        wanted,
        positions=drawing.count,
        only={view: max(len(places), 1) for view, places in drawing.rows.items()},
        tried=tried_works(drawing, minutes),
        passes=TRIED,
        minutes=minutes,
    )


def tried_works(
    drawing: Project, minutes: Mapping[str, float] | None = None
) -> dict[Mark, BoardWork]:
    """Return the work of one trial of each refinement of a drawing, by the mark that it leaves."""
    return {
        mark: count(trial.log, [trial.angle], [trial.reading], minutes=minutes)
        for mark, trial in tried(drawing).items()
    }
