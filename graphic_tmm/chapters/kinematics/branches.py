"""Which place a plate keeps, or two joined ones: all of them at one coordinate of the drive, one followed.

Between two places of a plate that meet it is not held: the sign of how it is held tells one from the other.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable

import numpy as np

from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.tracing import is_laid
from graphic_tmm.board.values import Complexes, Line, Reals
from graphic_tmm.chapters.kinematics.sides import standing
from graphic_tmm.chapters.kinematics.tracings import Branch, Loci, Tracing
from graphic_tmm.chapters.kinematics.wheels import Wheels
from graphic_tmm.errors import DrawnRemedy, StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Near, Sweep

STARTS = 60, 240
"""So many directions of the first leg, and of the plate, are tried for places; then so many, if their number
is odd: places come and go in twos."""
TRIES = 40
"""Corrections of a place that is sought from afar."""
STEPS = 180
"""So many steps are made along the drive, each halved where the plate turns fast."""
TURNED = 0.05
"""A step by which the plate or its first leg turns by more than this, rad, is halved."""
LEAST = 1e-11
"""A step that is less than this share of the drive's way ends a branch: two places meet there."""
MEANT = 30.0
"""So far from what a scene says, in degrees, a place may be that it means, if others are twice as far."""
LISTED = 8
"""At so many coordinates places are counted, to list them where there are most, or it is seen what holds."""
ALIKE = 1e-6
"""Two places that differ by less, rad, are one."""
LOOSE = 1e-9
"""What is held by less than this share of its size, squared, is not held: rounding leaves some."""


