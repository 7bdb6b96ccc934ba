"""From the flat photograph of a sheet to its points: every plan placed, its lines followed, its points told.

A point that was seen is a reading; one that is not sure, and one that was not seen, are asked for by name.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.pencil.again import again
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import Name, View
from graphic_tmm.checking.pencil.fitting import fit
from graphic_tmm.checking.pencil.lines import BAND, Track, tracks
from graphic_tmm.checking.pencil.placing import THERE, placed, stood
from graphic_tmm.checking.pencil.points import SEEN, UNSEEN, UNSURE, Spot, signs_of, spots
from graphic_tmm.checking.records import Taken
from graphic_tmm.language.catalogue import Speech, speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import view_name

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


class Found(NamedTuple):
    """What a photograph shows: the points of the plans on the sheet, and the plans that are not there."""

    points: tuple[Point, ...]
    missing: tuple[Pole, ...]


def read_plans(flat: Flat, views: Sequence[View], clicked: Mapping[Pole, complex]) -> Found:
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
        points += _told(view, seen(flat, view, shift, followed(flat, view, shift)), shift)
    return Found(tuple(points), tuple(missing))


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
        tracks(flat, line, shift, float(np.clip(WIDE * view.aside(line), BAND, WIDEST)))
        for line in view.lines
    ]


def _told(view: View, found: Sequence[Spot], shift: complex) -> Iterator[Point]:
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


def asked(found: Found, language: str = "en") -> tuple[str, ...]:
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
        if unsure := how.get(UNSURE):
            told.append(
                speech(
                    NOT_SURE,
                    plan=view_name(plan, language),
                    position=position,
                    points=", ".join(unsure),
                )
            )
        if unseen := how.get(UNSEEN):
            told.append(
                speech(
                    NOT_SEEN,
                    plan=view_name(plan, language),
                    position=position,
                    points=", ".join(unseen),
                )
            )
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
