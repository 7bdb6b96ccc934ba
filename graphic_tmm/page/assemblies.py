"""The places that a group can take where it is drawn, as small pictures, with what a scene writes for each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import DrawnRemedy
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.columns import GroupPlaces, Readings
from graphic_tmm.scene.document import toml

ASSEMBLIES: dict[str, str] = {
    "assemblies": said("Assemblies"),
    "assembly drawn": said("drawn"),
}
"""What the page says of assemblies, by the names that its program has for it."""
_HEAD = said("Group {group}: {count} ways to assemble it")
_SAYS = said(
    "All of them have the same lengths, the drive at {at}. To draw another, write its lines into link {link} "
    "of the scene."
)


def in_square(found: Sequence[DrawnRemedy]) -> Iterator[list[list[float]]]:
    """Yield the lines of pictures, x and y downward by turns, to one scale, in a square of side 1."""
    spots = [z for one in found for line in one.lines for z in line]
    if not spots:
        return
    left, low = min(z.real for z in spots), min(z.imag for z in spots)
    wide, high = max(z.real for z in spots) - left, max(z.imag for z in spots) - low
    size = max(wide, high) or 1.0
    corner = complex(left - (size - wide) / 2.0, low - (size - high) / 2.0)
    for one in found:
        yield [
            [round(x, 4) for z in line for x in _down((z - corner) / size)] for line in one.lines
        ]


def _down(spot: complex) -> tuple[float, float]:
    return spot.real, 1.0 - spot.imag


def assemblies(made: DrawnScene) -> list[dict[str, Any]]:
    """Return the groups of a scene that can be assembled in several ways, as the page's template takes them."""
    return [
        _group(one, made.scene.language)
        for drawn in made.boards
        for chapter in drawn.project.chapters
        for one in Readings.of(chapter).places(drawn)
    ]


def _group(one: GroupPlaces, language: str) -> dict[str, Any]:
    speech, values = speaking(language), dict(one.places[one.taken].values)
    (near, _), (_, at) = values.items()
    link = near.split(",")[0].removeprefix("link ")
    return {
        "head": speech(_HEAD, group=one.group, count=len(one.places)),
        "says": speech(_SAYS, at=at, link=link),
        "places": [
            {
                "lines": [
                    (" ".join(map(str, line)), len(line) > 4 and line[:2] == line[-2:])
                    for line in lines
                ],
                "written": [
                    f"{key.split(', ')[-1]} = {toml(value)}" for key, value in place.values
                ],
                "taken": k == one.taken,
            }
            for k, (place, lines) in enumerate(zip(one.places, in_square(one.places), strict=True))
        ],
    }
