"""How a scene's mechanism moves at any angles of its crank, in SI: as many as are wanted, a million too."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence
from functools import partial
from typing import Any, get_args

import numpy as np
from numpy.typing import ArrayLike

from graphic_tmm.any_angles.found import Motion, NotAsked
from graphic_tmm.any_angles.recorded import recorded
from graphic_tmm.any_angles.turn import PLAN_OF, Plan, Told
from graphic_tmm.board.execute import translator
from graphic_tmm.board.values import Reals
from graphic_tmm.errors import ConstructionError
from graphic_tmm.language.said import joined, said
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
    plans: Plan | Collection[Plan] = PLANS,
    exact: bool = False,
    fast: bool | None = None,
    threads: int | None = None,
) -> Motion:
    """Draw plans of a scene at angles of its crank and return what they say, in SI; see `face.motion`.

    Raises
    ------
    SceneError
        If the scene has no mechanism.
    StructureError
        If it cannot be drawn, or a load is not known at any angle.
    ConstructionError
        If a point or a plan is unknown, the angles are no row of numbers, or ``fast`` is asked for and cannot
        be had.
    """
    row = _row(angles)
    asked: frozenset[Plan] = frozenset((plans,) if isinstance(plans, str) else plans)
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
    told = ready.told(at, of.known, fast=fast, threads=threads)
    return Motion(row, *map(partial(_unless, asked), PLAN_OF.values(), told))


def _unless(asked: frozenset[Plan], plan: Plan, told: dict[Any, Any]) -> Mapping[Any, Any]:
    return told if plan in asked else NotAsked(plan)


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
