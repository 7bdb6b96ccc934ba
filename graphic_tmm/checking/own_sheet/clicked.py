"""A student's own sheet: which plans somebody clicked, his scale factors and turns by them, his scene."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.board import roles
from graphic_tmm.board.hand import EXACT
from graphic_tmm.checking.cells import points
from graphic_tmm.checking.congruence.remade import Remaking
from graphic_tmm.checking.congruence.witnesses import rounded
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SheetError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import view_name

SLIP = 0.5
"""A first vector is laid off, seen or clicked to so much, mm (one standard deviation)."""
LEAST, MOST = 0.004, 0.03
"""A scale factor is known no better, as a share, and no worse."""
DEVIATIONS = 2.2
"""One that is no farther from the scene's, or else from a round one, is that."""
QUARTER = 12.0
"""Degrees: a plan is turned by a quarter if its first vectors are no farther from there."""
SHORTEST = 8.0
"""A shorter first vector tells no scale factor, mm."""


class ClickedPlan(NamedTuple):
    """A plan that somebody clicked: where its pole is, and the end of its first vector (None: not clicked)."""

    plan: str
    position: str
    pole: complex
    first: complex | None = None


class ClickedScale(NamedTuple):
    """A student's own scale factor, SI per mm, beside the scene's; by what his plans may be turned."""

    plan: str
    mu: float
    due: float
    unit: str
    turns: tuple[complex, ...] = (1.0 + 0j,)

    @property
    def another(self) -> bool:
        """Whether it is not the scene's."""
        return self.mu != self.due


def plans_of(given: Iterable[str]) -> tuple[ClickedPlan, ...]:
    """Return the plans that somebody clicked, px of the photograph.

    Raises
    ------
    SheetError
        If one is not written as ``velocities:3=1200,840,1420,610`` or ``velocities:3=1200,840``.
    """
    found = []
    for text in given:
        name, _, places = text.rpartition("=")
        plan, _, position = name.partition(":")
        try:
            at = [float(part) for part in places.split(",")]
        except ValueError:
            at = []
        if not (plan and position and len(at) in (2, 4) and all(map(math.isfinite, at))):
            raise SheetError(
                said(
                    "--plan: write plan, position and where its pole p and the end of its first vector, a, are "
                    'in the photograph, "velocities:3=1200,840,1420,610"; of further ones p alone will do'
                )
            )
        first = complex(*at[2:]) if len(at) > 2 else None
        found.append(ClickedPlan(plan, position, complex(*at[:2]), first))
    return tuple(found)


def plan_text(one: ClickedPlan) -> str:
    """Return a clicked plan as it is written, in whole dots."""
    at = [one.pole] if one.first is None else [one.pole, one.first]
    return f"{one.plan}:{one.position}=" + ",".join(f"{z.real:.0f},{z.imag:.0f}" for z in at)


def own_scales(made: DrawnScene, clicked: Sequence[ClickedPlan]) -> dict[str, ClickedScale]:
    """Return the scale factors that plans were drawn with, by plan; ``clicked``: mm on the sheet.

    All plans of a kind share one: the median of what their first vectors say.
    """
    return {
        plan: _scale(made, plan, clicked) for plan in dict.fromkeys(one.plan for one in clicked)
    }


def _scale(made: DrawnScene, plan: str, clicked: Sequence[ClickedPlan]) -> ClickedScale:
    assert made.mechanism is not None
    scale = made.mechanism.scales[plan]
    due = points(made)
    letter = first_letter(made, plan)
    ratios, firsts = [], []
    for one in clicked:
        at = due.get((plan, letter, one.position))
        if one.plan != plan or one.first is None or not at:
            continue
        if abs(one.first - one.pole) >= SHORTEST:
            firsts.append(one.first - one.pole)
            ratios.append(firsts[-1] / at)
    if not ratios:
        return ClickedScale(plan, scale.value, scale.value, scale.unit)
    times = float(np.median(np.abs(ratios)))
    long = float(np.median([abs(one) for one in firsts])) * len(firsts) ** 0.5
    near = min(max(DEVIATIONS * SLIP / long, LEAST), MOST)
    mu = scale.value if abs(math.log(times)) < near else _rounded(scale.value / times, near)
    return ClickedScale(plan, mu, scale.value, scale.unit, _turns(ratios))


def first_letter(made: DrawnScene, plan: str) -> str:
    """Return the letter of the point with which a plan begins: of what the crank's pin has there.

    It is the first that moves: pivots stand still in the plan of positions.
    """
    assert made.mechanism is not None
    spots: dict[str, set[complex]] = {}
    for (view, letter, _), at in points(made).items():
        if view == plan:
            spots.setdefault(letter, set()).add(at)
    steps = made.mechanism.construction.steps
    known = [letter for step in steps for view, letter in [step.it.key] if view == plan]
    known = [letter for letter in known if letter in spots]
    return next((letter for letter in known if len(spots[letter]) > 1), (*known, "")[0])


def _turns(ratios: Sequence[complex]) -> tuple[complex, ...]:
    """Return by what plans may be turned: not at all, or by a quarter if their first vectors are.

    Half a turn is none: whoever draws a first vector the wrong way round turns no plan.
    """
    way = sum(ratio / abs(ratio) for ratio in ratios)
    for turn in (1j, -1j):
        if abs(np.degrees(np.angle(way / turn))) < QUARTER:
            return (1.0 + 0j, turn)
    return (1.0 + 0j,)


def _rounded(mu: float, near: float) -> float:
    """Return a scale factor as people take it, if there is one so ``near``, as a share."""
    taken = rounded(mu)
    return taken if abs(math.log(mu / taken)) < near else float(f"{mu:.4g}")


def scene_in(made: DrawnScene, scales: Mapping[str, ClickedScale]) -> DrawnScene:
    """Return a scene, drawn exactly, in a student's own scale factors."""
    own = {plan: one.due / one.mu for plan, one in scales.items() if one.another}
    if not own:
        return made
    # what a ruler rounds does not tell to which scale factor it is drawn
    exact = made._replace(boards=tuple(one.drawn_by(EXACT) for one in made.boards))
    remaking = Remaking(exact)
    return remaking.of({remaking.groups[plan, ""]: times for plan, times in own.items()}, {})


def may_be_clicked(made: DrawnScene, plan: str) -> bool:
    """Whether a plan is one of vectors: its pole and the end of its first vector can be clicked."""
    work = made.mechanism
    view = None if work is None else work.construction.view(plan)
    pole = None if view is None else view.pole
    return pole is not None and pole.role in (roles.VELOCITY, roles.ACCELERATION)


TURNED = said("{name}: drawn turned by {turn}°")


def turn_notes(scales: Iterable[ClickedScale], language: str) -> tuple[str, ...]:
    """Return what is said of how clicked plans are turned."""
    speech, told = speaking(language), []
    for one in scales:
        if turn := round(math.degrees(np.angle(one.turns[0]))):
            told.append(speech(TURNED, name=view_name(one.plan, language), turn=turn))
    return tuple(told)
