"""On which side, or near which place, groups stand as a sketch lies."""

from __future__ import annotations

from dataclasses import replace

from graphic_tmm.mechanism.driven import Driven
from graphic_tmm.mechanism.groups import AssurGroup, Group, Pair, laid
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import TURN, Link, Mechanism, Near, Side


def put_near(
    links: dict[int, Link],
    group: AssurGroup,
    drawn: Mechanism,
    first: Driven,
    lies: tuple[float, float],
) -> None:
    """Say near which place a plate is that does not say it; ``lies``: its own x axis, the crank, degrees."""
    angle, at = lies
    coordinate: float | None = at
    if first.telescopes:
        cylinder, rod = rod_ends(drawn, first.pair)
        coordinate = abs(rod - cylinder)
    elif first.drive.slides:
        coordinate = None
    number = laid(group, links)
    links[number] = replace(links[number], near=links[number].near or Near(angle, coordinate))


def pin_ends(drawn: Mechanism, group: Group) -> tuple[complex, complex]:
    """Return the two points whose way along the guide tells the side of a group of kind 2 or 3, as they lie."""
    first, second = group.legs
    by_number = drawn.by_number
    if group.kind == 2:
        pivot, pin = first.pair.name, group.inner.name
        return by_number[first.link].points[pivot], by_number[first.link].points[pin]
    stone, rocker = (by_number[leg.link].points[leg.pair.name] for leg in (first, second))
    return rocker, stone


def rod_ends(drawn: Mechanism, pair: Pair) -> tuple[complex, complex]:
    """Return the pivot of a cylinder and the pin of its rod, as they lie."""
    bodies = drawn.by_number
    letters = [letter for one in bodies.values() for letter in one.points]
    rod, cylinder = (
        next(z for letter, z in bodies[n].points.items() if letters.count(letter) > 1)
        for n in pair.links
    )
    return cylinder, rod


def put_along(
    links: dict[int, Link],
    pair: Pair,
    ends: tuple[complex, complex],
    drawn: Mechanism,
    degrees: float,
) -> float:
    """Give a sliding pair the side on which its second end lies; return how far from where it may turn over."""
    number, _ = pair.links
    at = next(
        k for k, one in enumerate(drawn.by_number[number].slides) if one.guide.name == pair.name
    )
    lies = drawn.by_number[number].slides[at]
    way, apart = turn(lies.guide.angle), ends[1] - ends[0]
    along = (apart * way.conjugate()).real
    side = _passed(1 if along >= 0.0 else -1, None, lies.side, degrees)
    slides = list(links[number].slides)
    slides[at] = replace(slides[at], side=side)
    links[number] = replace(links[number], slides=tuple(slides))
    return abs(along) / abs(apart) if apart else 0.0


def put_left(links: dict[int, Link], group: Group, drawn: Mechanism, degrees: float) -> float:
    """Give a group of turning pairs the side of its inner pin; return how far from where it may turn over."""
    first, second = group.legs
    a, c = (drawn.by_number[leg.link].points[leg.pair.name] for leg in group.legs)
    # where the first leg is a cylinder, the pin is its rod's
    name = group.inner.name
    b = next(one.points[name] for one in drawn.by_number.values() if name in one.points)
    cross = ((c - a).conjugate() * (b - a)).imag
    told = [n for leg in group.legs if drawn.by_number[n := leg.link].side is not None]
    lies = drawn.by_number[told[0]].side if told else None
    number = told[0] if told else second.link
    side = _passed(1 if cross >= 0.0 else -1, (first.pair.name, second.pair.name), lies, degrees)
    links[number] = replace(links[number], side=side)
    apart = abs(b - a) * abs(b - c)
    return abs(((a - b).conjugate() * (c - b)).imag) / apart if apart else 0.0


def _passed(sign: int, left_of: tuple[str, str] | None, lies: Side | None, degrees: float) -> Side:
    """Return a side by its sign at an angle of the crank: that behind 0°, and the flips that were told."""
    flips = None if lies is None else lies.flips_at
    passed = sum(0.0 < flip % TURN.high <= degrees % TURN.high for flip in flips or ())
    return Side(-sign if passed % 2 else sign, left_of, flips)
