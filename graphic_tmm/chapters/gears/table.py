"""The columns, results and tables of a gear pair: dimensions wheel by wheel, sliding on the line of action."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Angle, Reals
from graphic_tmm.chapters.gears.contact import Engagement
from graphic_tmm.chapters.gears.dimensions import VIEW, GearSizes
from graphic_tmm.chapters.gears.plan import GEARS_PLAN, Gear
from graphic_tmm.chapters.gears.record import BESIDE
from graphic_tmm.chapters.gears.shifts import letter_of
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.units import unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import Heights
from graphic_tmm.readers.columns import Column, Tabled, listed, measured_columns
from graphic_tmm.scene.captions import captions


def gear_results(drawn: Drawn) -> Results:
    """Return each result with its unit: those of the pair, those of each wheel with its number behind them.

    ``contact_ratio`` is that of the formula, ``contact_ratio_drawn`` ab over the base pitch as measured.
    """
    gear, reading = GEARS_PLAN.on(drawn), drawn.reading
    sizes, contact, beside = gear.sizes, gear.contact, BESIDE.on(drawn)
    found: dict[str, Mark | None] = {
        "gear_ratio": beside.ratio,
        "alpha_w": sizes.alpha_w,
        "a": sizes.a,
        "H" if sizes.rack else "a_w": sizes.a_w,
        "y": sizes.y,
        "delta_y": sizes.y and sizes.dy,
        "h": sizes.h,
        "h_w": sizes.h_w,
        "p": sizes.p,
        "p_b": sizes.p_b,
        "arc_of_engagement": beside.arc,
        "contact_ratio": sizes.contact_ratio,
        "contact_ratio_drawn": contact.drawn,
        "contact_ratio_difference": contact.difference,
    }
    marks = {name: mark for name, mark in found.items() if mark}
    for wheel, engaged in zip(sizes.wheels, contact.wheels, strict=True):
        own = {
            "r": wheel.r,
            "r_b": wheel.r_b,
            "r_w": wheel.r_w,
            "r_f": wheel.r_f,
            "r_a": wheel.r_a,
            "s": wheel.s,
            "s_a": wheel.s_a,
            "x_min": wheel.x_min,
            "arc_of_engagement": engaged.real,
        }
        marks |= {f"{name}{wheel.number}": mark for name, mark in own.items() if mark}
    marks |= {f"z_min{k}": mark for k, mark in enumerate(beside.z_min, 1)} | _further(drawn)
    return {name: (reading[mark][:, 0].copy(), _unit_of(mark)) for name, mark in marks.items()}


def _further(drawn: Drawn) -> dict[str, Mark]:
    """Return the results that only some pairs have: shifts that follow, a ring's, a helix, a motion."""
    gear, beside = GEARS_PLAN.on(drawn), BESIDE.on(drawn)
    sizes, found = gear.sizes, dict(beside.helical)
    if sizes.x_sum is not None:
        found |= {"x_sum": sizes.x_sum} | {f"x{w.number}": w.x for w in sizes.wheels}
    if sizes.helix is not None:
        found |= {"m_t": sizes.module, "alpha_t": sizes.alpha}
        found |= {f"x_t{w.number}": w.x_drawn for w in sizes.wheels}
    if (ring := sizes.ring) is not None:
        found |= {"r_a2_least": ring.least_tip, "tip_overlap": ring.overlap}
        found |= {"assembly_gap": ring.assembly}
        if ring.uncut is not None:
            found["contact_ratio_uncut"] = ring.uncut
    if sizes.rack is not None and gear.rack is not None:
        rack = sizes.rack
        found |= {"x1": sizes.wheels[0].x, "travel": rack.travel, "s2": rack.s, "s_a2": rack.s_a}
        found |= {"h_a2": rack.h_a, "h_f2": rack.h_f, "arc_of_engagement2": gear.rack.engaged.real}
    if (motion := beside.motion) is not None:
        for k, (omega, turns) in enumerate(zip(motion.omega, motion.turns, strict=True), 1):
            found |= {f"omega{k}": omega, f"n{k}": turns}
        found["v_rolling"] = motion.rolling
        for name, (speed, share) in motion.sliding.items():
            if name not in "sP":
                found |= {f"v_s{name}": speed, f"v_s{name}_ratio": share}
    return found


