"""What a task asks of forces, what it gives of loads that vary, and how it shows loads."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from graphic_tmm.chapters.forces.directions import all_letters, owner_of, two_letters
from graphic_tmm.chapters.forces.given import given, stated, wanted_positions
from graphic_tmm.chapters.forces.kinds import Along
from graphic_tmm.chapters.forces.load_diagrams import letters, varies, with_opposites
from graphic_tmm.chapters.forces.spring_signs import draw_ink, letter_of, middle
from graphic_tmm.chapters.forces.springs import ends_of, numbers
from graphic_tmm.chapters.forces.task import AGAINST, ASKED, Load, Spring, Travel, Unknown
from graphic_tmm.chapters.forces.tool import letter_of as sought_letter
from graphic_tmm.chapters.forces.travel import end_of
from graphic_tmm.chapters.indicator import given as gas
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.paper.drawing import Wanted
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.paper.symbols.kinematic import round_arrow
from graphic_tmm.readers.task_sheet import (
    Acting,
    Listed,
    LoadSign,
    Posed,
    TaskSheet,
    by_positions,
    given_figure,
)
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.values import CLOCKWISE, COUNTERCLOCKWISE

LONG = 22.0
"""How long the arrow of a force is, mm: it passes the edge of a slider."""
ROUND, SWEEP = 9.0, 90.0
"""Radius of the arrow of a moment, mm; it goes over so many degrees."""
BESIDE = 8.0
"""How far from the middle of a spring its letter begins, mm."""


def polygons(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the reactions and the balancing force."""
    _ = speaking(language)
    yield wanted_positions(scene, language) or _(_EVERYWHERE)
    yield _(_POLYGONS if _sought(scene) is None else _TOOL)


