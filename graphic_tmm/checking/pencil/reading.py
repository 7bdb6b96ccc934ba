"""From the flat photograph of a sheet to its points: plans placed, lines followed, points told."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import ExpectedLine, Name, View
from graphic_tmm.checking.pencil.fitting import Fit, fit
from graphic_tmm.checking.pencil.lines import BAND, ONE, Track, tracks
from graphic_tmm.checking.pencil.points import SEEN, UNSEEN, UNSURE, Spot, signs_of, spots
from graphic_tmm.checking.pencil.web import Pin
from graphic_tmm.checking.records import Taken
from graphic_tmm.language.catalogue import Speech, speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import view_name

REACH = 8.0
"""A view is sought as far from where it should stand, mm: a student measures that off the frame, or guesses."""
STEPS = (1.0, 0.25)
"""At first in such steps, mm, then about the best of them more finely."""
MOST = 600
"""So many places of its lines are looked at."""
FAR = 0.02
"""What a millimetre of moving costs, as a share of cover: of two places alike the nearer one."""
THERE, SURELY = 0.55, 0.78
"""A plan is on the sheet if so much of its lines is on pencil, near its due and elsewhere: of lettering and
other lines about a half is, of all other plans of a sheet somewhere 0.65."""
ELSEWHERE, LITTLE = 45.0, 0.002
"""A plan that is not there may stand elsewhere: as far away, mm, and what a millimetre costs then."""


def placed(
    flat: Flat, view: View, shift: complex = 0j, reach: float = REACH, far: float = FAR
) -> tuple[complex, float]:
    """Return by how much a view is moved, mm, beside ``shift``, and the share of its lines on pencil.

    ``reach``: it is sought as far, mm; ``far``: what a millimetre of that costs.
    """
    some = [line.start + line.way * np.arange(0.0, line.length, 1.0) for line in view.lines]
    if not some:
        return shift, 0.0
    ink = np.concatenate(some)
    ink = ink[:: -(-len(ink) // MOST)]
    found, reaches = shift, (reach, STEPS[0])
    for wide, step in zip(reaches, STEPS, strict=True):
        axis = np.arange(-wide, wide + 1e-9, step)
        best, most = found, -np.inf
        for rise in axis:  # a row at a time: memory
            moves = found + axis + 1j * rise
            worth = flat.near(ink + moves[:, None]).mean(axis=1) - far * abs(moves - shift)
            k = int(np.argmax(worth))
            if worth[k] > most:
                best, most = complex(moves[k]), float(worth[k])
        found = best
    return found, float(most + far * abs(found - shift))


def stood(flat: Flat, view: View) -> tuple[complex, float]:
    """Return where a view stands, and the share of its lines on pencil: near its due, or surely elsewhere."""
    near = placed(flat, view)
    if near[1] >= THERE:
        return near
    far = placed(flat, view, 0j, ELSEWHERE, LITTLE)
    return far if far[1] >= SURELY else near


LEAST = 0.2
"""A point that is seen is known no better, mm."""
NARROW = 3.0
"""A line is followed again so many deviations about where it is expected now, and `NEAREST` beside, mm."""
NEAREST = 0.5


def again(
    flat: Flat, view: View, shift: complex, found: Sequence[Sequence[Track]], spots: Sequence[Spot]
) -> Fit:
    """Return the lines of a view, chosen anew beside the spots that are seen."""
    pins = {
        k: Pin(spot.at - shift - view.places[k].at, max(spot.error, LEAST))
        for k, spot in enumerate(spots)
        if spot.how == SEEN and view.of[k] is not None
    }
    first = fit(view, found, pins)
    more = [
        some if _clear(first, n) else (*some, *_followed(flat, view, shift, line, some, first))
        for n, (line, some) in enumerate(zip(view.lines, found, strict=True))
    ]
    return fit(view, more, pins)


def _clear(first: Fit, n: int) -> bool:
    """Whether a line is known already: no other one may be."""
    return first.tracks[n] is not None and first.far[n] is None


def _followed(
    flat: Flat, view: View, shift: complex, line: ExpectedLine, known: Sequence[Track], first: Fit
) -> list[Track]:
    """Return the tracks of a line about where its places are by all that is known, that were not found yet."""
    left = 1j * line.way
    share = line.shares(view.at)
    off = np.array([(first.moved[k] / left).real for k in line.places])
    spread = max(first.spread(k, left) for k in line.places)
    if np.ptp(share) > 0.3:
        slope, start = np.polyfit(share, off, 1)
    else:
        slope, start = 0.0, float(off.mean())
    aside = Track(float(start), float(start + slope), 0.0)
    moved = ExpectedLine(line.start + left * aside.start, line.end + left * aside.end, line.places)
    found: list[Track] = []
    for one in tracks(flat, moved, shift, NARROW * spread + NEAREST):
        track = one._replace(start=one.start + aside.start, end=one.end + aside.end)
        if track.is_another(ONE, *known, *found):
            found.append(track)
    return found


WIDE, WIDEST = 3.5, 10.0
"""Lines are followed so many deviations of the hand aside, and never farther, mm."""
NO_PLAN = said(
    "no plan of this sheet is seen in the photograph: is it upright, and is it this sheet (--sheet)?"
)
NOT_SURE = said(
    "{plan}, position {position}: not sure of {points} in the photograph; read them off the paper"
)
NOT_SEEN = said("{plan}, position {position}: no {points} seen in the photograph")
NO_POLE = said(
    "{name}, position {positions}: not seen in the photograph; if it stands elsewhere on the sheet, "
    "click its pole: --pole {plan}:{first}=x,y"
)
CLICKED = 3.0
"""About a pole that was clicked a plan is sought as far, mm."""

Pole = tuple[str, str]
"""Plan and position."""


class Point(NamedTuple):
    """A point of a plan in pencil: its name; where, mm on the sheet and from its pole; how sure that is.

    ``how``: one of `SEEN`, `UNSURE`, `UNSEEN`. ``due``: where it should stand in the plan as placed.
    """

    name: Name
    at: complex
    spot: complex
    how: str
    due: complex


class PhotoPoints(NamedTuple):
    """What a photograph shows: the points of the plans on the sheet, and the plans that are not there."""

    points: tuple[Point, ...]
    missing: tuple[Pole, ...]


def read_plans(flat: Flat, views: Sequence[View], clicked: Mapping[Pole, complex]) -> PhotoPoints:
    """Return what the views of a sheet show; ``clicked``: where poles stand, mm on the sheet."""
    points: list[Point] = []
    missing: list[Pole] = []
    for view in views:
        begin, reach = 0j, None
        for pole, at in clicked.items():
            if pole in view.poles:
                begin, reach = at - view.places[view.poles[pole]].at, CLICKED
        shift, cover = stood(flat, view) if reach is None else placed(flat, view, begin, reach)
        if cover < THERE:
            missing += view.poles
            continue
        points += points_of(view, seen(flat, view, shift, followed(flat, view, shift)), shift)
    return PhotoPoints(tuple(points), tuple(missing))


def seen(
    flat: Flat, view: View, shift: complex, found: Sequence[Sequence[Track]]
) -> tuple[Spot, ...]:
    """Return where the places of a view stand: once by all its lines, once more by what was seen."""
    signs = signs_of(view)
    once = spots(flat, view, fit(view, found), shift, signs)
    return spots(flat, view, again(flat, view, shift, found, once), shift, signs)


def followed(flat: Flat, view: View, shift: complex) -> list[tuple[Track, ...]]:
    """Return by line of a view the lines of pencil near it: as far as a hand may have it."""
    return [
        tracks(flat, line, shift, float(np.clip(WIDE * view.sideways_scatter(line), BAND, WIDEST)))
        for line in view.lines
    ]


def points_of(view: View, found: Sequence[Spot], shift: complex) -> Iterator[Point]:
    """Yield the points of a view, each from the pole of its plan; of none more is known than of its pole."""
    for k, place in enumerate(view.places):
        for name in place.names:
            pole = view.poles[name[0], name[2]]
            how = found[k].how
            if found[pole].how != SEEN and how == SEEN:
                how = UNSURE
            at = found[k].at
            yield Point(name, at, at - found[pole].at, how, place.at + shift)


def readings(points: Iterable[Point]) -> tuple[Taken, ...]:
    """Return the points that were seen as readings, to 0.01 mm, numbered as lines of a file."""
    found = sorted(
        (one for one in points if one.how == SEEN), key=lambda one: (one.name[0], one.name[2])
    )
    return tuple(
        Taken(plan, position, letter, x=round(one.spot.real, 2), y=round(one.spot.imag, 2), line=n)
        for n, one in enumerate(found, 2)
        for plan, letter, position in (one.name,)
    )


def questions(found: PhotoPoints, language: str = "en") -> tuple[str, ...]:
    """Return what the photograph does not tell, a sentence for every plan and position."""
    speech = speaking(language)
    if found.missing and not found.points:
        return (speech(NO_PLAN),)
    by: dict[Pole, dict[str, list[str]]] = {}
    for one in found.points:
        plan, letter, position = one.name
        by.setdefault((plan, position), {}).setdefault(one.how, []).append(letter)
    told = []
    for (plan, position), how in by.items():
        name = view_name(plan, language)
        for kind, says in ((UNSURE, NOT_SURE), (UNSEEN, NOT_SEEN)):
            if kind in how:
                listed = ", ".join(how[kind])
                told.append(speech(says, plan=name, position=position, points=listed))
    return (*told, *_missing(found.missing, speech))


def _missing(poles: Iterable[Pole], speech: Speech) -> Iterator[str]:
    """Yield a sentence for every plan that is not there, at all its positions."""
    by: dict[str, list[str]] = {}
    for plan, position in poles:
        by.setdefault(plan, []).append(position)
    for plan, positions in by.items():
        yield speech(
            NO_POLE,
            name=view_name(plan, speech.language),
            plan=plan,
            positions=", ".join(positions),
            first=positions[0],
        )