class Station(NamedTuple):
    """A place: its name; x from N1 (mm on the sheet), ϑ of both wheels, (trial,), −∞ at the own limit.

    ``speeds``: where the speed is given that of sliding (m/s), and over that of the rolling circles.
    """

    name: str
    x: Reals
    sliding: tuple[Reals, Reals]
    speeds: tuple[Reals, Reals] | None = None


def stations(drawn: Drawn) -> list[Station]:
    """Return the places from N1 to N2, of a ring to b."""
    return sorted(map(_moving(drawn), _places(drawn)), key=lambda one: float(one.x[0]))


def _moving(drawn: Drawn) -> Callable[[Station], Station]:
    """Return what tells of a place how fast the flanks slide there."""
    motion, reading, ends = BESIDE.on(drawn).motion, drawn.reading, GEARS_PLAN.on(drawn).line.ends
    if motion is None:
        return lambda one: one
    limits = dict(zip("ab", (end.name.translate(_BARE) for end in ends), strict=True))

    def speeds_at(one: Station) -> Station:
        name, k = one.name.translate(_BARE), 0
        if name.isdigit():
            name, k = "s", int(name) - 1
        marks = motion.sliding[name if name in motion.sliding else limits[name]]
        speed, share = (reading[mark][:, k] for mark in marks)
        return one._replace(speeds=(speed, share))

    return speeds_at


def _places(drawn: Drawn) -> Iterator[Station]:
    gear, beside, reading = GEARS_PLAN.on(drawn), BESIDE.on(drawn), drawn.reading
    sliding = gear.sliding

    def falls(end: Reals) -> Reals:
        return np.full_like(end, -np.inf)

    first, *others = (reading[mark][:, 0] for mark in beside.limits)
    at_limits = [Station("N_{1}", reading[beside.start][:, 0], (falls(first), first))]
    for second in others:
        x = reading[gear.line.length][:, 0]
        at_limits.append(Station("N_{2}", x, (second, falls(second))))
    yield from at_limits[: 1 if gear.sizes.ring else 2]
    for name, end in zip("ab", gear.line.ends, strict=True):
        if end in gear.line.limits:
            yield at_limits[gear.line.limits.index(end)]._replace(name=name)
    for name, one in (*sliding.ends.items(), ("P", sliding.pole)):
        x, *found = (reading[mark][:, 0] for mark in (one.x, *one.sliding))
        if one is sliding.pole:  # neither slides there, whatever the ruler makes of x
            found = [np.zeros_like(row) for row in found]
        yield Station(name, x, (found[0], found[1]))
    if sliding.further is not None:
        marks = (sliding.further.x, *sliding.further.sliding)
        for k in range(len(gear.order.stations)):
            x, *found = (reading[mark][:, k] for mark in marks)
            yield Station(str(k + 1), x, (found[0], found[1]))


PLACES = 3
"""Decimals of lengths in mm and of coefficients."""
DIGITS = 4
"""Figures of an angle, of a contact ratio and of a sliding."""


def dimension_table(drawn: Drawn, language: str, title: str, heights: Heights) -> Drawing:
    """Return the dimensions: those of the wheels side by side, then those of the pair; and as drawn."""
    words, made, beside = captions(language), GEARS_PLAN.on(drawn), BESIDE.on(drawn)
    reading = drawn.reading

    def row(symbol: str, own: Mark, *mates: Mark) -> list[str]:
        real = [_cell(reading, mark, language) for mark in (own, *mates)]
        laid = [_drawn(reading, beside.drawn.get(mark), language) for mark in (own, *mates)]
        gap = [""] * (1 - len(mates))
        return [symbol, *real, *gap, _unit(own, language), *laid, *gap]

    rows = [row(symbol, *marks) for symbol, _, marks in wheel_sizes(drawn)]
    rows.append(row("cd", *(one.real for one in _engaged(made))))
    rows += [row(symbol, mark) for symbol, _, mark in pair_sizes(drawn)]
    _ = speaking(language)
    laid = [_("{wheel}, drawn,\nmm", wheel=k) for k in (1, 2)]
    heads = [words["value"], "1", "2", words["unit"], *laid]
    align = ["left", "centre", "centre", "left", "centre", "centre"]
    return breakable(
        "table-gear",
        title,
        heads,
        rows,
        again=words["continued"],
        size=heights.number,
        title_size=heights.title,
        align=align,
    )


