"""How high letters are: by the format of the sheet, that is by how far from it its reader stands."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple, Protocol

from graphic_tmm.paper.formats import USUAL


class Heights(NamedTuple):
    """Heights of capitals, mm (a row of ГОСТ 2.304).

    ``point``: letters at points and of vectors, equations, the lines of a caption below its title.
    ``title``: of views and tables. ``number``: numbers of positions and divisions, dimensions, cells of tables.
    """

    point: float
    title: float
    number: float

    def times(self, factor: float) -> Heights:
        """Return heights so many times as large."""
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
