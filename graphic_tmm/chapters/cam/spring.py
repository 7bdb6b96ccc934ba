"""The spring of a follower: its line over the inertia force, the force of contact, the moment on the camshaft.

The inertia force P = −m·a (of a lever the moment −J·ε) lifts the follower where it is braked on the rise and
sped up on the return. Over the displacement S the wanted force, P times the reserve less what presses besides,
must stay below the line of the spring F = F_0 + c·S: from the pole on the axis, as far before S = 0 as the
spring is compressed there, the steepest ray to the curve is that line, so one tangent gives c and F_0. The
normal of the contact carries what is left, F − P; its arm about the cam's centre gives the moment on the shaft.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure_along,
    meet,
    parallel,
    ray,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Point
from graphic_tmm.chapters.cam import formulas_spring as f
from graphic_tmm.chapters.cam import words_spring as why
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.kinds_spring import SpringTask
from graphic_tmm.chapters.cam.operations import smooth_stretch, steeper_of_two, steepest_ray
from graphic_tmm.chapters.cam.profile import VIEW as PROFILE
from graphic_tmm.chapters.cam.profile import Profile
from graphic_tmm.chapters.cam.task import CamTask
from graphic_tmm.chapters.cam.turn import TurnDiagram, draw_values

VIEW = "cam spring"
INERTIA, CONTACT, MOMENT = "cam inertia", "cam contact force", "cam moment"
ROOM = 80.0
"""Room for the largest force on the line of the spring, mm: twice that of a diagram, for its rate is read."""


class Contact(NamedTuple):
    """How a follower touches its cam: the profile, and what there is of pressure angle, lever, place on a face.

    ``lever`` (Length): of the roller; ``distance`` (Length): of the contact on the face of a lever.
    """

    profile: Profile
    pressure: Mark | None = None
    lever: Mark | None = None
    distance: Mark | None = None


@dataclass(frozen=True)
class Spring:
    """The spring as drawn: its chart, F_0 and c (Number), points wanted by stretch with their curves.

    ``line``: of the spring, from ``pole`` where it was sought, through ``ends`` over S = 0 and the stroke;
    ``force`` of it, and by stretch what it has over the wanted one ``left`` (Number).
    """

    chart: Chart
    preload: Mark
    rate: Mark
    points: tuple[Mark, ...]
    curves: tuple[Mark, ...]
    pole: Mark | None
    line: Mark
    ends: tuple[Mark, Mark]
    force: Mark
    left: tuple[Mark, ...]
    inertia: TurnDiagram
    contact: TurnDiagram
    moment: TurnDiagram

    @property
    def diagrams(self) -> tuple[TurnDiagram, ...]:
        """Those over the turn: inertia, contact, moment."""
        return (self.inertia, self.contact, self.moment)

    @property
    def charts(self) -> tuple[Chart, ...]:
        """The charts of its line and of the diagrams over the turn."""
        return (self.chart, *(diagram.chart for diagram in self.diagrams))


def draw_spring(
    draft: Draft, order: CamTask, of: SpringTask, diagrams: Diagrams, on: Contact, sense: int
) -> Spring:
    """Draw the inertia force, the line of the spring, the force of contact and the moment over the turn."""
    unit = "N·m" if order.rocks else "N"
    draft.open(INERTIA)
    mass = draft.take(
        Number, "J_B" if order.rocks else "m_B", of.inertia, "kg·m²" if order.rocks else "kg"
    )
    omega = draft.take(Number, "ω_1", order.speed, "1/s")
    forces = [
        draft.draw(f.follower_inertia, "P", mass, omega, second, unit=unit)
        for second in diagrams.A.readings
    ]
    inertia = draw_values(draft, diagrams, INERTIA, "P", unit, forces, sought=())
    load = draft.take(Number, "Q", of.load, unit) if of.load else None
    draft.open(VIEW)
    mu = draft.scale("μ_F", f"{unit}/mm")
    draft.lay_out()
    axes = _Axes(draft, diagrams)
    reserve = draft.take(Number, "k", of.reserve)
    wanted = []
    for force in forces:
        need = draft.draw(f.with_reserve, "P_k", reserve, force, unit=unit)
        wanted.append(
            need if load is None else draft.draw(f.less_load, "P_Q", need, load, unit=unit)
        )
    heights, points, curves = axes.curves(wanted)
    found = _given if of.rate is not None else _sought
    preload, rate, pole, line, ends, over = found(draft, of, diagrams, axes, curves, unit)
    chart = Chart(VIEW, "F", unit, mu, (*heights, *over), True, None, ROOM)
    force = draft.draw(f.follower_spring, "F", preload, rate, diagrams.S.reading, unit=unit)
    left = [draft.draw(f.over_wanted, "ΔF", force, need, unit=unit) for need in wanted]
    pressing = force if load is None else draft.draw(f.pressed, "F_Q", force, load, unit=unit)
    closing = [draft.draw(f.closing, "R", pressing, lifted, unit=unit) for lifted in forces]
    rest, *normal = (_normal(draft, on, one) for one in (pressing, *closing))
    contact = draw_values(draft, diagrams, CONTACT, "N", "N", normal, rest)
    draft.open(PROFILE)
    across = draft.draw(square, "(h)", on.profile.centre, on.profile.normals, sense=sense)
    reach = (on.profile.theoretical or on.profile.working).points
    arm = draft.draw(measure_along, "h", on.profile.centre, reach, across, why=why.ARM)
    moments = [draft.draw(f.shaft_moment, "M", one, arm, unit="N·m") for one in normal]
    moment = draw_values(draft, diagrams, MOMENT, "M", "N·m", moments)
    return Spring(
        chart, preload, rate, points, curves, pole, line, ends, force, tuple(left),
        inertia, contact, moment,
    )  # fmt: skip


class _Axes:
    """Displacement across, force up: the axes of the spring's diagram."""

    def __init__(self, draft: Draft, diagrams: Diagrams) -> None:
        self.draft, self.diagrams = draft, diagrams
        self.origin = draft.take(Point, "O", 0j)
        self.along = draft.draw(ray, "(S)", self.origin, draft.direction(0.0))
        self.up = draft.draw(square, "(F)", self.origin, self.along, sense=1)
        self.feet = draft.draw(lay_off, "S", self.along, diagrams.S.reading)
        self.lines = draft.draw(square, "(i)", self.feet, self.along, sense=1)
        width = draft.draw(to_board, "h_S", diagrams.stroke, diagrams.S.chart.mu)
        self.far = draft.draw(lay_off, "H", self.along, width)
        self.over = draft.draw(square, "(H)", self.far, self.along, sense=1)

    def curves(self, wanted: list[Mark]) -> tuple[list[Mark], tuple[Mark, ...], tuple[Mark, ...]]:
        """Mark the wanted forces of every stretch over S, and draw their curves; return their heights, too."""
        heights, points, curves = [], [], []
        for need, (_, first, last) in zip(wanted, self.diagrams.stretches, strict=True):
            heights.append(self.draft.draw(to_board, "y", need))
            points.append(
                self.draft.draw(lay_off, "P", self.lines, heights[-1], free=True, why=why.WANTED)
            )
            letter = f"({points[-1].letter}–{points[-1].letter})"
            curves.append(
                self.draft.draw(smooth_stretch, letter, points[-1], first=first, last=last)
            )
        return heights, tuple(points), tuple(curves)