class Search:
    """The places of what is laid at coordinates of the drive; ``loci``: what stands there at a row of these."""

    def __init__(
        self,
        tracing: Tracing,
        loci: Callable[[Reals], Loci],
        sweep: Sweep,
    ) -> None:
        self.tracing, self.loci, self.sweep = tracing, loci, sweep

    def places(self, at: float) -> list[Line]:
        """Return all places at a coordinate, by the direction of the plate."""
        loci, found = self.loci(np.array([at])), list[Line]()
        for starts in STARTS:
            ways = np.exp(2j * np.pi * np.arange(starts) / starts)
            legs, plates = (one.reshape(1, -1) for one in np.meshgrid(ways, ways))
            lies = self._laid(loci, Line(legs, plates), TRIES)
            there = self._there(loci, lies)[0]
            found = _apart(zip(lies.at[0, there], lies.along[0, there], strict=True))
            if len(found) % 2 == 0:
                break
        return sorted(found, key=lambda one: float(np.angle(one.along)[0, 0]))

    def loose(self) -> bool:
        """Return whether nothing holds what is laid at a few coordinates of the drive, however it lies."""
        ways = np.exp(2j * np.pi * np.arange(STARTS[0]) / STARTS[0])
        lies = Line(*(one.reshape(-1, 1) for one in np.meshgrid(ways, ways)))
        with np.errstate(all="ignore"):
            laid = self.tracing.laid(self.loci(np.array(_few(self.sweep))), lies)
            holds = np.abs(laid.held) > LOOSE * laid.size * laid.size
        # what it is laid on need not stand everywhere
        return not (holds.any() or np.isnan(laid.size).all())

    def follow(self, start: Line, at: float) -> Branch:
        """Return a place followed from a coordinate all over the sweep, or to where it meets another."""
        sweep = self.sweep
        way = sweep.high - sweep.low
        ends = (at - way, at + way) if sweep.closed else (sweep.low, sweep.high)
        ahead = self._run(start, at, ends[1])
        last = ahead[-1]
        whole = sweep.closed and last[0] >= ends[1]
        if whole:
            gone = abs(last[1].along - start.along) + abs(last[1].at - start.at)
            if float(gone[0, 0]) > ALIKE:
                raise self._elsewhere()
            nodes = ahead
        else:
            nodes = [*reversed(self._run(start, at, ends[0])[1:]), *ahead]
            if sweep.closed and last[0] - nodes[0][0] >= way:
                raise self._elsewhere()
            whole = not sweep.closed and nodes[0][0] <= ends[0] and last[0] >= ends[1]
        row = np.array([node[0] for node in nodes])
        lies = Line(*(np.concatenate([node[1][k] for node in nodes], axis=1) for k in (0, 1)))
        row, lies = self._denser(*self._denser(row, lies))
        leg, plate = (np.degrees(np.unwrap(np.angle(one[0]))) for one in lies)
        return Branch(row, leg, plate, sweep, whole, self.tracing.crossing(self.loci(row), lies))

    def _elsewhere(self) -> StructureError:
        return StructureError(
            said(
                "link {plate} is at another of its places after a turn of the drive: this board draws what "
                "comes back after one turn",
                plate=self.tracing.link.number,
            ),
            f"link {self.tracing.link.number}",
        )

    def _run(self, start: Line, at: float, end: float) -> list[tuple[float, Line]]:
        """Return coordinates and places from one coordinate to another, as far as the place goes on."""
        sense, full = math.copysign(1.0, end - at), abs(end - at) / STEPS
        sign = self._sign(self.loci(np.array([at])), start)
        nodes, step = [(at, start)], full
        least = LEAST * (self.sweep.high - self.sweep.low)
        while (end - nodes[-1][0]) * sense > least:
            here = nodes[-1][0]
            there = end if step + least >= abs(end - here) else here + sense * step
            reached = self._step(nodes, there, sign)
            if reached is None:
                step /= 2.0
                if step < least:
                    break
                continue
            nodes.append((there, reached))
            step = min(2.0 * step, full)
        return nodes

    def _step(self, nodes: list[tuple[float, Line]], there: float, sign: float) -> Line | None:
        """Return the place at the next coordinate; None if it is not there, or turned too far."""
        (here, lies), loci = nodes[-1], self.loci(np.array([there]))
        guess = lies
        if len(nodes) > 1:
            before, lay = nodes[-2]
            share = (there - here) / (here - before)
            guess = Line(*(_onward(a, b, share) for a, b in zip(lay, lies, strict=True)))
        found = self._laid(loci, guess, 8)
        turned = max(float(np.abs(a - b)[0, 0]) for a, b in zip(found, lies, strict=True))
        there_it_is = bool(self._there(loci, found)[0, 0]) and turned <= TURNED
        return found if there_it_is and self._sign(loci, found) == sign else None

    def _denser(self, row: Reals, lies: Line) -> tuple[Reals, Line]:
        """Return coordinates and places with one more between any two."""
        if row.size < 2:
            return row, lies
        middle = (row[:-1] + row[1:]) / 2.0
        guess = Line(*(one[:, :-1] + one[:, 1:] for one in lies))
        guess = Line(*(one / np.abs(one) for one in guess))
        loci = self.loci(middle)
        found = self._laid(loci, guess, 8)
        near = sum(np.abs(a - b) for a, b in zip(found, guess, strict=True)) < TURNED
        good = np.flatnonzero((self._there(loci, found) & near)[0])
        order = np.argsort(np.concatenate([row, middle[good]]), kind="stable")
        parts = (
            np.concatenate([a, b[:, good]], axis=1)[:, order]
            for a, b in zip(lies, found, strict=True)
        )
        return np.concatenate([row, middle[good]])[order], Line(*parts)

    def _laid(self, loci: Loci, lies: Line, times: int) -> Line:
        with np.errstate(all="ignore"):
            for _ in range(times):
                lies = self.tracing.corrected(loci, lies)
        return lies

    def _there(self, loci: Loci, lies: Line) -> np.ndarray:
        with np.errstate(all="ignore"):
            return np.asarray(is_laid(self.tracing.laid(loci, lies)))

    def _sign(self, loci: Loci, lies: Line) -> float:
        return float(np.sign(self.tracing.laid(loci, lies).held)[0, 0])


def _onward(before: Complexes, now: Complexes, share: float) -> Complexes:
    """Return a direction turned on by a share of what it turned by last."""
    turned = np.angle(now / before) * share
    return np.asarray(now * np.exp(1j * turned))


def _apart(found: Iterable[tuple[complex, complex]]) -> list[Line]:
    """Return places, each but once."""
    kept = list[Line]()
    for leg, plate in found:
        if all(abs(one.at[0, 0] - leg) + abs(one.along[0, 0] - plate) > ALIKE for one in kept):
            kept.append(Line(np.array([[leg]]), np.array([[plate]])))
    return kept


def branch_of(search: Search) -> Branch:
    """Return the place that a scene means, followed.

    Raises
    ------
    StructureError
        If it does not say which of the places, or none is near what it says, or the plate can be laid nowhere.
    """
    tracing = search.tracing
    near, link, name = tracing.link.near, tracing.link.number, tracing.group.name
    at, places = _begun(search, near)
    if not places:
        if slides := _loose_slides(search):
            raise StructureError(
                said(
                    "group {name}: along {listed} link {plate} is free to move, or fits nowhere, wherever the "
                    "drive stands: turn one of these to another direction, or move one of its pins",
                    name=name,
                    listed=", ".join(slides),
                    plate=link,
                ),
                f"link {link}",
            )
        raise StructureError(
            said(
                "group {name} cannot be assembled wherever the drive was tried, link {plate} is not reached: "
                "change lengths",
                name=name,
                plate=link,
            )
            if near is None or near.at is None
            else said(
                "group {name} cannot be assembled at {at}: give another coordinate of the drive as near_at",
                name=name,
                at=f'"{coordinate_text(search.sweep, at)}"',
            ),
            f"link {link}, near",
        )
    if near is None:
        raise _several(search, *_most_places(search))
    own = (_own_axis(tracing, one) for one in places)
    apart = [abs((one - near.angle + 180.0) % 360.0 - 180.0) for one in own]
    order = sorted(range(len(places)), key=apart.__getitem__)
    if apart[order[0]] > MEANT or (len(order) > 1 and apart[order[1]] < 2 * apart[order[0]]):
        raise _several(search, at, places)
    return search.follow(places[order[0]], at)