def lever(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the lever."""
    yield speaking(language)(BY_LEVER if _sought(scene) is None else _TOOL_BY_LEVER)


def _sought(scene: Scene) -> Unknown | None:
    order = ASKED.of(scene)
    return order.unknown if order is not None else None


_EVERYWHERE = said("Forces are found in all positions.")
_POLYGONS = said(
    "Reactions in all pairs are found by polygons of forces, group by group; the balancing force is found."
)
_TOOL = said(
    "With the unknown force that the lever gives, reactions in all pairs are found by polygons of forces, "
    "group by group; what drives must be left with nothing to balance it."
)
_TOOL_BY_LEVER = said(
    "The unknown force and the mechanical advantage are found by Zhukovsky's lever."
)
BY_LEVER = said("The balancing force is found by Zhukovsky's lever as well.")
_SHARE = said("{letter} by the travel of point {point}, from the zero position")
_SHARE_OUTER = said(
    "{letter} by the travel of point {point}, from its dead centre away from the crank"
)
_SHARE_AT = said("{letter} by the travel of point {point}, from its dead centre {at}")
_LINE = said(
    "{letter} by the travel of point {point} along the line at {angle}°, from its end {at}"
)
_LINE_BACK = said(
    "{letter} by the travel of point {point} along the line at {angle}°, on the way back"
)
_SWING = said("{letter} by the swing of link {point}, from its end {at}")
_SWING_BACK = said("{letter} by the swing of link {point}, on the way back")
AT = {
    "left": said("at left", context="dead centre"),
    "right": said("at right", context="dead centre"),
    "top": said("at top", context="dead centre"),
    "bottom": said("at bottom", context="dead centre"),
    CLOCKWISE: said("clockwise", context="dead centre"),
    COUNTERCLOCKWISE: said("counterclockwise", context="dead centre"),
    "": said("in the zero position", context="dead centre"),
}
_BACK = said("{letter} by the travel of point {point}, on the way back")
_ANGLE = said("{letter} by the turn of the crank from the zero position")
_TIME = said("{letter} by the time from the zero position")
_PLACES = said("{letter} by positions")


def listed(scene: Scene, language: str) -> Iterator[Listed]:
    """Yield the tables of loads that vary: by shares of a stroke, by angles, by positions."""
    order = ASKED.of(scene)
    if order is None:
        return
    for letter, load in zip(letters(order.loads), order.loads, strict=True):
        if varies(load):
            yield from _by_points(scene, symbol(letter, language), load, language)
    yield from gas.listed(order.gas, scene, language)


def _by_points(scene: Scene, called: str, load: Load, language: str) -> Iterator[Listed]:
    _ = speaking(language)
    told = unit("N·m" if load.point is None else "N", language)
    name, row = f"load-{load.link}", f"{markup(called)}, {told}"
    if load.travel is not None:
        travel, first = load.travel, _begun(scene, load.travel)
        at = _(AT[end_of(scene, travel) if not travel.slides else travel.start])
        angle = given_figure(travel.along or 0.0, language)
        for way, says in zip((travel.out, travel.back), first, strict=True):
            if way:
                point = markup(str(travel.of))
                title = _(says, letter=markup(called), point=point, at=at, angle=angle)
                yield _across(name, title, "s/S", row, way, language)
    elif load.by_time:
        title = _(_TIME, letter=markup(called))
        yield _across(name, title, f"t, {unit('s', language)}", row, load.by_time, language)
    elif load.by_angle:
        title = _(_ANGLE, letter=markup(called))
        yield _across(name, title, "φ, °", row, load.by_angle, language)
    elif isinstance(load.size, tuple):
        title = _(_PLACES, letter=markup(called))
        yield from by_positions(name, title, [(row, load.size)], scene, language)


def _begun(scene: Scene, travel: Travel) -> tuple[str, str]:
    """Return how to tell from where a travel is counted, out and back."""
    if isinstance(travel.of, int):
        return _SWING, _SWING_BACK
    if travel.along is not None:
        return _LINE, _LINE_BACK
    if travel.start:
        return _SHARE_AT, _BACK
    return (_SHARE_OUTER if end_of(scene, travel) else _SHARE), _BACK


def _across(
    name: str,
    title: str,
    head: str,
    row: str,
    points: Sequence[tuple[float, float]],
    language: str,
) -> Listed:
    """Return a table of two rows: where, and how much."""
    heads = (head, *(given_figure(at, language) for at, _ in points))
    return Listed(
        name, title, heads, ((row, *(given_figure(size, language) for _, size in points)),)
    )


def acting(scene: Scene, posed: Posed) -> Iterator[Acting]:
    """Yield the loads as arrows at their points, those against a motion the other way."""
    order, mechanism = ASKED.of(scene), scene.mechanism
    if order is None or mechanism is None:
        return
    for (letter, other), load in zip(with_opposites(order.loads), order.loads, strict=True):
        number = load.opposite if load.opposite != mechanism.frame.number else None
        if load.point is not None:
            way = _way(posed, load, load.point, mechanism)
            yield _force(posed, letter, load.link, load.point, way)
            if number is not None:
                at = load.opposite_at
                on = (load.link, load.point) if at is None else (number, at)
                yield _force(posed, other, *on, -way)
        else:
            yield from _moment(posed, letter, load, mechanism.by_number[load.link])
            if number is not None:
                back = replace(load, link=number, size=-max(_sizes(load), key=abs))
                yield from _moment(posed, other, back, mechanism.by_number[number])
    for index, spring in zip(numbers(order.springs), order.springs, strict=True):
        yield _spring(posed, spring, mechanism, index)
    if posed.weights and order.gravity:
        yield from _weights(posed, mechanism)
    if (sought := order.unknown) is not None:
        way = _way(posed, sought, sought.point, mechanism)
        yield _force(posed, sought_letter(sought), sought.link, sought.point, way)
    yield from gas.acting(order.gas, scene, posed)


def _spring(posed: Posed, spring: Spring, mechanism: Mechanism, index: str) -> Acting:
    """Return a spring between its ends, with the letter of what it is given by."""
    ends = ends_of(spring, mechanism)
    start, end = (posed.spot(*one)[0] for one in zip(ends.letters, ends.links, strict=True))
    strokes = draw_ink(spring, mechanism, start, end)
    at = middle(spring, mechanism, start, end)
    letter = letter_of(spring, index)
    told = Wanted(letter, at, posed.size, BESIDE, 1j * (end - start))
    inked = tuple(one._replace(part="load") for one in strokes)
    return Acting(inked, (told,), LoadSign(letter, start, end=end))


def _weights(posed: Posed, mechanism: Mechanism) -> Iterator[Acting]:
    for link in mechanism.links:
        if link.mass and link.centre is not None:
            yield _force(posed, f"G_{link.number}", link.number, link.centre, -1j)


def _way(posed: Posed, load: Load | Unknown, point: str, mechanism: Mechanism) -> complex:
    """Return the direction of a force; 0 of a resistance at a point that stands."""
    match load.direction:
        case Along():
            return _along(posed, load.direction, mechanism)
        case str():
            return -posed.spot(point, load.link)[1]
        case degrees:
            return cmath.rect(1.0, math.radians(degrees))


def _force(posed: Posed, letter: str, link: int, point: str, way: complex) -> Acting:
    at, _ = posed.spot(point, link)
    sign = LoadSign(letter, at, way)
    if not way:
        return Acting((), (), sign)
    strokes = tuple(one._replace(part="load") for one in arrow(at, at + LONG * way, "main"))
    return Acting(strokes, (Wanted(markup(letter), at + LONG * way, posed.size, 1.5, way),), sign)


def _along(posed: Posed, along: Along, mechanism: Mechanism) -> complex:
    """Return the direction of a load that turns with the links; 0 where its two points are one."""
    pair = two_letters(along.line, all_letters(mechanism))
    if pair is not None:
        links = mechanism.by_number.items()
        on = (next(k for k, link in links if letter in link.points) for letter in pair)
        start, end = (posed.spot(letter, link)[0] for letter, link in zip(pair, on, strict=True))
        way = (end - start) / (abs(end - start) or 1.0)
    else:
        number, guide = owner_of(along.line, mechanism)
        way = posed.turn(number) * turn(guide.angle)
    return way * turn(along.by)


def _moment(posed: Posed, letter: str, load: Load, link: Link) -> Iterator[Acting]:
    spots = [posed.spot(point, load.link) for point in link.points]
    if not spots:
        return
    (first, gone), *others = spots
    turning = sum(((at - first).conjugate() * (going - gone)).imag for at, going in others)
    sense = -math.copysign(1.0, turning) if load.direction == AGAINST else _sense(_sizes(load))
    middle = (first + others[0][0]) / 2 if others else first
    strokes = round_arrow(middle, ROUND, -SWEEP / 2 if sense > 0 else SWEEP / 2, sense * SWEEP)
    inked = tuple(one._replace(part="load") for one in strokes)
    wanted = Wanted(markup(letter), middle + ROUND, posed.size, 1.5, 1 + 0j)
    yield Acting(inked, (wanted,), LoadSign(letter, middle, turns=int(sense)))


def _sizes(load: Load) -> Sequence[float]:
    return load.size if isinstance(load.size, tuple) else (load.size,)


def _sense(sizes: Sequence[float]) -> float:
    return math.copysign(1.0, max(sizes, key=abs, default=1.0))


TASK_SHEET = TaskSheet(
    given=given,
    stated=stated,
    listed=listed,
    acting=acting,
    wanted={"forces": polygons, "lever": lever},
)
