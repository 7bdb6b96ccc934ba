"""The lengths of mechanisms found from a task, kind by kind: calculated steps, and what is refused.

Each takes what is given (SI, degrees) by the keys of the task, records its steps on a draft and returns the
marks of the lengths by the letters that a scene then knows. Refused is only what no mechanism does, with the
limit that would do.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import half_chord, sine_of_half, swing_angle
from graphic_tmm.board.operations.locus import refinement
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Number, Reals
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism import synthesis_formulas as f

Given = Mapping[str, Any]
Lengths = dict[str, Mark]

PLACES = (1, 2, 3)
"""The numbers of three positions."""
STRAIGHT = 1e-9
"""Three places whose triangle is flatter than this share of its longest side lie in one line."""


def rocker(draft: Draft, given: Given) -> Lengths:
    """A rocker with its stone, by K_v, the stroke and the distance of the pivots."""
    ratio = draft.take(Number, "K_v", given["K_v"])
    travel = draft.take(Number, "S", given["stroke"], "m")
    centres = draft.take(Number, "l_{OB}", given["OB"], "m")
    theta = draft.draw(swing_angle, "θ", ratio)
    crank = draft.draw(sine_of_half, "l_{OA}", centres, theta, unit="m")
    arm = draft.draw(half_chord, "l_{BC}", travel, theta, unit="m")
    return {"OA": crank, "BC": arm, "OB": centres}


def theta_of(K_v: float) -> float:
    """Return the angle θ between both dead centres, degrees."""
    return 180.0 * (K_v - 1.0) / (K_v + 1.0)


def ratio_of(theta: float) -> float:
    """Return K_v of an angle θ between both dead centres, degrees."""
    return (180.0 + theta) / (180.0 - theta)


def stroke_of(given: Given) -> float:
    """Return the stroke of a slider, m: as given, or by its mean speed."""
    if given.get("stroke"):
        return float(given["stroke"])
    return float(math.pi * given["v_m"] / given["n"])


def take_stroke(draft: Draft, given: Given) -> Mark:
    """Take the stroke of a slider, or calculate it of its mean speed."""
    if given.get("stroke"):
        return draft.take(Number, "S", given["stroke"], "m")
    speed = draft.take(Number, "v_m", given["v_m"], "m/s")
    omega = draft.take(Number, "ω_1", given["n"], "1/s")
    return draft.draw(f.stroke_by_speed, "S", speed, omega, unit="m")


def slider_crank(draft: Draft, given: Given) -> Lengths:
    """A slider-crank by its stroke and K_v with e, or λ or the greatest pressure angle, with e or not."""
    _refuse_slider(given)
    stroke = take_stroke(draft, given)
    offset = draft.take(Number, "e", given["e"], "m") if given.get("e") else None
    own = {} if offset is None else {"e": offset}
    if "K_v" in given:
        assert offset is not None
        ratio = draft.take(Number, "K_v", given["K_v"])
        theta = draft.draw(swing_angle, "θ", ratio)
        crank = draft.draw(f.crank_by_offset, "l_{OA}", stroke, offset, theta, unit="m")
        rod = draft.draw(f.rod_by_offset, "l_{AB}", stroke, offset, theta, unit="m")
        return {"OA": crank, "AB": rod, **own}
    if "lambda" in given:
        times = draft.take(Number, "λ", given["lambda"])
        if offset is None:
            crank = draft.draw(f.half_stroke, "l_{OA}", stroke, unit="m")
        else:
            crank = draft.draw(f.crank_by_ratio, "l_{OA}", stroke, offset, times, unit="m")
        return {
            "OA": crank,
            "AB": draft.draw(f.rod_by_ratio, "l_{AB}", times, crank, unit="m"),
            **own,
        }
    aslant = draft.take(Angle, "[α]", given["pressure"], "°")
    if offset is None:
        crank = draft.draw(f.half_stroke, "l_{OA}", stroke, unit="m")
        return {"OA": crank, "AB": draft.draw(f.rod_by_pressure, "l_{AB}", crank, aslant, unit="m")}
    crank = crank_by_pressure(draft, given)
    rod = draft.draw(f.rod_by_pressure_offset, "l_{AB}", crank, offset, aslant, unit="m")
    return {"OA": crank, "AB": rod, **own}


@dataclass(frozen=True)
class StrokeOf:
    """How much longer than wanted the stroke of a slider-crank is, its pressure angle given; of cranks (m)."""

    wanted: float
    offset: float
    pressure: float

    def __call__(self, crank: Reals) -> Reals:
        """Return that of each crank, m."""
        rod = (crank + self.offset) / math.sin(math.radians(self.pressure))
        ends = (
            np.sqrt(np.maximum(one**2 - self.offset**2, 0.0)) for one in (rod + crank, rod - crank)
        )
        far, near = ends
        return np.asarray(far - near - self.wanted)


TRY_CRANKS = said(
    "Try cranks between {low} and {high}, each with the connecting rod of the pressure angle, each time "
    "narrowing to where the stroke is what is wanted; this is {it}."
)


def crank_by_pressure(draft: Draft, given: Given) -> Mark:
    """Look for the crank of a slider-crank with an offset: the stroke is longer the longer the crank is."""
    stroke = stroke_of(given)
    ends = [draft.take(Number, "", one, "m") for one in (0.0, stroke)]
    tried = StrokeOf(stroke, given["e"], given["pressure"])
    return draft.draw(refinement(tried, TRY_CRANKS, Number), "l_{OA}", *ends, unit="m")


def _refuse_slider(given: Given) -> None:
    stroke, offset = stroke_of(given), float(given.get("e") or 0.0)
    if "K_v" in given:
        theta = theta_of(given["K_v"])
        largest = stroke / math.tan(math.radians(theta)) if theta < 90.0 else 0.0
        if theta >= 90.0:
            says = said("no crank that turns all round gives a slider K_v = 3 or more; give less")
            raise StructureError(says, "task.K_v", head="task")
        if offset >= largest:
            most = ratio_of(math.degrees(math.atan(stroke / offset)))
            says = said(
                "with this K_v a crank turns all round only while e is less than S/tan θ = {e:.4g} mm; with "
                "this e while K_v is less than {K:.5g}",
                e=1000.0 * largest,
                K=most,
            )
            raise StructureError(says, "task.e", head="task")
    elif "lambda" in given:
        times = given["lambda"]
        largest = stroke * (times**2 - 1.0) / (4.0 * times)
        if offset > largest:
            says = said(
                "with this λ there is a crank only while e is not more than S·(λ² − 1)/(4·λ) = {e:.4g} mm",
                e=1000.0 * largest,
            )
            raise StructureError(says, "task.e", head="task")


def refuse_count(given: Given, key: str, count: int) -> None:
    """Refuse a list that is not as long as it has to be."""
    if len(given[key]) != count:
        says = said("{count} values are wanted here, not {n}", count=count, n=len(given[key]))
        raise StructureError(says, f"task.{key}", head=f"task.{key}")


def refuse_line(places: Sequence[complex], letter: str, key: str) -> None:
    """Refuse three places in one line, or two that are one: the circle through them has no one centre."""
    one, other, third = places
    sides = (other - one, third - one, third - other)
    longest = max(map(abs, sides))
    for side, pair in zip(sides, combinations(PLACES, 2), strict=True):
        if abs(side) <= STRAIGHT * longest:
            says = said(
                "places {first} and {second} of {letter} are one, and any circle through it and the third one "
                "does: give three that differ",
                first=pair[0],
                second=pair[1],
                letter=letter,
            )
            raise StructureError(says, key, head="task")
    if abs((np.conj(sides[0]) * sides[1]).imag) > STRAIGHT * longest**2:
        return
    says = said(
        "the three places of {letter} lie in one line, and no link that turns keeps a point there: move one of "
        "them off it, or let {letter} slide along that line",
        letter=letter,
    )
    raise StructureError(says, key, head="task")


def circle_through(
    draft: Draft, places: Sequence[tuple[Mark, Mark]], letter: str
) -> tuple[Mark, Mark]:
    """Calculate where the centre of the circle through three places stands."""
    (x1, y1), (x2, y2), (x3, y3) = places
    area = draft.draw(f.double_area, f"D_{letter}", x1, y1, x2, y2, x3, y3, unit="m²")
    q, s = (
        draft.draw(f.chord_square, f"q_{{{letter}{k}}}", x1, y1, *place, unit="m²")
        for k, place in zip(PLACES[1:], places[1:], strict=True)
    )
    x = draft.draw(f.circle_centre, f"X_{{{letter}}}", x1, y1, y2, y3, q, s, area, unit="m")
    y = draft.draw(f.circle_centre, f"Y_{{{letter}}}", y1, x1, x3, x2, s, q, area, unit="m")
    return x, y


def coupler_places(given: Given) -> tuple[list[complex], list[complex]]:
    """Return the three places of A and of B, m."""
    A = list(given["A"])
    turned = np.exp(1j * np.radians(given["angles"]))
    return A, [a + given["AB"] * complex(one) for a, one in zip(A, turned, strict=True)]


def coupler(draft: Draft, given: Given) -> Lengths:
    """A four-bar that takes its coupler AB through three positions: centres of circles through A and B."""
    for key in ("A", "angles"):
        refuse_count(given, key, len(PLACES))
    A, B = coupler_places(given)
    refuse_line(A, "A", "task.A")
    refuse_line(B, "B", "task.angles")
    _refuse_rotation(A, B)
    length = draft.take(Number, "l_{AB}", given["AB"], "m")
    first, second = [], []
    for k, a, angle in zip(PLACES, A, given["angles"], strict=True):
        x, y = (
            draft.take(Number, f"{axis}_{{A{k}}}", part, "m")
            for axis, part in (("X", a.real), ("Y", a.imag))
        )
        alpha = draft.take(Angle, f"α_{k}", angle, "°")
        first.append((x, y))
        second.append(
            (
                draft.draw(f.end_across, f"X_{{B{k}}}", x, length, alpha, unit="m"),
                draft.draw(f.end_up, f"Y_{{B{k}}}", y, length, alpha, unit="m"),
            )
        )
    xO, yO = circle_through(draft, first, "O")
    xC, yC = circle_through(draft, second, "C")
    return {
        "xO": xO,
        "yO": yO,
        "xC": xC,
        "yC": yC,
        "OA": draft.draw(f.link_length, "l_{OA}", xO, yO, *first[0], unit="m"),
        "AB": length,
        "BC": draft.draw(f.link_length, "l_{BC}", xC, yC, *second[0], unit="m"),
    }


def _refuse_rotation(A: Sequence[complex], B: Sequence[complex]) -> None:
    """Refuse a coupler that turns about one point alone: both pivots of its mechanism would stand there."""
    size = max(abs(one - A[0]) for one in (*A, *B))
    about = _middle_of(A)
    if abs(_middle_of(B) - about) > STRAIGHT * max(size, abs(about - A[0])):
        return
    says = said(
        "the coupler turns about one point, X = {x:.4g} mm, Y = {y:.4g} mm, through all three places: one link "
        "on a pivot there does that; for a four-bar give other places or angles",
        x=1000.0 * about.real,
        y=1000.0 * about.imag,
    )
    raise StructureError(says, "task.angles", head="task")


def _middle_of(places: Sequence[complex]) -> complex:
    """Return the centre of the circle through three places."""
    start, *others = places
    one, other = (place - start for place in others)
    twice = 2j * (one.conjugate() * other).imag
    return start + (abs(other) ** 2 * one - abs(one) ** 2 * other) / -twice


def inverted(given: Given, crank: Sequence[float], rocker: Sequence[float]) -> list[complex]:
    """Return the places of A, O at 0, with the rocker held in its first position."""
    C = complex(given["OC"], 0.0)
    return [
        C
        + (given["OA"] * complex(np.exp(1j * math.radians(phi))) - C)
        * complex(np.exp(1j * math.radians(rocker[0] - psi)))
        for phi, psi in zip(crank, rocker, strict=True)
    ]


def angles(draft: Draft, given: Given) -> Lengths:
    """A four-bar whose crank and rocker stand at three pairs of angles, by inversion."""
    for key in ("crank", "rocker"):
        refuse_count(given, key, len(PLACES))
    take = [
        [draft.take(Angle, f"{letter}_{k}", one, "°") for k, one in zip(PLACES, row, strict=True)]
        for letter, row in (("φ", given["crank"]), ("ψ", given["rocker"]))
    ]
    refuse_line(inverted(given, given["crank"], given["rocker"]), "A", "task.rocker")
    return of_angles(draft, given, *take)


def of_angles(draft: Draft, given: Given, crank: list[Mark], rocker: list[Mark]) -> Lengths:
    """Calculate the four-bar whose crank and rocker stand at three pairs of angles."""
    frame = draft.take(Number, "l_{OC}", given["OC"], "m")
    arm = draft.take(Number, "l_{OA}", given["OA"], "m")
    origin = [draft.take(Number, letter, 0.0, "m") for letter in ("X_{O}", "Y_{O}")]
    places = []
    for k, phi, psi in zip(PLACES, crank, rocker, strict=True):
        x = draft.draw(f.end_across, f"X_{{A{k}}}", origin[0], arm, phi, unit="m")
        y = draft.draw(f.end_up, f"Y_{{A{k}}}", origin[1], arm, phi, unit="m")
        if k > 1:
            back = (x, y, frame, rocker[0], psi)
            x = draft.draw(f.turned_across, f"X_{{A{k}′}}", *back, unit="m")
            y = draft.draw(f.turned_up, f"Y_{{A{k}′}}", *back, unit="m")
        places.append((x, y))
    xB, yB = circle_through(draft, places, "B")
    return {
        "OA": arm,
        "AB": draft.draw(f.link_length, "l_{AB}", *places[0], xB, yB, unit="m"),
        "BC": draft.draw(f.link_length, "l_{BC}", frame, origin[1], xB, yB, unit="m"),
        "OC": frame,
    }


def cylinder(draft: Draft, given: Given) -> Lengths:
    """A crank whose rod is the piston of a swinging cylinder, by its stroke and the cylinder's swing."""
    stroke = take_stroke(draft, given)
    swing = draft.take(Angle, "ψ", given["psi"], "°")
    crank = draft.draw(f.half_stroke, "l_{OA}", stroke, unit="m")
    return {"OA": crank, "OC": draft.draw(f.pivots_by_swing, "l_{OC}", crank, swing, unit="m")}
