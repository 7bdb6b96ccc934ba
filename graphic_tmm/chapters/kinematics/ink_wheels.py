"""Wheels on links in ink: their circles, where they touch, belts and chains from one to the other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.ink_links import POINT_RADIUS, LinksInk
from graphic_tmm.mechanism.records import BELTS
from graphic_tmm.paper.arithmetic import bearing
from graphic_tmm.paper.drawing import Ink, arc, circle, line
from graphic_tmm.paper.figure import body

CHAIN = BELTS[-1]
"""Its wheels are toothed, so they and it are drawn by dash and dot as pitch circles are."""


def wheels(ink: LinksInk, names: Sequence[str], index: int, sweep: float = 0.0) -> Iterator[Ink]:
    """Yield the pitch circles of wheels and where they touch, or ``sweep`` degrees of them about there.

    Wheels of a belt have a rim there, in a main line.
    """
    known = set[Mark]()
    belts = [one.marks for one in ink.figures if one.kind in BELTS and one.kind != CHAIN]
    rims = {ends for marks in belts for ends in (marks[::2], marks[1::2])}
    for figure in (one for name in names for one in ink.of(name, "wheel")):
        centre, pitch = (ink.at(mark, index) for mark in figure.marks)
        pen = "main" if figure.marks in rims else "centre"
        made, out = [circle(pen, centre, abs(pitch - centre))], bearing(pitch - centre)
        if sweep:
            about = arc(pen, centre, abs(pitch - centre), out - sweep / 2.0, sweep)
            made = [about, line("thin", centre, pitch)]
        if figure.marks[1] not in known:
            made.append(circle("main", pitch, POINT_RADIUS, filled=True))
        known.add(figure.marks[1])
        yield from body(made, "wheel", figure.marks, index)


def runs(ink: LinksInk, index: int) -> Iterator[Ink]:
    """Yield both runs of every belt and chain: the line of centres mirrors one to the other."""
    for figure in (one for one in ink.figures if one.kind in BELTS):
        centre, other, *ends = (ink.at(mark, index) for mark in figure.marks)
        way = (other - centre) / abs(other - centre)
        slack = [centre + ((z - centre) / way).conjugate() * way for z in ends]
        pen = "centre" if figure.kind == CHAIN else "main"
        made = [line(pen, *run) for run in (ends, slack)]
        yield from body(made, "belt", figure.marks, index)
