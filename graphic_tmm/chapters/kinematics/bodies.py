"""Links as they stand on the plan of positions: points, a line fixed in each, what slides on them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from graphic_tmm.board.draft import ROUNDING, Draft
from graphic_tmm.board.operations.instruments import (
    incline,
    lay_off,
    parallel,
    place,
    shift,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.closings import (
    AnyClosing,
    GuideLeg,
    PinLeg,
    outer_guides,
)
from graphic_tmm.errors import ConstructionError
from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.guides import direction, level, turn
from graphic_tmm.mechanism.records import Arm, Link, Slide
from graphic_tmm.mechanism.wheels import Rolling


@dataclass
class Body:
    """A link on the plan of positions while it is being drawn.

    ``marks``: its points by letter; ``own``: where they are in the link's own axes, m. Its axis is a line
    whose beginning stands at ``at`` (own axes, m) and whose direction is ``angle`` (own axes, degrees); it
    is drawn when it is first needed.
    """

    link: Link
    at: complex
    angle: float
    draw_axis: Callable[[], Mark]
    marks: dict[str, Mark] = field(default_factory=dict)
    own: dict[str, complex] = field(default_factory=dict)
    _axis: Mark | None = None

    def letter_of(self, point: Mark) -> str:
        """The letter under which the scene names one of its points."""
        return next(letter for letter, mark in self.marks.items() if mark == point)

    @property
    def drawn(self) -> bool:
        """Whether the axis has been drawn."""
        return self._axis is not None

    @property
    def axis(self) -> Mark:
        """The line fixed in the link."""
        if self._axis is None:
            self._axis = self.draw_axis()
        return self._axis

    def __getstate__(self) -> dict[str, Any]:
        """Return what another process needs: the board on which its axis would be drawn stays here."""
        return {**self.__dict__, "draw_axis": _without_board}


def _without_board() -> Mark:
    raise ConstructionError("the axis of a link can be drawn only where its board is")


class Passive(NamedTuple):
    """A passive link as drawn: its number, the letters that hold it with the links that bear them, its axis.

    ``leg``: from the first of two letters to the second; ``slide``: the guide that holds it in their place.
    """

    link: int
    pins: tuple[tuple[str, int], ...]
    axis: Mark
    leg: PinLeg | None
    slide: Slide | None


class Meshed(NamedTuple):
    """A wheel as drawn: how it rolls, its leg from its centre to the pitch point, that point, its own angle.

    Of a belt the pitch point is where its pulling run leaves the wheel, and ``span`` the run from the other
    wheel to there: what a link would be whose pins are at both ends.
    """

    rolling: Rolling
    leg: PinLeg
    pitch: Mark
    angle: Mark
    span: PinLeg | None = None

    @property
    def far(self) -> Mark:
        """Where the other wheel is held: at the pitch point, or at the other end of the run of a belt."""
        return self.span.pivot if self.span else self.pitch

    @property
    def letter(self) -> str:
        """The letter of the image of the pitch point."""
        return self.rolling.letter.lower()


@dataclass(frozen=True)
class Positions:
    """The plan of positions as drawn: bodies by number, groups' closings, the side marks of the groups.

    ``row``: where each drive stands, the one that makes the row first. ``passive``: the passive links, last in
    ``bodies``. ``wheels``: those that roll on others.
    """

    bodies: dict[int, Body]
    closings: tuple[AnyClosing, ...]
    sides: dict[str, Mark]
    row: tuple[Mark, ...]
    passive: tuple[Passive, ...] = ()
    wheels: tuple[Meshed, ...] = ()

    def point(self, letter: str) -> Mark:
        """Return the mark of a letter, on whichever link it stands."""
        return next(body.marks[letter] for body in self.bodies.values() if letter in body.marks)

    def pivot_of(self, letter: str, frame: int) -> Mark | None:
        """Return the point of the frame about which a link of this letter turns, if one does."""
        fixed = self.bodies[frame].marks
        moving = (body for number, body in self.bodies.items() if number != frame)
        held = (body.marks for body in moving if letter in body.marks)
        return next((fixed[k] for marks in held for k in marks if k in fixed), None)


def sliding_points(
    closings: Iterable[AnyClosing], bodies: Mapping[int, Body], frame: int, room: str
) -> list[tuple[str, GuideLeg]]:
    """Return the points of links that slide on the frame, each with the leg by which it does."""
    guides = [leg for _, leg in outer_guides(closings, room) if leg.body == frame]
    return [(point, leg) for leg in guides for point in bodies[leg.link].link.points]


def off_axis(body: Body, point: complex) -> tuple[float, float]:
    """Return where a point (own axes, m) stands along and to the left of the body's axis, m."""
    return _off(point, body.at, body.angle)


