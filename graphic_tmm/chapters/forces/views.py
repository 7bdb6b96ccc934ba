"""What a sheet shows of forces: detached groups, polygons, the lever, the table."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.detached import Polygon, Reaction
from graphic_tmm.chapters.forces.driving import Driven
from graphic_tmm.chapters.forces.friction import below, pin_sentences
from graphic_tmm.chapters.forces.ink_balances import driver_rows, group_rows, lever_rows
from graphic_tmm.chapters.forces.ink_equations import Row, draw_balances
from graphic_tmm.chapters.forces.ink_groups import GroupFigure, Reactive, Rubbed, draw_group
from graphic_tmm.chapters.forces.ink_lever import draw_lever_ink
from graphic_tmm.chapters.forces.ink_polygons import bar, draw_polygon, whole
from graphic_tmm.chapters.forces.ink_writer import Writer
from graphic_tmm.chapters.forces.levers import Balanced
from graphic_tmm.chapters.forces.load_diagrams import load_views
from graphic_tmm.chapters.forces.load_strokes import loads_along_guides
from graphic_tmm.chapters.forces.plan import FORCES_PLAN, Forces
from graphic_tmm.chapters.forces.spring_diagrams import spring_views, springs_on_plan
from graphic_tmm.chapters.forces.statics import Solved
from graphic_tmm.chapters.forces.table import force_columns, names_of
from graphic_tmm.chapters.forces.task import FORCES, LOADS
from graphic_tmm.chapters.forces.tool import Tool
from graphic_tmm.chapters.forces.wheels import SolvedWheel
from graphic_tmm.chapters.forces.words import called
from graphic_tmm.chapters.indicator.views import indicator_views
from graphic_tmm.chapters.kinematics.along import AlongGuide, AlongGuides
from graphic_tmm.chapters.kinematics.closings import ClosingLeg, last_legs
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimals_of, fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.seen import Seen, Subject
from graphic_tmm.paper.views import captioned, mu_text, paired
from graphic_tmm.readers.columns import Readings
from graphic_tmm.readers.equations import polygon as polygon_read
from graphic_tmm.readers.result_table import result_table
from graphic_tmm.scene.captions import captions

EXACTLY = 2
"""To how many decimals a length is told that no ruler has rounded."""


def force_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return every detached group with its polygon and its equations, then the driving link, by positions."""
    made = FORCES_PLAN.of(drawn)
    if made is None:
        return []
    views = indicator_views(drawn, lettered, FORCES)
    for place in _places(drawn):
        writer = _writer(drawn, place)
        for solved in made.groups:
            rows = group_rows(writer, made, solved)
            views += _three(
                drawn,
                group_shown(drawn, made, solved),
                solved.polygon,
                solved.reactions,
                rows,
                place,
                lettered,
            )
        for driven in made.driven:
            rows = driver_rows(writer, made, driven)
            if driven.alone is None:
                continue
            polygon, reactions = driven.alone.polygon, (driven.alone.reaction,)
            shown = driver_shown(drawn, made, driven)
            views += _three(drawn, shown, polygon, reactions, rows, place, lettered)
    return views


def polygon_at(drawn: Drawn, view: str, place: int, name: str) -> Drawing | None:
    """Return a polygon by its view in one position; None where there is none."""
    made = FORCES_PLAN.of(drawn)
    scale = drawn.scales.get(view)
    if made is None or scale is None or place not in _places(drawn):
        return None
    groups = ((one.polygon, one.reactions) for one in made.groups)
    alone = ((one.polygon, (one.reaction,)) for one in made.alone)
    for polygon, reactions in (*groups, *alone):
        if polygon.view == view and whole(drawn.reading, polygon, reactions, place):
            sides = subject(drawn, "", "forces", name=name)
            mu, rods = scale.at(place).value, made.rods(polygon)
            return finished(draw_polygon(sides, polygon, reactions, place, mu, rods))
    return None


def _places(drawn: Drawn) -> list[int]:
    return [k for k in FORCES_PLAN.on(drawn).places if k not in drawn.undrawn]


def decimals_told(drawn: Drawn) -> int:
    """Return to how many decimals a length is told: those of the ruler."""
    return EXACTLY if drawn.hand.ruler is None else decimals_of(drawn.hand.ruler)


