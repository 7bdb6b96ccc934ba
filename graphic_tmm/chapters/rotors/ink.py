"""A rotor in ink: along its axis with its masses at their angles, from the side with its planes."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Step
from graphic_tmm.chapters.rotors.plan import END, SIDE, Rotor
from graphic_tmm.language.numbers import number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import small
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Wanted, circle, line
from graphic_tmm.paper.figure import Manner, added, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.rules import laid_off
from graphic_tmm.paper.seen import Seen, Subject
from graphic_tmm.paper.symbols.dimensions import dimension
from graphic_tmm.paper.symbols.kinematic import channel

MASS = 2.2
"""Radius of a mass, mm."""
SHAFT, DISC, PLANE = 2.0, 14.0, 22.0
"""Half the thickness of the shaft, half the height of a disc, of a plane of counterweights, mm."""
BEARING = 9.0
"""Length of a bearing, mm."""
BEYOND = 8.0
"""How far axes go on behind what stands on them, mm."""
BELOW, PITCH = 30.0, 8.0
"""From the axis down to the first dimension, and from one to the next, mm."""


def _stays(seen: Seen, step: Step) -> bool:
    return step.op is lay_off


def draw_end(on: Subject, rotor: Rotor) -> Drawing:
    """Return the rotor along its axis: masses black, counterweights white."""
    seen = on.seen((END,), [0])
    weights = {one.name for one in rotor.weights}
    traces = figure(seen, Manner({lay_off.name: laid_off}, _stays))
    view = seen.construction.view(END)
    assert view is not None
    assert view.pole is not None
    centre = seen.point(view.pole, 0)
    spots = {name: seen.point(mark, 0) for name, mark in rotor.spots.items()}
    far = max(abs(spot - centre) for spot in spots.values()) + BEYOND
    strokes = [*traces.staying]
    axes: list[Ink] = [
        line("centre", centre - far * way, centre + far * way) for way in (1 + 0j, 1j)
    ]
    strokes += added(axes, "axis")
    strokes += body([circle("main", centre, SHAFT)], "shaft", [view.pole])
    for name, spot in spots.items():
        sign = circle("joint" if name in weights else "main", spot, MASS)
        sign = sign._replace(filled=name not in weights)
        strokes += body([sign], "mass", [rotor.spots[name]])
    names = [
        Named(spot, _letter(rotor, name, on.language), (rotor.spots[name].slot,))
        for name, spot in spots.items()
    ]
    wanted = lettered(shared(names), on.heights.point, MASS + 0.6, away_from=centre)
    wanted.append(Wanted("x", centre + far, on.heights.point, 1.0, 1j))
    return traces.drawing(on, strokes, wanted)


def _letter(rotor: Rotor, name: str, language: str) -> str:
    bare = any(row.number == name and row.mass is None for row in rotor.rows)
    return symbol(f"{'D' if bare else 'm'}_{{{name}}}", language)


def draw_side(on: Subject, rotor: Rotor) -> Drawing:
    """Return the rotor from the side: discs, planes, bearings, distances from the first of the planes."""
    seen = on.seen((SIDE,), [0])
    traces = figure(seen, Manner({}, lambda seen, step: False))
    spots = {name: seen.point(mark, 0) for name, mark in rotor.stations.items()}
    low, high = (f(spot.real for spot in spots.values()) for f in (min, max))
    every = tuple(rotor.stations.values())
    ends = complex(low - BEYOND), complex(high + BEYOND)
    strokes: list[Ink] = [*body([line("centre", ends[0] - 4.0, ends[1] + 4.0)], "axis", every)]
    shaft = [line("main", *(end + side * SHAFT * 1j for end in ends)) for side in (1, -1)]
    strokes += body(shaft, "shaft", every)
    for name, spot in spots.items():
        strokes += body(_station(rotor, name, spot), "station", [rotor.stations[name]])
    sizes, labels = _distances(on, rotor, spots)
    strokes += sizes
    wanted = [*_names(on, rotor, spots)]
    return traces.drawing(on, strokes, wanted, labels)


def _station(rotor: Rotor, name: str, spot: complex) -> Iterator[Ink]:
    """What stands at a place: a disc, a plane of counterweights, a bearing."""
    if name in rotor.bearings:
        yield from channel(spot, 0.0, BEARING, width=2 * SHAFT + 1.6)
    elif name in rotor.planes:
        yield line("centre", spot - PLANE * 1j, spot + PLANE * 1j)
    else:
        for side in (1, -1):
            yield line("main", spot + side * SHAFT * 1j, spot + side * DISC * 1j)


def _names(on: Subject, rotor: Rotor, spots: dict[str, complex]) -> Iterator[Wanted]:
    """The names at what stands there: of discs above them, of planes above these, of bearings below."""
    above: list[Named] = []
    for name, spot in spots.items():
        of = (rotor.stations[name].slot,)
        if name in rotor.bearings:
            at = spot - (SHAFT + 5.0) * 1j
            yield Wanted(name, at, on.heights.point, 1.0, -1j, of)
        else:
            high = PLANE if name in rotor.planes else DISC
            text = symbol(name, on.language) if name in rotor.planes else name
            above.append(Named(spot + high * 1j, text, of))
    yield from lettered(shared(above), on.heights.point, 1.0, away_from=None)


def _distances(
    on: Subject, rotor: Rotor, spots: dict[str, complex]
) -> tuple[list[Ink], list[Label]]:
    """The dimensions of what stands apart from plane I, or from bearing A; the longest lowest."""
    zero = next((name for name in ("I", "A") if name in spots), "")
    if not zero:
        return [], []
    places = {**rotor.planes, **rotor.bearings}
    places |= {row.number: row.at for row in rotor.rows if row.at is not None}
    apart = {
        name: spots[name].real - spots[zero].real
        for name in dict.fromkeys(spots)
        if abs(spots[name] - spots[zero]) > 0.3
    }
    strokes: list[Ink] = []
    labels: list[Label] = []
    levels = {True: 0, False: 0}
    done: list[float] = []
    for name in sorted(apart, key=lambda one: abs(apart[one])):
        if any(abs(apart[name] - one) < 0.3 for one in done):
            continue
        done.append(apart[name])
        right = apart[name] > 0
        way = on.reading[places[name]].ravel()[0] - on.reading[places[zero]].ravel()[0]
        text = number(abs(small(float(way), on.language)[0]), on.language)
        start, end = spots[zero], spots[name]
        if not right:
            start, end = end, start
        made = dimension(start, end, -(BELOW + PITCH * levels[right]), text, on.heights.number)
        levels[right] += 1
        of = (rotor.stations[zero].slot, rotor.stations[name].slot)
        strokes += [stroke._replace(of=of, part="dimension") for stroke in made.strokes]
        labels.append(made.label._replace(of=of))
    return strokes, labels
