"""What a scene says to act on its mechanism, as signs where it stands: loads, weights, springs, gas."""

from __future__ import annotations

import cmath
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from functools import cache
from typing import Any

from graphic_tmm.errors import SceneError, TmmError
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Mechanism, Sweep
from graphic_tmm.mechanism.sketch import poses_of
from graphic_tmm.readers.any_angles.motion import motion
from graphic_tmm.readers.task_sheet import LoadSign, Posed, TaskSheet
from graphic_tmm.scene.chapter import MECHANISM, Chapter, chapters
from graphic_tmm.scene.document import Document
from graphic_tmm.scene.read import understood
from graphic_tmm.scene.records import Scene
from graphic_tmm.serve.scheme.written import placing_part

SOON = 1e-4
"""A moment later the drive has gone by this share of its way: which way points go is seen then."""


def load_signs(
    doc: Document, positions: Scene, sweep: Sweep, at: Sequence[float]
) -> list[list[dict[str, Any]]]:
    """Return the signs of what acts at every place of the drive, as JSON takes them; places and lengths in m.

    ``positions``: the scene that places are drawn by, which may ask for nothing else.
    """
    loaded = list(_loaded(doc))
    if not loaded:
        return [[] for _ in at]
    assert positions.mechanism is not None
    later = SOON * (sweep.high - sweep.low) * positions.mechanism.drive.sense
    row = [*at, *(one + later for one in at), *(one - later for one in at)]
    places = motion(positions, row, plans="positions", exact=True).places
    found = []
    for k in range(len(at)):
        here, after, before = (
            {one: complex(z[k + n * len(at)]) for one, z in places.items()} for n in range(3)
        )
        signs = dict[LoadSign, None]()
        for chapter, scene in loaded:
            with suppress(TmmError):
                signs |= dict.fromkeys(_signs(chapter, scene, here, after, before))
        found.append([_json(one) for one in signs if cmath.isfinite(one.at)])
    return found


Spots = Mapping[tuple[str, int], complex]


def _signs(
    chapter: Chapter, scene: Scene, here: Spots, after: Spots, before: Spots
) -> Iterator[LoadSign]:
    mechanism = scene.mechanism
    assert mechanism is not None
    letters = {letter: z for (letter, _), z in here.items()}

    def spot(letter: str, link: int) -> tuple[complex, complex]:
        if link == mechanism.frame.number:
            return mechanism.frame.points[letter], 0j
        at = here[letter, link]
        # at an end of its way nothing stands behind it
        by = next(filter(cmath.isfinite, (after[letter, link] - at, at - before[letter, link])), 0j)
        return at, by / abs(by) if abs(by) > 1e-9 * _size(mechanism) else 0j

    @cache
    def angle(link: int) -> float:
        return poses_of(mechanism, letters)[link].angle

    posed = Posed(spot, 1.0, lambda link: turn(angle(link)), weights=True)
    for acting in TaskSheet.of(chapter).acting(scene, posed):
        yield acting.sign


def _size(mechanism: Mechanism) -> float:
    return max(abs(z) for link in mechanism.by_number.values() for z in link.points.values())


def _loaded(doc: Document) -> Iterator[tuple[Chapter, Scene]]:
    """Yield chapters that something is given to, each with the scene as far as it reads that.

    What is given counts before anything is asked of it: then the section that asks is taken for empty. Of
    sections that cannot be understood nothing is shown.
    """
    for chapter in chapters(MECHANISM):
        known = [s for one in (chapter, *_below(chapter)) for s in one.sections]
        own = {section.name for section in chapter.sections} & doc.keys()
        asking = chapter.asking
        if not own or asking is None or TaskSheet.of(chapter).acting is TaskSheet().acting:
            continue
        kept = placing_part(doc, {section.name for section in known})
        with suppress(SceneError):
            yield chapter, understood({asking.name: {}} | kept, "scheme")


def _below(chapter: Chapter) -> Iterator[Chapter]:
    return (one for one in chapters() if one.name in chapter.builds_on)


def _json(sign: LoadSign) -> dict[str, Any]:
    return {
        "letter": sign.letter,
        "at": [sign.at.real, sign.at.imag],
        "way": [sign.way.real, sign.way.imag],
        "turns": sign.turns,
        "end": None if sign.end is None else [sign.end.real, sign.end.imag],
        "pushes": sign.pushes,
    }