WHEEL = (
    ("z", "z"), ("x", "x"), ("r", "r"), ("r_{b}", "r_b"), ("r_{w}", "r_w"), ("r_{f}", "r_f"),
    ("r_{a}", "r_a"), ("s", "s"), ("s_{a}", "s_a"), ("x_{min}", "x_min"),
)  # fmt: skip
"""What the table tells of a wheel: the symbol, the name in its sizes."""


def wheel_sizes(drawn: Drawn) -> Iterator[tuple[str, str, list[Mark]]]:
    """Yield what the table tells of the wheels: the symbol, the name that machines read, the marks."""
    sizes, helical = GEARS_PLAN.on(drawn).sizes, BESIDE.on(drawn).helical
    for symbol, key in WHEEL:
        bodies = (*sizes.wheels, *([sizes.rack] if sizes.rack else []))
        marks = [mark for body in bodies if (mark := getattr(body, key, None))]
        yield letter_of(sizes.order, symbol), key, marks
        if key == "x" and sizes.helix is not None:
            yield "x_{t}", "x_t", [wheel.x_drawn for wheel in sizes.wheels]
            yield "z_{v}", "z_v", [helical[f"z_v{wheel.number}"] for wheel in sizes.wheels]


def pair_sizes(drawn: Drawn) -> tuple[tuple[str, str, Mark], ...]:
    """Return what the table tells of the pair: the symbol, the name that machines read, the mark."""
    made, beside = GEARS_PLAN.on(drawn), BESIDE.on(drawn)
    sizes, helix, helical = made.sizes, made.sizes.helix, beside.helical
    found = [("u_{12}", "gear_ratio", beside.ratio)] if beside.ratio else []
    found.append(("m", "m", sizes.m))
    if helix is not None:
        found += [("β", "beta", helix.beta), ("m_{t}", "m_t", helix.m)]
        found.append(("α_{t}", "alpha_t", helix.alpha))
    if sizes.x_sum is not None:
        found.append(("x_{Σ}", "x_sum", sizes.x_sum))
    found += [
        *_distances(sizes), ("h", "h", sizes.h), ("h_{w}", "h_w", sizes.h_w),
        ("p", "p", sizes.p), ("p_{b}", "p_b", sizes.p_b),
        ("s_{cd}", "arc_of_engagement", beside.arc),
        ("ε_{α}", "contact_ratio", sizes.contact_ratio),
    ]  # fmt: skip
    if "overlap_ratio" in helical:
        found.append(("ε_{β}", "overlap_ratio", helical["overlap_ratio"]))
        found.append(("ε_{γ}", "total_ratio", helical["total_ratio"]))
    if (motion := beside.motion) is not None:
        found += [(f"n_{{{k}}}", f"n{k}", turns) for k, turns in enumerate(motion.turns, 1)]
        found.append(("v", "v_rolling", motion.rolling))
    base = letter_of(sizes.order, "p_{b}")
    found.append((f"{working(drawn)}/{base}", "contact_ratio_drawn", made.contact.drawn))
    return tuple((letter_of(sizes.order, symbol), key, mark) for symbol, key, mark in found)


def _distances(sizes: GearSizes) -> list[tuple[str, str, Mark]]:
    """Return the angle of mesh and the distances; of a rack how far its teeth reach, its travel in a turn."""
    angle = ("α_{w}", "alpha_w", sizes.alpha_w)
    if (rack := sizes.rack) is not None:
        far = [("H", "H", sizes.a_w), ("h_{a2}", "h_a2", rack.h_a), ("h_{f2}", "h_f2", rack.h_f)]
        return [angle, *far, ("L", "travel", rack.travel)]
    apart = (("a_{w}", "a_w", sizes.a_w), ("y", "y", sizes.y), ("Δy", "delta_y", sizes.dy))
    return [angle, *((symbol, key, mark) for symbol, key, mark in apart if mark)]


def _engaged(made: Gear) -> tuple[Engagement, ...]:
    """Return the arcs of engagement of both wheels, or of wheel and rack."""
    return (*made.contact.wheels, *([made.rack.engaged] if made.rack else []))


def working(drawn: Drawn) -> str:
    """Return what the working part of the line of action is called: ab, or N₁b where a is the limit N₁."""
    return "".join(end.letter for end in GEARS_PLAN.on(drawn).line.ends)