_Line = tuple[Mark, Mark, Mark | None, Mark, tuple[Mark, Mark], list[Mark]]
"""F_0, c, the pole if there is one, the line and its ends, how high these stand (Length)."""


def _given(
    draft: Draft,
    of: SpringTask,
    diagrams: Diagrams,
    axes: _Axes,
    curves: tuple[Mark, ...],
    unit: str,
) -> _Line:
    """Lay off the line of a spring that is given."""
    preload = draft.take(Number, "F_0", of.preload, unit)
    rate = draft.take(Number, "c", of.rate, _rate_unit(unit))
    most = draft.draw(f.greatest_force, "F_h", preload, rate, diagrams.stroke, unit=unit)
    heights = [
        draft.draw(to_board, "y_0", preload),
        draft.draw(to_board, "y_h", most),
    ]
    ends = (
        draft.draw(lay_off, "A_0", axes.up, heights[0]),
        draft.draw(lay_off, "A_h", axes.over, heights[1]),
    )
    return preload, rate, None, draft.draw(join, "(c)", *ends), ends, heights


def _sought(
    draft: Draft,
    of: SpringTask,
    diagrams: Diagrams,
    axes: _Axes,
    curves: tuple[Mark, ...],
    unit: str,
) -> _Line:
    """Draw the steepest ray from the pole to the wanted forces; read F_0 and c off it."""
    lead = diagrams.stroke
    if of.lead is not None:
        lead = draft.take(Number, "S_0", of.lead, diagrams.stroke.unit)
    back = draft.draw(parallel, "(S_0)", axes.origin, axes.along, sense=-1)
    length = draft.draw(to_board, "OK", lead, diagrams.S.chart.mu)
    pole = draft.draw(lay_off, "K", back, length, why=why.POLE)
    line, *others = [draft.draw(steepest_ray, "(t)", pole, curve) for curve in curves]
    for other in others:
        line = draft.draw(steeper_of_two, "(c)", line, other, why=why.SPRING_LINE)
    ends, heights, sizes = [], [], []
    for index, over, foot in (("0", axes.up, axes.origin), ("h", axes.over, axes.far)):
        ends.append(draft.draw(meet, f"A_{index}", over, line))
        heights.append(draft.draw(measure_along, f"y_{index}", foot, ends[-1], over))
        force = draft.draw(in_si, f"A_{index}", heights[-1], unit=unit, free=True)
        sizes.append(draft.draw(f.pushing, f"F_{index}", force, unit=unit))
    rate = draft.draw(f.rate_of_spring, "c", *sizes[::-1], diagrams.stroke, unit=_rate_unit(unit))
    return sizes[0], rate, pole, line, (ends[0], ends[1]), heights


def _rate_unit(unit: str) -> str:
    return "N/m" if unit == "N" else "N·m/rad"


def _normal(draft: Draft, on: Contact, force: Mark) -> Mark:
    """Calculate the force of contact from what closes the pair along the follower's way, or about its pivot."""
    if on.distance is not None:
        return draft.draw(f.on_face, "N", force, on.distance, unit="N")
    if on.pressure is None:
        return draft.draw(f.along_rod, "N", force, unit="N")
    if on.lever is not None:
        return draft.draw(f.by_roller_lever, "N", force, on.lever, on.pressure, unit="N")
    return draft.draw(f.by_pressure_angle, "N", force, on.pressure, unit="N")
