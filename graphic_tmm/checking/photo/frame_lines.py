"""The frame's four lines found in a photograph, near where its corners were clicked.

Along every edge a strip is read; the darkest smooth path in it is the line, gone about a finger or a
line that ends on it; its axis is the centroid of its darkness, much finer than a dot of the photograph.

The numbers below were tried on photographs of known cameras (``tests/support/photographs.py``): ink, ink
seen steeply, a pencil line of 0.5 mm, a line of 0.3 mm in grain with clicks 5 px off, fingers on the frame.
As they stand, corners and lens put every point within the frame within 0.012, 0.014, 0.050, 0.038 and 0.012 mm.
Where it is said that a number could move, all stayed within 0.05 mm before the lens was sought too.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.photo.camera import Curl, Lens, Shot, bowed, pinhole, unbending
from graphic_tmm.checking.photo.perspective import bilinear, cross, homography, vertices
from graphic_tmm.language.said import said
from graphic_tmm.paper.ruled import Box

EDGES = said("lower"), said("right"), said("upper"), said("left")

STATIONS = 400
"""Places along an edge where the line is sought, about 2 mm apart on an A1: more of them average more
grain. Half as many leave 0.07 mm (pencil), a quarter 0.09 mm; twice as many 0.03 mm, in twice the time."""

REACH = 4.0
"""How far from the line through the corners it is sought, mm: the nearest line beside it is at 5 mm.
Could be 2 (clicks have to be that near) to 5."""

FAR = 8.0
"""How far it is sought at first sight where none is seen within `REACH`, mm: a corner that was clicked 20 dots
off is 5 mm off on an A1 of 12 megapixels, 7 mm aslant. Lines beside the frame are shorter, or paler."""

CLEAR, CLEAR_DOTS = 1.2, 2.5
"""From the axis of a line to the paper beside it: mm (a main line is 0.8 mm wide), and at least pixels.
Could be 0.8 to 1.6 mm and 1.5 to 2.5 px: with 3.5 px grain beside the line counts, and 0.13 mm are lost."""

ASIDE = 8
"""Readings of a strip from the axis of a line to the paper beside it. Could be 4 to 16 at least."""

NEAR_CORNER = 3.0
"""So much of an edge is left out at its ends, where the next line begins, mm: half of a main line
and what a corner blurs. Could be 3 to 20; with 1.5 pencil is 0.06 mm off."""

FAINT = 0.12
"""A line is darker than the paper beside it by this share at least. Could be 0.03 to 0.12, where an empty
sheet still shows no line; with 0.2 pencil is no longer seen."""

SEEN = 1 / 3
"""Of its stations so many must show a line: hands may cover the others. Could be 0.15 to 0.5; with 0.7
pencil is lost."""

BEND, STRAY = 0.1, 0.1
"""In the path: the cost of a step aside, and that of the edge of the strip, as shares of darkness. Could
be 0.02 to 0.5, and 0 to 1."""

DEGREE, ROUNDS, CUT = 4, 12, 4.7
"""The smooth curve fitted to a line, rounds of Tukey's biweight, its cut in standard deviations (the
customary one: 95 % as efficient as least squares on normal errors). A lens bows the line, so that it is no
straight one. Could be 2 to 6, 3 to 25 and 2.5 to 9."""

FLOOR = 0.01
"""Scatter of a line drawn and photographed without fault, mm: keeps the weights defined. Could be
0.001 to 0.1."""

DIM = 20.0
"""Paper darker than this, of 255, is taken for no paper: its noise is no line. Could be 5 to 80."""

SIGHTS = 3
"""So many times the lines are sought: from the clicks, along the lines, with the lens. Could be 3 to 5."""

Reading = Callable[[Reals], Reals]
"""From offsets across an edge, mm, (offsets,) or (stations, offsets), to grey values 0 ... 255."""


class Lines(NamedTuple):
    """The frame in a photograph: corners (4,), px, in the order of `vertices`; its lens; edges not found.

    ``residual``: how far the frame's lines are from straight without the lens, mm; NaN if none was found.
    ``bowed``: how far the lens alone bows them.
    """

    corners: Complexes
    residual: float
    missing: tuple[str, ...]
    lens: Lens
    curl: Curl
    bowed: float


class Edge(NamedTuple):
    """A line across an edge: offsets at its two ends to the left, mm, and how far it is from straight.

    ``seen``: its points in the photograph, px; ``weights``: how far each is believed.
    """

    start: float
    end: float
    bend: float
    seen: Complexes
    weights: Reals


_UNSEEN = Edge(0.0, 0.0, np.nan, np.empty(0, np.complex128), np.empty(0))


def refine(
    image: NDArray[np.uint8], box: Box, corners: Complexes, known: Lens | None = None
) -> Lines:
    """Return the frame ``box`` (mm) found near ``corners`` (4,), px, in ``image`` (rows, columns, 3).

    Neighbouring lines meet in the corners. It is done again, so that the strips then lie along the lines,
    bowed as the lens bows them; an edge that shows no line stays where it was clicked. ``known``: the lens that
    it begins with, a pinhole where nobody knows.
    """
    feet = vertices(box)
    straighter, less = known or pinhole(image), Curl(box)
    for sight in range(SIGHTS):
        lens, curl = straighter, less
        shot = Shot(image, homography(box, lens.straight(corners)), lens, curl)
        edges = [
            _edge_near(shot, foot, head, first=sight == 0)
            for foot, head in zip(feet, np.roll(feet, -1), strict=True)
        ]
        corners = shot.to_picture(_meet(feet, edges))
        lines = [(one.seen, one.weights) for one in edges if one.seen.size]
        straighter, less = unbending(shot, lines)
    bends = [edge.bend for edge in edges if edge.bend == edge.bend]
    missing = tuple(name for name, edge in zip(EDGES, edges, strict=True) if edge.bend != edge.bend)
    whole = Shot(image, homography(box, lens.straight(corners)), lens, curl)
    return Lines(corners, max(bends, default=np.nan), missing, lens, curl, bowed(whole, feet))


def _meet(feet: Complexes, edges: list[Edge]) -> Complexes:
    """Return where the lines of neighbouring edges meet, mm on the sheet."""
    heads = np.roll(feet, -1)
    left = 1j * (heads - feet) / abs(heads - feet)
    starts = feet + left * np.array([edge.start for edge in edges])
    ways = heads + left * np.array([edge.end for edge in edges]) - starts
    before, way = np.roll(starts, 1), np.roll(ways, 1)
    along = cross(starts - before, ways) / cross(way, ways)
    met: Complexes = before + way * along
    return met


def _edge_near(shot: Shot, foot: complex, head: complex, *, first: bool) -> Edge:
    """Return the line along an edge; at first sight farther away if there is none near it."""
    near = _edge(shot, foot, head, REACH)
    return near if near.seen.size or not first else _edge(shot, foot, head, FAR)


def _edge(shot: Shot, foot: complex, head: complex, reach: float) -> Edge:
    """Return the line that is seen along the edge from ``foot`` to ``head``, no farther than ``reach``, mm."""
    length = abs(head - foot)
    way = (head - foot) / length
    inset = min(NEAR_CORNER, length / 10)
    along = np.linspace(inset, length - inset, STATIONS)
    axis = (foot + way * along)[:, None]
    fine = float(abs(np.diff(shot.to_picture(axis[:, 0]))).min()) / (along[1] - along[0])
    clear = max(CLEAR, CLEAR_DOTS / fine)

    def read(offsets: Reals) -> Reals:
        grey: Reals = bilinear(shot.image, shot.to_picture(axis + 1j * way * offsets)).mean(axis=-1)
        return grey

    offsets, dark = _strip(read, clear, reach)
    path = _darkest(dark - STRAY * (offsets / reach) ** 2)
    depth = np.take_along_axis(dark, path[:, None], axis=1)[:, 0]
    centre = _centred(read, offsets[path], clear)
    shown = (depth > FAINT) & (depth > np.median(depth) / 2) & np.isfinite(centre)
    if shown.mean() < SEEN:
        return _UNSEEN
    centre = np.where(shown, centre, 0.0)
    place = 2 * along / length - 1
    curve, weights = _smooth(place, centre, shown.astype(np.float64))
    kept = weights > 0
    if kept.mean() < SEEN:
        return _UNSEEN
    line = _fitted(place, centre, weights, 1)
    # beside its straight line, and what the curl that the strip follows has of bend
    rise = ((shot.curl.seen(axis[:, 0]) - axis[:, 0]) / way).imag
    bent = curve(place) - line(place) + rise - _fitted(place, rise, weights, 1)(place)
    bend = abs(bent)[kept].max()
    seen = shot.to_picture(axis[:, 0] + 1j * way * centre)
    return Edge(float(line(-1.0)), float(line(1.0)), float(bend), seen[kept], weights[kept])


def _strip(read: Reading, clear: float, reach: float) -> tuple[Reals, Reals]:
    """Return offsets to ``reach``, mm, and how much darker each is than the paper on both sides of it.

    Shares (stations, offsets), 0 where a side, ``clear`` away, is darker or is not in the photograph; each is
    the mean with its neighbours along the edge.
    """
    step = clear / ASIDE
    half = round(reach / step)
    offsets: Reals = step * np.arange(-half - ASIDE, half + ASIDE + 1, dtype=np.float64)
    grey = read(offsets)
    grey[1:-1] = (grey[:-2] + grey[1:-1] + grey[2:]) / 3
    paper = np.minimum(grey[:, : -2 * ASIDE], grey[:, 2 * ASIDE :])
    dark = (paper - grey[:, ASIDE:-ASIDE]) / np.maximum(paper, DIM)
    return offsets[ASIDE:-ASIDE], np.where(dark > 0, dark, 0.0).astype(np.float64)


def _darkest(dark: Reals) -> NDArray[np.intp]:
    """Return the path (stations,) of columns of ``dark`` with the greatest sum, a column a step at most."""
    stations, width = dark.shape
    came = np.zeros((stations, width), dtype=np.intp)
    best = dark[0]
    columns = np.arange(width)
    for k in range(1, stations):
        fenced = np.pad(best, 1, constant_values=-np.inf)
        ways = np.stack([fenced[1:-1], fenced[:-2] - BEND, fenced[2:] - BEND])
        taken = ways.argmax(axis=0)
        came[k] = columns + np.array([0, -1, 1])[taken]
        best = ways[taken, columns] + dark[k]
    path = np.empty(stations, dtype=np.intp)
    path[-1] = best.argmax()
    for k in range(stations - 1, 0, -1):
        path[k - 1] = came[k, path[k]]
    return path


def _centred(read: Reading, centre: Reals, clear: float) -> Reals:
    """Return the centroids of darkness within ``clear`` of ``centre`` (stations,), mm."""
    window = np.linspace(-clear, clear, 33)
    for _ in range(3):
        grey = read(centre[:, None] + window)
        share = (window + clear) / (2 * clear)
        paper = grey[:, :1] * (1 - share) + grey[:, -1:] * share
        dark = np.maximum(paper - grey, 0.0)
        whole = dark.sum(axis=1)
        centre = centre + (dark * window).sum(axis=1) / np.where(whole > 0, whole, np.nan)
    return centre


def _smooth(place: Reals, offset: Reals, given: Reals) -> tuple[Polynomial, Reals]:
    """Return the smooth curve through most of the offsets, and the weight of each (Tukey's biweight)."""
    weights = given
    for _ in range(ROUNDS):
        if (weights > 0).sum() <= DEGREE:
            break
        curve = _fitted(place, offset, weights, DEGREE)
        off = abs(offset - curve(place))
        scatter = 1.4826 * float(np.median(off[given > 0])) + FLOOR
        weights = given * np.maximum(1 - (off / (CUT * scatter)) ** 2, 0.0) ** 2
    return curve, weights


def _fitted(place: Reals, offset: Reals, weights: Reals, degree: int) -> Polynomial:
    return Polynomial.fit(place, offset, degree, domain=(-1, 1), w=np.sqrt(weights))
