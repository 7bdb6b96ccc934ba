"""Forces in the scheme of centres in ink: the mechanism, lines of action, arms from the centres of links."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from graphic_tmm.board.operations.instruments import parallel
from graphic_tmm.board.operations.statics import arm
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.chapters.advantage.plan import Advantage, Arm
from graphic_tmm.chapters.advantage.task import ADVANTAGE
from graphic_tmm.chapters.centres.ink import EDGE, RADIUS, SchemeInk
from graphic_tmm.chapters.centres.record import Centres
from graphic_tmm.chapters.forces.ink_arrows import (
    Arrows,
    ArrowText,
    action,
    arm_shows,
    drawn_arm,
    drawn_on,
    length_of,
    turning,
)
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.kinematics.ink_numbers import link_numbers
from graphic_tmm.chapters.kinematics.ink_positions import PAIR
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.figure import Manner, body, figure
from graphic_tmm.paper.labels import Named, lettered, shared
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.seen import Seen, Subject, finite
from graphic_tmm.paper.symbols.dimensions import arrow

HEAD = 8.0
"""How long the arrow to a far centre is at least, mm."""
DECIMALS = 1
"""To how many an arm is written on the scheme, mm."""


TOGETHER = 1.0
"""Arms whose feet are nearer than this, mm, lie on one another, and share a letter."""
SHORT = 1.0
"""An arm shorter than this, mm, has no letter."""


class _Arms:
    """The forces of one position while they are inked."""

    def __init__(self, on: Subject, ink: SchemeInk, centres: Centres, place: int) -> None:
        self.on, self.ink, self.centres, self.place = on, ink, centres, place
        self.seen = on.seen((ADVANTAGE,), [place])
        self.arrows = Arrows(place, on.heights.point)
        self.inside = ink.room.grown(-EDGE / 2)

    def there(self, mark: Mark) -> bool:
        """Whether a point stands in what is drawn of the scheme."""
        spot = self.seen.point(mark, self.place)
        return finite(spot) and bool(self.inside.holds(spot))

    def line(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """A line of action as far as the foot of its arm, where that is drawn."""
        uses = [one for one in seen.uses.get(step.it, ()) if one.op is arm]
        if all(self.inside.holds(action(seen, one, k)[2]) for one in uses):
            yield from drawn_on(seen, step, k)

    def height(self, seen: Seen, step: Step, k: int) -> Iterator[Ink]:
        """An arm; of one about a far centre its beginning, an arrow that leads there."""
        about, _, foot = action(seen, step, k)
        if not finite(about, foot) or not self.inside.holds(foot):
            return
        if self.inside.holds(about):
            yield from drawn_arm(seen, step, k)
            return
        for tip, way in self._leads(about, foot):
            yield line("thin", foot, tip)
            yield from arrow(tip - HEAD * way, tip, "thin")

    def _leads(self, about: complex, foot: complex) -> Iterator[tuple[complex, complex]]:
        """Yield where the arrow to a far centre ends, and its way."""
        way = (about - foot) / abs(about - foot)
        part = self.inside.span(foot, way)
        if part is not None and part[1] > HEAD:
            yield foot + part[1] * way, way

    def force(self, force: Force, own: Arm, largest: float, pen: str) -> None:
        """An arrow where the force turns its link; a thin one where it acts if that is elsewhere."""
        seen, place = self.seen, self.place
        size, (_, way) = seen.number(force.value, place), seen.line(own.line, place)
        arms = turning(seen.number(own.height, place), size)
        of = (own.point.slot, own.line.slot, force.value.slot)
        text = ArrowText(force.letter, abs(size), "N", of, arms)
        called, way = markup(symbol(force.letter, self.on.language)), -way if size < 0 else way
        length = length_of(size, largest)
        if own.own is None or self.there(own.point):
            self.arrows.put(seen.point(own.point, place), way, length, called, text, pen)
        if own.own is not None:
            at = seen.point(own.own, place)
            self.arrows.put(at, way, length, called, text._replace(more=()), "thin")

    def letters(self, arms: Iterable[Arm]) -> Iterator[Wanted]:
        """The letters of arms with their mm; those on one another share one."""
        seen, place, language = self.seen, self.place, self.on.language
        feet: list[tuple[complex, complex, list[Mark]]] = []
        for own in arms:
            about, (at, way) = seen.point(own.about, place), seen.line(own.line, place)
            foot = at + ((about - at) * way.conjugate()).real * way
            if not finite(about, foot) or not self.inside.holds(foot):
                continue
            if not self.inside.holds(about):
                names = {one.mark: one.name for one in self.centres.centres}
                for tip, toward in self._leads(about, foot):
                    leads = f"→ {names[own.about]}"
                    slots = own.height.slot, own.about.slot
                    yield Wanted(leads, tip, self.on.heights.number, 1.0, toward, slots, place)
                    about = tip
            near = [k for a, z, k in feet if abs(a - about) + abs(z - foot) < TOGETHER]
            if near:
                near[0].append(own.height)
            else:
                feet.append((about, foot, [own.height]))
        for about, foot, marks in feet:
            mm = abs(seen.number(marks[0], place))
            if mm >= SHORT:
                names_ = [markup(symbol(mark.name, language)) for mark in marks]
                text = " = ".join([*names_, fixed(mm, DECIMALS, language)])
                of = tuple(mark.slot for mark in marks)
                at, across = (about + foot) / 2, 1j * (foot - about)
                yield Wanted(text, at, self.on.heights.number, 0.8, across, of, place)

    def couples(self, couples: Iterable[Couple]) -> None:
        """Couples, each at its link, between two of its points."""
        links: dict[int, list[Couple]] = {}
        for couple in couples:
            links.setdefault(couple.link, []).append(couple)
        for link, several in links.items():
            figures = [one for one in self.ink.links.construction.figures if one.name == str(link)]
            marks = dict.fromkeys(mark for one in figures for mark in one.marks)
            own = [self.centres.points[mark] for mark in marks if mark in self.centres.points]
            ends = [self.seen.point(mark, self.place) for mark in own]
            told = [(markup(symbol(k.letter, self.on.language)), self._text(k)) for k in several]
            if ends:
                self.arrows.couples(ends[0], ends[-1], told)

    def _text(self, couple: Couple) -> ArrowText:
        value = self.seen.number(couple.value, self.place)
        return ArrowText(couple.letter, value, "N·m", (couple.value.slot,))

    def points(self, marks: Iterable[Mark]) -> tuple[list[Wanted], list[Ink]]:
        """Return the letters of points and of centres that forces turn links about; circles of the latter."""
        names = {one.mark: one.name for one in self.centres.centres if not one.far}
        drawn = [mark for mark in marks if self.there(mark)]
        letters = [(mark, markup(of.name)) for of, mark in self.centres.points.items()]
        letters += [(mark, names[mark]) for mark in drawn if mark in names]
        letters += [(mark, markup(mark.name)) for mark in drawn if mark.view == ADVANTAGE]
        at, place = self.seen.point, self.place
        named = (Named(at(mark, place), text, (mark.slot,), place) for mark, text in letters)
        circles = list[Ink]()
        for mark in drawn:
            if mark in names and mark not in self.centres.points.values():
                circles += body([circle("joint", at(mark, place), RADIUS)], "centre", [mark], place)
        return lettered(shared(named), self.on.heights.point, PAIR), circles


def draw_arms(
    on: Subject, centres: Centres, made: Advantage, tool: Force | None, ink: SchemeInk
) -> Drawing:
    """Return the forces in the position of a scheme of centres; ``tool``: the force that is sought."""
    place = ink.place
    arms = _Arms(on, ink, centres, place)
    rules = {parallel.name: arms.line, arm.name: arms.height}
    traces = figure(arms.seen, Manner(rules, lambda seen, step: arm_shows(seen, step, place)))
    forces = [(one.load, one.arm, "over") for one in made.loads if isinstance(one.load, Force)]
    if tool is not None:
        forces.append((tool, made.tool, "rod"))
    mechanism = [*ink.mechanism()]
    arms.arrows.stands_on(mechanism)
    sizes = [abs(arms.seen.number(force.value, place)) for force, _, _ in forces]
    largest = max((size for size in sizes if size == size), default=0.0)
    drawn = list[Arm]()
    for force, own, pen in forces:
        if own is not None:
            arms.force(force, own, largest, pen)
            drawn.append(own)
    arms.couples(one.load for one in made.loads if isinstance(one.load, Couple))
    used = dict.fromkeys(mark for own in drawn for mark in (own.about, own.point))
    letters, circles = arms.points(used)
    wanted = [*letters, *arms.letters(drawn), *arms.arrows.wanted]
    strokes: list[Ink] = [*traces.staying, *mechanism, *circles, *arms.arrows.strokes]
    circled = link_numbers(ink.links, place, strokes, wanted, on.heights.number)
    strokes += [stroke for one in circled for stroke in one.strokes]
    found = traces.drawing(on, strokes, wanted, [one.label for one in circled])
    return found._replace(position=place)
