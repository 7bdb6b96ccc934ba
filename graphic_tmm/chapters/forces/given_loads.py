"""Loads that a scene gives: forces in any direction, moments, the opposites of those that come from a link."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

import numpy as np

from graphic_tmm.board.operations.instruments import parallel, ray, square
from graphic_tmm.board.operations.statics import (
    action,
    against_turning,
    reversed_,
    with_motion,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Reals
from graphic_tmm.chapters.forces import words as why
from graphic_tmm.chapters.forces.directions import draw_along
from graphic_tmm.chapters.forces.kinds import Along
from graphic_tmm.chapters.forces.loads import VIEW, Couple, Force, Ground, Loads, point_of
from graphic_tmm.chapters.forces.task import AGAINST, SAME_TIME, TURN, Load
from graphic_tmm.chapters.forces.travel import by_travel, size_at_turn, size_in_row
from graphic_tmm.chapters.kinematics.closings import two_legged
from graphic_tmm.chapters.kinematics.motion import image_letter, is_signed, reading_of
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said


def given_load(ground: Ground, load: Load, loads: Loads) -> Iterator[Force | Couple]:
    """Yield a load that the scene gives, and the opposite of it where it comes from another link.

    Raises
    ------
    StructureError
        If it names what is not there.
    """
    given = _given(ground, load, loads)
    yield given
    yield from _opposite(ground, load, given)


def _given(ground: Ground, load: Load, loads: Loads) -> Force | Couple:
    links = ground.mechanism.by_number
    if load.link not in links or load.link == ground.mechanism.frame.number:
        raise StructureError(
            said("there is no moving link {link}", link=load.link), "link", head="load"
        )
    if load.point is None:
        return _moment(ground, load, loads)
    if load.point not in links[load.link].points:
        known = ", ".join(links[load.link].points)
        raise StructureError(
            said(
                "load on link {link}: it has no point {point}; its points are {known}",
                link=load.link,
                point=load.point,
                known=known,
            ),
            "point",
        )
    draft = ground.draft
    point, image = point_of(ground, load.link, load.point)
    letter = free_letter(ground, "F", index_of(load))
    if load.direction != AGAINST:
        size = _size(ground, load, letter, "N", loads)
        line = line_of(ground, load.direction, point, letter)
        return Force(letter, load.link, point, line, size, image)
    reading = reading_of(draft, ground.velocities, image)
    if reading is None:
        raise StructureError(
            said(
                "load on link {link}: {point} does not move: give the direction as an angle",
                link=load.link,
                point=load.point,
            ),
            "direction",
        )
    size = _size(ground, load, f"|{letter}|", "N", loads)
    line = _against(ground, letter, point, image, reading)
    value = draft.draw(with_motion, letter, size, reading, ground.pin_speed, unit="N")
    return Force(letter, load.link, point, line, value, image)


def line_of(ground: Ground, direction: float | str | Along, point: Mark, letter: str) -> Mark:
    """Draw the line of action of a load, in a direction fixed in the sheet or in one that turns with a link."""
    draft = ground.draft
    if isinstance(direction, Along):
        return draw_along(draft, ground.positions, ground.mechanism, direction, point, letter)
    degrees = draft.direction(float(direction))
    return draft.draw(ray, f"({letter})", point, degrees, why=why.GIVEN_LINE)


def index_of(load: Load) -> str:
    """Return the index of a load's letter: its link, behind the one that it comes from if there is one."""
    return str(load.link) if load.opposite is None else between(load.opposite, load.link)


def between(link: int, other: int) -> str:
    """Return the index of what a link does to another."""
    return f"{{{link}{other}}}"


def numbered(symbol: str, index: str, number: int) -> str:
    """Return the letter of a load: F_5, of link 3 on link 2 F_{32}; a second one of that index is F_{5(2)}.

    >>> numbered("F", "5", 1), numbered("F", "{32}", 1), numbered("F", "{32}", 2)
    ('F_5', 'F_{32}', 'F_{32(2)}')
    """
    return f"{symbol}_{index}" if number == 1 else f"{symbol}_{{{index.strip('{}')}({number})}}"


def free_letter(ground: Ground, symbol: str, index: str) -> str:
    """Return the letter of a load that nothing else in the view bears."""
    board = ground.draft.board
    tried = (numbered(symbol, index, number) for number in count(1))
    return next(letter for letter in tried if board.free(letter) == letter)


