"""A planetary train 2K–H: sizes and conditions, two views and their places, velocities, the ratio measured."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard, standard_length
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.trains.bevel import (
    BevelView,
    choose_room,
    draw_side_view,
    draw_triangle,
)
from graphic_tmm.chapters.trains.dimensions import Dimensions, calculate_train
from graphic_tmm.chapters.trains.motion import Motion, motion_of
from graphic_tmm.chapters.trains.pairs import Pairs, draw_pairs
from graphic_tmm.chapters.trains.pictures import (
    VIEW,
    AxialView,
    EndView,
    draw_axial_view,
    draw_end_view,
)
from graphic_tmm.chapters.trains.rates import (
    Rates,
    Trial,
    VelocityPicture,
    draw_picture,
    draw_rates,
)
from graphic_tmm.chapters.trains.rows import closing_rows, draw_closing
from graphic_tmm.chapters.trains.task import ASKED, PLANETARY_TRAIN, PlanetaryTask, Scheme, Train
from graphic_tmm.chapters.trains.tooth_search import choose
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded

DIAMETER = 160.0
"""Room for the circles, mm."""
BEVEL = (110.0, 50.0)
"""Room for bevel wheels, and for the longest velocity above them, mm."""
VELOCITY, RATE = 70.0, 80.0
"""Room for the longest velocity, and for the longest segment of the plan of angular velocities, mm."""
TRIAL = 40.0
"""Room for the longest velocity of a trial, mm."""
POLES = (60.0, 50.0, 40.0, 30.0, 25.0, 20.0, 15.0, 10.0)
"""Pole distances that are chosen from, mm."""
BESIDE, ROW, ARM = 60.0, 26.0, 18.0
"""From the circles to the first row; from row to row; from the last row to the arm of the carrier, mm."""
PICTURE, BELOW = 62.0, 48.0
"""From the scheme to the picture of velocities; from the axis down to the plan below it, mm."""
CLEAR = 45.0
"""The least way from the scheme to the picture: the shaft's bearing stands there, mm."""
HOLLOW = 20.0
"""Further out the hollow shaft of a ring that turns reaches, mm."""
SHAFT = 42.0
"""From the arm, or the last row, to a wheel on the driven shaft, whose bearing stands between, mm."""
IDLE = 21.0
"""Left of the first row stands the arm of a carrier that runs idle, mm."""
AROUND = 40.0
"""Room beside such a wheel for the shaft of the one that it drives, mm."""


@dataclass(frozen=True)
class Drawn:
    """What scales are chosen for: train, views, picture, plan, wheels outside it; the share of usual room."""

    order: PlanetaryTask
    motion: Motion
    train: Train
    end: EndView
    axial: AxialView
    picture: VelocityPicture
    rates: Rates
    pairs: Pairs
    size: float = 1.0


def choose_scales(draft: Draft, drawn: Drawn) -> None:
    """Choose what the draft's given marks still lack; every slice is run with the exact hand.

    The order's own scale factors and pole distance are kept.
    """
    order, picture, rates, size = drawn.order, drawn.picture, drawn.rates, drawn.size
    mu_v, distance, stations = picture.mu, rates.distance, drawn.axial.stations
    draft.given |= {draft.mu_l: 1.0, mu_v: 1.0, distance: 1.0, rates.depth: BELOW}
    draft.given |= dict.fromkeys((*stations.values(), picture.place), 0.0)
    draft.given |= {mark: 0.0 for view in drawn.pairs.outside for mark in view.stations}
    if picture.trial is not None:
        draft.given[picture.trial.length] = 1.0
    diameter, longest_velocity = BEVEL if drawn.train.scheme.bevel else (DIAMETER, VELOCITY)
    draft.given[draft.mu_l] = order.mu_l or standard_length(
        2.0 * _reach(draft, drawn), diameter * size
    )
    longest = max(_sizes(draft, picture.readings.values()))
    draft.given[mu_v] = order.mu_v or standard(longest, longest_velocity * size)
    if picture.trial is not None:
        _choose_trial(draft, picture, picture.trial, size)
    if drawn.train.scheme.bevel:
        choose_room(draft, picture, rates, drawn.axial, size)
        return
    longest = max(_sizes(draft, rates.segments.values()))
    fits = (pole for pole in POLES if pole * longest <= RATE * size)
    draft.given[distance] = order.pole or next(fits, RATE * size / longest)
    _place(draft, drawn, stations)


