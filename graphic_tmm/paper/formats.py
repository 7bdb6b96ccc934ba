"""Formats of paper, and what depends on them: room for plans and graphs, heights of letters."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import NamedTuple, Protocol


@dataclass(frozen=True)
class Format:
    """A format: width, height and width s of the main line, mm; ``called``: its Cyrillic name.

    ``share``: how large plans are that are 1 large on an A1. ``graph``: the height of a graph, three of which
    stand in a column, mm; ``base``: how many times longer than usual its base is. On a small sheet they are
    what it holds next to its title block.
    """

    width: float
    height: float
    main: float
    share: float
    graph: float
    base: float
    called: tuple[str, ...] = ()


FORMATS: Mapping[str, Format] = MappingProxyType(
    {
        "A1": Format(841.0, 594.0, 0.8, 1.0, 120.0, 1.5, ("А1",)),
        "A1 portrait": Format(594.0, 841.0, 0.8, 1.0, 120.0, 1.5),
        "A2": Format(594.0, 420.0, 0.8, 0.77, 80.0, 1.25, ("А2",)),
        "A2 portrait": Format(420.0, 594.0, 0.8, 0.77, 120.0, 1.25),
        "A3": Format(420.0, 297.0, 0.6, 0.58, 50.0, 1.0, ("А3",)),
        "A3 portrait": Format(297.0, 420.0, 0.6, 0.58, 80.0, 1.0),
        "A4": Format(210.0, 297.0, 0.6, 0.53, 45.0, 1.0, ("А4",)),
        "A4 landscape": Format(297.0, 210.0, 0.6, 0.42, 30.0, 1.0),
    }
)
"""By name. All are landscape by default but A4, which is portrait (ГОСТ 2.301; lines by ГОСТ 2.303)."""
PAPERS = tuple(name for name in tuple(FORMATS)[::-1] if " " not in name)
"""Formats of paper, the smallest first, whether it stands or lies."""
USUAL = "A1"
"""The format of a sheet that does not say."""
AUTO = "auto"
"""What a scene writes for the smallest format that holds a sheet's views; they are drawn as large as on
`SENSIBLE` until it is known."""
SENSIBLE = "A2"


def growing() -> tuple[str, ...]:
    """Return the names of formats, the smallest first; of two of one size the usual way first."""
    return tuple(sorted(FORMATS, key=lambda name: FORMATS[name].width * FORMATS[name].height))


def size_of(name: str) -> tuple[float, float]:
    """Return the width and the height of a format, mm."""
    return FORMATS[name].width, FORMATS[name].height


def turned(name: str) -> str:
    """Return the format of the same paper that stands where another one lies, and lies where it stands."""
    one = FORMATS[name]
    return next(n for n, f in FORMATS.items() if (f.width, f.height) == (one.height, one.width))


def narrowest(names: Iterable[str]) -> Format:
    """Return the format with the least room of some; the usual one of none."""
    there = (FORMATS[SENSIBLE if name == AUTO else name] for name in names)
    return min(there, key=lambda one: one.share, default=FORMATS[USUAL])


def other_names() -> dict[str, str]:
    """Return the other names of formats that scenes may write, each with the format that is meant."""
    return {other: name for name, one in FORMATS.items() for other in one.called}


class Heights(NamedTuple):
    """Heights of capitals, mm (a row of ГОСТ 2.304).

    ``point``: letters at points and of vectors, equations, the lines of a caption below its title.
    ``title``: of views and tables. ``number``: numbers of positions and divisions, dimensions, cells of tables.
    """

    point: float
    title: float
    number: float

    def times(self, factor: float) -> Heights:
        """Return the heights multiplied by a factor."""
        return Heights(*(factor * height for height in self))


_WALL, _DESK = Heights(5.0, 7.0, 3.5), Heights(3.5, 5.0, 3.5)
"""On a wall, where a board of examiners reads it from 1.5 m; in the hand."""
HEIGHTS: Mapping[str, Heights] = MappingProxyType(
    {"A4": _DESK, "A3": _DESK, "A2": _WALL, "A1": _WALL}
)
"""By the first word of a format, the narrowest first."""


def heights_on(formats: Iterable[str]) -> Heights:
    """Return the heights on the narrowest of some formats; on the usual one if none of them is known."""
    there = {format.split()[0] for format in formats}
    return next((found for name, found in HEIGHTS.items() if name in there), HEIGHTS[USUAL])


class Ordered(Protocol):
    """A sheet that is ordered: its format, the places that it shows."""

    @property
    def format(self) -> str:
        """The format."""

    @property
    def place(self) -> tuple[str, ...]:
        """The places."""


class Orders(Protocol):
    """Sheets that are ordered, and how high their letters are to be, mm; None: as usual."""

    @property
    def sheets(self) -> Sequence[Ordered]:
        """The sheets."""

    @property
    def letters(self) -> tuple[float, float, float] | None:
        """The heights."""


def heights(scene: Orders, *places: str) -> Heights:
    """Return how high the letters of a place of a scene's sheets are, the same on all that show it.

    ``places``: it and those that it is a part of. One that no sheet shows is lettered as the narrowest of all.
    """
    shown = [sheet.format for sheet in scene.sheets if not {*places}.isdisjoint(sheet.place)]
    if scene.letters is not None:
        return Heights(*scene.letters)
    return heights_on(shown or (sheet.format for sheet in scene.sheets))
