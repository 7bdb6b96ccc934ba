"""The replacing linkage in ink, and each group that a wheel makes with the link in place of its higher pair."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.figures import SLIDING
from graphic_tmm.chapters.kinematics.ink_links import MAIN, rigid_figure
from graphic_tmm.chapters.kinematics.ink_numbers import link_numbers
from graphic_tmm.chapters.kinematics.ink_positions import PAIR, PositionsInk
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.chapters.structure import REPLACING
from graphic_tmm.chapters.structure.record import MOBILITY
from graphic_tmm.chapters.structure.replacing import Replaced, replaced_formula
from graphic_tmm.chapters.structure.table import WORDS
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.language.numbers import number
from graphic_tmm.mechanism.structure import CLASSES, dissect, freedoms
from graphic_tmm.paper.drawing import Drawing, Ink
from graphic_tmm.paper.figure import body
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.symbols.kinematic import fixed_pivot, turning_pair


def _linkage(
    on: Subject, ink: PositionsInk, index: int, names: Sequence[str], replaced: Sequence[Replaced]
) -> Drawing:
    """Return links with those in place of their higher pairs; all links on the frame."""
    whole = len(names) == len(ink.names)
    strokes: list[Ink] = [*ink.guides()] if whole else []
    wide = dict[str, list[Mark]]()
    marks = dict.fromkeys(
        [
            *(ink.frame.marks if whole else ()),
            *(m for k in names for f in ink.of(k, "link") for m in f.marks),
        ]
    )
    ends, pins = dict[str, tuple[complex, complex]](), list[Ink]()
    for one in replaced:
        for name, both in one.lines.items():
            if name != ink.frame.name and (whole or name != str(one.rolling.on)):
                wide.setdefault(name, []).extend(both)
                ends[name] = ink.at(both[0], index), ink.at(both[1], index)
        for mark, link in ((one.pin, one.rolling.link), (one.far, one.rolling.on)):
            stands = whole and str(link) == ink.frame.name
            sign = (fixed_pivot if stands else turning_pair)(ink.at(mark, index))
            pins += body(sign, "pair", [mark], index)
            marks[mark] = None
    for name in names:
        if name not in wide or any(ink.of(name, "guide", *SLIDING)):
            strokes += ink.lines(name, index, MAIN)
    for name, more in wide.items():
        spots = [*ink.spots(name, index), *(ink.at(mark, index) for mark in more)]
        strokes += body(rigid_figure(spots, MAIN[0]), "link", [*ink.marks(name), *more], index)
    strokes += [one for one in ink.symbols(names, index) if one.part != "centre"]
    strokes += [*pins, *(ink.pivots() if whole else ())]
    named = [Named(ink.at(m, index), markup(m.name), (m.slot,), index) for m in marks]
    letters = lettered(shared(named), on.heights.point, PAIR)
    numbered = dict.fromkeys([*names, *ends, *([ink.frame.name] if whole else ())])
    circled = link_numbers(ink, index, strokes, letters, on.heights.number, [*numbered], ends)
    strokes += [stroke for one in circled for stroke in one.strokes]
    labels = tuple(one.label for one in circled)
    return Drawing(on.name, on.title, tuple(strokes), labels, wanted=tuple(letters))


def replacing_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the replacing linkage with its formula of structure, and the groups of its wheels, each with W."""
    made, mechanism, language = MOBILITY.of(drawn), drawn.scene.mechanism, drawn.scene.language
    if made is None or mechanism is None or not made.replaced:
        return []
    structure, words, index = dissect(mechanism), WORDS[language], drawn.main
    ink = PositionsInk(drawn.construction, drawn.reading, reaches(drawn), [index])
    more = len(made.replaced)
    size = structure.moving + more, len(structure.pairs) + 2 * more, 0
    rows = [(ink.names, made.replaced, words["replacing"], size, "")]
    rows += [
        (
            (str(one.rolling.link),),
            (one,),
            words["class of group"].format(name=one.name, numeral=CLASSES[1]),
            (2, 3, 0),
            one.name,
        )
        for one in made.replaced
    ]
    found = []
    for names, replaced, title, (n, p5, p4), name in rows:
        on = subject(drawn, title, REPLACING, name=f"replacing-{name}".rstrip("-"))
        view = _linkage(on, ink, index, names, replaced)
        w = drawn.reading[made.replacing[name]].item()
        told = [f"W = {freedoms(n, p5, p4)} = {number(w, language)}"]
        told += [] if name else [f"{words['formula']}: {replaced_formula(structure)}"]
        found.append(with_caption(view, on, lettered, *told))
    return found
