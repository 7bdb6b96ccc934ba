"""Plans proposed without a click: lines of pencil in the directions that a plan is due, in one scale factor.

Two lines that cross in the directions of a corner of the plan tell where that is; any further line in a due
direction tells by its distance from there how many times as large the plan was drawn. What is proposed is
shown, to be confirmed or clicked elsewhere: nothing is judged by it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.hand import Hand
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.checking.cells import points
from graphic_tmm.checking.own_sheet.alternatives import MISSED, Alternatives, roughly, shapeless
from graphic_tmm.checking.own_sheet.clicked import ClickedPlan, first_letter, may_be_clicked
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import View
from graphic_tmm.checking.photo.long_lines import segments
from graphic_tmm.drawn import DrawnScene

STRONG = 4.0
"""Pencil is so many times as dark as the faintest that is sure, or shown as if it were."""
LEAST = 5.0
"""Shorter segments are letters and heads, mm."""
ASIDE, APART, GAP = 0.8, 2.5, 6.0
"""Segments of one line of pencil are so near to it, mm, turned by so many degrees, so far apart, at most."""
TURNED = 3.0
"""A line is drawn in a direction that it is due, degrees."""
BEYOND = 3.0
"""Lines meet in a pole no farther from where they are seen, mm."""
SIZES = 0.3, 3.0
"""Plans are so many times as large as they are due."""
OFF = 8.0
"""Lines nearer to the pole, in a plan as due, do not tell how large it is, mm."""
CORNERS = 5
"""So many corners of a plan, the clearest, tell where it stands."""
ALIKE = 0.04
"""Plans of a kind are drawn to one scale factor; sizes told by single lines agree so far."""
KEPT = 40
"""So many places of a plan are kept, the best."""
DRAWN, CLEARER = 0.93, 0.1
"""So much of a plan's lines is pencil, less what is not; so much more than at any other place."""
FINER = (3.0, 0.6), (0.6, 0.2)
"""A plan is fitted so far about where lines tell that it stands, in such steps, mm."""
EDGE, TRIED = 2.0, 6
"""Plans stand so far from the sheet's edges, mm; so many places are looked at closely."""
LINE, DENSE = 0.3, 1.5
"""Half of a line of pencil is so broad, mm; it is looked for so densely along it, mm."""
AT_ONCE = 2000
"""So many places are looked at, at once: memory."""
ELSEWHERE = 4.0
"""Another place is so far away, mm."""
TURNS = (1.0 + 0j, 1j, -1j)
"""Plans of a kind may be turned so."""
Bools = NDArray[np.bool_]


class Proposal(NamedTuple):
    """A plan that may stand somewhere: where, mm on the sheet; the share of its lines that is pencil."""

    plan: ClickedPlan
    share: float


class Pencil(NamedTuple):
    """A sheet, and the straight lines of pencil on it: their ends, mm, (lines, 2)."""

    flat: Flat
    lines: Complexes

    def along(self, way: complex) -> Complexes:
        """Return the lines in a direction, either way."""
        turn = np.angle(((self.lines[:, 1] - self.lines[:, 0]) / way) ** 2) / 2
        return np.asarray(self.lines[abs(turn) < np.radians(TURNED)], np.complex128)


class Candidate(NamedTuple):
    """Where a plan may stand: its pole, mm, how many times as large as due, the share that is pencil."""

    pole: complex
    size: float
    share: float


class Candidates(NamedTuple):
    """Where a plan may stand: poles, mm, how many times as large as due, the share that is pencil."""

    poles: Complexes
    sizes: Reals
    shares: Reals

    def near(self, size: float) -> Candidates:
        """Return those about as large as that."""
        some = abs(np.log(self.sizes / size)) < ALIKE
        return Candidates(self.poles[some], self.sizes[some], self.shares[some])


def proposals(made: DrawnScene, flat: Flat, hand: Hand) -> tuple[Proposal, ...]:
    """Return where plans of a scene may stand on a sheet, each kind in one scale factor and one turn.

    What is drawn in one line, as at a dead centre, has no shape and is not proposed.
    """
    assert made.mechanism is not None
    others, pencil = Alternatives(made.mechanism, hand), Pencil(flat, pencil_lines(flat))
    due, found = points(made), []
    for plan in dict.fromkeys(key[0] for key in due if may_be_clicked(made, key[0])):
        names = dict.fromkeys(key[2] for key in due if key[0] == plan)
        views = {name: others.due(plan, name) for name in names}
        views = {name: view for name, view in views.items() if not shapeless(view)}
        turned = [_Kind.of(pencil, views, turn) for turn in TURNS]
        best = max(turned, key=lambda kind: kind.worth)
        for name, place in best.clear(pencil).items():
            end = place.size * best.views[name].turn * due[plan, first_letter(made, plan), name]
            clicked = ClickedPlan(plan, name, place.pole, place.pole + end)
            found.append(Proposal(clicked, place.share))
    return _apart(found)


