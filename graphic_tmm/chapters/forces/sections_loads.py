"""What a load says against itself and the mechanism."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from graphic_tmm.chapters.forces import task
from graphic_tmm.chapters.forces.kinds import AGAINST, Along
from graphic_tmm.chapters.indicator.task import ONE_TURN
from graphic_tmm.language.said import said
from graphic_tmm.scene import letters, mechanism
from graphic_tmm.scene.declare import Flaw, Path, Said
from graphic_tmm.scene.drive_checks import goes_by_length, is_even, time_of_turn
from graphic_tmm.scene.references import Outline, arm_only, no_link, no_moving, of_link

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

TOLD = ("force", "moment", "by_position", "by_angle", "by_time", "of")


def loads(told: list[tuple[Path, Said]], parts: Parts) -> Iterator[Flaw]:
    """Yield what is wrong with each load, by its place in the scene."""
    count = parts.drive.count if parts.drive is not None else None
    strokes = parts.drive is not None and goes_by_length(parts.drive, parts)
    for path, load in told:
        yield from _load(path, load, parts.names, count)
        if load.by_angle is not None and strokes:
            says = said(
                "what drives slides and has no angle: write by_position, or of and out for a travel"
            )
            yield Flaw((*path, "by_angle"), says)
        by = "by_time" if load.by_time is not None else "by_angle"
        if why := _untimed(load.by_time or (), parts, strokes=strokes):
            yield Flaw((*path, by), why)
        for other in ONE_TURN:
            if other in parts.doc and task.turns_written(load, parts) > 1:
                says = said(
                    "it goes over two turns, and the graphs of [{other}] over one; give it a scene of its own",
                    other=other,
                )
                yield Flaw((*path, by), says)


def _untimed(points: task.Table, parts: Parts, *, strokes: bool) -> str:
    """Return why times tell no places, or not all of them; "" where they do."""
    drive, turn = parts.drive, time_of_turn(parts)
    if drive is None or not points:
        return ""
    if not any(mechanism.as_row(drive.speed)):
        return said("what drives stands, so no place has a time; write by_position")
    if not is_even(drive):
        return said(
            "speeds and accelerations hold in the positions they are given for and tell no time between two: "
            "give the drive one speed and no acceleration, or write by_position"
        )
    if strokes and not drive.open:
        return said("where does the time begin? write from and to in [drive]")
    if turn is not None and points[-1][0] > 2.0 * turn * (1.0 + task.SAME_TIME):
        return said(
            "two turns take {time:.6g} s, and the table goes on; end it there", time=2.0 * turn
        )
    return ""


def _load(path: Path, load: Said, names: Outline, count: int | None) -> Iterator[Flaw]:
    if load.link not in names.bodies:
        yield from no_link((*path, "link"), load.link, names)
        return
    yield from bears(path, load, names, ("link", "from"))
    if isinstance(load.of, int):
        yield from _swings(path, load, names)
    elif load.of is not None and load.of not in names.moving:
        yield Flaw((*path, "of"), no_moving(load.of, names))
    if isinstance(load.direction, Along):
        if load.point is None:
            says = said("a moment has no line of action; leave the direction out")
            yield Flaw((*path, "direction"), says)
        yield from turning(path, load.direction, names)
    yield from _pair(path, load, names)
    yield from _size(path, load, count)


def _swings(path: Path, load: Said, names: Outline) -> Iterator[Flaw]:
    """Say what is wrong with a link by whose swing a load is told."""
    number = load.of
    if number not in names.bodies:
        yield from no_link((*path, "of"), number, names)
    elif number == names.frame:
        says = said("link {number} is the frame; name a moving link", number=number)
        yield Flaw((*path, "of"), says)
    elif (welded := names.bodies[number].welded) is not None:
        yield Flaw((*path, "of"), arm_only(number, welded))
    if load.along is not None:
        says = said("the swing of a link has no line; leave along out")
        yield Flaw((*path, "along"), says)


def bears(
    path: Path, load: Said | task.Unknown, names: Outline, keys: tuple[str, ...]
) -> Iterator[Flaw]:
    """Say what is wrong with the links that a load acts on, by ``keys``, and with its point."""
    if load.link == names.frame:
        says = said("link {number} is the frame; name a moving link", number=load.link)
        yield Flaw((*path, "link"), says)
    for key in keys:
        number = getattr(load, key)
        welded = names.bodies[number].welded if number in names.bodies else None
        if welded is not None:
            yield Flaw((*path, key), arm_only(number, welded))
        if number in names.bodies and names.bodies[number].passive:
            says = said(
                "link {number} is passive and carries no forces: let the load act on a link that holds it",
                number=number,
            )
            yield Flaw((*path, key), says)
    own = names.bodies[load.link].letters
    if load.point is not None and load.point not in own:
        of = of_link(load.link)
        says = said('"{letter}" is no letter of {of}', letter=load.point[:20], of=of)
        what = said("letters of {of}", of=of)
        yield Flaw((*path, "point"), letters.unknown(says, load.point, own, what))


def _pair(path: Path, load: Said, names: Outline) -> Iterator[Flaw]:
    """Say what is wrong with the opposite of a load: it acts on another link, along the same line."""
    other, at = getattr(load, "from"), load.from_point
    if other is None:
        if at is not None:
            yield Flaw((*path, "from"), said("of which link is that point? write from = 3"))
        return
    if other not in names.bodies:
        yield from no_link((*path, "from"), other, names)
        return
    if other == load.link:
        says = said("link {number} bears the load itself; name another link", number=other)
        yield Flaw((*path, "from"), says)
    if load.direction == AGAINST or (load.direction is None and load.point is not None):
        says = said('two links push each other along a line; write direction = "along AC"')
        if load.point is None:
            says = said(
                "two links turn each other by a moment with its sign; leave the direction out"
            )
        yield Flaw((*path, "direction"), says)
    if at is not None:
        yield from _other_point(path, load, names.bodies[other].letters)


def _other_point(path: Path, load: Said, own: tuple[str, ...]) -> Iterator[Flaw]:
    """Say what is wrong with the point where the opposite of a load acts."""
    other, at, along = getattr(load, "from"), load.from_point, load.direction
    if load.point is None:
        says = said("a moment acts on the whole link; leave the point out")
        yield Flaw((*path, "from_point"), says)
        return
    if at not in own:
        of = of_link(other)
        says = said('"{letter}" is no letter of {of}', letter=at[:20], of=of)
        what = said("letters of {of}", of=of)
        yield Flaw((*path, "from_point"), letters.unknown(says, at, own, what))
        return
    pair = letters.split(along.line) if isinstance(along, Along) else None
    joins = pair is not None and {*pair} == {load.point, at} and along.by % 180.0 == 0.0
    if along not in (None, AGAINST) and not joins:
        says = said(
            'a force and its opposite act along one line; write direction = "along {point}{at}", or leave '
            "from_point out",
            point=load.point,
            at=at,
        )
        yield Flaw((*path, "direction"), says)


def turning(path: Path, along: Along, names: Outline) -> Iterator[Flaw]:
    """Say what is wrong with a direction that turns with the links: of two letters, or of a guide."""
    at, line = (*path, "direction"), along.line
    pair = letters.split(line)
    if pair is not None and set(pair) <= set(names.letters):
        if pair[0] == pair[1]:
            yield Flaw(at, said('"{line}" names one letter twice; name two letters', line=line))
        return
    owners = [number for number, body in names.bearing.items() if line in body.guides]
    if len(owners) > 1:
        says = said(
            'links {links} have guides called "{line}"; name two letters, "along AC", or call one otherwise',
            links=", ".join(map(str, owners)),
            line=line,
        )
        yield Flaw(at, says)
    elif not owners:
        known = [name for body in names.bearing.values() for name in body.guides]
        says = said('"{line}" is neither two letters of the mechanism nor a guide', line=line[:20])
        yield Flaw(at, letters.unknown(says, line, known, said("guides of the mechanism")))


def _size(path: Path, load: Said, count: int | None) -> Iterator[Flaw]:
    told = [key for key in TOLD if getattr(load, key) is not None]
    if not told:
        says = said(
            'nothing says how large it is; write force = "190 N", moment, by_position or by_angle'
        )
        yield Flaw((*path, "force"), says)
    for other in told[1:]:
        says = said("{key} gives the size already; leave one of them out", key=told[0])
        yield Flaw((*path, other), says)
    if load.force is not None and load.point is None:
        yield Flaw((*path, "point"), said('a force acts at a point; write point = "D"'))
    if load.moment is not None and load.point is not None:
        says = said("a moment acts on the whole link; leave the point out")
        yield Flaw((*path, "point"), says)
    if load.by_position is not None and count is not None and len(load.by_position) != count:
        says = said(
            "{n} sizes for {count} positions; give one for each",
            n=len(load.by_position),
            count=count,
        )
        yield Flaw((*path, "by_position"), says)
    strokes = load.out is not None or load.back is not None
    if load.of is None and strokes:
        says = said('by the travel of which point? write of = "D"')
        yield Flaw((*path, "of"), says)
    if load.of is None and load.along is not None:
        says = said('the travel of which point goes along that line? write of = "E"')
        yield Flaw((*path, "along"), says)
    if load.of is None and load.start is not None and not strokes:
        says = said('the travel of which point begins there? write of = "D"')
        yield Flaw((*path, "start"), says)
    if load.of is not None and not strokes:
        says = said('it says no size; write out = [[0, "0 N"], [1, "190 N"]], or back')
        yield Flaw((*path, "of"), says)
