"""How a scene's mechanism moves at any angles of its crank, in SI: as many as are wanted, a million too."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import prepare
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Angle, Complexes, Reals
from graphic_tmm.chapters.kinematics.accelerations import draw_accelerations
from graphic_tmm.chapters.kinematics.motion import Motion
from graphic_tmm.chapters.kinematics.plan import ACCELERATIONS, PLANS, POSITIONS, VELOCITIES
from graphic_tmm.chapters.kinematics.positions import (
    draw_frame,
    draw_positions,
    side_record,
    side_values,
)
from graphic_tmm.chapters.kinematics.velocities import draw_velocities
from graphic_tmm.drawn import doubted, hand_of
from graphic_tmm.errors import ConstructionError
from graphic_tmm.fitting.scales import Fitting, reach_of
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.paper.formats import FORMATS, USUAL
from graphic_tmm.project import record as recorded
from graphic_tmm.scene.records import Scene, SheetOrder

SIZES = {POSITIONS: FORMATS[USUAL].room, VELOCITIES: 80.0, ACCELERATIONS: 80.0}
"""Usual sizes."""


@dataclass(frozen=True)
class Kinematics:
    """The motion at the angles asked for (degrees); each array runs along them, NaN where nothing assembles.

    ``places`` (m), ``velocities`` (m/s), ``accelerations`` (m/s²): of each (letter, link), x + iy in the
    frame's axes. ``omega`` (rad/s), ``epsilon`` (rad/s²): of each link that can turn, counter-clockwise
    positive. What does not vary has one number.
    """

    angles: Reals
    places: Mapping[tuple[str, int], Complexes]
    velocities: Mapping[tuple[str, int], Complexes]
    accelerations: Mapping[tuple[str, int], Complexes]
    omega: Mapping[int, Reals]
    epsilon: Mapping[int, Reals]


def motion(
    scene: Scene,
    angles: ArrayLike,
    points: Collection[str] | None = None,
    *,
    exact: bool = False,
    fast: bool = False,
) -> Kinematics:
    """Draw the three plans of a scene at angles of its crank, degrees, and return what they say in SI.

    Parameters
    ----------
    scene
        A scene with a mechanism. Its scale factors and its hand hold; of a hand that slips, the first
        drawing.
    angles
        Directions of the crank from the x axis, counter-clockwise positive.
    points
        Letters of the points wanted; None for all.
    exact
        Read without the ruler's rounding.
    fast
        Compile the log with numba (extra ``fast``): a few seconds once a mechanism, then several times
        as fast; the same numbers to 1e-12. Pays from some ten million positions, or in long series.

    Raises
    ------
    SceneError
        If the scene has no mechanism.
    StructureError
        If it cannot be drawn.
    ConstructionError
        If a point is unknown, or ``fast`` is asked for without numba.
    """
    plain = _plain(scene)
    project = recorded(plain)
    # read exactly, the same comes out to any scale: then nobody asks what sets it
    doubts = Doubts((), {}) if exact else doubted(project)
    fitting = Fitting(project, SIZES, reach_of(project, doubts))
    mu = [fitting.plan_scales()[plan].value for plan in PLANS]
    row = np.atleast_1d(np.asarray(angles, dtype=np.float64))
    drawn = _drawn(scene, row, mu)
    names = [name for name in drawn.marks[0] if points is None or name[0] in points]
    if points is not None and (unknown := set(points) - {letter for letter, _ in names}):
        listed = ", ".join(sorted(unknown))
        raise ConstructionError(said("motion: no link has a point {listed}", listed=listed))
    rates = [drawn.motions[0].rates, drawn.motions[1].rates]
    wanted = [plan[name] for plan in drawn.marks for name in names]
    wanted += [mark for plan in rates for mark in plan.values()]
    program = prepare(drawn.log, wanted)
    hand = EXACT if exact else hand_of(scene)
    reading = (program.compiled() if fast else program).run(drawn.given, hand=hand)
    places, speeds, gains = (
        {name: reading[plan[name]][0] * unit for name in names}
        for plan, unit in zip(drawn.marks, mu, strict=True)
    )
    places = {name: place + drawn.origin for name, place in places.items()}
    omega, epsilon = ({n: reading[mark][0] for n, mark in plan.items()} for plan in rates)
    return Kinematics(row, places, speeds, gains, omega, epsilon)


class _Drawn(NamedTuple):
    """Three plans over free angles: the log, what is given, where the pivot stands, marks by (letter, link)."""

    log: Construction
    given: dict[Mark, Any]
    origin: complex
    marks: tuple[dict[tuple[str, int], Mark], ...]
    motions: tuple[Motion, Motion]


def _plain(scene: Scene) -> Scene:
    """Return a scene of three plans only, with an acceleration plan somewhere: for its scale factors."""
    form = scene.sheets[0].format if scene.sheets else USUAL
    row = scene.row
    if not row.accelerations:
        numbers = range(row.first, row.first + row.count)
        row = replace(row, accelerations=tuple(map(str, numbers)))
    sheets = (SheetOrder(form, PLANS),)
    return replace(scene, row=row, sheets=sheets, trajectories=(), tasks={})


def _drawn(scene: Scene, row: Reals, mu: Sequence[float]) -> _Drawn:
    mechanism = scene.mechanism
    assert mechanism is not None
    structure = dissect(mechanism)
    draft = Draft()
    frame = draw_frame(draft, mechanism, structure)
    phi = draft.ask(Angle, "φ", "°")
    positions = draw_positions(draft, mechanism, structure, frame, phi)
    speeds = draw_velocities(draft, mechanism, structure, positions, turned=False)
    gains = draw_accelerations(draft, mechanism, structure, positions, speeds)
    given: dict[Mark, Any] = {**draft.given, phi: row[None, :]}
    given |= dict(zip((draft.mu_l, speeds.mu, gains.mu), mu, strict=True))
    for group in structure.groups:
        side = side_record(mechanism, group)
        if group.name in positions.sides and side is not None:
            given[positions.sides[group.name]] = side_values(side, row[None, :])
    bodies = positions.bodies
    names = [(letter, n) for n, body in bodies.items() for letter in body.link.points]
    marks = (
        {(letter, n): bodies[n].marks[letter] for letter, n in names},
        *(
            {(letter, n): plan.images.by_letter[n][letter] for letter, n in names}
            for plan in (speeds, gains)
        ),
    )
    origin = mechanism.frame.points[structure.pivot]
    return _Drawn(draft.board.construction(), given, origin, marks, (speeds, gains))
