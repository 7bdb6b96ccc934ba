"""Look again, by what was seen: points that are sure tell where the lines through them run.

A line that was drawn from a point begins where that point was drawn, not where it should be. So lines are
followed once more, near where the points on them were found, and chosen anew.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import Line, View
from graphic_tmm.checking.pencil.fitting import Fit, fit
from graphic_tmm.checking.pencil.lines import ONE, Track, tracks
from graphic_tmm.checking.pencil.points import SEEN, Spot
from graphic_tmm.checking.pencil.web import Pin

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
    flat: Flat, view: View, shift: complex, line: Line, known: Sequence[Track], first: Fit
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
    moved = Line(line.start + left * aside.start, line.end + left * aside.end, line.places)
    found: list[Track] = []
    for one in tracks(flat, moved, shift, NARROW * spread + NEAREST):
        track = one._replace(start=one.start + aside.start, end=one.end + aside.end)
        if all(
            max(abs(track.start - t.start), abs(track.end - t.end)) > ONE for t in (*known, *found)
        ):
            found.append(track)
    return found
