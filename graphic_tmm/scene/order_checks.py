"""What the sections of diagrams say against themselves, against the drive and the sheets."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise
from typing import Any

from graphic_tmm.bounds import INTERVALS, OrderError
from graphic_tmm.scene import build_cam, build_wheels, letters
from graphic_tmm.scene.faults import Found
from graphic_tmm.scene.order_tables import DiagramsTable, IndicatorTable
from graphic_tmm.scene.sections import Document, Parts, raw_links, table

ASKED = {
    "diagrams": 'point = "D"',
    "flywheel": "delta = 0.04",
    "cam": 'stroke = "28 mm", rise = "100 deg", fall = "90 deg"',
    "gears": 'z1 = 15, z2 = 25, m = "8 mm"',
    "planetary": 'ratio = 4.55, module = "8 mm"',
}
"""Sections that a sheet can place, and what they begin with."""


def check(doc: Document, parts: Parts) -> Iterator[Found]:
    """Every contradiction of the sections that ask for more than plans."""
    if parts.diagrams is not None:
        yield from _point(doc, ("diagrams", "point"), parts.diagrams.point)
        yield from _row(parts, "diagrams")
        yield from _diagrams(parts.diagrams)
    if parts.indicator is not None:
        yield from _point(doc, ("indicator", "point"), parts.indicator.point)
        yield from _pressures(parts, parts.indicator)
    if parts.flywheel is not None:
        yield from _row(parts, "flywheel")
        if "indicator" not in doc and "forces" not in doc:
            says = "nothing drives or resists; write a section [indicator], or loads and [forces]"
            yield Found(("flywheel",), says)
    if parts.cam is not None:
        yield from list(build_cam.check(parts.cam)) or _refused("cam", build_cam.cam(parts.cam))
    if parts.gears is not None:
        yield from _refused("gears", build_wheels.gears(parts.gears))
    if parts.planetary is not None:
        if len(parts.planetary.behind) not in (0, 2):
            says = "the pair behind the train has two wheels; write [15, 25]"
            yield Found(("planetary", "behind"), says)
        if parts.planetary.ratio is None and not parts.planetary.teeth:
            says = "neither a ratio nor tooth numbers are given; write ratio = 4.55"
            yield Found(("planetary", "ratio"), says)
        else:
            yield from _refused("planetary", build_wheels.planetary(parts.planetary))
    yield from _placed(doc)


def _refused(part: str, order: Any) -> Iterator[Found]:
    """Yield what the plan of a part refuses of its order, before anything is drawn."""
    from graphic_tmm.chapters.cam.refusals import refuse
    from graphic_tmm.chapters.gears.refusals import refuse_order
    from graphic_tmm.chapters.planetary.task import scheme_of

    refusals: dict[str, Callable[[Any], object]] = {
        "cam": refuse,
        "gears": refuse_order,
        "planetary": scheme_of,
    }
    try:
        refusals[part](order)
    except OrderError as error:
        yield Found(error.key, error.says)


def _pressures(parts: Parts, made: IndicatorTable) -> Iterator[Found]:
    """Pressures that are not as many as the positions; a rod without its side."""
    count = parts.drive.positions if parts.drive is not None else None
    for side in ("cover", "shaft"):
        told = [k for k in (side, f"{side}_points", f"{side}_strokes") if getattr(made, k)]
        for other in told[1:]:
            says = f"{told[0]} gives the pressures of that side already; leave one of them out"
            yield Found(("indicator", other), says)
        if side == "cover" and not told:
            says = 'it is missing; write the pressures, ["300 kPa", ...], or cover_points, or cover_strokes'
            yield Found(("indicator", "cover"), says)
        yield from _stretches(made, side)
    for side in ("cover", "shaft"):
        given = getattr(made, side)
        if given is not None and count is not None and len(given) != count:
            says = f"{len(given)} pressures for {count} positions; give one for each, from the first on"
            yield Found(("indicator", side), says)
    others = made.shaft or made.shaft_points or made.shaft_strokes
    if made.rod is not None and not others:
        yield Found(
            ("indicator", "rod"), "it matters on the side of the shaft only; write shaft as well"
        )
    if made.rod is not None and made.rod >= made.bore:
        yield Found(("indicator", "rod"), "the rod is as thick as the cylinder; make it thinner")


def _point(doc: Document, path: tuple[str, ...], letter: str) -> Iterator[Found]:
    """A point that no moving link has."""
    there = [name for _, link in raw_links(doc) for name in table(link.get("points"))]
    if there and letter not in there:
        meant = letters.unknown(letter, there, "points of moving links")
        yield Found(path, f'"{letter[:20]}" is no point of a moving link{meant}')


def _row(parts: Parts, section: str) -> Iterator[Found]:
    drive = parts.drive
    if drive is not None and not INTERVALS.holds(drive.positions):
        says = f"a diagram needs {INTERVALS.least} positions at least, there are {drive.positions}"
        yield Found((section,), f"{says}; write positions = 12 in [drive]")


def _diagrams(made: DiagramsTable) -> Iterator[Found]:
    lengths = [key for key in ("base", "mu_t", "mu_phi") if getattr(made, key) is not None]
    for key in lengths[1:]:
        yield Found(
            ("diagrams", key), f"{lengths[0]} fixes the base already; leave one of them out"
        )
    other = {"time": ("mu_phi", "mu_t"), "angle": ("mu_t", "mu_phi")}[made.over]
    if other[0] in lengths:
        says = f'the diagrams are over {made.over}; write {other[1]}, or over = "'
        yield Found(("diagrams", other[0]), says + {"time": 'angle"', "angle": 'time"'}[made.over])
    for symbol in ("S", "V", "a"):
        if getattr(made, f"mu_{symbol}") is not None and getattr(made, f"H_{symbol}") is not None:
            says = f"H_{symbol} and mu_{symbol} both fix the same scale; leave one of them out"
            yield Found(("diagrams", f"H_{symbol}"), says)
    first = {"displacement": "S", "velocity": "V"}[made.start]
    if getattr(made, f"H_{first}") is not None:
        says = f"the diagram of {first} is laid off, not differentiated: it has no pole"
        yield Found(("diagrams", f"H_{first}"), f"{says}; write mu_{first}, or leave it out")


def _stretches(made: IndicatorTable, side: str) -> Iterator[Found]:
    """Points or strokes that do not go from the cover to the far end and back."""
    traced = getattr(made, f"{side}_points")
    if traced is not None:
        for way, ends in (("out", (0.0, 1.0)), ("back", (1.0, 0.0))):
            shares = [share for share, _ in getattr(traced, way)]
            steps = [b - a for a, b in pairwise(shares)]
            turned = any(step * (ends[1] - ends[0]) <= 0 for step in steps)
            if (shares[0], shares[-1]) != ends or turned:
                says = f"the shares of the stroke {way} go from {ends[0]:g} to {ends[1]:g}, one after the other"
                yield Found(("indicator", f"{side}_points", way), f"{says}; put them in order")
    reached = {"out": 0.0, "back": 1.0}
    strokes = getattr(made, f"{side}_strokes")
    for i, part in enumerate(strokes):
        if (part.to - reached[part.stroke]) * (1 if part.stroke == "out" else -1) <= 0:
            says = f"the stroke {part.stroke} has come to {reached[part.stroke]:g} already; go on from there"
            yield Found(("indicator", f"{side}_strokes", i, "to"), says)
        reached[part.stroke] = part.to
    if strokes and reached != {"out": 1.0, "back": 0.0}:
        says = "the parts of the stroke out have to end at 1, those of the stroke back at 0"
        yield Found(("indicator", f"{side}_strokes"), f"{says}; add the last part")
    if any(part.n > 0 for part in strokes) and not made.clearance > 0:
        says = "gas that is expanded or compressed needs the clearance"
        yield Found(("indicator", "clearance"), f"{says}; write clearance = 0.08")


def _placed(doc: Document) -> Iterator[Found]:
    """A sheet that places diagrams which the scene does not ask for."""
    sheets = doc.get("sheet")
    for i, sheet in enumerate(sheets if isinstance(sheets, list) else []):
        places = table(sheet).get("place")
        for section, what in ASKED.items():
            if isinstance(places, list) and section in places and section not in doc:
                says = f"nothing says what it is; write a section [{section}] with {what}"
                yield Found(("sheet", i, "place"), f'"{section}": {says}')