def _few(sweep: Sweep) -> list[float]:
    """Return a few even coordinates of the drive."""
    return [sweep.low + (sweep.high - sweep.low) * k / LISTED for k in range(LISTED)]


def _loose_slides(search: Search) -> list[str]:
    """Return the names of a group's guides if they hold its plate nowhere; none if they do.

    So it is with three that are parallel, and where what is square to all three always meets in one point.
    """
    group = search.tracing.group
    pairs = (*(leg.pair for leg in group.legs), *group.inner_pairs)
    slides = [pair.name for pair in pairs if pair.kind == "P"]
    return slides if slides and search.loose() else []


def _most_places(search: Search) -> tuple[float, list[Line]]:
    """Return the one of a few coordinates of the drive at which there are most places, and these."""
    row = _few(search.sweep)
    tried = [_begun(search, None), *((at, search.places(at)) for at in row)]
    return max(tried, key=lambda one: len(one[1]))


def _several(search: Search, at: float, places: list[Line]) -> StructureError:
    """Return the refusal of a scene that does not say which of several places it means."""
    link, where = search.tracing.link, f'"{coordinate_text(search.sweep, at)}"'
    own = (_own_axis(search.tracing, one) for one in places)
    return StructureError(
        said(
            "group {name} can be assembled in {count} ways at {letter} = {at}: give link {plate} the "
            "direction of its own x axis there, near = one of {listed}, and near_at = {at}",
            name=search.tracing.group.name,
            count=len(places),
            letter=search.sweep.letter,
            at=where,
            plate=link.number,
            listed=", ".join(f'"{one:.6g} deg"' for one in own),
        ),
        f"link {link.number}, near" if link.near else f"link {link.number}",
        pictures=drawn_places(search, at, places),
    )


def coordinate_text(sweep: Sweep, at: float) -> str:
    """Return a coordinate of the drive as a scene writes it."""
    return f"{at:.6g} deg" if sweep.turns else f"{1000.0 * at:.6g} mm"


def _own_axis(tracing: Tracing, place: Line) -> float:
    """Return the direction of a plate's own x axis in a place, degrees from −180 to 180."""
    angle = math.degrees(float(np.angle(place.along)[0, 0])) - tracing.angle
    return (angle + 180.0) % 360.0 - 180.0


def drawn_places(search: Search, at: float, places: Iterable[Line]) -> tuple[DrawnRemedy, ...]:
    """Return places at a coordinate drawn small, each with what a scene writes that means it."""
    loci, tracing = search.loci(np.array([at])), search.tracing
    link, where = f"link {tracing.link.number}", coordinate_text(search.sweep, at)
    return tuple(
        DrawnRemedy(
            tracing.outline(loci, place),
            (
                (f"{link}, near", f"{_own_axis(tracing, place):.6g} deg"),
                (f"{link}, near_at", where),
            ),
        )
        for place in places
    )


def _begun(search: Search, near: Near | None) -> tuple[float, list[Line]]:
    """Return the coordinate at which places are sought, and these: the first of even ones that has any."""
    sweep = search.sweep
    if near is not None and near.at is not None:
        return near.at, search.places(near.at)
    for k in range(24):
        at = sweep.low + (sweep.high - sweep.low) * k / 24
        if places := search.places(at):
            return at, places
    return sweep.low, []


def followed_place(wheels: Wheels, tracing: Tracing) -> Branch:
    """Return the place that a scene means of a plate, followed all over what the first drive goes through."""
    draft = wheels.draft
    log, sweep = draft.board.construction(), wheels.pairs[0].sweep

    def loci(row: Reals) -> Loci:
        at = row[None, :]
        given = draft.given | {draft.mu_l: 1.0, wheels.row[0]: at} | standing(wheels, at)
        reading = execute(log, given, tracing.loci)
        return [reading[mark] for mark in tracing.loci]

    return branch_of(Search(tracing, loci, sweep))
