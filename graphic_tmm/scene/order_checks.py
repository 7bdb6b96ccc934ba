"""What the sections of diagrams say against themselves, against the drive and the sheets."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.scene import letters
from graphic_tmm.scene.faults import Found
from graphic_tmm.scene.order_tables import DiagramsTable, IndicatorTable
from graphic_tmm.scene.sections import Document, Parts, raw_links, table

LEAST = 4
"""Positions that a diagram needs."""


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
        if "indicator" not in doc:
            says = "nothing drives the machine; write a section [indicator] with the pressures"
            yield Found(("flywheel",), says)
    yield from _placed(doc)


def _pressures(parts: Parts, made: IndicatorTable) -> Iterator[Found]:
    """Pressures that are not as many as the positions; a rod without its side."""
    count = parts.drive.positions if parts.drive is not None else None
    for side in ("cover", "shaft"):
        given = getattr(made, side)
        if given is not None and count is not None and len(given) != count:
            says = f"{len(given)} pressures for {count} positions; give one for each, from the first on"
            yield Found(("indicator", side), says)
    if made.rod is not None and made.shaft is None:
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
    if drive is not None and drive.positions < LEAST:
        says = f"a diagram needs {LEAST} positions at least, there are {drive.positions}"
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


def _placed(doc: Document) -> Iterator[Found]:
    """A sheet that places diagrams which the scene does not ask for."""
    sheets = doc.get("sheet")
    for i, sheet in enumerate(sheets if isinstance(sheets, list) else []):
        places = table(sheet).get("place")
        for section, what in (("diagrams", 'point = "D"'), ("flywheel", "delta = 0.04")):
            if isinstance(places, list) and section in places and section not in doc:
                says = f"nothing says what it is; write a section [{section}] with {what}"
                yield Found(("sheet", i, "place"), f'"{section}": {says}')
