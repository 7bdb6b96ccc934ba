"""What a plan of velocities or accelerations leaves: its images, its readings, the links' rates."""

from __future__ import annotations

from dataclasses import dataclass, field

from graphic_tmm.board import roles
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.naming import between
from graphic_tmm.board.operations.instruments import measure, measure_along
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics import reasons as why
from graphic_tmm.chapters.kinematics.bodies import Closing, GuideLeg, PinLeg
from graphic_tmm.chapters.kinematics.images import Base, Hanging, Images, image_letter
from graphic_tmm.chapters.kinematics.positions import Positions


@dataclass
class Motion:
    """A plan as drawn.

    ``readings[link]``: the segment read along the line of that link's leg, with its sign. ``measured``:
    images whose distance from the pole has been read. ``rates[link]``: the mark of the link's ω (or ε);
    a link that is absent does not turn. ``speed``: the crank's ω without its sign, in a plan of velocities.
    ``closed``: the image of each group's closing point, as a point of the second leg's link, by group name.
    """

    images: Images
    mu: Mark
    readings: dict[int, Mark] = field(default_factory=dict)
    measured: set[Mark] = field(default_factory=set)
    rates: dict[int, Mark] = field(default_factory=dict)
    speed: Mark | None = None
    closed: dict[str, Mark] = field(default_factory=dict)


def known_image(plan: Motion, closing: Closing, leg: PinLeg | GuideLeg) -> Mark:
    """Return the image that a leg starts from: of its pivot, or of the point of the body under Q."""
    if isinstance(leg, PinLeg):
        return plan.images.of(leg.body, leg.pivot, leg.letter, image_letter(leg.letter))
    shown = image_letter(closing.letter, leg.body)
    return plan.images.of(leg.body, closing.point, closing.letter, shown)


def hang_group(positions: Positions, plan: Motion, closing: Closing, point: Mark) -> None:
    """Enter both links of a group into the plan's images, complete them, and note rates they share.

    A link that slides turns as what it slides on: the stone of kind 3 as the rocker, that of kind 5 as
    the yoke.
    """
    plan.closed[closing.group.name] = point
    first, second = closing.legs
    inner_first = isinstance(first, GuideLeg) and first.inner
    for leg in (second, first) if inner_first else (first, second):
        known = {}
        if isinstance(leg, PinLeg):
            start = known_image(plan, closing, leg)
            hanging = Hanging(leg.pivot, start, Base(leg.pivot, closing.point, start, point))
            known[leg.letter] = start
        else:
            model = second.link if leg.inner else leg.body
            at = known_image(plan, closing, leg) if leg.inner else point
            hanging = Hanging(closing.point, at, plan.images.hanging[model].base)
            if model in plan.rates:
                plan.rates[leg.link] = plan.rates[model]
        body = positions.bodies[leg.link]
        if closing.letter in body.link.points:
            known[closing.letter] = hanging.image if hanging.anchor == closing.point else point
        plan.images.hang(body, hanging, known)
        plan.images.complete(body)


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
        for closing in positions.closings
        for leg in closing.legs
        if isinstance(leg, GuideLeg) and not leg.inner
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
