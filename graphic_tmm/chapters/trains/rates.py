"""The picture of linear velocities of a planetary train and, from it, the plan of angular velocities.

At the level of a point stands its velocity; the points of a body on the line of centres end in one straight
line, which passes through the level where the body stands. Rays from a pole parallel to these lines cut off
on a line parallel to the axis segments proportional to the angular velocities.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, product, scale_of_derivative, to_board
from graphic_tmm.board.operations.instruments import (
    join,
    lay_off,
    measure_along,
    meet,
    parallel,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.trains import formulas as f
from graphic_tmm.chapters.trains import words as why
from graphic_tmm.chapters.trains.dimensions import Dimensions, draw_held, third_rate
from graphic_tmm.chapters.trains.formulas import miss_of_ratio, ratio_of_segments
from graphic_tmm.chapters.trains.motion import Closing, Motion
from graphic_tmm.chapters.trains.pictures import EndView
from graphic_tmm.chapters.trains.rows import closed_velocity, of_trial
from graphic_tmm.chapters.trains.task import Scheme, Train
from graphic_tmm.chapters.trains.tooth_conditions import stands_still

VELOCITIES = "planetary-velocities"
RATES = "planetary-rates"
STANDS = "0"
"""The frame, on the plan of a differential, in which no member stands."""


@dataclass(frozen=True)
class Trial:
    """Velocities of any size of two members that are closed (false position), and what drives moves by them.

    ``length``: of the first of them (Length, given); ``ends``: of all three velocities by the point; ``line``:
    that of the satellites.
    """

    length: Mark
    ends: Mapping[str, Mark]
    line: Mark


@dataclass(frozen=True)
class VelocityPicture:
    """The picture of linear velocities.

    ``place``: where its zero line stands along the axis (Length, given); ``zeros``: O, A, B, C on it, no O of
    bevel wheels;
    ``ends``: those of velocities, by the point; ``lines``: of the bodies that move, satellites as "2";
    ``readings``: the velocities by point, laid off and the others measured (Length); ``speeds`` the same in
    m/s; ``omegas``: what is given, 1/s, by the member. ``trial``: by which a closed train was found.
    """

    mu: Mark
    place: Mark
    zeros: Mapping[str, Mark]
    ends: Mapping[str, Mark]
    lines: Mapping[str, Mark]
    readings: Mapping[str, Mark]
    speeds: Mapping[str, Mark]
    omegas: Mapping[str, Mark]
    trial: Trial | None = None


@dataclass(frozen=True)
class Rates:
    """The plan of angular velocities.

    ``depth``: how far below the axis its line lies (Length, given); ``distance``: H of the pole (Length,
    given); ``foot``: what stands; ``ends``, ``segments``, ``values`` (1/s): of the bodies that move. Of vectors
    along the axes of bevel wheels the pole, where all that stands is, is ``distance`` along the axis from O and
    ``depth`` above it. ``due`` by
    Willis, ``drawn`` as measured: driving over driven, or a differential's third angular velocity, 1/s;
    ``difference`` of both, %, None where what is driven stands still.
    """

    mu: Mark
    depth: Mark
    distance: Mark
    pole: Mark
    foot: Mark
    ends: Mapping[str, Mark]
    segments: Mapping[str, Mark]
    values: Mapping[str, Mark]
    due: Mark
    drawn: Mark
    difference: Mark | None


def draw_picture(
    draft: Draft,
    motion: Motion,
    scheme: Scheme,
    end: EndView,
    sizes: Dimensions,
    before: Sequence[Mark] = (),
    closing: Mapping[str, Mark] = MappingProxyType({}),
) -> VelocityPicture:
    """Draw the picture from two points of the satellite that are known, of A, its axis B and C.

    ``before``: where wheels stand before the train, angular velocities up to that of what drives; ``closing``:
    of wheels that let another member turn with it.
    """
    draft.open(VELOCITIES)
    mu = draft.scale("μ_v", "(m/s)/mm")
    draft.lay_out()
    place = draft.ask(Length, "x_v", "mm")
    name = "B" if scheme.bevel else "O"
    reason = why.ZERO_OF_BEVEL if scheme.bevel else why.ZERO
    origin = draft.draw(lay_off, name, end.axis, place, why=reason)
    zero = draft.draw(square, "(0)", origin, end.axis, sense=1, why=reason)
    feet = {
        letter: origin if letter == name else draft.draw(meet, letter, zero, level, why=why.ZERO)
        for letter, level in end.levels.items()
    }
    points = {member: letter for letter, member in scheme.spots.items()}
    arms = {at: sizes.radii.get(member, sizes.axes) for member, at in points.items()}
    tips, readings, speeds, omegas = (
        dict[str, Mark](),
        dict[str, Mark](),
        dict[str, Mark](),
        dict[str, Mark](),
    )
    joined = (name for name in closing if name in points and name not in motion.driving)
    for member in (*motion.driving, *joined):
        known = closing.get(member) or (before[-1] if before else None)
        given = motion.driving.get(member, 0.0)
        omegas[member] = known or draft.take(Number, f"ω_{member}", given, "1/s")
        at = points[member]
        speeds[at] = draft.draw(product, f"v_{at}", omegas[member], arms[at], unit="m/s")
        readings[at] = draft.draw(to_board, f"{at}{at.lower()}", speeds[at])
        along = draft.draw(
            parallel,
            f"({at}{at.lower()})",
            feet[at],
            end.levels[at],
            sense=1,
            why=why.KNOWN_VELOCITY,
        )
        tips[at] = draft.draw(lay_off, at.lower(), along, readings[at], why=why.KNOWN_VELOCITY)
    trial = None
    if motion.closing is not None and not closing:
        trial, found = draw_trial(
            draft, motion.closing, motion.first, points, end, sizes, feet, readings
        )
        at = points[motion.closing.joint]
        readings[at] = found
        speeds[at] = draft.draw(in_si, f"v_{at}", found, unit="m/s")
        along = draft.uses(trial.ends[at])[0]
        tips[at] = draft.draw(lay_off, at.lower(), along, found)
    through = [feet[points[motion.fixed]], *tips.values()] if motion.fixed else [*tips.values()]
    letter = "".join(mark.letter for mark in through)
    reason = why.SATELLITE_LINE if points.get(motion.fixed) == "C" else why.SATELLITE_OF_TWO
    satellite = draft.draw(join, f"({letter})", *through, why=reason)
    sought = sorted(
        (at for at, member in scheme.spots.items() if at not in tips and member != motion.fixed),
        key=lambda at: scheme.spots[at] != motion.driven,
    )
    for at in sought:
        tips[at] = draft.draw(meet, at.lower(), satellite, end.levels[at], why=why.SOUGHT_VELOCITY)
    lines = {}
    for body in sorted([*points, scheme.rims[0]], key=lambda body: (body == "H", body)):
        if body == scheme.rims[0]:
            lines[body] = satellite
        elif body != motion.fixed and not scheme.bevel:
            tip = tips[points[body]]
            lines[body] = draft.draw(join, f"(O{tip.letter})", origin, tip, why=why.BODY_LINE)
    for at in sought:
        readings[at] = draft.draw(
            measure_along, f"{at}{at.lower()}", feet[at], tips[at], end.axis, why=why.VELOCITY_READ
        )
        speeds[at] = draft.draw(in_si, f"v_{at}", readings[at], unit="m/s")
    ends = {point: tips[point] for point in points.values() if point in tips}
    zeros = {name: origin, **feet}
    return VelocityPicture(mu, place, zeros, ends, lines, readings, speeds, omegas, trial)


def draw_trial(
    draft: Draft,
    closing: Closing,
    driving: str,
    points: Mapping[str, str],
    end: EndView,
    sizes: Dimensions,
    feet: Mapping[str, Mark],
    readings: Mapping[str, Mark],
) -> tuple[Trial, Mark]:
    """Draw velocities of any size; return what that of the first member is where what drives has its own."""
    at, to, by = (points[member] for member in (closing.joint, closing.other, driving))
    arms = [sizes.radii.get(member, sizes.axes) for member in (closing.other, closing.joint)]
    length = draft.ask(Length, f"{at}{at.lower()}′", "mm")
    other = draft.draw(
        closed_velocity, f"{to}{to.lower()}′", length, sizes.closing[closing.other], *arms
    )
    ends = dict[str, Mark]()
    for name, own in ((at, length), (to, other)):
        letter = f"({name}{name.lower()}′)"
        way = draft.draw(parallel, letter, feet[name], end.levels[name], sense=1, why=why.TRIAL)
        ends[name] = draft.draw(lay_off, f"{name.lower()}′", way, own, why=why.TRIAL)
    letter = f"({ends[at].letter}{ends[to].letter})"
    line = draft.draw(join, letter, ends[at], ends[to], why=why.TRIAL)
    ends[by] = draft.draw(meet, f"{by.lower()}′", line, end.levels[by], why=why.TRIAL)
    read = draft.draw(
        measure_along, f"{by}{by.lower()}′", feet[by], ends[by], end.axis, why=why.VELOCITY_READ
    )
    found = draft.draw(of_trial, f"{at}{at.lower()}", length, readings[by], read)
    return Trial(length, ends, line), found


def draw_rates(
    draft: Draft,
    motion: Motion,
    train: Train,
    end: EndView,
    sizes: Dimensions,
    picture: VelocityPicture,
) -> Rates:
    """Draw the plan of angular velocities below the picture; measure the ratio and compare it."""
    draft.open(RATES)
    distance = draft.ask(Length, "H_ω", "mm")
    depth = draft.ask(Length, "y_ω", "mm")
    mu = draft.draw(scale_of_derivative, "μ_ω", picture.mu, draft.mu_l, distance, unit="(1/s)/mm")
    fixed = motion.fixed or STANDS
    down = draft.draw(square, "(Oy)", picture.zeros["O"], end.axis, sense=-1, why=why.RATES_LINE)
    foot = draft.draw(lay_off, fixed, down, depth, why=why.RATES_LINE)
    line = draft.draw(parallel, "(ω)", foot, end.axis, sense=1, why=why.RATES_LINE)
    below = draft.draw(square, f"({fixed}P)", foot, line, sense=-1, why=why.RATES_POLE)
    pole = draft.draw(lay_off, "P", below, distance, why=why.RATES_POLE)
    draft.lay_out(pole, mu)
    ends, segments, values = {}, {}, {}
    for body, drawn in picture.lines.items():
        way = draft.draw(parallel, f"(P{body})", pole, drawn, sense=1, why=why.RATE_RAY)
        ends[body] = draft.draw(meet, body, line, way, why=why.RATE_RAY)
        segments[body] = draft.draw(
            measure_along, f"s_{body}", foot, ends[body], line, why=why.RATE_READ
        )
        values[body] = draft.draw(in_si, f"ω_{body}", segments[body], unit="1/s")
    compared = compare(draft, motion, train, sizes, picture.omegas, segments, values)
    return Rates(mu, depth, distance, pole, foot, ends, segments, values, *compared)


def compare(
    draft: Draft,
    motion: Motion,
    train: Train,
    sizes: Dimensions,
    omegas: Mapping[str, Mark],
    segments: Mapping[str, Mark],
    values: Mapping[str, Mark],
) -> tuple[Mark, Mark, Mark | None]:
    """Calculate what is due by Willis, what was drawn, and how far both differ: not of what stands still."""
    if sizes.ratio is None:
        name, drawn = "Δω", values[motion.driven]
        due = draw_willis(draft, motion, train.scheme, sizes.teeth, omegas)
        if stands_still(train, motion):
            return due, drawn, None
    else:
        name, letter, due = "ΔU", f"U′_{{{motion.first}{motion.driven}}}", sizes.ratio
        read = segments[motion.first], segments[motion.driven]
        drawn = draft.draw(ratio_of_segments, letter, *read)
    return due, drawn, draft.draw(miss_of_ratio, name, drawn, due, unit="%", why=why.COMPARED)


def draw_willis(
    draft: Draft,
    motion: Motion,
    scheme: Scheme,
    z: Mapping[str, Mark],
    omegas: Mapping[str, Mark],
) -> Mark:
    """Calculate the angular velocity of what is driven from two that are given."""
    driven, (first, *others) = motion.driven, scheme.meshes
    letter = f"ω′_{driven}"
    given = dict(omegas)
    if not others:
        if motion.fixed:
            given[motion.fixed] = draft.take(Number, f"ω_{motion.fixed}", 0.0, "1/s")
        op = f.mesh_outside if first.sense > 0 else f.mesh_inside
        held = draft.draw(op, f"U_{{{driven}1}}^{{H}}", z["1"], z[driven])
        return draft.draw(f.rate_of_first, letter, held, given["1"], given["H"], unit="1/s")
    if "H" not in scheme.members:
        one, other = given
        held = draw_held(draft, scheme, z, one, other)
        carrier = draft.draw(f.rate_of_carrier, "ω′_H", held, *given.values(), unit="1/s")
        held = draw_held(draft, scheme, z, driven, other)
        return draft.draw(f.rate_of_first, letter, held, given[other], carrier, unit="1/s")
    return third_rate(draft, scheme, z, driven, given, letter)
