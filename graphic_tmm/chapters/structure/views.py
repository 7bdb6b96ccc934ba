"""What a sheet shows of structure: the tables; the driving link and the groups by themselves."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from graphic_tmm.board.record import Figure
from graphic_tmm.chapters.kinematics.figures import SLIDING
from graphic_tmm.chapters.kinematics.ink_links import MAIN, LinksInk
from graphic_tmm.chapters.kinematics.ink_numbers import link_numbers
from graphic_tmm.chapters.kinematics.ink_positions import PAIR
from graphic_tmm.chapters.kinematics.ink_wheels import wheels
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.chapters.structure import PARTS, REPLACING, STRUCTURE
from graphic_tmm.chapters.structure.record import MOBILITY, parts
from graphic_tmm.chapters.structure.table import (
    WORDS,
    link_table,
    pair_table,
    structure_lines,
)
from graphic_tmm.chapters.structure.views_replacing import replacing_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.numbers import number
from graphic_tmm.mechanism.groups import numeral
from graphic_tmm.mechanism.structure import dissect, freedoms
from graphic_tmm.paper.drawing import Drawing, Ink, line
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.symbols.kinematic import SLIDER_LENGTH, fixed_pivot
from graphic_tmm.paper.views import captioned

PIECE = 0.9 * SLIDER_LENGTH
"""How far a guide outside of the part is shown to both sides of what slides on it, mm."""


def draw_part(
    on: Subject,
    reaches: Mapping[Figure, Reach],
    links: Sequence[int],
    rods: Sequence[int],
    index: int,
) -> Drawing:
    """Return one part of a mechanism: the links of these numbers, in one position (an index).

    ``rods``: those that are one link with their cylinders; they bear no number of their own.
    """
    ink = LinksInk(on.construction, on.reading, reaches)
    names = [str(number) for number in (*links, *rods)]
    strokes: list[Ink] = [*wheels(ink, names, index)] if len(names) == 1 else []
    strokes += [stroke for one in names for stroke in ink.lines(one, index, MAIN)]
    strokes += _outer_guides(ink, names, index)
    strokes += [stroke for stroke in ink.symbols(names, index) if stroke.part != "centre"]
    marks = dict.fromkeys(m for one in names for told in ink.of(one, "link") for m in told.marks)
    if len(names) == 1:
        for mark in (m for m in marks if m in ink.frame.marks):
            strokes += body(fixed_pivot(ink.at(mark, index)), "pivot", [mark])
    named = [Named(ink.at(m, index), markup(m.name), (m.slot,), index) for m in marks]
    letters = lettered(shared(named), on.heights.point, PAIR)
    circled = link_numbers(ink, index, strokes, letters, on.heights.number, names[: len(links)])
    strokes += [stroke for one in circled for stroke in one.strokes]
    labels = tuple(one.label for one in circled)
    return Drawing(on.name, on.title, tuple(strokes), labels, wanted=tuple(letters))


def _outer_guides(ink: LinksInk, names: Sequence[str], index: int) -> Iterator[Ink]:
    """Yield a piece of each guide on which a link of the part slides and which is no link of it."""
    own = {figure.marks[1] for one in names for figure in ink.of(one, "guide")}
    for one in names:
        for slid in ink.of(one, *SLIDING):
            path = slid.marks[1]
            if path not in own:
                foot, way = ink.foot(slid, index), ink.along(slid, index)
                piece = line("thin", foot - PIECE * way, foot + PIECE * way)
                yield from body([piece], "guide", [path], index)


def structure_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the table of links, and that of pairs with the formula of structure below it."""
    mechanism, language = drawn.scene.mechanism, drawn.scene.language
    assert mechanism is not None
    structure = dissect(mechanism)
    high = heights(drawn.scene, STRUCTURE)
    pairs = pair_table(mechanism, structure, language, high)
    return [
        link_table(mechanism, structure, language, high),
        captioned(pairs, *structure_lines(mechanism, structure, language), heights=high),
    ]


def part_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the driving link and every group, each with its mobility below it."""
    made = MOBILITY.of(drawn)
    if made is None or drawn.scene.mechanism is None:
        return []
    structure = dissect(drawn.scene.mechanism)
    words, found = WORDS[drawn.scene.language], []
    groups = {group.name: group for group in structure.groups}
    rods = {one.name for one in structure.driven if one.telescopes}
    rolling = {one.name: one.mesh.belted for one in structure.wheels}
    for name, (n, p5, p4) in parts(structure).items():
        links = [int(one) for one in name.split("-")]
        kind = "rod" if name in rods else "link"
        kind = "group" if name in groups else kind
        kind = ("wheel", "belted wheel")[rolling[name]] if name in rolling else kind
        of = numeral(groups[name]) if name in groups else ""
        told = words[f"class of {kind}"].format(name=name, numeral=of)
        on = subject(drawn, told, PARTS, name=f"part-{name}")
        view = draw_part(
            on, reaches(drawn), links, groups[name].rods if name in groups else (), drawn.main
        )
        w = drawn.reading[made.parts[name]].item()
        line = f"W = {freedoms(n, p5, p4)} = {number(w, drawn.scene.language)}"
        found.append(with_caption(view, on, lettered, line))
    return found


SHOWN = Views(draw={"structure": structure_views, PARTS: part_views, REPLACING: replacing_views})
