"""Forces in the scheme of centres in ink: the mechanism, lines of action, arms from the centres of links."""

from __future__ import annotations

from collections.abc import Mapping

from graphic_tmm.board.operations.instruments import parallel
from graphic_tmm.board.operations.statics import arm
from graphic_tmm.board.record import Figure
from graphic_tmm.board.values import Point
from graphic_tmm.chapters.advantage.plan import Advantage, Arm
from graphic_tmm.chapters.advantage.task import ADVANTAGE
from graphic_tmm.chapters.centres.ink import RADIUS, SchemeInk
from graphic_tmm.chapters.centres.plan import Centres
from graphic_tmm.chapters.forces.ink_arrows import (
    Arrows,
    ArrowText,
    arm_shows,
    drawn_arm,
    drawn_on,
    length_of,
    turning,
)
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.kinematics.ink_numbers import link_numbers
from graphic_tmm.chapters.kinematics.ink_positions import PAIR
from graphic_tmm.chapters.kinematics.reaches import Reach
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Subject

DECIMALS = 1
"""To how many an arm is written on the scheme, mm."""


def draw_arms(
    on: Subject,
    centres: Centres,
    made: Advantage,
    tool: Force | None,
    scheme: tuple[Mapping[Figure, Reach], float],
    place: int,
) -> Drawing:
    """Return the forces in one position; ``scheme``: see `draw_scheme` of centres."""
    ink, seen = SchemeInk(on, centres, *_placed(scheme, place)), on.seen((ADVANTAGE,), [place])
    rules = {parallel.name: drawn_on, arm.name: drawn_arm}
    traces = figure(seen, Manner(rules, lambda seen, step: arm_shows(seen, step, place)))
    forces = [(one.load, one.arm) for one in made.loads if isinstance(one.load, Force)]
    if tool is not None:
        forces.append((tool, made.tool))
    mechanism = ink.mechanism()
    arrows = Arrows(place, on.heights.point)
    arrows.stands_on(mechanism)
    sizes = [abs(seen.number(force.value, place)) for force, _ in forces]
    largest = max((size for size in sizes if size == size), default=0.0)
    wanted = list[Wanted]()
    for force, own in forces:
        if own is None:
            continue
        size, (_, way) = seen.number(force.value, place), seen.line(own.line, place)
        of = (own.point.slot, own.line.slot, force.value.slot)
        text = ArrowText(
            force.letter, abs(size), "N", of, turning(seen.number(own.height, place), size)
        )
        at, called = seen.point(own.point, place), markup(symbol(force.letter, on.language))
        arrows.put(
            at, -way if size < 0 else way, length_of(size, largest), called, text,
            "rod" if force is tool else "over",
        )  # fmt: skip
        if own.own is not None:
            beside = seen.point(own.own, place), -way if size < 0 else way
            arrows.put(*beside, length_of(size, largest), called, text._replace(more=()), "thin")
        wanted += _arm(on, ink, own, place)
    for one in made.loads:
        if isinstance(one.load, Couple):
            _couple(arrows, on, ink, centres, one.load, place)
    arms = [own for _, own in forces if own is not None]
    used = dict.fromkeys(mark for own in arms for mark in (own.about, own.point))
    names = {one.mark: one.name for one in centres.centres if not one.far}
    letters = [(mark, markup(of.name)) for of, mark in centres.points.items()]
    letters += [(mark, names[mark]) for mark in used if mark in names]
    letters += [(mark, markup(mark.name)) for mark in used if mark.view == ADVANTAGE]
    named = (Named(ink.seen.point(k, place), text, (k.slot,), place) for k, text in letters)
    wanted = [*lettered(shared(named), on.heights.point, PAIR), *wanted, *arrows.wanted]
    strokes: list[Ink] = [*traces.staying, *mechanism, *arrows.strokes]
    for mark in used:
        if mark in names and mark not in centres.points.values():
            spot = circle("joint", seen.point(mark, place), RADIUS)
            strokes += body([spot], "centre", [mark], place)
    circled = link_numbers(ink.links, place, strokes, wanted, on.heights.number)
    strokes += [stroke for one in circled for stroke in one.strokes]
    found = traces.drawing(on, strokes, wanted, [one.label for one in circled])
    return found._replace(position=place)


def _placed(
    scheme: tuple[Mapping[Figure, Reach], float], place: int
) -> tuple[Mapping[Figure, Reach], int, float]:
    return scheme[0], place, scheme[1]


def _arm(on: Subject, ink: SchemeInk, own: Arm, place: int) -> list[Wanted]:
    """Return the letter of an arm with its mm; none of one that turns nothing."""
    seen = on.seen((ADVANTAGE,), [place])
    mm = abs(seen.number(own.height, place))
    if not mm >= 1.0:
        return []
    about, (at, way) = seen.point(own.about, place), seen.line(own.line, place)
    foot = at + ((about - at) * way.conjugate()).real * way
    name = markup(symbol(own.height.name, on.language))
    text = f"{name} = {fixed(mm, DECIMALS, on.language)}"
    middle, across = (about + foot) / 2, 1j * (foot - about)
    return [Wanted(text, middle, on.heights.number, 0.8, across, (own.height.slot,), place)]


def _couple(
    arrows: Arrows, on: Subject, ink: SchemeInk, centres: Centres, couple: Couple, place: int
) -> None:
    """Draw a couple at its link, between two of its points."""
    seen = on.seen((ADVANTAGE,), [place])
    marks = [of for of in ink.links.construction.figures if of.name == str(couple.link)]
    points = [
        centres.points[mark]
        for one in marks
        for mark in one.marks
        if mark.kind is Point and mark in centres.points
    ]
    ends = [ink.seen.point(mark, place) for mark in dict.fromkeys(points)]
    if not ends:
        return
    value = seen.number(couple.value, place)
    text = ArrowText(couple.letter, value, "N·m", (couple.value.slot,))
    arrows.couples(ends[0], ends[-1], [(markup(symbol(couple.letter, on.language)), text)])
