"""How a scene's mechanism moves at any angles of its crank, in SI: as many as are wanted, a million too."""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from typing import cast, get_args

import numpy as np
from numpy.typing import ArrayLike

from graphic_tmm.any_angles.found import Motion
from graphic_tmm.any_angles.recorded import recorded
from graphic_tmm.board.road import translator
from graphic_tmm.board.values import Reals
from graphic_tmm.errors import ConstructionError
from graphic_tmm.language.said import joined, said
from graphic_tmm.moving import Plan, Told
from graphic_tmm.scene.misfits import meant
from graphic_tmm.scene.records import Scene

PLANS: tuple[Plan, ...] = ("positions", "velocities", "accelerations")
"""What motion tells if nobody says."""
ALL: frozenset[Plan] = frozenset(get_args(Plan))
OF_POINTS = frozenset({"places", "velocities", "accelerations"})


def motion(
    scene: Scene,
    angles: ArrayLike,
    points: Collection[str] | None = None,
    *,
    plans: Collection[Plan] = PLANS,
    exact: bool = False,
    fast: bool | None = None,
    threads: int | None = None,
) -> Motion:
    """Draw plans of a scene at angles of its crank and return what they say, in SI.

    The log is recorded at the first call and kept beside the scene; only the steps are run that what is asked
    for needs. Arrays of a call that is compiled lie side by side in one piece of memory, which goes when the
    last of them does.

    Parameters
    ----------
    scene
        A scene with a mechanism. Its scale factors and its hand hold; of a hand that slips, the first
        drawing.
    angles
        Directions of the crank from the x axis, degrees, counter-clockwise positive: a number or a row.
    points
        Letters of the points wanted; None for all.
    plans
        What is wanted, of "positions", "velocities" (with ω), "accelerations" (with ε), and "forces": the
        reactions and what balances the crank, of a scene that has loads. A load by the travel of a slider turns
        at the ends of its travel; one by the angle or by the position is read off its diagram along straight
        lines, gas off the indicator diagram as drawn. They go with the cycle, which begins at the zero
        position; its angles go on to 720° where it takes two turns.
    exact
        Read without the ruler's rounding.
    fast
        Whether the log is compiled (extra ``fast``), to the same numbers within 1e-12; None: where llvmlite is
        installed, at any number of angles. A process' first call for a kind of mechanism takes some hundredths
        of a second more then, less where the code is kept on the disk; every other one takes a tenth, of
        mechanisms of other lengths too. It hangs on nothing that was called before.
    threads
        How many threads a compiled log may use; None: as many as there are. The numbers do not depend on it.

    Raises
    ------
    SceneError
        If the scene has no mechanism.
    StructureError
        If it cannot be drawn, or a load is not known at any angle.
    ConstructionError
        If a point or a plan is unknown, the angles are no row of numbers, or ``fast`` is asked for and cannot
        be had.

    Examples
    --------
    >>> import graphic_tmm
    >>> scene = graphic_tmm.read("sheets/windrower")
    >>> k = graphic_tmm.motion(scene, [0, 90, 180], ["C", "D"])
    >>> k["D"].velocity.shape, k.omega[3].shape
    ((3,), (3,))
    """
    row = _row(angles)
    asked = frozenset(plans if not isinstance(plans, str) else (cast(Plan, plans),))
    if not asked <= ALL:
        says = said(
            "motion: there is no plan {name}; there are {known}",
            name=min(asked - ALL),
            known=", ".join(get_args(Plan)),
        )
        raise ConstructionError(says)
    of = recorded(scene, asked, exact=exact)
    if not asked <= of.plans:
        raise ConstructionError(
            said(
                "motion: the scene asks for no {plan}: write [forces] with what acts, [[load]], [effects]",
                plan=min(asked - of.plans),
            )
        )
    letters = (
        None if points is None else frozenset((points,) if isinstance(points, str) else points)
    )
    ready = of.ready(letters, lambda: _wanted(of.told, letters))
    # a product of the row with itself tells in one pass whether all of it can be turned by
    at = row if math.isfinite(row.dot(row)) else np.where(np.isinf(row), np.nan, row)
    fast = translator() if fast is None else fast
    return Motion(row, *ready.told(at, of.known, fast=fast, threads=threads))


def _row(angles: ArrayLike) -> Reals:
    """Return angles as a row of numbers."""
    try:
        row = np.asarray(angles, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ConstructionError(said("motion: angles are numbers, degrees")) from error
    if row.ndim == 0:
        return row[None]
    if row.ndim != 1:
        raise ConstructionError(
            said("motion: angles are a number or a row, not {shape}", shape=str(row.shape))
        )
    return row


def _wanted(told: Sequence[Told], asked: frozenset[str] | None) -> Sequence[Told]:
    """Return the rows that are wanted: of points only those asked for."""
    if asked is None:
        return told
    known = dict.fromkeys(_letter(row) for row in told if row.quantity in OF_POINTS)
    if known and (unknown := sorted(asked - known.keys())):
        says = said(
            "motion: no link has a point {listed}; there are {known}",
            listed=", ".join(unknown),
            known=", ".join(known),
        )
        like = meant(unknown[0], known)
        raise ConstructionError(joined("; ", (says, like)) if like else says)
    return [row for row in told if row.quantity not in OF_POINTS or _letter(row) in asked]


def _letter(row: Told) -> str:
    assert isinstance(row.key, tuple)
    return row.key[0]