def _off(point: complex, at: complex, angle: float) -> tuple[float, float]:
    z = (point - at) * turn(-angle)
    least = ROUNDING * max(abs(point), abs(at), abs(z))
    x, y = (0.0 if abs(part) <= least else part for part in (z.real, z.imag))
    return x, y


def draw_points(draft: Draft, body: Body, anchor: str) -> None:
    """Draw the points of the body that do not stand on the board yet, from its axis.

    ``anchor`` is the letter (or sign) at the axis' beginning: it names the lengths laid off.
    """
    lines: dict[Arm, Mark] = {}
    for letter, own in body.link.points.items():
        if letter in body.marks:
            continue
        arm = next((k for k in body.link.arms if letter in k.letters and k.at in body.marks), None)
        if arm is None or (arm.angle == body.angle and body.own[arm.at] == body.at):
            x, y = off_axis(body, own)
            stand(body, letter, lay_out(draft, body.axis, letter, anchor, x, y), own)
            continue
        if arm not in lines:
            bent = body.marks[arm.at], body.axis, arm.angle - body.angle
            lines[arm] = incline_by(draft, f"{arm.at}{letter}", *bent, because=why.ARM)
        x, y = _off(own, body.link.points[arm.at], arm.angle)
        stand(body, letter, lay_out(draft, lines[arm], letter, arm.at, x, y), own)


def anchor(body: Body) -> str:
    """Return the letter at the beginning of a body's axis, or its number where no point stands there."""
    return next((k for k, own in body.own.items() if own == body.at), str(body.link.number))


def stand(body: Body, letter: str, mark: Mark, own: complex) -> None:
    """Note that a point of the body stands on the board."""
    body.marks[letter] = mark
    body.own[letter] = own


def lay_out(draft: Draft, axis: Mark, letter: str, anchor: str, x: float, y: float) -> Mark:
    """Draw the point at x along and y to the left of an axis (m); a coordinate that is 0 takes no step."""
    if y == 0.0:
        along = draft.length(f"{anchor}{letter}", x)
        return draft.draw(lay_off, letter, axis, along, why=why.POINT)
    if x == 0.0:
        start = draft.uses(axis)[0]
        upright = draft.draw(square, f"({anchor}{letter})", start, axis, why=why.UPRIGHT)
        left = draft.length(f"y_{{{letter}}}", y)
        return draft.draw(lay_off, letter, upright, left, why=why.POINT)
    along, left = draft.length(f"x_{{{letter}}}", x), draft.length(f"y_{{{letter}}}", y)
    return draft.draw(place, letter, axis, along, left, why=why.POINT)


def incline_by(
    draft: Draft,
    name: str,
    through: Mark,
    to: Mark,
    degrees: float,
    because: str = why.SLIDER_PATH,
) -> Mark:
    """Draw a line through a point at an angle to another line: parallel, square or by the protractor."""
    rest = degrees % 360.0
    name = f"({name})"
    if rest in (0.0, 180.0):
        sense = 1 if rest == 0.0 else -1
        return draft.draw(parallel, name, through, to, sense=sense, why=because)
    if rest in (90.0, 270.0):
        sense = 1 if rest == 90.0 else -1
        return draft.draw(square, name, through, to, sense=sense, why=because)
    return draft.draw(incline, name, through, to, draft.direction(degrees), why=because)


def nearest(number: int, points: Mapping[str, complex], pair: Pair, levelled: float) -> str:
    """Return the letter of a link's point (own axes) that lies nearest to a level (m) of a guide."""
    return min(points, key=lambda k: abs(levelled - level(pair, number, points[k])))


def draw_guide(draft: Draft, body: Body, pair: Pair, levelled: float, name: str) -> Mark:
    """Draw the path, on a body, of the point that slides at the given level (m) off the guide.

    The line starts from the point of the body that is nearest to it.
    """
    number = body.link.number
    letter = nearest(number, body.own, pair, levelled)
    own = body.own[letter]
    size = max(abs(own), abs(body.at), abs(levelled))
    by = levelled - level(pair, number, own)
    bend = direction(pair, number) - body.angle
    if abs(by) <= ROUNDING * size and own == body.at and bend % 360.0 == 0.0:
        return body.axis
    if abs(by) <= ROUNDING * size:
        return incline_by(draft, name, body.marks[letter], body.axis, bend)
    inclined = incline_by(draft, f"{name}′", body.marks[letter], body.axis, bend)
    return draft.draw(
        shift, f"({name})", inclined, draft.length(f"h_{{{name}}}", by), why=why.SLIDER_PATH
    )
