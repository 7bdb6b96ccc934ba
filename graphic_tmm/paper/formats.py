"""The formats of paper: what of a drawing depends on them, each stated here and nowhere else."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from types import MappingProxyType


@dataclass(frozen=True)
class Format:
    """A format: width and height (mm), the width s of its main line (mm), ``called`` so in Russian scenes too.

    ``room``: for a plan of positions, and ``graph``: for how high a graph is, three of which stand in a column
    (mm); on a small sheet both are what it holds beside its title block.
    """

    width: float
    height: float
    main: float
    room: float
    graph: float
    called: tuple[str, ...] = ()


FORMATS: Mapping[str, Format] = MappingProxyType(
    {
        "A1": Format(841.0, 594.0, 0.8, 230.0, 120.0, ("А1",)),
        "A1 portrait": Format(594.0, 841.0, 0.8, 230.0, 120.0),
        "A4": Format(210.0, 297.0, 0.6, 140.0, 45.0, ("А4",)),
    }
)
"""By name: A1 lies unless it is asked to stand, A4 stands (ГОСТ 2.301; lines by ГОСТ 2.303)."""
USUAL = "A1"
"""The format of a sheet that does not say."""


def size_of(name: str) -> tuple[float, float]:
    """Return the width and the height of a format, mm."""
    return FORMATS[name].width, FORMATS[name].height


def narrowest(names: Iterable[str]) -> Format:
    """Return the format with the least room of some; the usual one of none."""
    return min((FORMATS[name] for name in names), key=lambda one: one.room, default=FORMATS[USUAL])


def others() -> dict[str, str]:
    """Return the other names of formats that scenes may write, each with the format that is meant."""
    return {other: name for name, one in FORMATS.items() for other in one.called}
