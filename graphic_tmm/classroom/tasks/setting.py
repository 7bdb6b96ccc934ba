"""How close the sheets of a task are set: the settings that are tried, from the roomiest on."""

from __future__ import annotations

from typing import NamedTuple


class Setting(NamedTuple):
    """How close a task is set; mm.

    ``text``, ``heading``, ``rows``: heights of what is read, of headings, of letters in tables (ГОСТ 2.304);
    ``between``, ``least``: between blocks, and between the sentences of one list; ``share``: of its usual
    height that the scheme may take; ``run_in``: whether sentences begin on the line of their heading;
    ``under``: whether they stand in what is free below the scheme beside its table, too.
    """

    text: float = 3.5
    heading: float = 5.0
    rows: float = 3.5
    between: float = 4.0
    least: float = 1.5
    share: float = 1.0
    run_in: bool = False
    under: bool = False


ROOMY = Setting()
_CLOSE = Setting(between=3.0, least=0.8, under=True)
_CLOSER = _CLOSE._replace(run_in=True, rows=2.5)
_SMALL = Setting(2.5, 3.5, 2.5, 3.0, 1.0, 0.8, under=True)
SETTINGS = (
    ROOMY,
    ROOMY._replace(share=0.72),
    _CLOSE,
    _CLOSE._replace(rows=2.5),
    _CLOSER,
    _CLOSER._replace(share=0.72),
    _SMALL,
    _SMALL._replace(share=0.6, run_in=True, between=2.2, least=0.4),
)
"""The first that saves a sheet is taken."""
FILLING = tuple(
    one._replace(share=share)
    for one in (ROOMY, ROOMY._replace(under=True), _CLOSE._replace(rows=2.5))
    for share in (1.0, 1.3, 1.6)
)
"""Where several sheets are needed in any of them: that is taken which leaves them the least white."""
