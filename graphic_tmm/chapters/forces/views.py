"""What a sheet shows of forces: detached groups, polygons, the lever, the table."""

from __future__ import annotations

import math

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard
from graphic_tmm.captions import captions
from graphic_tmm.chapters.forces.captions import called
from graphic_tmm.chapters.forces.ink_groups import Detached, Reactive, draw_group
from graphic_tmm.chapters.forces.ink_lever import draw_lever_ink
from graphic_tmm.chapters.forces.ink_polygons import bar, draw_polygon, whole
from graphic_tmm.chapters.forces.plan import FORCES, Forces
from graphic_tmm.chapters.forces.polygons import Polygon, Reaction
from graphic_tmm.chapters.forces.statics import Solved
from graphic_tmm.chapters.forces.table import force_columns
from graphic_tmm.chapters.indicator.views import indicator_views
from graphic_tmm.chapters.kinematics.bodies import PinLeg
from graphic_tmm.chapters.kinematics.plan import KINEMATICS
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.names import plain
from graphic_tmm.language.numbers import number
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.letters import (
    escape,
)
from graphic_tmm.paper.views import captioned, mu_text, paired
from graphic_tmm.readers.result_table import (
    result_table,
)


def force_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return every detached group with its polygon, then the driving link with its own, by positions."""
    made = FORCES.of(drawn)
    if made is None:
        return []
    views = indicator_views(drawn, lettered, FORCES.chapter)
    for place in _places(drawn):
        for solved in made.groups:
            name = solved.closing.group.name
            shown = _group(drawn, made, solved)
            views += _pair(drawn, shown, solved.polygon, solved.reactions, name, place, lettered)
        crank = str(KINEMATICS.on(drawn).structure.driver)
        reactions = (made.driven.reaction,)
        views += _pair(
            drawn, _driver(drawn, made), made.driven.polygon, reactions, crank, place, lettered
        )
    return views


def _places(drawn: Drawn) -> list[int]:
    return [k for k in FORCES.on(drawn).places if k not in drawn.undrawn]


def _pair(
    drawn: Drawn,
    shown: Detached,
    polygon: Polygon,
    reactions: tuple[Reaction, ...],
    name: str,
    place: int,
    lettered: bool,
) -> list[Drawing]:
    """Return the figure of a group and its polygon, captioned; neither, where a force is not there."""
    if not whole(drawn.reading, polygon, reactions, place):
        return []
    project, language = drawn.project, drawn.scene.language
    _, words = speaking(language), captions(language)
    at = f"{words['position']} {escape(project.names[place])}"
    title = f"{called(f'group {name}', _)}, {at}"
    scale = drawn.scales.get(polygon.view)
    arrows = scale._replace(value=shown.mu) if scale is not None else None
    both = (drawn.scales["positions"], arrows)
    scales = ", ".join(mu_text(s, language) for s in both if s is not None)
    figure = draw_group(
        project.construction,
        drawn.reading,
        reaches(drawn),
        shown,
        place,
        f"group-{name}-{project.names[place]}",
        title,
        KINEMATICS.on(drawn).mu_l,
        language,
        lettered=lettered,
    )
    if scale is None:
        return [captioned(figure, title, scales, _("all forces are zero: there is no polygon"))]
    caption = f"{called(f'forces {name}', _)}, {at}"
    plan = draw_polygon(
        drawn.reading,
        polygon,
        reactions,
        place,
        f"forces-{name}-{project.names[place]}",
        caption,
        scale.value,
        language,
        lettered=lettered,
    )
    equation = _equation(polygon, language)
    return paired(
        [
            captioned(figure, title, scales),
            captioned(plan, caption, mu_text(scale, language), equation),
        ]
    )


def _equation(polygon: Polygon, language: str) -> str:
    """Return the vector equation of a polygon: two lines under what was known, one under a direction."""
    letters = [symbol(letter, language) for letter, _, _ in polygon.sides]
    known = len(letters) - (2 if "-" in polygon.view else 1)
    terms = [
        f"\\{'uu' if k < known else 'u'}{{{bar(letter)}}}"
        if "-" in polygon.view or k < known
        else bar(letter)
        for k, letter in enumerate(letters)
    ]
    return " + ".join(terms) + " = 0"


def _group(drawn: Drawn, made: Forces, solved: Solved) -> Detached:
    closing = solved.closing
    links = closing.group.links
    unknown = []
    by_letter = {letter: (tail, head) for letter, tail, head in solved.polygon.sides}
    for leg, reaction in zip(closing.legs, solved.reactions, strict=False):
        at = leg.pivot if isinstance(leg, PinLeg) else closing.point
        parts = [f"{reaction.letter}^{{t}}", f"{reaction.letter}^{{n}}"]
        letters = [p for p in parts if p in by_letter] or [reaction.letter]
        for letter in letters:
            ends = by_letter.get(letter, (reaction.tail, reaction.head))
            unknown.append(Reactive(letter, at, *ends))
    return Detached(
        links,
        [f for k in links for f in made.acting.forces.get(k, [])],
        [c for k in links for c in made.acting.couples.get(k, [])],
        unknown,
        _arrows(drawn, solved.polygon),
        _circles(
            made, [leg.pivot for leg in closing.legs if isinstance(leg, PinLeg)] + [closing.point]
        ),
    )


def _arrows(drawn: Drawn, polygon: Polygon) -> float:
    """Return μ_F of the arrows on a figure: that of its polygon, a larger one where no sheet holds them.

    Without end where the polygon has none, for its forces are nothing: then no arrow has a length.
    """
    scale, size = drawn.scales.get(polygon.view), drawn.sizes["groups"]
    if scale is None:
        return math.inf
    return standard(scale.value / size, 1.0) if size < 1.0 else scale.value


def _circles(made: Forces, pins: list[Mark]) -> list[tuple[Mark, Mark]]:
    """Return the friction circles of pins: their points and radii (m)."""
    circles = made.circles or {}
    return [(pin, circles[pin]) for pin in pins if pin in circles]


def _driver(drawn: Drawn, made: Forces) -> Detached:
    plans = KINEMATICS.on(drawn)
    crank = plans.structure.driver
    body = plans.positions.bodies[crank]
    reaction, driven = made.driven.reaction, made.driven
    forces = [*made.acting.forces.get(crank, []), *([driven.force] if driven.force else [])]
    pivot = body.marks[plans.structure.pivot]
    found = Reactive(reaction.letter, pivot, reaction.tail, reaction.head)
    couples = made.acting.couples.get(crank, [])
    circles = _circles(made, [pivot, body.marks[plans.structure.pin]])
    return Detached((crank,), forces, couples, [found], _arrows(drawn, driven.polygon), circles)


def lever_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the lever in every position whose forces are asked for."""
    made, project, language = FORCES.of(drawn), drawn.project, drawn.scene.language
    if made is None:
        return []
    words, views = captions(language), []
    for place in _places(drawn):
        title = f"{words['lever']}, {words['position']} {escape(project.names[place])}"
        force, balance = made.driven.force, None
        if force is not None:
            along = drawn.reading[force.line].along[0]
            way = complex(along[place if along.size > 1 else 0])
            balance = (
                symbol(force.letter, language),
                float(drawn.reading[made.lever.balance][0, place]),
                way,
            )
        view = draw_lever_ink(
            project.construction,
            drawn.reading,
            made.lever,
            balance,
            place,
            f"lever-{project.names[place]}",
            title,
            language,
            lettered=lettered,
        )
        scale = mu_text(drawn.scales["lever"], language)
        views.append(captioned(view, title, scale, *_verdict(drawn, made, place)))
    return views


