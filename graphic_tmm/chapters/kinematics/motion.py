"""What a plan of velocities or accelerations leaves: image points, vectors and their names, rates of links."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import (
    coincide,
    homologous,
    lay_off,
    measure,
    measure_along,
    similar,
)
from graphic_tmm.board.record import Construction, Mark, Step, between
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import Body, Meshed, Positions
from graphic_tmm.chapters.kinematics.closings import (
    AnyClosing,
    Closing,
    ClosingLeg,
    GuideLeg,
    PinLeg,
    outer_guides,
    unheld,
)


class Base(NamedTuple):
    """Two points of a link on the plan of positions, and their images."""

    A: Mark
    B: Mark
    a: Mark
    b: Mark


class Hanging(NamedTuple):
    """How a link hangs in the plan: its anchor, the anchor's image, and the base it turns with."""

    anchor: Mark
    image: Mark
    base: Base | None


class Images:
    """The images of one plan while it is being drawn, by link."""

    def __init__(self, draft: Draft, pole: Mark, frame: Body) -> None:
        self.draft = draft
        self.pole = pole
        self.by_letter: dict[int, dict[str, Mark]] = {}
        self.hanging: dict[int, Hanging] = {}
        number = frame.link.number
        self.hanging[number] = Hanging(pole, pole, None)
        self.by_letter[number] = dict.fromkeys(frame.marks, pole)

    def hang(self, body: Body, hanging: Hanging, known: dict[str, Mark]) -> None:
        """Enter a link, with the images of letters known already."""
        self.hanging[body.link.number] = hanging
        self.by_letter[body.link.number] = known

    def turns(self, number: int) -> bool:
        """Whether a link turns (otherwise its images coincide)."""
        return self.hanging[number].base is not None

    def at(self, body: Body, point: Mark) -> Mark:
        """Return the image of a point of a body that is drawn already."""
        return self.by_letter[body.link.number][body.letter_of(point)]

    def of(self, number: int, point: Mark, letter: str, shown: str) -> Mark:
        """Return the image of a point as a point of the link; draw it if it is not there yet.

        ``letter``: that of the point in the scene; ``shown``: that of the image.
        """
        known = self.by_letter[number]
        if letter in known:
            return known[letter]
        anchor, image, base = self.hanging[number]
        if point == anchor or (base is None and image == self.pole):
            drawn = image
        elif base is None:
            drawn = self.draft.draw(coincide, shown, image, free=True)
        elif anchor == base.A and image == base.a:
            drawn = self.draft.draw(
                similar, shown, base.a, base.b, base.A, base.B, point, free=True
            )
        else:
            drawn = self.draft.draw(
                homologous,
                shown,
                image,
                base.a,
                base.b,
                base.A,
                base.B,
                anchor,
                point,
                free=True,
            )
        known[letter] = drawn
        return drawn

    def complete(self, body: Body) -> None:
        """Draw the images of all letters of the link."""
        for letter in body.link.points:
            self.of(body.link.number, body.marks[letter], letter, image_letter(letter))


def image_letter(letter: str, link: int | None = None) -> str:
    """Return the small letter of an image; with the link's number for one of several points at a place."""
    return letter.lower() if link is None else f"{letter.lower()}{link}"


class Vector(NamedTuple):
    """A vector of a plan: its two marks and the segment's letter; ``absolute`` if it starts at the pole.

    ``step``: the one that drew or measured it first.
    """

    start: Mark
    end: Mark
    segment: str
    absolute: bool
    step: Step


def vectors(construction: Construction, plan: str) -> tuple[Vector, ...]:
    """Return the vectors of a plan in the order in which they were drawn or measured."""
    view = construction.view(plan)
    assert view is not None
    by_mark = {step.it: step for step in construction.steps}
    found: dict[tuple[Mark, Mark], Vector] = {}
    for step in construction.steps:
        if step.it.view != plan:
            continue
        ends = _ends(step, by_mark)
        if ends is not None:
            start, end, segment = ends
            found.setdefault((start, end), Vector(start, end, segment, start == view.pole, step))
    return tuple(found.values())


def _ends(step: Step, by_mark: dict[Mark, Step]) -> tuple[Mark, Mark, str] | None:
    if step.op in (measure, measure_along):
        return step.uses[0], step.uses[1], step.it.name
    if step.op is lay_off:
        drawn = by_mark[step.uses[0]]
        return drawn.uses[0], step.it, step.uses[1].name
    return None