def _opposite(ground: Ground, load: Load, given: Force | Couple) -> Iterator[Force | Couple]:
    """Yield what acts on the link that a load comes from: the opposite, on the same line; none on the frame."""
    draft, link = ground.draft, load.opposite
    if link is None or link == ground.mechanism.frame.number:
        return
    letter = free_letter(ground, given.letter[0], between(load.link, link))
    if isinstance(given, Couple):
        yield Couple(letter, link, draft.draw(reversed_, letter, given.value, unit="N·m"))
        return
    assert load.point is not None
    if load.opposite_at is None:
        point, image = given.point, _image_over(ground, link, given.point, load.point)
    else:
        point, image = point_of(ground, link, load.opposite_at)
    because = why.OPPOSITE_LINE
    line = draft.draw(parallel, f"({letter})", point, given.line, sense=1, why=because)
    value = draft.draw(reversed_, letter, given.value, unit="N")
    yield Force(letter, link, point, line, value, image)


def _image_over(ground: Ground, link: int, point: Mark, letter: str) -> Mark:
    """Return the image of the point of a link that lies under a point of another one."""
    plan, draft = ground.velocities, ground.draft
    for closing in two_legged(ground.positions.closings, VIEW):
        if closing.point == point and closing.legs[1].link == link:
            return plan.closed[closing.group.name]
    draft.open(plan.images.pole.view)
    image = plan.images.of(link, point, letter, image_letter(letter, link))
    draft.open(VIEW)
    return image


def _against(ground: Ground, letter: str, point: Mark, image: Mark, reading: Mark) -> Mark:
    """Draw the line of action against a velocity; where that was read along a line, against its sense."""
    draft, turns, because = ground.draft, ground.quarters, why.AGAINST_VELOCITY
    if not is_signed(ground.draft, reading):
        pole = ground.velocities.images.pole
        return draft.draw(action, f"({letter})", point, image, pole, quarters=turns, why=because)
    along = draft.uses(reading)[2]
    if turns == 0:
        return draft.draw(parallel, f"({letter})", point, along, sense=-1, why=because)
    return draft.draw(square, f"({letter})", point, along, sense=-turns, why=because)


def _moment(ground: Ground, load: Load, loads: Loads) -> Couple:
    draft, plan = ground.draft, ground.velocities
    letter = free_letter(ground, "M", index_of(load))
    if load.direction != AGAINST:
        return Couple(letter, load.link, _size(ground, load, letter, "N·m", loads))
    rate = plan.rates.get(load.link)
    if rate is None:
        raise StructureError(
            said(
                "load on link {link}: it does not turn: leave the moment's direction out",
                link=load.link,
            ),
            "direction",
        )
    size = _size(ground, load, f"|{letter}|", "N·m", loads)
    fastest = plan.rates.get(ground.mechanism.drive.link, rate)
    value = draft.draw(against_turning, letter, size, rate, fastest, unit="N·m")
    return Couple(letter, load.link, value)


def _size(ground: Ground, load: Load, letter: str, unit: str, loads: Loads) -> Mark:
    """Take the size of a load: constant, by position, by angle; or find it by a travel. Note it."""
    if load.travel is not None:
        count = ground.numbers.size
        found, of = by_travel(ground.draft, ground, load.travel, count, (letter, unit))
        loads.travels[found] = of
    else:
        found = _sized(ground, load, letter, unit)
    loads.given.append(found)
    return found


def _sized(ground: Ground, load: Load, letter: str, unit: str) -> Mark:
    draft, intervals = ground.draft, ground.intervals
    value: object = load.size
    if load.by_angle:
        turned = ground.numbers * (TURN / intervals) if ground.steps is None else ground.steps
        value = size_at_turn(load.by_angle, turned)[None, :]
    elif load.by_time:
        value = _in_row(ground, load)[None, :]
    elif isinstance(load.size, tuple):
        if len(load.size) != intervals:
            raise StructureError(
                said(
                    "load on link {link}: {n} sizes for {count} positions: give one for each",
                    link=load.link,
                    n=len(load.size),
                    count=intervals,
                ),
                "by_position",
            )
        row = [*load.size] * ground.turns
        value = np.array([*row, *[np.nan] * (ground.numbers.size - len(row))])[None, :]
    return draft.take(Number, letter, value, unit)


def _in_row(ground: Ground, load: Load) -> Reals:
    """Return the size of a load by time in every position of a row that does not close."""
    assert ground.steps is not None
    (pair, *_), steps = ground.pairs, ground.steps
    last = pair.time(float(steps.max()))
    if not load.by_time[-1][0] <= last * (1.0 + SAME_TIME) or not last > 0.0:
        says = said(
            "load on link {link}: the last position comes after {time:.6g} s, and the table goes on; end it "
            "there",
            link=load.link,
            time=last,
        )
        raise StructureError(says, "by_time")
    return size_in_row(load.by_time, pair, float(steps[ground.intervals - 1]), steps)