def told_lengths(drawn: Drawn) -> tuple[Mark, int]:
    """Return μ_l of the plan of positions, and to how many decimals a length is told."""
    return KINEMATICS_PLAN.on(drawn).mu_l, decimals_told(drawn)


def _writer(drawn: Drawn, place: int) -> Writer:
    seen = Seen(drawn.construction, drawn.reading, (), [place])
    return Writer(seen, place, drawn.scene.language, decimals_told(drawn))


def _three(
    drawn: Drawn,
    shown: GroupFigure,
    polygon: Polygon,
    reactions: tuple[Reaction, ...],
    rows: Iterable[Row],
    place: int,
    lettered: bool,
) -> list[Drawing]:
    """Return the figure of a group, its polygon and its equations; none, where a force is not there."""
    if not whole(drawn.reading, polygon, reactions, place):
        return []
    language = drawn.scene.language
    _, name, position = speaking(language), polygon.of.name, drawn.names[place]
    at = f"{captions(language)['position']} {escape(position)}"

    def on(what: str) -> Subject:
        title = f"{called(f'{what} {name}', _)}, {at}"
        return subject(drawn, title, "forces", name=f"{what}-{name}-{position}")

    group, sides, sums = on("group"), on("forces"), on("equations")
    figure = draw_group(group, reaches(drawn), shown, place, told_lengths(drawn))
    scale = drawn.scales.get(polygon.view)
    own, pins = (
        mu_text(drawn.scales[shown.figure.view], language),
        below(drawn, shown.links, language),
    )
    if scale is None:
        nothing = _("all forces are zero: there is no polygon")
        return [with_caption(figure, group, lettered, own, nothing)]
    scale = scale.at(place)
    lines = (mu_text(scale, language), *vectors_of(drawn, polygon, language))
    rods = FORCES_PLAN.on(drawn).rods(polygon)
    plan = draw_polygon(sides, polygon, reactions, place, scale.value, rods)
    return paired(
        [
            with_caption(figure, group, lettered, f"{own}, {_('forces not to scale')}", *pins),
            with_caption(plan, sides, lettered, *lines),
            draw_balances(sums.name, sums.title, rows, place, sums.heights),
        ]
    )


def vectors_of(drawn: Drawn, polygon: Polygon, language: str) -> list[str]:
    """Return the vector equation of a polygon: two lines under what was known, one under a direction.

    Of a side that was drawn along no line not even the direction was known. Then the first of two plates alone.
    """
    read = polygon_read(drawn.construction, polygon.view)
    terms, found = [], []
    for (letter, *ends), term in zip(polygon.sides, read, strict=True):
        along = term.line is not None and {*ends} == {*term.marks}
        under = r"\uu{{{}}}" if term.known else r"\u{{{}}}" if along else "{}"
        terms.append(under.format(bar(symbol(letter, language))))
    if polygon.parted is not None:
        plate, does = ([one for one, *_ in row] for row in polygon.parted[:2])
        unders = [r"\uu{{{}}}"] * (len(plate) + len(does) - 2) + [r"\u{{{}}}"] * 2
        bars = (bar(symbol(letter, language)) for letter in (*plate, *does))
        both = [under.format(one) for one, under in zip(bars, unders, strict=True)]
        found = [f"{' + '.join(both[: len(plate)])} = {' + '.join(both[len(plate) :])}"]
    return [" + ".join(terms) + " = 0", *found]


def _wheel_shown(made: Forces, solved: SolvedWheel) -> GroupFigure:
    """Return what the figure of a wheel shows: both parts of the tooth's force, the reaction of its pin."""
    (link,), unknown = solved.links, list[Reactive]()
    for part in solved.parts:
        assert part.side is not None
        unknown.append(Reactive(part.letter, solved.wheel.pitch, *part.side))
    pin = solved.reactions[1]
    unknown.append(Reactive(pin.letter, solved.wheel.leg.pivot, pin.tail, pin.head))
    acting = made.acting
    loads = acting.forces.get(link, []), acting.couples.get(link, [])
    return GroupFigure(solved.figure, (link,), *loads, unknown)