def component(draft: Draft, segment: Mark, part: str, *images: str, of: str = "a") -> None:
    """Tell which component of an acceleration a segment is: normal, tangential, Coriolis (k), relative (r).

    ``images``: the letters of the point that it is of, and of the one it is about; ``of``: "v" of a velocity.
    """
    draft.figure(roles.COMPONENT, f"{of}_{{{''.join(images).upper()}}}^{{{part}}}", segment)


class PathPart(NamedTuple):
    """Of a point: its velocity as read (Length), the square to it, the acceleration along that (Length)."""

    speed: Mark
    normal: Mark
    part: Mark


@dataclass
class Motion:
    """A plan as drawn.

    ``readings[link]``: the segment read along the line of that link's leg, with its sign. ``measured``:
    images whose distance from the pole has been read. ``rates[link]``: the mark of the link's ω (or ε);
    a link that is absent does not turn. ``speeds``: what is given of each drive without its sign, ω or v, by
    link, in a plan of velocities.
    ``closed``: the image of each group's closing point, as a point of the second leg's link, by group name.
    ``ends``: of a leg of changing length, by its link, where the part begins that turns only; ``outs``: the
    segment (Length) of its rod's velocity seen from the cylinder. ``driven``: by the link of each drive, the
    ends of the vector that is given; ``possible``: of a mechanism that stands, what could be. ``pitches``: by
    the link of a wheel, the image of the pitch point as a point of it. ``paths``: of accelerations, by images,
    what was read square to paths.
    """

    images: Images
    mu: Mark
    readings: dict[int, Mark] = field(default_factory=dict)
    measured: set[Mark] = field(default_factory=set)
    rates: dict[int, Mark] = field(default_factory=dict)
    paths: dict[Mark, PathPart] = field(default_factory=dict)
    speeds: dict[int, Mark] = field(default_factory=dict)
    closed: dict[str, Mark] = field(default_factory=dict)
    ends: dict[int, Mark] = field(default_factory=dict)
    outs: dict[int, Mark] = field(default_factory=dict)
    driven: dict[int, tuple[Mark, Mark]] = field(default_factory=dict)
    pitches: dict[int, Mark] = field(default_factory=dict)
    possible: bool = False

    @property
    def speed(self) -> Mark | None:
        """What is given of the first drive, without its sign: ω of a crank; None in a plan of accelerations."""
        return next(iter(self.speeds.values()), None)


def pivot_image(plan: Motion, leg: PinLeg) -> Mark:
    """Return the image of the pivot of a turning leg."""
    return plan.images.of(leg.body, leg.pivot, leg.letter, image_letter(leg.letter))


def known_image(plan: Motion, closing: AnyClosing, leg: ClosingLeg) -> Mark:
    """Return the image that a leg starts from: of its pivot, or of the point of the body under Q."""
    match leg:
        case PinLeg():
            return pivot_image(plan, leg)
        case GuideLeg():
            letter = closing.pin_letter(leg)
            return plan.images.of(
                leg.body, closing.pin(leg), letter, image_letter(letter, leg.body)
            )
        case _:
            unheld(leg, plan.images.pole.view)


def pin_image(plan: Motion, closing: AnyClosing, leg: ClosingLeg) -> Mark:
    """Return the image of the inner end of a leg: of a closing point, or of a pin of a plate."""
    if isinstance(closing, Closing):
        return plan.closed[closing.group.name]
    bearer, letter = closing.borne(leg), closing.pin_letter(leg)
    return plan.images.of(bearer, closing.pin(leg), letter, closing.image_of(leg))


def hang_group(positions: Positions, plan: Motion, closing: Closing, point: Mark) -> None:
    """Enter both links of a group into the plan's images, complete them, and note rates they share.

    The stone of kind 3 turns as the rocker, that of kind 5 as the yoke: they come after these.
    """
    plan.closed[closing.group.name] = point
    first, second = closing.legs
    inner_first = isinstance(first, GuideLeg) and first.inner
    for leg in (second, first) if inner_first else (first, second):
        hang_leg(positions, plan, closing, leg, point)


