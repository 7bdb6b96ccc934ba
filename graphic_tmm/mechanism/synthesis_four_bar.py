"""A crank-rocker found from its rocker's swing and length and K_v: O on circles that see a chord under θ.

Both extreme places of B and the angle θ between the dead centres fix two circles on which the crank's pivot may
stand, one on each side of the chord. On one of them is a freedom: the distance of the pivots, or the least
angle of transmission. Not every place does: the crank has to turn all round, and both dead centres have to be
of one assembly.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import swing_angle
from graphic_tmm.board.operations.locus import narrow, refinement
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number, Reals
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism import synthesis_formulas as f
from graphic_tmm.mechanism.synthesis_kinds import Given, Lengths, ratio_of, theta_of

SIDES = (1, -1)
"""Of the chord on which a circle bulges: away from C, towards it."""
TRIED = 1500
"""So many places of O on a locus are tried: for the limit that a refusal tells, and for a transmission."""
SPREAD = TRIED // 20
"""A frame that is looked for by its transmission stands within so many of these places on both sides."""
COARSE = 400
"""So many at each try for the greatest K_v."""
ABOUT = 1e-6
"""A locus is about C itself, as where θ = ψ/2, if its centre is nearer to C than this share of the rocker."""
HALVINGS = 14
"""So often the angle θ is halved in which the limit of K_v is sought: to a hundredth of a degree."""


class FourBar(NamedTuple):
    """A crank-rocker that does what is asked, lengths in m.

    ``pivot``: where O stands from C, the chord level above C; ``side``: of the chord on which the locus
    of O bulges, 1 away from C. ``least``: the least angle of transmission, degrees. ``centre``: of the
    locus, how far over C; ``sense``: 1 where B lies to the left of the way from O to C. ``between``: the
    frames between which this one was looked for by its transmission; with a locus ``about`` C itself, on which
    all frames are alike, the angles of CO from the axis of the chord, degrees.
    """

    side: int
    frame: float
    pivot: complex
    crank: float
    coupler: float
    rocker: float
    least: float
    centre: float
    sense: int
    between: tuple[float, float] | None = None
    about: bool = False

    @property
    def angle(self) -> float:
        """The angle of CO from the axis of the chord, degrees."""
        return math.degrees(math.atan2(-self.pivot.real, self.pivot.imag))


def four_bar_at(
    side: int, half: float, height: float, theta: float, frame: float
) -> FourBar | None:
    """Return the crank-rocker with O on one of both circles, so far from C; None if there is none.

    ``half`` of the chord, its ``height`` over C (m), ``theta`` in degrees.
    """
    centre = height + side * half / math.tan(math.radians(theta))
    if is_about(centre, half, height):
        return None
    along = (frame**2 + height**2 - half**2 + 2.0 * height * (centre - height)) / (2.0 * centre)
    if abs(along) >= frame:
        return None
    return _checked(side, complex(-math.sqrt(frame**2 - along**2), along), half, height)


def is_about(centre: float, half: float, height: float) -> bool:
    """Return whether a locus, its centre so far over C, is about C itself."""
    return abs(centre) <= ABOUT * math.hypot(half, height)


def _checked(side: int, at: complex, half: float, height: float) -> FourBar | None:
    """Return what a place of O makes, if its crank turns all round and both dead centres are one assembly."""
    if not side * (at.imag - height) > 0.0:
        return None  # the other arc of the circle: the chord is seen under 180° − θ
    ends = complex(-half, height), complex(half, height)
    near, far = sorted(abs(end - at) for end in ends)
    crank, coupler = (far - near) / 2.0, (far + near) / 2.0
    frame, rocker = abs(at), abs(ends[0])
    turns = [((end - at) * np.conj(-at)).imag for end in ends]
    shortest, *_, longest = sorted((crank, coupler, frame, rocker))
    whole = shortest + longest < (crank + coupler + frame + rocker) / 2.0
    if not (crank > 0.0 and crank == shortest and whole and turns[0] * turns[1] > 0.0):
        return None
    least = least_transmission(crank, coupler, rocker, frame)
    centre, sense = _centre(at, ends).imag, 1 if turns[0] > 0.0 else -1
    about = is_about(centre, half, height)
    return FourBar(side, frame, at, crank, coupler, rocker, least, centre, sense, about=about)


def least_transmission(crank: float, coupler: float, rocker: float, frame: float) -> float:
    """Return the least angle of transmission, degrees: where crank and frame lie in one line."""
    angles = []
    for apart in (frame - crank, frame + crank):
        cosine = (coupler**2 + rocker**2 - apart**2) / (2.0 * coupler * rocker)
        angle = math.degrees(math.acos(max(-1.0, min(1.0, cosine))))
        angles.append(min(angle, 180.0 - angle))
    return min(angles)


def sizes_of_chord(given: Given) -> tuple[float, float, float]:
    """Return half the chord of B, its height over C (m) and θ (degrees)."""
    swing = math.radians(given["psi"]) / 2.0
    rocker, theta = given["BC"], theta_of(given["K_v"])
    return rocker * math.sin(swing), rocker * math.cos(swing), theta


def on_locus(given: Given, tried: int = TRIED) -> Iterator[list[FourBar | None]]:
    """Yield what O makes along each of both circles, place by place; None where it makes no crank-rocker."""
    half, height, theta = sizes_of_chord(given)
    radius = half / math.sin(math.radians(theta))
    for side in SIDES:
        centre = height + side * half / math.tan(math.radians(theta))
        spots = (
            complex(0.0, centre) + radius * complex(-math.sin(turn), side * math.cos(turn))
            for turn in np.linspace(0.0, math.pi - math.radians(theta), tried)
        )
        yield [_checked(side, at, half, height) for at in spots]


def choose_four_bar(given: Given) -> FourBar:
    """Return the crank-rocker of a task: of several the one with the better transmission.

    Raises
    ------
    StructureError
        If there is none; the message tells between which distances of the pivots there are some, or the best
        transmission.
    """
    if "OC" in given:
        half, height, theta = sizes_of_chord(given)
        back = height - half / math.tan(math.radians(theta))
        if is_about(back, half, height) and is_about(given["OC"] - given["BC"], half, height):
            says = said(
                "where θ is half of ψ, O may stand anywhere on a circle about C, and OC = BC chooses no place "
                'on it: give transmission = "20 deg" instead of OC'
            )
            raise StructureError(says, "task.OC", head="task")
        several = [four_bar_at(side, half, height, theta, given["OC"]) for side in SIDES]
        fit = [one for one in several if one is not None]
        if fit:
            return max(fit, key=lambda one: one.least)
        raise _no_frame(given)
    return _by_transmission(given)


def _no_frame(given: Given) -> StructureError:
    places = list(on_locus(given))
    about = any(one is not None and one.about for row in places for one in row)
    rows = [[None if one is None or one.about else one.frame for one in row] for row in places]
    merged: list[tuple[float, float]] = []
    for low, high in sorted(run for row in rows for run in _runs(row)):
        if merged and low <= merged[-1][1] * (1.0 + 1.0 / TRIED):
            merged[-1] = merged[-1][0], max(high, merged[-1][1])
        else:
            merged.append((low, high))
    if not merged and about:
        says = said(
            "where θ is half of ψ, a crank-rocker has OC = BC, which chooses no place of O on its circle: give "
            'transmission = "20 deg" instead of OC'
        )
        return StructureError(says, "task.OC", head="task")
    if not merged:
        return _no_crank_rocker(given)
    says = said(
        "no crank-rocker has this ψ and this K_v with the pivots so far apart; with OC = {listed} mm one has",
        listed=", ".join(f"{1000.0 * low:.4g}…{1000.0 * high:.4g}" for low, high in merged),
    )
    return StructureError(says, "task.OC", head="task")


def _no_crank_rocker(given: Given) -> StructureError:
    """Return the refusal of a K_v that no crank-rocker has, with the greatest that one has at this swing."""
    low, high = 0.0, theta_of(given["K_v"])
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        there = on_locus({**given, "K_v": ratio_of(middle)}, COARSE)
        low, high = (middle, high) if any(map(any, there)) else (low, middle)
    says = said(
        "no crank-rocker has this ψ and this K_v; with this ψ one has while K_v is less than {K:.5g}",
        K=math.floor(1e3 * ratio_of(low)) / 1e3,
    )
    return StructureError(says, "task.K_v", head="task")


def _runs(row: Sequence[float | None]) -> Iterator[tuple[float, float]]:
    """Yield the least and the greatest of each stretch of a row."""
    some: list[float] = []
    for one in (*row, None):
        if one is not None:
            some.append(one)
        elif some:
            yield min(some), max(some)
            some = []


@dataclass(frozen=True)
class TransmissionOf:
    """How far the least angle of transmission is above what is wanted, of frames (m) with O on a circle."""

    side: int
    half: float
    height: float
    theta: float
    wanted: float

    def __call__(self, frame: Reals) -> Reals:
        """Return that of each frame, degrees."""
        centre = self.height + self.side * self.half / math.tan(math.radians(self.theta))
        square = frame**2 + self.height**2 - self.half**2
        along = (square + 2.0 * self.height * (centre - self.height)) / (2.0 * centre)
        off = np.sqrt(np.maximum(frame**2 - along**2, 0.0))
        return _least_of(frame, off, along, self.half, self.height) - self.wanted


@dataclass(frozen=True)
class TransmissionAbout:
    """How far the least angle of transmission is above what is wanted, of angles of CO on a circle about C."""

    half: float
    height: float
    wanted: float

    def __call__(self, angle: Reals) -> Reals:
        """Return that of each angle (degrees), degrees."""
        frame, turn = math.hypot(self.half, self.height), np.radians(angle)
        off, along = frame * np.sin(turn), frame * np.cos(turn)
        return (
            _least_of(np.full_like(turn, frame), off, along, self.half, self.height) - self.wanted
        )


def _least_of(frame: Reals, off: Reals, along: Reals, half: float, height: float) -> Reals:
    """Return the least angles of transmission, degrees: O ``along`` the axis of the chord and ``off`` it."""
    far, near = (np.hypot(off + side * half, along - height) for side in SIDES)
    crank, coupler = (far - near) / 2.0, (far + near) / 2.0
    rocker = math.hypot(half, height)
    angles = []
    for apart in (frame - crank, frame + crank):
        cosine = (coupler**2 + rocker**2 - apart**2) / (2.0 * coupler * rocker)
        angle = np.degrees(np.arccos(np.clip(cosine, -1.0, 1.0)))
        angles += [angle, 180.0 - angle]
    return np.asarray(np.min(angles, axis=0))


TRY_FRAMES = said(
    "Try distances of the pivots between {low} and {high}, each time narrowing to where the least angle of "
    "transmission is what is wanted; this is {it}."
)
TRY_PLACES = said(
    "The circle on which O stands is about C. Try angles of CO from the axis of the chord between {low} and "
    "{high}, each time narrowing to where the least angle of transmission is what is wanted; this is {it}."
)


def _by_transmission(given: Given) -> FourBar:
    """Return the crank-rocker with the shortest frame whose least angle of transmission is what is asked."""
    wanted, fit, best = given["transmission"], list[FourBar](), 0.0
    chord = sizes_of_chord(given)
    for side, row in zip(SIDES, on_locus(given), strict=True):
        best = max([best, *(one.least for one in row if one is not None)])
        for k, (one, other) in enumerate(pairwise(row)):
            if one is None or other is None or (one.least < wanted) == (other.least < wanted):
                continue
            ends = _farther(row, k, -1, wanted), _farther(row, k + 1, 1, wanted)
            if one.about:
                low, high = sorted(end.angle for end in ends)
                made = _at_angle(side, low, high, wanted, chord)
            else:
                low, high = sorted(end.frame for end in ends)
                tried = TransmissionOf(side, *chord, wanted)
                made = four_bar_at(side, *chord, _narrowed(tried, low, high))
            if made is not None:
                fit.append(made._replace(between=(low, high)))
    if fit:
        return min(fit, key=lambda one: one.frame)
    if best == 0.0:
        raise _no_crank_rocker(given)
    says = said(
        "with this ψ and this K_v the least angle of transmission is {best:.4g}° at best; ask for less",
        best=math.floor(100.0 * best) / 100.0,
    )
    raise StructureError(says, "task.transmission", head="task")


def _narrowed(tried: Callable[[Reals], Reals], low: float, high: float) -> float:
    return float(narrow(tried, np.array([[low]]), np.array([[high]]))[0, 0])


def _at_angle(
    side: int, low: float, high: float, wanted: float, chord: tuple[float, float, float]
) -> FourBar | None:
    half, height, _ = chord
    turn = math.radians(_narrowed(TransmissionAbout(half, height, wanted), low, high))
    at = math.hypot(half, height) * complex(-math.sin(turn), math.cos(turn))
    return _checked(side, at, half, height)


def _farther(row: Sequence[FourBar | None], k: int, way: int, wanted: float) -> FourBar:
    """Return how far one may go from a place of the locus without coming past what is wanted again."""
    found = row[k]
    assert found is not None
    for j in range(1, SPREAD):
        other = row[k + way * j] if 0 <= k + way * j < len(row) else None
        if other is None or (other.least < wanted) != (found.least < wanted):
            break
        found = other
    return found


def take_frame(draft: Draft, given: Given, chosen: FourBar) -> Mark:
    """Take the distance of the pivots, or look for it on the locus by the least angle of transmission."""
    if chosen.between is None:
        return draft.take(Number, "l_{OC}", chosen.frame, "m")
    tried = TransmissionOf(chosen.side, *sizes_of_chord(given), given["transmission"])
    ends = [draft.take(Number, "", one, "m") for one in chosen.between]
    return draft.draw(refinement(tried, TRY_FRAMES, Number), "l_{OC}", *ends, unit="m", why=_WORST)


def take_angle(draft: Draft, given: Given, chosen: FourBar) -> Mark:
    """Look for the place of O on a circle about C by the least angle of transmission: the angle of CO."""
    assert chosen.between is not None
    half, height, _ = sizes_of_chord(given)
    tried = TransmissionAbout(half, height, given["transmission"])
    ends = [draft.take(Angle, "", one, "°") for one in chosen.between]
    return draft.draw(refinement(tried, TRY_PLACES), "η", *ends, unit="°", why=_WORST)


_WORST = said("The transmission is worst where crank and frame lie in one line.")


def _centre(at: complex, ends: tuple[complex, complex]) -> complex:
    """Return the centre of the circle through a place and both ends of a chord that lies level."""
    half, height = ends[1].real, ends[1].imag
    rise = at.imag - height
    return complex(0.0, height + (at.real**2 + rise**2 - half**2) / (2.0 * rise))


def crank_rocker(draft: Draft, given: Given) -> Lengths:
    """A crank-rocker by the rocker's swing, K_v, its length, and the distance of the pivots or transmission."""
    chosen = choose_four_bar(given)
    swing = draft.take(Angle, "ψ", given["psi"], "°")
    ratio = draft.take(Number, "K_v", given["K_v"])
    rocker_ = draft.take(Number, "l_{BC}", given["BC"], "m")
    if chosen.about:
        frame = draft.draw(f.pivots_about, "l_{OC}", rocker_, unit="m")
        angle = take_angle(draft, given, chosen)
    else:
        frame = take_frame(draft, given, chosen)
    theta = draft.draw(swing_angle, "θ", ratio)
    half = draft.draw(f.half_of_chord, "g", rocker_, swing, unit="m")
    height = draft.draw(f.height_of_chord, "h", rocker_, swing, unit="m")
    if chosen.about:
        along = draft.draw(f.along_by_angle, "Y_{O}", frame, angle, unit="m")
        off = draft.draw(f.off_by_angle, "X_{O}", frame, angle, unit="m")
    else:
        centre_of = f.centre_beyond if chosen.side > 0 else f.centre_before
        centre = draft.draw(centre_of, "m", height, half, theta, unit="m")
        along = draft.draw(f.along_axis, "Y_{O}", frame, height, half, centre, unit="m")
        off = draft.draw(f.off_axis, "X_{O}", frame, along, unit="m")
    far = draft.draw(f.far_end, "l_{1}", off, half, along, height, unit="m")
    near = draft.draw(f.near_end, "l_{2}", off, half, along, height, unit="m")
    crank = draft.draw(f.half_difference, "l_{OA}", far, near, unit="m")
    rod = draft.draw(f.half_sum, "l_{AB}", far, near, unit="m")
    draft.draw(f.transmission_folded, "γ_1", crank, rod, rocker_, frame, unit="°")
    draft.draw(f.transmission_stretched, "γ_2", crank, rod, rocker_, frame, unit="°")
    return {"OA": crank, "AB": rod, "BC": rocker_, "OC": frame}
