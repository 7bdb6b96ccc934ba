"""The follower of a cam given by arcs in all positions: reversed motion, one arc after the other, readings."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import to_board
from graphic_tmm.board.operations.instruments import (
    cross,
    cut,
    join,
    lay_off,
    measure_along,
    meet,
    parallel,
    shift,
    square,
    strike,
    tangent,
    touch,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Reals, Side
from graphic_tmm.chapters.arc_cam import formulas as f
from graphic_tmm.chapters.arc_cam import words as why
from graphic_tmm.chapters.arc_cam.contour import Arc, Contour, End
from graphic_tmm.chapters.arc_cam.formulas import line_on_arc, on_arc, turn_between
from graphic_tmm.chapters.arc_cam.geometry import ARCS, TURN, Lie, side_on_straight
from graphic_tmm.chapters.arc_cam.task import FLAT, FLAT_ROCKER, ArcTask
from graphic_tmm.chapters.cam.operations import slant, slew


class Follower(NamedTuple):
    """The follower in all positions.

    ``guides``: the lines of the rod, out of the cam (of a rocker: from the cam's centre to the pivot);
    ``pivots`` of the lever, None without one. ``points`` B: the roller's centre, or where the rod's line meets
    the face; ``contacts``: where a flat face touches, None for a roller. ``instant``: the instant centre P of
    cam and follower. ``travel``: S (Length), or the swing (Angle). ``part``: OP as read (Length), ``rate``:
    dS/dφ from it (Number). ``pressure``: the pressure angle (Angle), None under a flat face. ``rows``: how what
    is given of each position follows from its number.
    """

    guides: Mark
    pivots: Mark | None
    points: Mark
    contacts: Mark | None
    instant: Mark
    travel: Mark
    part: Mark
    rate: Mark
    work: Mark
    pressure: Mark | None
    rows: Mapping[Mark, Callable[[Reals], Reals]]


class _Own(NamedTuple):
    """What is drawn for the positions at which the follower is on one arc."""

    guide: Mark
    point: Mark
    instant: Mark
    pivot: Mark | None = None
    contact: Mark | None = None


def draw_follower(
    draft: Draft, order: ArcTask, contour: Contour, lie: Lie, numbers: Reals, sense: int
) -> Follower:
    """Draw the follower in its positions; ``numbers``: of each, from 0 where it begins to rise."""
    page, rows = _Page(draft, order, contour, sense), dict[Mark, Callable[[Reals], Reals]]()
    on = lie.arcs_at(numbers / order.parts)
    owns, inside = [], []
    for k, name in enumerate(ARCS):
        if not (on == k).any():
            continue
        draft.say(name)
        there = partial(_on_arc, lie, order.parts, k)
        n = draft.take(Number, "n", (numbers * there(numbers, np.nan))[None, :])
        rows[n] = partial(_numbers, there)
        page.index = str(k + 1)
        owns.append(page.own(contour.arcs[name], page.angle(n)))
        inside.append(there)
    draft.say("readings")
    found = owns[-1]
    for own, there in zip(owns[-2::-1], inside[-2::-1], strict=True):
        page.index = "" if own is owns[0] else f"{{{len(owns) - 1},{len(owns)}}}"
        at = draft.take(Number, "σ", there(numbers)[None, :])
        rows[at] = there
        found = page.merged(own, found, at)
    return page.read(found)._replace(rows=rows)


def _on_arc(lie: Lie, parts: int, arc: int, numbers: Reals, off: float = 0.0) -> Reals:
    """Return 1 of the positions at which the follower is on an arc."""
    return np.where(lie.arcs_at(numbers / parts) == arc, 1.0, off)


def _numbers(there: Callable[..., Reals], numbers: Reals) -> Reals:
    return numbers * there(numbers, np.nan)


LETTERS = {"point": "B", "instant": "P", "pivot": "O_1", "contact": "K"}
"""What is drawn in every position, as its letters."""


class _Page:
    """The contour on which positions are drawn, and the sense in which the cam turns."""

    def __init__(self, draft: Draft, order: ArcTask, contour: Contour, sense: int) -> None:
        self.draft, self.order, self.contour, self.sense = draft, order, contour, sense
        self.rocks, self.index = order.rocks, ""
        self.left = sense * (-1 if order.same_sense else 1)
        draw = draft.draw
        if order.offset:
            e = draft.take(Number, "l_{e}", -sense * order.offset, "m")
            self.offset: Mark | None = draw(to_board, "e", e)
        else:
            self.offset = None
        if self.rocks:
            assert order.centres is not None
            self.centres = self._length("a", order.centres)
            if order.lever is not None:
                self.lever = self._length("l", order.lever)
        self.begin = self._end(contour.ends[0], "0")
        self.parts = draft.take(Number, "N", float(order.parts))
        if order.eccentric:
            self.work = draft.angle("Φ", TURN)
        else:
            ends = (self.begin, self._end(contour.ends[1], "N"))
            self.work = draw(turn_between, "Φ", *ends, sense=-sense, unit="°")

    def _length(self, letter: str, real: float) -> Mark:
        """Calculate a length on the board."""
        mark = self.draft.take(Number, f"l_{{{letter}}}", real, "m")
        return self.draft.draw(to_board, letter, mark)

    def _end(self, end: End, index: str) -> Mark:
        """Draw the line of the rod, or of the pivots, through the cam's centre where the follower goes over."""
        draw, origin = self.draft.draw, self.contour.origin
        if self.order.follower == FLAT:
            return draw(parallel, f"(B_{index})", origin, end.normal, why=why.FIRST)
        if self.order.follower == FLAT_ROCKER:
            return self._end_of_face(end, index)
        if self.rocks:
            arcs = (
                draw(strike, "(a)", origin, self.centres),
                draw(strike, "(l)", end.point, self.lever),
            )
            where = self.draft.take(Side, "±", float(-self.left))
            pivot = draw(cross, f"O_{{1,{index}}}", *arcs, where, why=why.FIRST)
            return draw(join, f"(OO_{{1,{index}}})", origin, pivot, why=why.FIRST)
        if self.offset is None:
            return draw(join, f"(OB_{index})", origin, end.point, why=why.FIRST)
        side = self.draft.take(Side, "±", 1.0)
        guide = draw(tangent, f"(B_{index})", end.point, origin, self.offset, side, why=why.OFFSET)
        return draw(parallel, f"(OB_{index})", origin, guide, why=why.FIRST)

    def _end_of_face(self, end: End, index: str) -> Mark:
        """Draw the line of the pivots where a flat rocker's line is square to the normal of the contour."""
        draw = self.draft.draw
        circle = draw(strike, "(a)", self.contour.origin, self.centres)
        line = draw(square, f"(b_{index})", end.point, end.normal, sense=1, why=why.FIRST)
        where = self.draft.take(
            Side, "±", 1.0 if self.order.same_sense == (self.sense > 0) else -1.0
        )
        pivot = draw(cut, f"O_{{1,{index}}}", line, circle, where, why=why.FIRST)
        return draw(join, f"(OO_{{1,{index}}})", self.contour.origin, pivot, why=why.FIRST)

    def letter(self, letter: str) -> str:
        """Return a letter with the number of the arc, or of the arcs, that the follower is on."""
        name = letter.strip("()").replace("_1", "′") if self.index else letter.strip("()")
        name = f"{name}_{self.index}" if self.index else name
        return f"({name})" if letter.startswith("(") else name

    def angle(self, n: Mark) -> Mark:
        """Calculate the angle of the cam in positions that are numbered."""
        return self.draft.draw(f.part_of_work, "φ", n, self.work, self.parts, unit="°")

    def own(self, arc: Arc, angle: Mark) -> _Own:
        """Draw the positions at which the follower is on an arc; ``angle``: the cam's, missing elsewhere."""
        draw, origin = self.draft.draw, self.contour.origin
        guide = draw(
            slew, self.letter("(B)"), origin, self.begin, angle, sense=-self.sense, why=why.INVERTED
        )
        if self.rocks:
            return self._rocked(arc, guide)
        across = draw(square, "(O)", origin, guide, sense=-self.sense, why=why.ACROSS)
        if self.offset is not None:
            guide = draw(shift, self.letter("(B)"), guide, self.offset, why=why.OFFSET)
        if self.order.follower == FLAT:
            return self._flat(arc, guide, across)
        assert arc.way is not None
        if arc.centre is None:
            point = draw(meet, self.letter("B"), guide, arc.way, free=True, why=why.ON_STRAIGHT)
        else:
            where = self.draft.take(Side, "±", -1.0 if arc.hollow else 1.0)
            point = draw(cut, self.letter("B"), guide, arc.way, where, free=True, why=why.REPLACED)
        return _Own(guide, point, self._instant(arc, point, across, why.ACROSS))

    def _instant(self, arc: Arc, point: Mark, across: Mark, reason: str) -> Mark:
        draw = self.draft.draw
        if arc.centre is None:
            assert arc.way is not None
            normal = draw(square, "(n)", point, arc.way, why=why.NORMAL)
        else:
            normal = draw(join, f"({arc.centre.name}B)", arc.centre, point, why=why.NORMAL)
        return draw(meet, self.letter("P"), across, normal, free=True, why=reason)

    def _flat(self, arc: Arc, guide: Mark, across: Mark) -> _Own:
        draw, contact = self.draft.draw, arc.centre
        assert contact is not None
        line = draw(parallel, "(K)", contact, guide, why=why.FACE)
        if arc.radius is not None:
            contact = draw(lay_off, self.letter("K"), line, arc.radius, free=True, why=why.FACE)
        face = draw(square, "(f)", contact, guide, why=why.FACE)
        point = draw(meet, self.letter("B"), guide, face, free=True, why=why.FACE)
        return _Own(
            guide,
            point,
            draw(meet, self.letter("P"), across, line, free=True, why=why.ACROSS),
            None,
            contact,
        )

    def _rocked(self, arc: Arc, line: Mark) -> _Own:
        draw, draft = self.draft.draw, self.draft
        pivot = draw(lay_off, self.letter("O_1"), line, self.centres, free=True, why=why.INVERTED)
        if self.order.follower == FLAT_ROCKER:
            return self._tilted(arc, line, pivot)
        assert arc.way is not None
        swing = draw(strike, "(l)", pivot, self.lever)
        if arc.centre is None:
            flank, rising = (self.order.rise, 1) if arc.name == "rise" else (self.order.fall, -1)
            side = -self.sense * side_on_straight(self.order, flank, rising)
            point = draw(
                cut, self.letter("B"), arc.way, swing, draft.take(Side, "±", float(side)), free=True
            )
        else:
            side = -self.left * (-1 if arc.hollow else 1)
            where = draft.take(Side, "±", float(side))
            point = draw(
                cross, self.letter("B"), swing, arc.way, where, free=True, why=why.REPLACED
            )
        return _Own(line, point, self._instant(arc, point, line, why.PIVOTS), pivot)

    def _tilted(self, arc: Arc, line: Mark, pivot: Mark) -> _Own:
        """Draw a flat rocker on an arc: its line touches the circle at the face's distance about the centre."""
        draw, contact = self.draft.draw, arc.centre
        assert contact is not None
        point = contact
        if arc.way is not None:
            side = self.draft.take(Side, "±", float(-self.left))
            point = draw(
                touch, self.letter("B"), pivot, arc.way, side, free=True, why=why.FACE_OF_LEVER
            )
        lever = draw(join, "(O_1B)", pivot, point)
        normal = draw(square, "(n)", point, lever, sense=1, why=why.NORMAL)
        if arc.radius is not None:
            out = draw(square, "(K)", contact, lever, sense=-self.left, why=why.NORMAL)
            contact = draw(
                lay_off, self.letter("K"), out, arc.radius, free=True, why=why.FACE_OF_LEVER
            )
        instant = draw(meet, self.letter("P"), line, normal, free=True, why=why.PIVOTS)
        return _Own(line, point, instant, pivot, contact)

    def merged(self, own: _Own, other: _Own, at: Mark) -> _Own:
        """Put together what was drawn for an arc and for those behind it."""
        draw = self.draft.draw

        def point(name: str) -> Mark | None:
            first, second = getattr(own, name), getattr(other, name)
            if first is None:
                return None
            return draw(on_arc, self.letter(LETTERS[name]), first, second, at, free=True)

        guide = draw(line_on_arc, self.letter("(B)"), own.guide, other.guide, at)
        found = {name: point(name) for name in LETTERS}
        assert found["point"] is not None
        assert found["instant"] is not None
        return _Own(guide, found["point"], found["instant"], found["pivot"], found["contact"])

    def read(self, own: _Own) -> Follower:
        """Read what the follower does: travel or swing, the instant centre's distance, the pressure angle."""
        draw, draft, contour, order = self.draft.draw, self.draft, self.contour, self.order
        base = contour.arcs["base"]
        assert base.way is not None
        pressure = None
        if self.rocks:
            assert own.pivot is not None
            where = draft.take(Side, "±", float(-self.left))
            if order.flat:
                lowest = draw(touch, "B_0", own.pivot, base.way, where, why=why.LOWEST)
            else:
                arc = draw(strike, "(l)", own.pivot, self.lever)
                lowest = draw(cross, "B_0", arc, base.way, where, why=why.LOWEST)
            begin = draw(join, "(O_1B_0)", own.pivot, lowest)
            travel = draw(
                slant, "ψ", own.pivot, own.point, begin, sense=-self.left, unit="°", why=why.SWING
            )
            line = own.guide
            if order.same_sense:
                line = draw(parallel, "(OO_1)", contour.origin, line, sense=-1)
            part = draw(measure_along, "OP", contour.origin, own.instant, line, why=why.INSTANT)
            ends = (own.instant, own.pivot)[:: -1 if order.same_sense else 1]
            rest = draw(measure_along, "O_1P", *ends, line, why=why.INSTANT)
            rate = draw(f.rate_of_lever, "ψ′_{P}", part, rest, unit="rad")
            if not order.flat:
                lever = draw(join, "(O_1B)", own.pivot, own.point)
                way = draw(square, "(t)", own.point, lever, sense=-self.left)
        else:
            where = draft.take(Side, "±", 1.0)
            lowest = draw(cut, "B_0", own.guide, base.way, where, why=why.LOWEST)
            travel = draw(measure_along, "s", lowest, own.point, own.guide, why=why.TRAVEL)
            across = draw(
                square, "(O)", contour.origin, own.guide, sense=-self.sense, why=why.ACROSS
            )
            part = draw(measure_along, "OP", contour.origin, own.instant, across, why=why.INSTANT)
            rate = draw(f.transfer, "S′_{P}", part, contour.mu, unit="m")
            way = own.guide
        if not order.flat:
            pressure = draw(
                slant,
                "α",
                own.instant,
                own.point,
                way,
                sense=self.sense,
                unit="°",
                why=why.PRESSURE,
            )
        return Follower(
            own.guide,
            own.pivot,
            own.point,
            own.contact,
            own.instant,
            travel,
            part,
            rate,
            self.work,
            pressure,
            {},
        )