def _choose_trial(draft: Draft, picture: VelocityPicture, trial: Trial, size: float) -> None:
    """Choose the trial of a closed train: in whole mm, to the side where the true picture is not."""
    at = next(iter(trial.ends))
    marks = (*trial.ends.values(), picture.ends[at])
    reading = execute(draft.board.construction(), draft.given, marks)
    *ends, true = (float(reading[mark][0, 0].real) for mark in marks)
    length = TRIAL * size / max(map(abs, ends))
    draft.given[trial.length] = math.copysign(round(length) or length, -true)


def _place(draft: Draft, drawn: Drawn, stations: Mapping[str, Mark]) -> None:
    """Place the rows and the arm of the scheme, then the picture, to the right of the circles.

    Where the fixed wheel has external teeth the arm stands between the rows: its shaft goes through that wheel.
    Wheels outside the train stand on the shaft of wheel 1, to the left, or on another one, to the right.
    """
    size, scheme = drawn.size, drawn.train.scheme
    outside, idle = scheme.second > 0 and scheme.rows > 1, "H" not in scheme.members
    first = _reach(draft, drawn) + BESIDE * size
    views = sorted(drawn.pairs.outside, key=lambda view: view.member == "H")
    rows = {
        left: tuple(
            mark for view in views if (view.member == "1") == left for mark in view.stations
        )
        for left in (True, False)
    }
    for station in rows[True]:
        draft.given[station] = -SHAFT
        first += SHAFT
    if rows[True]:
        draft.given[rows[True][0]] = first - SHAFT
    if idle:
        first += IDLE + (HOLLOW if drawn.motion.fixed != "3" else 0.0)
    last = first + ROW * size * (scheme.rows - 1)
    arm = last + size * (-ROW / 2.0 if outside else ARM)
    if idle:
        arm = first - size * ARM
    draft.given |= {stations["I"]: first, stations["H"]: arm}
    if "II" in stations:
        draft.given[stations["II"]] = last
    trial = drawn.picture.trial
    marks = (*drawn.picture.ends.values(), *(trial.ends.values() if trial is not None else ()))
    tips = execute(draft.board.construction(), draft.given, marks)
    left = min(float(tips[mark][0, 0].real) for mark in marks)
    turns = not outside and not idle and drawn.motion.fixed != drawn.motion.last
    beside = max(PICTURE * size, CLEAR) + (HOLLOW if turns else 0.0)
    zero = last + size * ARM + beside + max(0.0, -left)
    if rows[False]:
        begins = max(last, arm) + SHAFT + (HOLLOW if turns else 0.0)
        draft.given |= dict.fromkeys(rows[False], SHAFT)
        draft.given[rows[False][0]] = begins
        if sum(view.member != "1" for view in views) > 1:
            # both from O: that of the carrier behind the hollow shaft of the other
            draft.given[rows[False][1]] = begins + HOLLOW + SHAFT
        ends = tuple(drawn.rates.ends.values())
        rays = execute(draft.board.construction(), draft.given, ends)
        left = min(left, *(float(rays[mark][0, 0].real) for mark in ends))
        over = not idle and any(view.member == drawn.motion.last for view in drawn.pairs.outside)
        begins += (len(rows[False]) - 1) * SHAFT + (HOLLOW if over else 0.0)
        zero = max(zero, begins + AROUND - left)
    draft.given[drawn.picture.place] = zero


def _sizes(draft: Draft, marks: Iterable[Mark]) -> list[float]:
    """Return lengths as they come out with what is given now, without their signs."""
    wanted = tuple(marks)
    reading = execute(draft.board.construction(), draft.given, wanted)
    return [abs(float(reading[mark][0, 0])) for mark in wanted]