def group_shown(drawn: Drawn, made: Forces, solved: Solved | SolvedWheel) -> GroupFigure:
    """Return what the figure of a group shows."""
    if isinstance(solved, SolvedWheel):
        return _wheel_shown(made, solved)
    closing, unknown = solved.closing, list[Reactive]()
    links = (*closing.group.links, *closing.group.rods)
    for leg, reaction in zip(closing.legs, solved.reactions, strict=False):
        at = closing.at(leg)
        tangent = solved.tangents.get(leg.link)
        if tangent is not None and tangent.side is not None:
            tail, head = tangent.side
            own = tangent.value, tangent.arm, leg.link
            unknown.append(Reactive(tangent.letter, at, tail, head, *own))
        elif leg in last_legs(closing) or leg.inner:
            unknown.append(Reactive(reaction.letter, at, reaction.tail, reaction.head))
            continue
        unknown.append(_along(solved, leg, at))
    for leg in (one for one in closing.arms if one not in closing.legs):
        if (known := solved.tangents.get(leg.link)) is not None and known.side is not None:
            ends = closing.at(leg), *known.side
            unknown.append(Reactive(known.letter, *ends, known.value, known.arm, leg.link))
    held = solved.special.couples if solved.special is not None else ()
    return GroupFigure(
        solved.figure,
        links,
        [f for k in links for f in made.acting.forces.get(k, [])],
        [*(c for k in links for c in made.acting.couples.get(k, [])), *held],
        unknown,
        _rubbed(drawn, made, links),
        special=solved.special,
    )


def _along(solved: Solved, leg: ClosingLeg, at: Mark) -> Reactive:
    """Return what holds a leg along its known line: one of the sides that end a polygon, or of a third leg."""
    last = last_legs(solved.closing)
    if leg in last:
        letter, tail, head = solved.polygon.sides[-1 - last.index(leg)]
        return Reactive(letter, at, tail, head)
    assert solved.special is not None
    third = solved.special.third
    assert third is not None
    assert third.given.side is not None
    return Reactive(third.given.letter, at, *third.given.side)


def _rubbed(drawn: Drawn, made: Forces, links: tuple[int, ...]) -> list[Rubbed]:
    """Return the friction in the pins of some links."""
    place, found = KINEMATICS_PLAN.on(drawn).positions.point, list[Rubbed]()
    between = {frozenset(one.links): one for one in made.reactions}
    for couple in (one for link in links for one in made.acting.couples.get(link, [])):
        if couple.rubs is None:
            continue
        pin, other = place(couple.rubs[0]), couple.rubs[1]
        reaction = between[frozenset((couple.link, other))]
        ends = reaction.tail, reaction.head
        if reaction.links[1] != couple.link:  # what the other link bears is turned round
            ends = ends[::-1]
        found.append(Rubbed(pin, (made.circles or {})[pin], couple, *ends))
    return found


def driver_shown(drawn: Drawn, made: Forces, driven: Driven) -> GroupFigure:
    """Return what the figure of a driving link that stands by itself shows."""
    alone = driven.alone
    assert alone is not None
    link, reaction = driven.pair.link, alone.reaction
    # where a force at a tool is sought, what the groups leave at the drive is an error, no load
    force, couple = (driven.force, driven.couple) if made.tool is None else (None, None)
    forces = [*made.acting.forces.get(link, []), *([force] if force else [])]
    found = Reactive(reaction.letter, alone.about, reaction.tail, reaction.head)
    couples = list(made.acting.couples.get(link, []))
    if couple is not None:
        couples.append(couple)
    balance = (force.line, alone.arm) if force and alone.arm is not None else None
    return GroupFigure(
        alone.figure, (link,), forces, couples, [found], _rubbed(drawn, made, (link,)), balance
    )


