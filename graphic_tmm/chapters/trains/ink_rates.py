"""The picture of linear velocities of a planetary train and its plan of angular velocities in ink."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.trains.ink_scheme import ASIDE, LEAST, OVER, TrainInk
from graphic_tmm.paper.drawing import Ink, Stroke, Wanted, circle, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.seen import Rule, Seen
from graphic_tmm.paper.symbols.dimensions import arrow
from graphic_tmm.paper.symbols.kinematic import pole

LETTERED = 8.0
"""A line shorter than this bears no number, mm."""
DOT = 0.5
"""Radius of a point, mm."""


def picture_rules(ink: TrainInk) -> dict[Mark, Rule]:
    """What stays of the picture: its zero line, the velocities of A, B and C, the lines of the bodies."""
    picture = ink.made.picture
    high = max(ink.zeros.values(), key=lambda z: z.imag) + 1j * OVER
    zero = ink.seen.by_mark[picture.zeros["A"]].uses[0]
    rules = {zero: line_between("thin", ink.zeros["O"], high)}
    for key, end in picture.ends.items():
        told = picture.readings[key], picture.speeds[key]
        known = not is_read(ink, told[0])
        rules[end if known else told[0]] = vector(ink, ink.zeros[key], ink.tips[key], *told)
    if (trial := picture.trial) is not None:
        spots = sorted(ink.trial.values(), key=lambda z: z.imag)
        rules[trial.line] = line_between("thin", spots[0], spots[-1])
        for key, mark in trial.ends.items():
            rules[mark] = line_between("thin", ink.zeros[key], ink.trial[key])
    for key, spots in body_spots(ink).items():
        low, *_, top = sorted(spots, key=lambda z: z.imag)
        rules[picture.lines[key]] = line_between("main", low, top)
    return rules


def body_spots(ink: TrainInk) -> dict[str, list[complex]]:
    """Return the points of each body's line: where it stands and where velocities end."""
    points = ink.made.train.scheme.spots
    spots = {ink.rims[0]: [ink.tips.get(at, ink.zeros[at]) for at in points]}
    for at, name in points.items():
        if name in ink.made.picture.lines:
            spots[name] = [ink.zeros["O"], ink.tips[at]]
    return {name: spots[name] for name in ink.made.picture.lines}


def is_read(ink: TrainInk, mark: Mark) -> bool:
    """Return whether a length is read of the drawing, not calculated."""
    return not ink.seen.by_mark[mark].op.formula


def line_between(pen: str, start: complex, end: complex) -> Rule:
    """A line between two places, unless they are one."""

    def drawn(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        if abs(end - start) >= LEAST:
            yield line(pen, start, end)

    return drawn


def vector(ink: TrainInk, foot: complex, tip: complex, segment: Mark, quantity: Mark) -> Rule:
    """A velocity, with what was read of it."""

    def vector(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        if abs(tip - foot) >= LEAST:
            shaft, *head = arrow(foot, tip, "medium")
            yield from (with_segment(ink, shaft, segment, quantity), *head)

    return vector


def with_segment(ink: TrainInk, stroke: Stroke, segment: Mark, quantity: Mark) -> Stroke:
    """Return a stroke that tells a page the segment read, in mm, and what it stands for."""
    mm, value = (ink.seen.number(mark, 0) for mark in (segment, quantity))
    data = (
        ("segment", segment.name),
        ("mm", f"{mm:.2f}"),
        ("value", f"{value:.6g}"),
        ("unit", quantity.unit),
    )
    title = f"{segment.name} = {mm:.1f} mm = {value:.4g} {quantity.unit}"
    return stroke._replace(title=title, data=data)


def rate_rules(ink: TrainInk) -> dict[Mark, Rule]:
    """What stays of the plan: the line of angular velocities with its points, the rays from the pole."""
    rates = ink.made.rates
    xs = [ink.foot.real, *(z.real for z in ink.ends.values())]
    y, base = ink.foot.imag, ink.seen.by_mark[rates.ends[ink.rims[0]]].uses[0]
    rules = {
        base: line_between("main", complex(min(xs) - OVER, y), complex(max(xs) + OVER, y)),
        rates.foot: _dot(circle("main", ink.foot, DOT, filled=True)),
        rates.pole: line_between("thin", ink.foot, ink.pole),
    }
    for key, end in rates.ends.items():
        ray = ink.seen.by_mark[end].uses[1]
        rules[ray] = line_between("medium", ink.pole, ink.ends[key])
        dot = circle("main", ink.ends[key], DOT, filled=True)
        rules[end] = _dot(with_segment(ink, dot, rates.segments[key], rates.values[key]))
    return rules


def _dot(made: Stroke) -> Rule:
    def dot(seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        yield made

    return dot


def draw_pole(ink: TrainInk) -> Iterator[Ink]:
    """The pole of the plan."""
    yield from body(pole(ink.pole), "pole", [ink.made.rates.pole])


def picture_letters(ink: TrainInk) -> list[Wanted]:
    """The letters of the zero line and of the ends of velocities, the bodies of the lines."""
    picture, small = ink.made.picture, ink.heights.point
    away = -1.0 if sum((tip - ink.zeros["O"]).real for tip in ink.tips.values()) > 0.0 else 1.0
    wanted = list[Wanted]()
    for name, at in ink.zeros.items():
        way = away - 1j if name == "O" else away + 1j
        wanted.append(Wanted(name, at, small, ASIDE, way, (picture.zeros[name].slot,)))
    for name, at in ink.tips.items():
        way = at - ink.zeros[name]
        if abs(way) >= LEAST:
            of = (picture.ends[name].slot,)
            wanted.append(Wanted(name.lower(), at, small, 0.8, way, of))
    if picture.trial is not None:
        for name, mark in picture.trial.ends.items():
            at = ink.trial[name]
            wanted.append(Wanted(mark.name, at, small, 0.8, at - ink.zeros[name], (mark.slot,)))
    for key, spots in body_spots(ink).items():
        parts = pairwise(sorted(spots, key=lambda z: z.imag))
        low, high = max(parts, key=lambda part: round(abs(part[1] - part[0]), 6))
        if abs(high - low) > LETTERED:
            of = (picture.lines[key].slot,)
            wanted.append(Wanted(_name(ink, key), (low + high) / 2, small, 0.8, -away + 0j, of))
    return wanted


def _name(ink: TrainInk, key: str) -> str:
    """What a body is called: satellites of two rims by both."""
    return ", ".join(ink.rims) if key == ink.rims[0] else key


def rate_letters(ink: TrainInk) -> list[Wanted]:
    """The pole, the fixed wheel and the ends of the segments; ends that coincide share a label."""
    rates, small = ink.made.rates, ink.heights.point
    named = [Named(ink.foot, rates.foot.name, (rates.foot.slot,))]
    named += [Named(ink.ends[key], _name(ink, key), (m.slot,)) for key, m in rates.ends.items()]
    letters = lettered(shared(named), small, 0.8, away_from=ink.pole)
    return [*letters, Wanted("P", ink.pole, small, 0.8, -1j, (rates.pole.slot,))]
