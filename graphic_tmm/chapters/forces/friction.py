"""Friction from the reactions of the pass before; to which link a pin is counted where more than two meet."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si
from graphic_tmm.board.operations.instruments import measure_along
from graphic_tmm.board.operations.statics import (
    circle_radius,
    difference_of,
    pin_friction,
    reversed_,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.detached import Reaction
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.forces.statics import inside
from graphic_tmm.chapters.forces.task import Friction
from graphic_tmm.chapters.forces.unknowns import Slope, links_of
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.closings import AnyClosing, GuideLeg, groups_of
from graphic_tmm.chapters.kinematics.drives.pair import DrivenPair, reach
from graphic_tmm.chapters.kinematics.motion import Motion, known_image, pin_image
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import joined, said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.mechanism.groups import Pair

VIEW = "friction"


class Joint(NamedTuple):
    """A pair where friction is called for: its name, its links (link, body), its kind, the closing it is in."""

    pair: Pair
    links: tuple[int, int]
    closing: AnyClosing | None
    driven: DrivenPair | None = None


@dataclass
class Rubbing:
    """Friction of one pass: couples of the pins, slopes of the reactions of guides by pair."""

    couples: list[Couple] = field(default_factory=list)
    slopes: dict[tuple[int, int], Slope] = field(default_factory=dict)


Reactions = dict[tuple[int, int, str], Reaction]
"""Reactions of a pass by (link, body, name of the pair)."""


def guide_leg(joint: Joint) -> GuideLeg:
    """Return the leg along whose line a pair slides: that of its link, or the inner one."""
    assert joint.closing is not None
    link, body = joint.links
    return next(
        leg
        for leg in joint.closing.legs
        if isinstance(leg, GuideLeg) and (link, body) in ((leg.link, leg.body), (leg.on, leg.link))
    )


def joints(closings: tuple[AnyClosing, ...], pairs: Iterable[DrivenPair]) -> tuple[Joint, ...]:
    """Return all pairs of a mechanism; ``pairs``: its drives."""
    there = (one for one in pairs if not one.driven.telescopes)
    found = [Joint(one.pair, one.pair.links, None, one) for one in there]
    for closing in groups_of(closings, "forces"):
        for leg, own in zip(closing.legs, closing.group.legs, strict=True):
            found.append(Joint(own.pair, (links_of(leg)[0], leg.body), closing))
        for pair, (pushes, pushed) in zip(closing.group.inner_pairs, inside(closing), strict=True):
            found.append(Joint(pair, (pushed, pushes), closing))
    return tuple(found)


class _Rubs(NamedTuple):
    """Where friction acts along a guide: point and line, the images of it and of the point under it."""

    point: Mark
    line: Mark
    image: Mark
    under: Mark


def _usual_rate(draft: Draft, pair: DrivenPair) -> Mark:
    """Take the angular velocity that turning is measured by where a drive slides: v over all lengths."""
    return draft.take(Number, "v/Σl", abs(pair.speed) / reach(pair.mechanism), "1/s")


class Rub:
    """Draws the friction of the joints, pass after pass; radii of friction circles are calculated once."""

    def __init__(
        self, draft: Draft, plans: tuple[Positions, Motion], friction: Friction, pair: DrivenPair
    ) -> None:
        self.draft, self.friction = draft, friction
        self.positions, self.velocities = plans
        self.pin_speed = draft.uses(self.velocities.driven[pair.link][1])[1]
        self.fastest = self.velocities.rates.get(pair.link) or _usual_rate(draft, pair)
        self.circles: dict[str, Mark] = {}
        self._coefficients: dict[str, Mark] = {}
        self._relative: dict[tuple[int, int], Mark | None] = {}

    def draw(self, found: tuple[Joint, ...], reactions: Reactions, number: int) -> Rubbing:
        """Return the friction of a pass by its number: what the reactions of the pass before cause."""
        self.draft.open(VIEW)
        made = Rubbing()
        for joint in found:
            if self.friction.f.get(joint.pair.name, 0.0) <= 0.0:
                continue
            reaction = reactions[(*joint.links, joint.pair.name)]
            if joint.pair.kind == "R":
                if not made.couples:
                    self.draft.say(f"{VIEW} {number}")
                self._pin(joint, reaction, made)
            else:
                self._guide(joint, reaction, made)
        return made

    def _coefficient(self, name: str) -> Mark:
        if name not in self._coefficients:
            value = self.friction.f[name]
            self._coefficients[name] = self.draft.take(Number, f"f_{{{name}}}", value)
        return self._coefficients[name]

    def _pin(self, joint: Joint, reaction: Reaction, made: Rubbing) -> None:
        draft, (link, body), name = self.draft, joint.links, joint.pair.name
        radius = self.friction.radius.get(name, 0.0)
        omega = self._turning(link, body)
        if radius <= 0.0 or omega is None:
            return
        if name not in self.circles:
            of = self.draft.take(Number, f"r_{{{name}}}", radius, "m")
            self.circles[name] = draft.draw(
                circle_radius, f"ρ_{{{name}}}", self._coefficient(name), of, unit="m"
            )
        letter = f"M_{{f{name}{link}}}"
        value = draft.draw(
            pin_friction,
            letter,
            self.circles[name],
            reaction.value,
            omega,
            self.fastest,
            unit="N·m",
        )
        made.couples.append(Couple(letter, link, value, (name, body)))
        back = draft.draw(reversed_, f"M_{{f{name}{body}}}", value, unit="N·m")
        made.couples.append(Couple(f"M_{{f{name}{body}}}", body, back, (name, link)))

    def _guide(self, joint: Joint, reaction: Reaction, made: Rubbing) -> None:
        assert reaction.normal is not None
        if not self._moves(joint):
            return
        segment = (
            self.velocities.readings[guide_leg(joint).link]
            if joint.closing is not None
            else self.draft.uses(self.velocities.driven[joint.links[0]][1])[1]
        )
        f = self._coefficient(joint.pair.name)
        made.slopes[joint.links] = Slope(f, reaction.normal, segment, self.pin_speed)

    def _moves(self, joint: Joint) -> bool:
        """Whether a pair is no held slider's: nothing rubs there."""
        return joint.closing is not None or joint.links[0] in self.velocities.driven

    def along_guides(
        self, found: tuple[Joint, ...], reactions: Reactions, taken: Container[str]
    ) -> list[Force]:
        """Measure the friction forces along the guides: of each pair on both of its links.

        ``taken``: the letters of loads, which none of them may bear.
        """
        made = []
        for joint in found:
            rough = self.friction.f.get(joint.pair.name, 0.0) > 0.0
            if joint.pair.kind == "P" and rough and self._moves(joint):
                made += self._along(joint, reactions[(*joint.links, joint.pair.name)], taken)
        return made

    def _along(self, joint: Joint, reaction: Reaction, taken: Container[str]) -> list[Force]:
        draft, (link, body), view = self.draft, joint.links, reaction.length.view
        rubs = self._rubs_at(joint)
        draft.open(view)
        letters = [f"F_{{{body}{link}}}", f"F_{{{link}{body}}}"]
        letters = [f"F_{{f{one[3:]}" if one in taken else one for one in letters]
        ends = (reaction.tail, reaction.head)
        segment = draft.draw(
            measure_along, f"y_{{F{body}{link}}}", *ends, rubs.line, why=why.FRICTION_READ
        )
        value = draft.draw(in_si, letters[0], segment, unit="N")
        made = [Force(letters[0], link, rubs.point, rubs.line, value, rubs.image)]
        if rubs.under != self.velocities.images.pole:
            back = draft.draw(reversed_, letters[1], value, unit="N")
            made.append(Force(letters[1], body, rubs.point, rubs.line, back, rubs.under))
        return made

    def _rubs_at(self, joint: Joint) -> _Rubs:
        """Return where friction acts along a guide."""
        closing, plan = joint.closing, self.velocities
        if closing is not None:
            leg = guide_leg(joint)
            own = pin_image(plan, closing, leg)
            return _Rubs(closing.pin(leg), leg.line, own, known_image(plan, closing, leg))
        assert joint.driven is not None
        _, pin = joint.driven.led(self.positions)
        under, own = plan.driven[joint.links[0]]
        return _Rubs(pin, joint.driven.path(self.positions, self.draft.uses), own, under)

    def _turning(self, link: int, body: int) -> Mark | None:
        """Return the angular velocity of a link relative to another; None if there is none."""
        if (link, body) not in self._relative:
            rates, draft = self.velocities.rates, self.draft
            own, other = rates.get(link), rates.get(body)
            letter = f"ω_{{{link}{body}}}"
            if own == other:
                found = None
            elif own is None and other is not None:
                found = draft.draw(reversed_, letter, other, unit="1/s")
            elif other is None:
                found = own
            else:
                assert own is not None
                found = draft.draw(difference_of, letter, own, other, unit="1/s")
            self._relative[link, body] = found
        return self._relative[link, body]