def _cell(reading: Reading, mark: Mark, language: str) -> str:
    value = float(reading[mark][0, 0])
    if mark.unit == "m":
        return fixed(1000.0 * value, PLACES, language)
    return number(value, language, DIGITS)


def _drawn(reading: Reading, mark: Mark | None, language: str) -> str:
    return "" if mark is None else fixed(float(reading[mark][0, 0]), 1, language)


def _unit(mark: Mark, language: str) -> str:
    if mark.kind is Angle:
        return unit("°", language)
    return unit("mm" if mark.unit == "m" else mark.unit, language)


def sliding_table(drawn: Drawn, language: str, title: str, heights: Heights) -> Drawing:
    """Return x (mm on the drawing) and both slidings at N1, a, P, b, N2, and at the stations of the task."""
    words, places = captions(language), stations(drawn)
    cells = [fixed(float(one.x[0]), 1, language) for one in places]
    rows = [["x", unit("mm", language), *cells]]
    for k in (0, 1):
        cells = [_sliding(float(one.sliding[k][0]), language) for one in places]
        rows.append([f"ϑ_{{{k + 1}}}", "", *cells])
    for k, symbol, of in ((0, "v_{s}", "m/s"), (1, "v_{s}/v", "")):
        speeds = [one.speeds for one in places if one.speeds]
        if speeds:
            cells = [number(float(one[k][0]), language, DIGITS) for one in speeds]
            rows.append([symbol, unit(of, language) if of else "", *cells])
    heads = [words["value"], words["unit"], *(one.name for one in places)]
    align = ["left", "left", *["centre"] * len(places)]
    return breakable(
        "table-sliding",
        title,
        heads,
        rows,
        again=words["continued"],
        size=heights.number,
        title_size=heights.title,
        lead=2,
        align=align,
    )


def _sliding(value: float, language: str) -> str:
    if value in (0.0, -math.inf):
        return "−∞" if value else "0"
    return fixed(value, 2 if abs(value) > 4.0 else 3, language)


SLIDING = "sliding-table"
"""The plan of the table of specific sliding; the diagram is another."""
_BARE = str.maketrans("", "", "_{}")
"""What letters lose where they are typed: N_{1} is N1."""


def gear_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return what was measured, the dimensions of the wheels and of the pair, the sliding at named places."""
    return (*measured_columns(drawn), *_dimensions(drawn), *_sliding_columns(drawn))


def _dimensions(drawn: Drawn) -> Iterator[Column]:
    made, reading, laid = GEARS_PLAN.on(drawn), drawn.reading, BESIDE.on(drawn).drawn

    def column(symbol: str, key: str, heads: tuple[str, ...], *marks: Mark) -> Column:
        figures = [reading.figure(mark)[:, 0] for mark in marks]
        lengths = [reading.figure(laid[mark])[:, 0] for mark in marks if mark in laid]
        return listed(VIEW, key, symbol, _unit_of(marks[0]), figures, heads, lengths)

    for symbol, key, marks in wheel_sizes(drawn):
        yield column(symbol, key, ("1", "2")[: len(marks)], *marks)
    arcs = (one.real for one in _engaged(made))
    yield column("cd", "arc_of_engagement_drawn", ("1", "2"), *arcs)
    for symbol, key, mark in pair_sizes(drawn):
        # a word of the catalogue, as results are called
        yield column(key if "/" in symbol else symbol, key, (), mark)


def _sliding_columns(drawn: Drawn) -> Iterator[Column]:
    places = stations(drawn)
    heads, x = [place.name.translate(_BARE) for place in places], [place.x for place in places]
    mu = drawn.scales["gear"].value
    yield listed(SLIDING, "x", "x", "m", [mu * one for one in x], heads, x)
    for k in (0, 1):
        figures = [place.sliding[k] for place in places]
        yield listed(SLIDING, f"theta{k + 1}", f"ϑ_{{{k + 1}}}", "", figures, heads)
    for k, key, symbol, of in ((0, "v_s", "v_{s}", "m/s"), (1, "v_s_ratio", "v_{s}/v", "")):
        figures = [place.speeds[k] for place in places if place.speeds]
        if figures:
            yield listed(SLIDING, key, symbol, of, figures, heads)


def _unit_of(mark: Mark) -> str:
    return "°" if mark.kind is Angle else mark.unit


TABLE = Tabled(columns=gear_columns, results=gear_results)
