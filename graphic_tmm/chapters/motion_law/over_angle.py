"""Graphs over the angle of the crank, known at the end of the base, too: ω, ε by subnormals, t by 1/ω."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board import graphs, roles
from graphic_tmm.board.charts import STANDARD, Chart, integrated_scale
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.graphs import Axes, Boundaries
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.graph_curves import graph_of_stretch
from graphic_tmm.board.operations.graphs import following, halve
from graphic_tmm.board.operations.instruments import join, lay_off, measure_along, meet, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length
from graphic_tmm.chapters.flywheel.plan import angle_per_mm
from graphic_tmm.chapters.indicator.plan import Machine
from graphic_tmm.chapters.motion_law import operations as op
from graphic_tmm.chapters.motion_law import words as why
from graphic_tmm.chapters.motion_law.task import (
    ACCELERATION,
    MOMENT,
    SLOWNESS,
    SPEED,
    TIME,
    MotionLawTask,
)


class Both(NamedTuple):
    """What is known at the positions, and at the end of the base."""

    row: Mark
    end: Mark


class OverAngle:
    """The graphs while they are drawn, one after another, on a base that they share."""

    def __init__(self, draft: Draft, machine: Machine, order: MotionLawTask) -> None:
        self.draft, self.machine, self.order = draft, machine, order
        self.charts: list[Chart] = []
        self.causes: list[tuple[Mark, str]] = []
        draft.open(MOMENT)
        length = draft.take(Length, "L", order.base, "mm", roles.BASE)
        mu = angle_per_mm(draft, length, machine.turns)
        self.base = graphs.lay_base(draft, length, mu, machine.count, machine.numbers[None, :])

    @property
    def row(self) -> int:
        """How many positions make the row."""
        return self.base.intervals

    def chart(self, view: str, symbol: str, unit: str, mu: Mark, *read: Mark) -> None:
        """Enter a graph whose scale is chosen by what was read off it."""
        self.charts.append(Chart(view, symbol, unit, mu, read, True, None, None))

    def both(
        self,
        operation: Operation,
        letter: str,
        row: tuple[Mark, ...],
        end: tuple[Mark, ...],
        unit: str = "",
        why: str = "",
    ) -> Both:
        """Draw the same at the positions and at the end of the base."""
        at = self.draft.draw(operation, letter, *row, unit=unit, why=why)
        return Both(at, self.draft.draw(operation, at_end(letter), *end, unit=unit, why=why))

    def laid(self, axes: Axes, heights: Both, letter: str) -> Boundaries:
        """Lay off ordinates at the positions and at the end of the base."""
        feet, along = Both(axes.feet, axes.end), axes.along
        lines = [
            self.draft.draw(
                square, f"({foot.letter})", foot, along, sense=1, why=graphs.ORDINATE_LINE
            )
            for foot in feet
        ]
        names = (letter, at_end(letter))
        found = [
            self.draft.draw(lay_off, name, line, height, why=graphs.ORDINATE)
            for name, line, height in zip(names, lines, heights, strict=True)
        ]
        return Boundaries(*found)

    def read(self, axes: Axes, at: Boundaries, letter: str) -> Both:
        """Measure ordinates, that at the end of the base, too."""
        row, end = (axes.feet, at.points, axes.up), (axes.end, at.end, axes.up)
        return self.both(measure_along, letter, row, end, why=graphs.ORDINATE_READ)

    def speeds(self, omega: Both) -> None:
        """Draw ω over the angle."""
        draft = self.draft
        draft.open(SPEED)
        mu = draft.scale("μ_ω", "(1/s)/mm")
        heights = self.both(to_board, "y_ω", (omega.row, mu), (omega.end, mu))
        self.speed_axes = graphs.draw_axes(draft, SPEED, self.base, mu)
        self.speed = self.laid(self.speed_axes, heights, "w")
        graphs.through(draft, self.speed_axes, self.speed, closed=False)
        self.omega = self.read(self.speed_axes, self.speed, "ω")
        self.chart(SPEED, "ω", "1/s", mu, *self.omega)

    def accelerations(self) -> None:
        """Find ε in the middles of the intervals by the subnormals of the chords of ω."""
        draft, axes = self.draft, self.speed_axes
        draft.open(SPEED)
        after = draft.draw(following, "w+1", *self.speed, row=self.row)
        chord = draft.draw(join, "(w,w+1)", self.speed.points, after, why=graphs.CHORD)
        self.middle = draft.draw(halve, "m_w", self.speed.points, after)
        normal = draft.draw(square, "(n)", self.middle, chord, sense=-1, why=why.NORMAL)
        foot = draft.draw(meet, "n", axes.along, normal, why=why.NORMAL)
        segment = draft.draw(measure_along, "s", axes.middles, foot, axes.along, why=why.SUBNORMAL)
        draft.open(ACCELERATION)
        gain = draft.draw(op.by_subnormal, "ε", segment, axes.mu, self.base.mu, unit="1/s²")
        mu = draft.scale("μ_ε", "(1/s²)/mm")
        self._middles(ACCELERATION, mu, gain, "ε", "1/s²")

    def _middles(self, view: str, mu: Mark, of: Mark, symbol: str, unit: str) -> tuple[Axes, Mark]:
        """Draw a graph of what is known in the middles of the intervals; return its axes and points."""
        draft = self.draft
        height = draft.draw(to_board, f"y_{{{symbol}}}", of, mu)
        axes = graphs.draw_axes(draft, view, self.base, mu)
        line = draft.draw(
            square, "(m)", axes.middles, axes.along, sense=1, why=graphs.ORDINATE_LINE
        )
        points = draft.draw(lay_off, "q", line, height, why=graphs.ORDINATE)
        # what lies outside the first and the last middle is not known
        draft.draw(graph_of_stretch, "(q–q)", points, first=0, last=self.row - 1)
        read = draft.draw(measure_along, symbol, axes.middles, points, axes.up)
        self.chart(view, symbol, unit, mu, read)
        return axes, points

    def times(self) -> None:
        """Integrate 1/ω of the middles: the time since the first position."""
        draft, speed = self.draft, self.speed_axes
        draft.open(SLOWNESS)
        read = draft.draw(measure_along, "ω_m", speed.middles, self.middle, speed.up)
        slow = draft.draw(op.slowness, "1/ω_m", read, speed.mu, unit="s")
        mu = draft.scale("μ_{1/ω}", "s/mm")
        source, high = self._middles(SLOWNESS, mu, slow, "1/ω", "s")
        draft.open(TIME)
        scaled = integrated_scale(draft, "t", "s/mm", mu, self.base.mu, STANDARD)
        axes = graphs.draw_axes(draft, TIME, self.base, scaled.mu)
        pole = graphs.set_pole(draft, source, scaled.distance)
        at = graphs.add_up(draft, source, high, axes, pole, "τ")
        graphs.through(draft, axes, at, closed=False)
        self.time_axes, self.time_points = axes, at
        self.chart(TIME, "t", "s", scaled.mu, *self.read(axes, at, "t"))


def at_end(letter: str) -> str:
    """Return what a mark at the end of the base is called."""
    return f"{letter}_N" if "_" not in letter else f"{letter}N"