class _Kind(NamedTuple):
    """Views of a kind of plan, turned alike; where each may stand; the size that most pencil agrees with."""

    views: Mapping[str, View]
    places: Mapping[str, Candidates]
    worth: float
    size: float

    @classmethod
    def of(cls, pencil: Pencil, due: Mapping[str, View], turn: complex) -> _Kind:
        """Return the views of a kind, as far as the pencil tells."""
        views = {name: view.turned(turn) for name, view in due.items()}
        places = {name: _places(pencil, view) for name, view in views.items()}
        tried = np.exp(np.arange(np.log(SIZES[0]), np.log(SIZES[1]), ALIKE / 2))
        # twice as large a plan explains twice as much pencil
        worth = [
            sum(size * one.near(size).shares.max(initial=0.0) ** 2 for one in places.values())
            for size in tried
        ]
        best = int(np.argmax(worth))
        return cls(views, places, float(worth[best]), float(tried[best]))

    def clear(self, pencil: Pencil) -> dict[str, Candidate]:
        """Return by position where plans clearly stand, all to the scale factor that they say together."""
        found = {}
        for name, view in self.views.items():
            ends = _ends(pencil, view, self.size)
            some = (*self.places[name].near(self.size), *_drawn(pencil.flat, view, *ends))
            both = Candidates(*(np.concatenate([some[n], some[n + 3]]) for n in range(3)))
            if (place := _clear(pencil.flat, view, both)) is not None:
                found[name] = place
        if not found:
            return found
        size = float(np.median([place.size for place in found.values()]))
        alike = {
            name: _nearer(pencil.flat, self.views[name], place.pole, size, 0.0)
            for name, place in found.items()
        }
        return {name: place for name, place in alike.items() if place.share > DRAWN}


def pencil_lines(flat: Flat) -> Complexes:
    """Return the straight lines of pencil on a sheet: their ends, mm, (lines, 2)."""
    dark = (np.clip(flat.dark / (STRONG * flat.level), 0.0, 1.0) * 106).astype(np.uint8)
    ends = (segments(dark) + 0.5 + 0.5j) / flat.dots
    ends = flat.area.left + 1j * flat.area.top + ends.conj()
    ends = ends[np.argsort(-abs(ends[:, 1] - ends[:, 0]), kind="stable")]
    ends = ends[abs(ends[:, 1] - ends[:, 0]) > LEAST]
    found = []
    while len(ends):
        foot, head = ends[0]
        for _ in range(3):
            way = (head - foot) / abs(head - foot)
            own = (ends - foot) / way
            turn = abs(np.angle((own[:, 1] - own[:, 0]) ** 2)) / 2
            near = (abs(own.imag).max(axis=1) < ASIDE) & (turn < np.radians(APART))
            near &= own.real.min(axis=1) < abs(head - foot) + GAP
            near &= own.real.max(axis=1) > -GAP
            near[0] = True
            along = own[near].real
            off = own[near].imag.mean()
            foot, head = (foot + way * (end + 1j * off) for end in (along.min(), along.max()))
        found.append((foot, head))
        ends = ends[~near]
    return np.array(found, np.complex128).reshape(-1, 2)


def _places(pencil: Pencil, view: View) -> Candidates:
    """Return where a view may stand: by lines that cross, others that tell its size; by ends of lines."""
    like = [pencil.along(line.way) for line in view.lines]
    poles, sizes = [], []
    for a, b, place in _corners(view):
        at, crossed = view.places[place].at, _crossings(like[a], like[b])
        for line, own in zip(view.lines, like, strict=True):
            aside = ((line.start - at) / line.way).imag
            if place in line.places or abs(aside) < OFF:
                continue
            # by how far a line of pencil is from each corner, and on which side of it
            times = ((own.mean(axis=1) - crossed[:, None]) / line.way).imag / aside
            k, n = np.nonzero((times > SIZES[0]) & (times < SIZES[1]))
            sizes.append(times[k, n])
            poles.append(crossed[k] - sizes[-1] * at)
    ends, times = _ends(pencil, view)
    right = (times > SIZES[0]) & (times < SIZES[1])
    poles, sizes = [*poles, ends[right]], [*sizes, times[right]]
    return _drawn(pencil.flat, view, np.concatenate(poles), np.concatenate(sizes))


def _ends(pencil: Pencil, view: View, size: float | None = None) -> tuple[Complexes, Reals]:
    """Return ends of pencil where a view may have its pole, how large it is: ``size``, or as they are long."""
    poles, sizes = [np.zeros(0, np.complex128)], [np.zeros(0)]
    pole = next(iter(view.poles.values()))
    for line in view.lines:
        far = complex(max(view.at[list(line.places)], key=abs))
        if pole not in line.places or abs(far) < OFF:
            continue
        own = pencil.along(line.way)
        for ends in (own, own[:, ::-1]):
            times = ((ends[:, 1] - ends[:, 0]) / far).real
            poles.append(ends[times > 0, 0])
            sizes.append(times[times > 0])
    whole = np.concatenate(sizes)
    return np.concatenate(poles), whole if size is None else np.full(len(whole), size)


