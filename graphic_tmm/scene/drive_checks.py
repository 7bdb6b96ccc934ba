"""Contradictions of a drive: speeds and places of what slides and of what turns, rows with ends."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from graphic_tmm.language.said import said
from graphic_tmm.scene import mechanism
from graphic_tmm.scene.coordinates import Bare, Metres
from graphic_tmm.scene.declare import Flaw, Path
from graphic_tmm.scene.mechanism import Drive, Frame, FurtherDrive, Link

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


def goes_by_length(drive: Drive, parts: Parts) -> bool:
    """Whether the places of a drive are lengths: it slides, or a rack turns it."""
    link = next((one for one in parts.links if one is not None and one.number == drive.link), None)
    racked = drive.rack is not None
    return racked or (parts.frame is not None and mechanism.slides(drive, link, parts.frame))


def is_even(drive: Drive) -> bool:
    """Whether it goes at one speed all along its row: then the way that it has come tells the time."""
    return not isinstance(drive.speed, tuple) and drive.speed > 0.0 and not drive.acceleration


def time_of_turn(parts: Parts) -> float | None:
    """Return how long a turn of the crank takes, s; None where it does not go round evenly."""
    drive = parts.drive
    if drive is None or not is_even(drive) or drive.open or goes_by_length(drive, parts):
        return None
    return math.tau / mechanism.as_row(drive.speed)[0]


def motion_faults(path: Path, drive: Drive | FurtherDrive, parts: Parts) -> Iterator[Flaw]:
    """A speed in m/s of a link that does not slide, angles of one that does, and the other way round."""
    link = next((one for one in parts.links if one is not None and one.number == drive.link), None)
    if link is None or parts.frame is None:
        return
    sliding = mechanism.slides(drive, link, parts.frame)
    racked = isinstance(drive, Drive) and drive.rack is not None
    if flaw := _wrong_speed(drive, link, parts.frame, sliding=sliding, racked=racked):
        yield Flaw((*path, "speed"), flaw)
    rest: dict[str, tuple[object, ...]] = {"acceleration": mechanism.as_row(drive.acceleration)}
    if isinstance(drive, Drive):
        yield from _listed(path, drive)
    if isinstance(drive, FurtherDrive):
        rest["at"] = (drive.at,)
    else:
        places = drive.positions if isinstance(drive.positions, tuple) else ()
        rest |= {
            "from": (drive.begin,),
            "to": (drive.end,),
            "positions": places,
            "extra": drive.extra,
        }
    wrong = said('an angle is wanted, "20 deg": link {number} turns', number=link.number)
    if racked:
        wrong = said('a length is wanted, "200 mm": the rack slides')
    elif sliding:
        wrong = said('a length is wanted, "200 mm": link {number} slides', number=link.number)
    for name, values in rest.items():
        written = [one for one in values if isinstance(one, float) and not isinstance(one, Bare)]
        if any(isinstance(one, Metres) != (sliding or racked) for one in written if one):
            yield Flaw((*path, name), wrong)


def _wrong_speed(
    drive: Drive | FurtherDrive, link: Link, frame: Frame, *, sliding: bool, racked: bool
) -> str:
    """Return what is wrong with a speed of what turns, or slides, "" if nothing is."""
    written = [one for one in mechanism.as_row(drive.speed) if one and not isinstance(one, Bare)]
    if racked:
        slides = all(isinstance(one, Metres) for one in written)
        return "" if slides else said('a rack slides: write its speed, "0.2 m/s"')
    if any(isinstance(one, Metres) != sliding for one in written):
        return said(
            'these are speeds of what slides and of what turns: write all as "0.2 m/s", or all as "380 rpm"'
        )
    if sliding and not link.pairs:
        return said(
            "this is the speed of what slides, and link {number} slides on nothing: write its angular speed, "
            '"380 rpm", or give it slides',
            number=link.number,
        )
    if not sliding and link.pairs and not frame.points.keys() & link.points.keys():
        return said(
            "this is an angular speed, and link {number} slides and turns about nothing fixed: write its "
            'speed, "0.2 m/s"',
            number=link.number,
        )
    return ""


def _listed(path: Path, drive: Drive) -> Iterator[Flaw]:
    """Speeds or accelerations listed that are not one for each position."""
    rows = {"speed": drive.speed, "acceleration": drive.acceleration}
    for name, row in rows.items():
        if isinstance(row, tuple) and len(row) != drive.count:
            says = said(
                "{n} are listed for {count} positions: write one for each",
                n=len(row),
                count=drive.count,
            )
            yield Flaw((*path, name), says)
        elif isinstance(row, tuple) and drive.extra:
            says = said("a list tells nothing of positions beside the row: leave extra out")
            yield Flaw((*path, "extra"), says)


def end_faults(drive: Drive) -> Iterator[Flaw]:
    """Yield what is wrong with the ends of a row: one is missing, both are one place, the row begins twice."""
    listed = not isinstance(drive.positions, int)
    ends = {"from": drive.begin, "to": drive.end}
    there = [name for name, value in ends.items() if value is not None]
    if listed and there:
        says = said("positions lists all places: leave {name} out", name=there[0])
        yield Flaw(("drive", there[0]), says)
    elif len(there) == 1:
        says = said("a row from one end to the other has both: write from and to")
        yield Flaw(("drive", there[0]), says)
    elif there and drive.begin == drive.end:
        yield Flaw(("drive", "to"), said("the row ends where it begins; write another place"))
    places = drive.positions if isinstance(drive.positions, tuple) else ()
    if drive.extra and list(places) not in (sorted(places), sorted(places, reverse=True)):
        says = said(
            "the places do not follow one another, so nothing stands between two: write these among them"
        )
        yield Flaw(("drive", "extra"), says)
    if (there or listed) and drive.zero != 0.0:
        key = there[0] if there else "positions"
        yield Flaw(
            ("drive", "zero"), said("{key} says where the row begins: leave zero out", key=key)
        )
