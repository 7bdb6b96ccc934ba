"""The protocol as a page holds it: a heading a plan, its steps in ordered lists, remarks between them."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import groupby
from typing import NamedTuple

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.readers.narration import Line
from graphic_tmm.readers.protocol import plans, told


class Run(NamedTuple):
    """Lines that follow one another, all of them steps (``numbered``) or all remarks."""

    numbered: bool
    lines: tuple[Line, ...]


class Plan(NamedTuple):
    """A plan: what it is headed by, its lines in runs."""

    title: str
    runs: tuple[Run, ...]


def protocol_of(made: DrawnScene, language: str) -> list[Plan]:
    """Return the protocols of all plans of a scene, a reason only where it is another than before."""
    return [
        Plan(one.title, tuple(_runs(_reasoned(one.lines))))
        for one in told(made, plans(), None, language)
    ]


def _runs(lines: Iterator[Line]) -> Iterator[Run]:
    for numbered, some in groupby(lines, lambda line: line.number > 0):
        yield Run(numbered, tuple(some))


def _reasoned(lines: tuple[Line, ...]) -> Iterator[Line]:
    before = ""
    for line in lines:
        yield line._replace(why="" if line.why == before else line.why)
        before = line.why or before
