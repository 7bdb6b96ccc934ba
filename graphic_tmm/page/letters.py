"""Letters that move with the crank: each at its point, off it as on the sheet, gliding between positions.

Where the sheet letters a figure its own labels tell how far each letter stands from its point; between two such
positions that way turns and stretches evenly, the shorter way round. A letter that no sheet shows finds its
place as it would on a sheet, in a few positions; on the mechanism itself, round which the numbers of all
positions stand, in each of these.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.page.dense import Dense
from graphic_tmm.page.strands import Letter, Moving, Strands, bare
from graphic_tmm.paper.drawing import Drawing, Label, Wanted
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.write.svg import shift

LEAST = 2
"""A figure is lettered at so many angles at least."""

BESIDE = 1.5 + 1.5j
"""Where a letter begins that is nowhere placed: so far from its point, mm."""

Aside = dict[Letter, dict[int, complex]]
"""How far the middle of a letter stands from its point, mm, by the angles (indices) at which it was placed."""


def lettered(
    dense: Dense,
    moving: Moving,
    made: Strands,
    shown: Mapping[str, Drawing],
    still: Drawing | None = None,
) -> dict[Letter, Reals]:
    """Return where the base lines of letters begin at the angles drawn, (drawn, 2), mm.

    ``shown``: the views of the sheets by their names; ``still``: what stands about the figure, lettered.
    """
    found: Aside = {}
    # where numbers stand about it they do so otherwise than on the sheet
    for k, place in enumerate(dense.at if still is None or not still.labels else ()):
        view = shown.get(moving.on_sheet(dense.sheet.names[k]))
        if view is not None and moving.name in view.shows and place in made.drawn:
            _from_sheet(found, made, view, view.origin(moving.name), place, k)
    _placed(found, dense, moving, made, still)
    at = dense.frames[list(made.drawn)]
    return {
        key: _along(key, row, found.get(key, {}), dense, at)
        for key, row in made.rows.items()
        if isinstance(key, Letter)
    }


def _from_sheet(
    found: Aside, made: Strands, view: Drawing, origin: complex, place: int, k: int
) -> None:
    """Enter how a view of a sheet letters a position; ``origin``: where that of the figure stands there."""
    row = made.drawn.index(place)
    many = len(view.numbers) > 1
    labels = [one for one in view.labels if not many or one.position == k]
    for key, at in _anchors(made, row):
        label = next(
            (one for one in labels if one.of == key.of and bare(one.text) == key.text), None
        )
        if label is not None:
            labels.remove(label)
            found.setdefault(key, {})[place] = _middle(label, key) - origin - at


def _anchors(made: Strands, row: int) -> Iterable[tuple[Letter, complex]]:
    for key, rows in made.rows.items():
        if isinstance(key, Letter) and np.isfinite(rows[row, 0]):
            yield key, complex(*rows[row])


def _placed(
    found: Aside, dense: Dense, moving: Moving, made: Strands, still: Drawing | None
) -> None:
    """Place the letters that no sheet shows, as on a sheet: in some positions, then where most are left."""
    there = [place for place in dense.at if place in made.drawn]
    there = [place for place in there if place not in dense.drawn.undrawn]
    need = {key for key in made.rows if isinstance(key, Letter)} - found.keys()
    done = {place for places in found.values() for place in places}
    least = min(LEAST, len(there)) if moving.crank is None else len(there)
    if len(done) < least:
        spread = np.linspace(0, len(there), least, endpoint=False).astype(int)
        for place in dict.fromkeys(there[k] for k in spread):
            if place not in done:
                _place(found, moving, made, still, place, None)
        need -= found.keys()
    rows = [
        (sum(np.isfinite(made.rows[key][row, 0]) for key in need), -row)
        for row in range(len(made.drawn))
    ]
    count, row = max(rows)
    if count:
        _place(found, moving, made, still, made.drawn[-row], need)


def _place(
    found: Aside,
    moving: Moving,
    made: Strands,
    still: Drawing | None,
    place: int,
    only: set[Letter] | None,
) -> None:
    drawing = moving.at(place)
    if still is not None:
        drawing = drawing._replace(
            strokes=(*drawing.strokes, *still.strokes), labels=(*drawing.labels, *still.labels)
        )
    row = made.drawn.index(place)
    labels = finished(drawing).labels
    wanted = [one for one in drawing.wanted if np.isfinite(one.at)]
    placed = dict(zip(map(_like, wanted), labels[len(drawing.labels) :], strict=True))
    for key, at in _anchors(made, row):
        label = placed.get((key.of, key.text))
        if label is not None and (only is None or key in only):
            found.setdefault(key, {})[place] = _middle(label, key) - at


def _like(one: Wanted) -> tuple[tuple[int, ...], str]:
    return one.of, bare(one.text)


def _middle(label: Label, key: Letter) -> complex:
    """Return the middle of a label without the figure that it tells."""
    whole = letter(label.text, size=label.size, inclined=label.inclined)
    return label.at - shift(label, whole.width) + _half(key)


def _half(key: Letter) -> complex:
    own = letter(key.text, size=key.size)
    return complex(own.width, own.ascent - own.descent) / 2


def _along(
    key: Letter, row: Reals, placed: Mapping[int, complex], dense: Dense, at: Reals
) -> Reals:
    """Return where a letter stands at every angle drawn; ``at``: these, in degrees from the zero position."""
    middle = row[:, 0] + 1j * row[:, 1]
    if not placed:
        middle = middle + BESIDE + _half(key)
    else:
        where = dense.frames[list(placed)]
        middle = middle + glide(where, np.array(list(placed.values())), at, float(dense.whole))
    start = middle - _half(key)
    return np.stack([start.real, start.imag], axis=1)


def glide(where: Reals, asides: Complexes, at: Reals, whole: float) -> Complexes:
    """Return ways off a point that go evenly from one to the next, round the shorter way.

    ``where``: the angles at which they are ``asides``, degrees of the ``whole``; ``at``: those wanted.
    """
    order = np.argsort(where)
    where, asides = where[order], asides[order]
    size, turn = np.abs(asides), np.angle(asides)
    after = np.roll(np.arange(where.size), -1)
    k = (np.searchsorted(where, at, side="right") - 1) % where.size
    span = (where[after[k]] - where[k]) % whole
    share = ((at - where[k]) % whole) / np.where(span > 0, span, np.inf)
    by = (turn[after[k]] - turn[k] + np.pi) % (2 * np.pi) - np.pi
    far = size[k] + share * (size[after[k]] - size[k])
    return np.asarray(far * np.exp(1j * (turn[k] + share * by)))