def hang_leg(
    positions: Positions, plan: Motion, closing: AnyClosing, leg: ClosingLeg, point: Mark
) -> None:
    """Enter the links of a leg into the plan's images and complete them; ``point``: the image of its inner end.

    A link that slides turns as what it slides on.
    """
    known, pin, letter = dict[str, Mark](), closing.pin(leg), closing.pin_letter(leg)
    match leg:
        case PinLeg():
            start = known_image(plan, closing, leg)
            turned = plan.ends.get(leg.link, start)
            base = Base(leg.pivot, pin, turned, point)
            outer, inner = Hanging(leg.pivot, start, base), Hanging(pin, point, base)
            hanging = outer
            known[leg.letter] = start
            if leg.rod:
                rod, first_of = positions.bodies[leg.rod], positions.bodies[leg.link]
                hanging, other = (inner, outer) if leg.turned else (outer, inner)
                known = {k: m for k, m in known.items() if k in first_of.link.points}
                ends = {leg.letter: start, letter: point}
                plan.images.hang(
                    rod, other, {k: m for k, m in ends.items() if k in rod.link.points}
                )
                plan.images.complete(rod)
        case GuideLeg():
            at = known_image(plan, closing, leg) if leg.inner else point
            hanging = Hanging(pin, at, plan.images.hanging[leg.on].base)
            if leg.on in plan.rates:
                plan.rates[leg.link] = plan.rates[leg.on]
        case _:
            unheld(leg, plan.images.pole.view)
    body = positions.bodies[leg.link]
    if letter in body.link.points:
        known[letter] = hanging.image if hanging.anchor == pin else point
    plan.images.hang(body, hanging, known)
    plan.images.complete(body)


def hang_wheel(
    positions: Positions, plan: Motion, wheel: Meshed, centre: Mark, image: Mark
) -> None:
    """Enter a wheel's link into the plan's images: by its centre's, and the pitch point's as a point of it."""
    leg, body = wheel.leg, positions.bodies[wheel.rolling.link]
    base = Base(leg.pivot, wheel.pitch, centre, image)
    plan.pitches[leg.link] = image
    known = {leg.letter: centre, wheel.rolling.letter: image}
    plan.images.hang(body, Hanging(leg.pivot, centre, base), known)
    plan.images.complete(body)


def hold(plan: Motion, body: Body) -> None:
    """Enter a body that stands still: all its points are the pole."""
    anchor = next(iter(body.marks.values()))
    plan.images.hang(body, Hanging(anchor, plan.images.pole, None), {})
    plan.images.complete(body)


def hang_passive(positions: Positions, plan: Motion) -> None:
    """Enter the passive links into the plan's images, by those of the letters that they share.

    One that slides turns as what it slides on.
    """
    for passive in positions.passive:
        body = positions.bodies[passive.link]
        known = {letter: plan.images.by_letter[on][letter] for letter, on in passive.pins}
        (first, image), *others = known.items()
        at = body.marks[first]
        if passive.slide is None:
            second, end = others[0]
            hanging = Hanging(at, image, Base(at, body.marks[second], image, end))
        else:
            on = passive.slide.on
            hanging = Hanging(at, image, plan.images.hanging[on].base)
            if on in plan.rates:
                plan.rates[passive.link] = plan.rates[on]
        plan.images.hang(body, hanging, known)
        plan.images.complete(body)


def passive_legs(positions: Positions, plan: Motion) -> Iterator[tuple[PinLeg, Mark, Mark]]:
    """Yield the legs of the passive links that two letters hold, with the images of both."""
    for passive in positions.passive:
        if passive.leg is not None:
            (first, _), (second, _), *_ = passive.pins
            images = plan.images.by_letter[passive.link]
            yield passive.leg, images[first], images[second]


def measure_absolute(draft: Draft, plan: Motion, positions: Positions) -> None:
    """Measure the vector from the pole to the image of every moving point that has no reading yet.

    The point of a moving link that lies under a stone on its guide is one of them, and so is a rocker's under
    the crank's pin.
    """
    pole = plan.images.pole
    because = {
        roles.VELOCITY: why.ABSOLUTE_VELOCITY,
        roles.ACCELERATION: why.ABSOLUTE_ACCELERATION,
    }[pole.role]
    images = [
        plan.images.by_letter[number][letter]
        for number, body in positions.bodies.items()
        for letter in body.link.points
    ]
    images += [
        known_image(plan, closing, leg)
        for closing, leg in outer_guides(positions.closings, pole.view)
    ]
    images += plan.closed.values()
    for image in images:
        if image == pole or image in plan.measured:
            continue
        plan.measured.add(image)
        draft.draw(measure, between(pole, image.letter), pole, image, why=because)


def reading_of(draft: Draft, plan: Motion, image: Mark) -> Mark | None:
    """Return the length of the vector from the pole to an image, as read (Length); None at the pole itself.

    The crank pin's was laid off, not read. A reading along a line has a sign.
    """
    pole = plan.images.pole
    if image == pole:
        return None
    return draft.board.length(pole, image) or draft.uses(image)[1]


def is_signed(draft: Draft, reading: Mark) -> bool:
    """Whether a reading was taken along a line."""
    return draft.board.step(reading).op is measure_along