def _corners(view: View) -> list[tuple[int, int, int]]:
    """Return the clearest corners of a view: two lines (indices) that cross in a place (index)."""
    found = [
        (min(a.length, b.length) * abs((a.way / b.way).imag), n, m, place)
        for n, a in enumerate(view.lines)
        for m, b in enumerate(view.lines[:n])
        for place in set(a.places) & set(b.places)
    ]
    return [(n, m, place) for clear, n, m, place in sorted(found)[-CORNERS:] if clear > OFF / 2]


def _crossings(some: Complexes, others: Complexes) -> Complexes:
    """Return where lines of pencil cross others, or nearly reach them."""
    a, b = some[:, None, 0], others[None, :, 0]
    u, v = (some[:, 1] - some[:, 0])[:, None], (others[:, 1] - others[:, 0])[None]
    with np.errstate(divide="ignore", invalid="ignore"):
        along = ((b - a) / v).imag / (u / v).imag
    at = a + along * u
    near = np.ones(at.shape, bool)
    for start, way in ((a, u), (b, v)):
        share, beyond = ((at - start) / way).real, BEYOND / abs(way)
        near &= (share > -beyond) & (share < 1 + beyond)
    return np.asarray(at[near], np.complex128)


def _drawn(flat: Flat, view: View, poles: Complexes, sizes: Reals) -> Candidates:
    """Return the best of places where a view may stand."""
    there = _on_sheet(flat, view, poles, sizes)
    poles, sizes = poles[there], sizes[there]
    if not len(poles):
        return Candidates(poles, sizes, sizes)
    whole = sum(line.length for line in view.lines)
    starts, ends = (poles[:, None] + sizes[:, None] * some for some in view.ends)
    shares = np.concatenate(
        [
            roughly(flat, starts[n : n + AT_ONCE], ends[n : n + AT_ONCE])
            for n in range(0, len(poles), AT_ONCE)
        ]
    ) / (whole * sizes)
    best = np.argsort(-shares)[:KEPT]
    return Candidates(poles[best], sizes[best], shares[best])


def _on_sheet(flat: Flat, view: View, poles: Complexes, sizes: Reals) -> Bools:
    """Return whether all places of a view lie on the sheet, well off its edges."""
    at, area = poles[:, None] + sizes[:, None] * view.at, flat.area
    inside = (at.real > area.left + EDGE) & (at.real < area.right - EDGE)
    inside &= (at.imag > area.bottom + EDGE) & (at.imag < area.top - EDGE)
    return np.asarray(inside.all(axis=1))


def _nearer(flat: Flat, view: View, pole: complex, size: float, loose: float = 1.0) -> Candidate:
    """Return where a view stands near a place.

    ``loose``: how far its size may change, of as much as its place.
    """
    some = [(line, np.arange(0.0, line.length, DENSE / size)) for line in view.lines]
    ink = np.concatenate([line.start + line.way * along for line, along in some])
    left = np.concatenate([np.full(len(along), 1j * line.way) for line, along in some])
    near, share = (pole, size), 0.0
    for reach, step in FINER:
        (pole, size), best = near, -np.inf
        moves = np.arange(-reach, reach + 1e-9, step)
        sizes = size * (1 + loose * moves / max(abs(ink).max() * size, reach))
        for rise in moves:  # a row at a time: memory
            at = pole + moves[:, None, None] + 1j * rise + sizes[:, None] * ink
            pencil = np.maximum(flat.pencil(at + LINE * left), flat.pencil(at - LINE * left))
            drawn = pencil.mean(axis=2)
            # a smaller plan lies on the same pencil, but on less of it
            worth = sizes * (drawn - MISSED * (1 - drawn))
            if reach < FINER[0][0]:  # in the middle of the lines
                dark = np.minimum(flat.darkness(at) / (STRONG * flat.level), 1.0).mean(axis=2)
                worth = dark - MISSED * (1 - drawn)
            k, n = divmod(int(np.argmax(worth)), len(sizes))
            if worth[k, n] > best:
                best, share = float(worth[k, n]), float(drawn[k, n])
                near = complex(pole + moves[k] + 1j * rise), float(sizes[n])
    return Candidate(*near, share)


def _clear(flat: Flat, view: View, some: Candidates) -> Candidate | None:
    """Return the best of some places, if enough of it is drawn, and it is clearly better than all elsewhere."""
    tried: list[Candidate] = []
    for k in np.argsort(-some.shares, kind="stable"):
        pole = complex(some.poles[k])
        if len(tried) < TRIED and all(abs(pole - one.pole) > ELSEWHERE / 2 for one in tried):
            tried.append(_nearer(flat, view, pole, float(some.sizes[k])))
    best = max(tried, key=lambda one: one.share, default=None)
    if best is None or best.share < DRAWN:
        return None
    elsewhere = [one.share for one in tried if abs(one.pole - best.pole) > ELSEWHERE]
    return best if best.share - max(elsewhere, default=0.0) > CLEARER else None


def _apart(found: Sequence[Proposal]) -> tuple[Proposal, ...]:
    """Return the proposals of which no better one has its pole in the same place."""
    kept: list[Proposal] = []
    for one in sorted(found, key=lambda one: -one.share):
        if all(abs(one.plan.pole - other.plan.pole) > ELSEWHERE for other in kept):
            kept.append(one)
    return tuple(one for one in found if one in kept)