SHORT = said("pin {letter} is counted to link {link}")
"""What stands below a figure."""
WHOLE = said(
    "Links {links} meet in pin {letter}, which is counted to link {link}: {reactions}, the forces of link "
    "{link} with the pin on each of the others; a load at {letter} acts on the link that it is given on."
)
"""What stands below the table, in the protocol and in the note."""


class SharedPin(NamedTuple):
    """A pin of more than two links: its letter, the link that bears it, the others as they are attached."""

    letter: str
    bearer: int
    others: tuple[int, ...]


def shared_pins(drawn: Drawn) -> Iterator[SharedPin]:
    """Yield the pins in which more than two links meet, in the order of attachment."""
    plans = KINEMATICS_PLAN.on(drawn)
    on: dict[tuple[str, int], list[int]] = {}
    for joint in joints(plans.positions.closings, plans.pairs):
        if joint.pair.kind == "R":
            link, bearer = joint.links
            on.setdefault((joint.pair.name, bearer), []).append(link)
    for (letter, bearer), others in on.items():
        if len(others) > 1:
            yield SharedPin(letter, bearer, tuple(others))


def below(drawn: Drawn, links: tuple[int, ...], language: str) -> list[str]:
    """Return the lines that stand below the figure of some links."""
    _ = speaking(language)
    return [
        _(SHORT, letter=symbol(pin.letter, language), link=pin.bearer)
        for pin in shared_pins(drawn)
        if {pin.bearer, *pin.others} & set(links)
    ]


def pin_sentences(drawn: Drawn, language: str) -> list[str]:
    """Return a sentence on each shared pin (mark-up)."""
    _ = speaking(language)
    return [
        _(
            WHOLE,
            links=joined(", ", map(str, (pin.bearer, *pin.others))),
            letter=symbol(pin.letter, language),
            link=pin.bearer,
            reactions=", ".join(
                symbol(f"R_{{{pin.bearer}{other}}}", language) for other in pin.others
            ),
        )
        for pin in shared_pins(drawn)
    ]