def _verdict(drawn: Drawn, made: Forces, place: int) -> list[str]:
    """Return what the two methods found and whether they agree within the limit."""
    language = drawn.scene.language
    _, words = speaking(language), captions(language)

    def at(mark: Mark) -> float:
        row = drawn.reading.figure(mark)[0]
        return float(row[place if row.size > 1 else 0])

    of = unit("N" if made.order.balance == "force" else "N·m", language)
    key = "P" if made.order.balance == "force" else "M"
    both = [
        f"{words[f'{key}_bal_{way}']} = {number(at(mark), language)} {of}"
        for way, mark in (("forces", made.balance), ("lever", made.lever.balance))
    ]
    apart, limit = at(made.difference), made.order.limit
    if not math.isfinite(apart):
        return [", ".join(both), _("Δ: there is nothing to compare")]
    sign = "≤" if apart <= limit else ">"
    judged = f"Δ = {number(apart, language, 2)} % {sign} {number(limit, language, 2)} %"
    return [", ".join(both), judged]


def force_table(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the table of forces."""
    columns = force_columns(drawn) if FORCES.of(drawn) is not None else ()
    rows = [column.without(drawn.undrawn) for column in columns]
    if not rows:
        return []
    return [result_table("forces", rows, drawn.project.names, drawn.scene.language)]


def polygon_equation(drawn: Drawn, view: str, language: str) -> list[str]:
    """Return the vector equation of the polygon drawn in a view, in plain text."""
    return [
        " + ".join(plain(symbol(letter, language)) for letter, _, _ in polygon.sides) + " = 0"
        for polygon in FORCES.on(drawn).polygons
        if polygon.view == view
    ]
