"""The axes of a pair and the shifts: both shifts give the distance, or the distance the one that is missing."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.formulas import pitch_radius
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.gears import formulas as g
from graphic_tmm.chapters.gears import ring as inside
from graphic_tmm.chapters.gears.helical import ACROSS, LOWER, Helix
from graphic_tmm.chapters.gears.task import GearTask


class Section(NamedTuple):
    """The basic rack in a section: m (m), α (Angle), h_a of both wheels and c (Number)."""

    m: Mark
    alpha: Mark
    ha: tuple[Mark, Mark]
    c: Mark


class Axes(NamedTuple):
    """Teeth, shifts and pitch radii of both wheels, the distances, the angle of mesh.

    ``x``: of the normal section, ``x_drawn`` of that which is drawn; ``x_sum``: of ``x``. With a rack one wheel
    has them, and ``a_w`` is the distance of the datum line from its axis.
    """

    z: tuple[Mark, ...]
    x: tuple[Mark, ...]
    x_drawn: tuple[Mark, ...]
    r: tuple[Mark, ...]
    a: Mark | None
    a_w: Mark
    inv: Mark
    inv_w: Mark
    alpha_w: Mark
    x_sum: Mark | None


def letter_of(order: GearTask, letter: str, wheel: int = 0) -> str:
    """Return the letter of a size, of a wheel if it has one; of a helical pair it tells the section."""
    found = letter if order.beta is None else ACROSS.get(letter, letter)
    if not wheel:
        return found
    return f"{found[:-1]}{wheel}}}" if found.endswith("}") else f"{found}_{wheel}"


def calculate_axes(
    draft: Draft, order: GearTask, normal: Section, drawn: Section, helix: Helix | None
) -> Axes:
    """Calculate the distance of the axes by the shifts, or the shifts by the distance."""
    z1, z2 = (draft.take(Number, f"z_{i}", float(n)) for i, n in enumerate(order.teeth, 1))
    x_sum = None
    if order.distance is None:
        x, x_sum = _shifts(draft, order, None)
        across = drawn_shifts(draft, helix, x)
    r1, r2 = (
        draft.draw(pitch_radius, f"r_{i}", drawn.m, z, unit="m") for i, z in ((1, z1), (2, z2))
    )
    inv = draft.draw(g.involute, letter_of(order, "inv α"), drawn.alpha)
    inv_w_, alpha_w_ = letter_of(order, "inv α_{w}"), letter_of(order, "α_{w}")
    between = (inside.less, "a", r2, r1) if order.internal else (added, "a", r1, r2)
    if order.distance is not None:
        a = draft.draw(*between, unit="m")
        a_w = draft.take(Number, "a_{w}", order.distance, "m")
        alpha_w = draft.draw(g.angle_of_distance, alpha_w_, a, drawn.alpha, a_w)
        inv_w = draft.draw(g.involute, inv_w_, alpha_w)
        z = (inside.less, "z_{Σ}", z2, z1) if order.internal else (added, "z_{Σ}", z1, z2)
        angles = (inv_w, inv, normal.alpha, draft.draw(*z))
        x_sum = draft.draw(g.sum_of_shifts, "x_{Σ}", *angles)
        x, _ = _shifts(draft, order, x_sum)
        across = drawn_shifts(draft, helix, x)
    else:
        op = inside.working_involute_inside if order.internal else g.working_involute
        inv_w = draft.draw(op, inv_w_, *across, drawn.alpha, z1, z2)
        alpha_w = draft.draw(g.angle_of_involute, alpha_w_, inv_w)
        a = draft.draw(*between, unit="m")
        a_w = draft.draw(g.working_distance, "a_{w}", a, drawn.alpha, alpha_w, unit="m")
    return Axes((z1, z2), x, across, (r1, r2), a, a_w, inv, inv_w, alpha_w, x_sum)


def _shifts(
    draft: Draft, order: GearTask, whole: Mark | None
) -> tuple[tuple[Mark, Mark], Mark | None]:
    """Take the shifts of both wheels; the one that is missing follows from the sum, if that is known."""
    names = (letter_of(order, "x", 1), letter_of(order, "x", 2))
    if whole is None and order.x_sum is not None:
        whole = draft.take(Number, "x_{Σ}", order.x_sum)
    if whole is None or (order.x1 is not None and order.x2 is not None):
        one = draft.take(Number, names[0], order.x1 or 0.0)
        return (one, draft.take(Number, names[1], order.x2 or 0.0)), whole
    if order.x2 is None:
        one = draft.take(Number, names[0], order.x1 or 0.0)
        op, marks = (added, (whole, one)) if order.internal else (inside.less, (whole, one))
        return (one, draft.draw(op, names[1], *marks)), whole
    other = draft.take(Number, names[1], order.x2)
    marks = (other, whole) if order.internal else (whole, other)
    return (draft.draw(inside.less, names[0], *marks), other), whole


def drawn_shifts(draft: Draft, helix: Helix | None, x: tuple[Mark, ...]) -> tuple[Mark, ...]:
    """Return the shifts in the section that is drawn."""
    if helix is None:
        return x
    return tuple(
        draft.draw(g.times_cosine, f"x_{{t{i}}}", shift, helix.beta, why=LOWER)
        for i, shift in enumerate(x, 1)
    )