def _reach(draft: Draft, drawn: Drawn) -> float:
    """Return the radius about the main axis that the pitch circles take, mm."""
    names = [*drawn.train.scheme.wheels, "H"]
    sizes = _sizes(draft, (drawn.end.lengths[name] for name in names))
    return reach_of(drawn.train.scheme, dict(zip(names, sizes, strict=True)))


def reach_of(scheme: Scheme, radii: Mapping[str, float]) -> float:
    """Return the radius about the main axis that wheels take; ``radii``: by wheel, that of the axes as "H"."""
    rims = max(radii[rim] for rim in scheme.rims)
    if scheme.bevel:
        return max(radii.values())
    return max(radii["H"] + rims, *(radii[mesh.wheel] for mesh in scheme.meshes))


@dataclass(frozen=True)
class Planetary:
    """The train as drawn: what was asked and settled, μ_l, its sizes, views, picture and plan.

    ``results``: marks (Number) by the names under which tables give them: planetary_z1 …, planetary_satellites,
    planetary_ratio (Willis), planetary_ratio_drawn, planetary_difference (%); overall_ratio, where there is a
    ``pairs`` outside the train.
    """

    order: PlanetaryTask
    motion: Motion
    train: Train
    mu: Mark
    sizes: Dimensions
    end: EndView
    axial: AxialView
    picture: VelocityPicture
    rates: Rates
    results: Mapping[str, Mark]
    pairs: Pairs


PLANETARY_PLAN: Recorded[Planetary] = Recorded(PLANETARY_TRAIN)


def record(bench: Bench) -> Planetary | None:
    """Draw the train that the scene asks for, at a share of its usual size where there is one."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    share = bench.sizes.get(PLANETARY_TRAIN, 1.0)
    return draw_planetary(bench.draft, order, share)


def draw_planetary(draft: Draft, order: PlanetaryTask, size: float = 1.0) -> Planetary:
    """Draw the smallest train that fulfils an order, or the one whose tooth numbers it gives.

    The draft is the train's own: its positions are the satellites. The scale factors, the pole distance and the
    places of the views are chosen and kept in ``draft.given``; they may be replaced there. ``size``: what share
    of the usual room the views take.

    Raises
    ------
    StructureError
        If the order is not sound, no train fulfils it, or the one given breaks a condition.
    """
    train = choose(order)
    draft.open(VIEW)
    mu = draft.mu_l = draft.scale("μ_l", "m/mm")
    draft.lay_out()
    sizes = calculate_train(draft, order, train)
    end: EndView
    if train.scheme.bevel:
        end, axial = draw_side_view(draft, train, sizes)
    else:
        end = draw_end_view(draft, train, sizes)
        axial = draw_axial_view(draft, train, end)
    pairs = draw_pairs(draft, order, train.scheme, sizes, end)
    motion = motion_of(order)
    closing, turned = motion.closing, dict[str, Mark]()
    if closing is not None and closing.joint in motion.driving:
        drives = draft.take(Number, f"ω_{closing.joint}", motion.driving[closing.joint], "1/s")
        rows = closing_rows(order, train.scheme, closing)
        turned = draw_closing(draft, rows, sizes.outside, closing, drives)
    before = [*pairs.before.values()]
    picture = draw_picture(draft, motion, train.scheme, end, sizes, before, turned)
    if isinstance(end, BevelView):
        rates = draw_triangle(draft, motion, train, end, sizes, picture)
    else:
        rates = draw_rates(draft, motion, train, end, sizes, picture)
    found = "ratio" if sizes.ratio is not None else "omega"
    results = {f"planetary_z{wheel}": mark for wheel, mark in sizes.teeth.items()}
    results |= {
        "planetary_satellites": sizes.satellites,
        f"planetary_{found}": rates.due,
        f"planetary_{found}_drawn": rates.drawn,
    }
    if rates.difference is not None:
        apart = "difference" if sizes.ratio is not None else "omega_difference"
        results[f"planetary_{apart}"] = rates.difference
    if pairs.ratio is not None:
        results["overall_ratio"] = pairs.ratio
    choose_scales(draft, Drawn(order, motion, train, end, axial, picture, rates, pairs, size))
    return Planetary(order, motion, train, mu, sizes, end, axial, picture, rates, results, pairs)
