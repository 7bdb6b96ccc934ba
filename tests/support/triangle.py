"""A chapter that no folder of the book holds: a triangle by its sides."""

from __future__ import annotations

from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.operations.instruments import cross, lay_off, measure, ray, strike
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Point, Side
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.paper.drawing import Drawing, Wanted, line
from graphic_tmm.paper.figure import body, figure
from graphic_tmm.paper.views import mu_text
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene import values as v
from graphic_tmm.scene.captions import Named, captions
from graphic_tmm.scene.chapter import Chapter, Place, Recorded
from graphic_tmm.scene.declare import Section, key
from graphic_tmm.scene.tasks import SectionKey


@dataclass(frozen=True)
class Sides:
    """A triangle by its sides."""

    a: float = key(v.POSITIVE_LENGTH, "the base", "60 mm")
    b: float = key(v.POSITIVE_LENGTH, "the side at its beginning", "50 mm")
    c: float = key(v.POSITIVE_LENGTH, "the side at its end", "40 mm", 0.04)


class Triangle(NamedTuple):
    corners: tuple[Mark, Mark, Mark]
    side: Mark
    mu: Mark


ASKED: SectionKey[Sides] = SectionKey("triangle")
TRIANGLE: Recorded[Triangle] = Recorded("triangle")


def record(bench: Bench) -> Triangle:
    task, draft = ASKED.of(bench.scene), bench.draft
    draft.open("triangle")
    draft.mu_l = mu = draft.scale("μ_l", "m/mm")
    draft.lay_out()
    a = draft.take(Point, "A", 0j)
    base = draft.draw(ray, "(AB)", a, draft.direction(0.0))
    b = draft.draw(lay_off, "B", base, draft.length("AB", task.a))
    arcs = [draft.draw(strike, f"({name})", at, draft.length(name, size))
            for name, at, size in (("AC", a, task.b), ("BC", b, task.c))]  # fmt: skip
    c = draft.draw(cross, "C", *arcs, draft.take(Side, "±", 1.0))
    return Triangle((a, b, c), draft.draw(measure, "CA", c, a), mu)


def views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    on = subject(drawn, captions(drawn.scene.language)["triangle"], "triangle")
    traces = figure(on.seen(("triangle",), range(len(drawn.names))))
    corners = TRIANGLE.on(drawn).corners
    spots = [traces.seen.point(mark, 0) for mark in corners]
    letters = [Wanted(m.letter, z, on.heights.point) for m, z in zip(corners, spots, strict=True)]
    sides = body([line("main", *spots, closed=True)], "triangle", corners)
    view = traces.drawing(on, [*traces.staying, *sides], letters)
    return [with_caption(view, on, lettered, mu_text(drawn.scales["triangle"], on.language))]


CHAPTER = Chapter(
    "triangle", 98, "triangle",
    sections=(Section("triangle", Sides, "a triangle by its sides", alone=True),),
    places=(Place("triangle", 130),),
    answers=(
        Plan(record=record), Views(draw={"triangle": views}),
        ScaleFactors(factors=lambda on: [ScaleFactor(TRIANGLE.on(on).mu, "a", 0.06, 120.0, lengths=True)]),
        Named(captions={"triangle": "Triangle by its sides"}, plans=("triangle",)),
    ),
)  # fmt: skip
