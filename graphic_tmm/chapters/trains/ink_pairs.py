"""Wheels outside a planetary train along its axis: rows on its shafts, the shafts and bearings of others."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.paper.drawing import Stroke, line
from graphic_tmm.paper.symbols.kinematic import FIX, Strokes, gear_side, hatching

WIDTH = 8.0
"""Width of a wheel, mm."""
BEARING, GAP = 6.0, 1.8
"""Length of a bearing, and from the shaft to its lines, mm."""
OWN, BESIDE = 13.0, 8.0
"""How far the shaft of a wheel behind the train reaches to either side of it, where its bearings stand, mm."""
HOLLOW = 4.0
"""Radius of the bore of a wheel through which the shaft of the carrier goes, mm."""
STUB = 2.5
"""How far a shaft goes on behind its last wheel, mm."""


RACK = 4.0
"""Height of the section of a rack, mm."""


class Side(NamedTuple):
    """A wheel from its side: two opposite points of its pitch circle and its centre."""

    near: complex
    far: complex
    centre: complex

    @property
    def radius(self) -> float:
        """Its radius, mm."""
        return abs(self.near - self.centre)


class SideRows(NamedTuple):
    """Rows of wheels on the shaft of a member, from the train outward; each by the numbers of its wheels."""

    member: str
    rows: tuple[dict[str, Side], ...]

    @property
    def first(self) -> Side:
        """The wheel on the shaft of the train."""
        return next(iter(self.rows[0].values()))


def wheels_of(outside: Sequence[SideRows]) -> dict[str, Side]:
    """Return all wheels by their numbers."""
    return {name: wheel for view in outside for row in view.rows for name, wheel in row.items()}


def racks_of(outside: Sequence[SideRows]) -> dict[str, tuple[str, complex]]:
    """Return each rack: its number, its wheel's, where both touch: a wheel by itself in its row drives one."""
    return {
        str(int(name) + 1): (name, wheel.near)
        for view in outside
        for row in view.rows
        for name, wheel in row.items()
        if len(row) == 1
    }


def draw_outside(
    outside: Sequence[SideRows], *, joined: bool, hollow: Sequence[Side]
) -> Iterator[tuple[str, Strokes]]:
    """Yield the wheels, each with the shaft that it brings: the last of a row carries the next row, too.

    ``joined``: the last wheels of two views stand on one shaft. ``hollow``: those on the train's hollow one.
    """
    ends = [[*view.rows[-1]][-1] for view in outside] if joined else []
    for view in outside:
        after = [next(iter(row.values())) for row in view.rows[1:]]
        for row, carried in zip(view.rows, [*after, None], strict=True):
            last = [*row][-1]
            for k, (name, wheel) in enumerate(row.items()):
                strokes = gear_side(wheel.centre, wheel.radius, WIDTH, fixed=wheel not in hollow)
                if wheel in hollow:
                    strokes = (*strokes, *_on_hollow(wheel.centre))
                other = carried if carried is not None and name == last else wheel
                if name in ends:
                    other = wheels_of(outside)[ends[-1]]
                shaft = k > 0 and (name not in ends or name == ends[0])
                yield name, (*strokes, *(_shaft(wheel.centre, other.centre) if shaft else ()))
    for name, (_, at) in racks_of(outside).items():
        yield name, _rack(at)


def _rack(at: complex) -> Strokes:
    """The section of a rack below its wheel: it runs square to the paper."""
    left, right, deep = at - WIDTH / 2, at + WIDTH / 2, RACK * 1j
    outline = line("main", left, right, right - deep, left - deep, closed=True)
    return (outline, *hatching(left - deep, right - deep, 1))


def _on_hollow(at: complex) -> Iterator[Stroke]:
    """What fixes a wheel to a hollow shaft: a cross on each of its lines, none on the shaft within."""
    for side in (at + 1j * HOLLOW, at - 1j * HOLLOW):
        for way in (FIX * (1 + 1j), FIX * (1 - 1j)):
            yield line("main", side - way, side + way)


def occupied(outside: Sequence[SideRows]) -> list[tuple[float, float, float, float]]:
    """Return the rooms (left, bottom, right, top) of the wheels outside the train, with their shafts."""
    half, driving = WIDTH / 2 + OWN + STUB, [wheel for wheel, _ in racks_of(outside).values()]
    return [
        (x - half, min(y) - STUB - (RACK if name in driving else 0.0), x + half, max(y) + STUB)
        for name, wheel in wheels_of(outside).items()
        for x, y in [(wheel.centre.real, (wheel.near.imag, wheel.far.imag))]
    ]


def _shaft(one: complex, other: complex) -> Strokes:
    """The shaft of one wheel, or of two, on a bearing at either side."""
    left, right = sorted((one, other), key=lambda z: z.real)
    ends = left - WIDTH / 2 - OWN, right + WIDTH / 2 + OWN
    bearings = (bearing(left - WIDTH / 2 - BESIDE), bearing(right + WIDTH / 2 + BESIDE))
    return (line("main", *ends), *(stroke for one in bearings for stroke in one))


def bearing(at: complex) -> Strokes:
    """A bearing of the frame on a level shaft."""
    strokes: list[Stroke] = []
    for sense in (1, -1):
        start, end = (at + 1j * sense * GAP + x for x in (-BEARING / 2, BEARING / 2))
        strokes.append(line("main", start, end))
        strokes += hatching(start, end, sense)
    return tuple(strokes)