def lever_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the lever of each drive and its equations in every position whose forces are asked for."""
    made = FORCES_PLAN.of(drawn)
    if made is None:
        return []
    places = _places(drawn)
    return [
        view
        for place in places
        for one in made.balanced
        for view in _lever(drawn, made, one, place, lettered)
    ]


def _lever(drawn: Drawn, made: Forces, one: Balanced, place: int, lettered: bool) -> list[Drawing]:
    language, lever, key = drawn.scene.language, one.lever, one.view.replace(" ", "-")
    _, scale = speaking(language), mu_text(drawn.scales[one.view], language)
    name, at = drawn.names[place], f"{captions(language)['position']} {escape(drawn.names[place])}"
    on = subject(drawn, f"{lever_called(drawn, one)}, {at}", "lever", name=f"{key}-{name}")
    view = draw_lever_ink(on, lever, place, decimals_told(drawn), tool=made.tool)
    larger = number(drawn.value(lever.times), language)
    times = _("enlargement {k} = {larger}", k=lever.times.name, larger=larger)
    lines = [f"{scale}, {times}, {_('forces not to scale')}", *_verdict(drawn, made, one, place)]
    sums = _("Equations of the lever")
    if len(made.balanced) > 1:
        sums = _("Equations of the lever, link {link} driving", link=one.driven.pair.link)
    rows = lever_rows(_writer(drawn, place), lever, made.tool)
    told = draw_balances(f"equations-{key}-{name}", f"{sums}, {at}", rows, place, on.heights)
    return paired([with_caption(view, on, lettered, *lines, known=(lever.balance,)), told])


def lever_called(drawn: Drawn, one: Balanced) -> str:
    """Return what the lever of a drive is called."""
    language = drawn.scene.language
    return called(one.view, speaking(language)) or captions(language)["lever"]


def _verdict(drawn: Drawn, made: Forces, one: Balanced, place: int) -> list[str]:
    """Return what the two methods found of a drive and whether they agree within the limit."""
    language = drawn.scene.language
    _, words = speaking(language), captions(language)

    def at(mark: Mark) -> float:
        row = drawn.reading.figure(mark)[0]
        return float(row[place if row.size > 1 else 0])

    of = unit("N" if made.order.balance == "force" else "N·m", language)
    values = at(one.balance), at(one.lever.balance)
    if len(made.balanced) > 1:
        names = symbol(one.driven.letter, language), symbol(one.lever.balance.name, language)
    else:
        forces, lever, _difference = names_of(made, one)
        names = words[forces], words[lever]
    both = [
        f"{name} = {number(value, language)} {of}"
        for name, value in zip(names, values, strict=True)
    ]
    if made.tool is not None:
        both = _sought(drawn, made.tool, at) + both[:1]
    row, limit = drawn.reading[one.difference][0], made.order.limit
    apart = float(row[place if row.size > 1 else 0])
    if not math.isfinite(at(one.difference)):
        return [", ".join(both), _("Δ: there is nothing to compare")]
    places = drawn.percent_decimals
    told, sign = fixed(apart, places, language), "≤" if round(apart, places) <= limit else ">"
    judged = f"Δ = {told} % {sign} {number(limit, language, 2)} %"
    return [", ".join(both), judged]


def _sought(drawn: Drawn, tool: Tool, at: Callable[[Mark], float]) -> list[str]:
    """Return the force at a tool, and how many times the force at the drive it is."""
    language = drawn.scene.language
    marks = ((tool.force.value, tool.force.letter, "N"), (tool.advantage, tool.advantage.name, ""))
    return [
        f"{symbol(letter, language)} = {number(at(mark), language)} {unit(of, language)}".rstrip()
        for mark, letter, of in marks
    ]


COUPLES = said(
    "A couple is positive counter-clockwise; in sums of moments it stands by its size, with the sign of its "
    "arrow."
)


def force_table(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the table of forces."""
    columns = force_columns(drawn) if FORCES_PLAN.of(drawn) is not None else ()
    rows = [column.without(drawn.undrawn) for column in columns]
    if not rows:
        return []
    high = heights(drawn.scene, "force table")
    language = drawn.scene.language
    table = result_table("forces", rows, drawn.names, language, heights=high)
    lines = [*pin_sentences(drawn, language)]
    if any(column.unit == "N·m" and np.any(column.value < 0.0) for column in rows):
        lines.append(speaking(language)(COUPLES))
    return [captioned(table, *lines, heights=high) if lines else table]


def _diagrams(drawn: Drawn, lettered: bool) -> list[Drawing]:
    return [*load_views(drawn, lettered), *spring_views(drawn, lettered)]


def _on_plan(drawn: Drawn, view: Drawing) -> Iterator[AlongGuide]:
    yield from springs_on_plan(drawn)
    yield from loads_along_guides(drawn, view)


ALONG = AlongGuides(_on_plan)
SHOWN = Views(
    draw={
        "forces": force_views,
        "lever": lever_views,
        "force table": force_table,
        LOADS: _diagrams,
    }
)


READINGS = Readings(figure_at=polygon_at)
