"""Which place a plate on three legs keeps: all of them at one coordinate of the drive, one followed from there.

Between two places of a plate that meet it is not held: the sign of how it is held tells one from the other.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from itertools import combinations
from typing import Any, NamedTuple

import numpy as np

from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.tracing import (
    OFF,
    arc_normal,
    arc_off,
    held,
    line_off,
    on_arcs,
    on_guide,
    on_guides,
)
from graphic_tmm.board.values import Arc, Complexes, Line, Reals
from graphic_tmm.chapters.kinematics.closings import Branch
from graphic_tmm.chapters.kinematics.plates import Plate
from graphic_tmm.chapters.kinematics.sides import standing
from graphic_tmm.chapters.kinematics.wheels import Wheels
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.groups import PlateGroup
from graphic_tmm.mechanism.records import Near, Sweep

Loci = tuple[Any, Any, Any]
"""The loci of the three pins: an arc, then arcs before guides (`Line`)."""
CORRECTIONS = on_arcs, on_guide, on_guides
"""A correction of how a plate lies, by how many of its pins are on guides."""
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
ALIKE = 1e-6
"""Two places that differ by less, rad, are one."""


class PlateSizes(NamedTuple):
    """Where the second and the third pin of a plate are from the first, along its line and to the left, mm."""

    second: float
    third: complex


class Search:
    """The places of a plate at coordinates of the drive; ``loci``: those of its pins at a row of these."""

    def __init__(
        self,
        group: PlateGroup,
        sizes: PlateSizes,
        loci: Callable[[Reals], Loci],
        sweep: Sweep,
    ) -> None:
        self.group, self.loci, self.sweep = group, loci, sweep
        self.c, self.f = (np.array([[complex(one)]]) for one in sizes)
        guides = sum(leg.pair.kind == "P" for leg in group.legs)
        self.corrected = CORRECTIONS[guides]

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

    def follow(self, start: Line, at: float) -> Branch:
        """Return a place followed_plate from a coordinate all over the sweep, or to where it meets another."""
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
        return Branch(row, leg, plate, sweep, whole, self._crossing(row, lies))

    def _elsewhere(self) -> StructureError:
        return StructureError(
            said(
                "link {plate} is at another of its places after a turn of the drive: this board draws what "
                "comes back after one turn",
                plate=self.group.plate,
            ),
            f"link {self.group.plate}",
        )

    def _run(self, start: Line, at: float, end: float) -> list[tuple[float, Line]]:
        """Return coordinates and places from one coordinate to another, as far as the place goes on."""
        sense, full = math.copysign(1.0, end - at), abs(end - at) / STEPS
        sign = self._sign(self.loci(np.array([at])), start)
        nodes, step = [(at, start)], full
        least = LEAST * (self.sweep.high - self.sweep.low)
        while (end - nodes[-1][0]) * sense > least:
            here = nodes[-1][0]
            there = here + sense * min(step, abs(end - here))
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
                lies = self.corrected(lies, *loci, self.c, self.f)
        return lies

    def _pins(self, loci: Loci, lies: Line) -> tuple[Complexes, Complexes]:
        b = loci[0].centre + loci[0].radius * lies.at
        return b + self.c * lies.along, b + self.f * lies.along

    def _there(self, loci: Loci, lies: Line) -> np.ndarray:
        size = loci[0].radius + abs(self.c) + abs(self.f)
        with np.errstate(all="ignore"):
            pins = zip(self._pins(loci, lies), loci[1:], strict=True)
            off = [np.abs(_off(pin, locus)) for pin, locus in pins]
            return np.asarray((off[0] <= OFF * size) & (off[1] <= OFF * size))

    def _normals(self, loci: Loci, lies: Line) -> tuple[Complexes, Complexes, Complexes]:
        second, third = (
            arc_normal(pin, locus) if isinstance(locus, Arc) else locus.along * 1j
            for pin, locus in zip(self._pins(loci, lies), loci[1:], strict=True)
        )
        return lies.at, second, third

    def _sign(self, loci: Loci, lies: Line) -> float:
        normals = self._normals(loci, lies)
        return float(np.sign(held(lies, self.c, self.f, normals[1], normals[2]))[0, 0])

    def _crossing(self, row: Reals, lies: Line) -> tuple[int, int]:
        """Return the two legs of which the lines, or what is square to the guides, cross most squarely."""
        normals = self._normals(self.loci(row), lies)
        least = {
            (a, b): float(np.abs((np.conj(normals[a]) * normals[b]).imag).min())
            for a, b in combinations(range(3), 2)
        }
        return max(least, key=lambda two: round(least[two], 9))


def _off(point: Complexes, locus: Arc | Line) -> Reals:
    return arc_off(point, locus) if isinstance(locus, Arc) else line_off(point, locus)


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


def branch_of(search: Search, angle: float, near: Near | None, link: int) -> Branch:
    """Return the place that a scene means, followed; ``angle``: of the plate's line in its own axes, degrees.

    Raises
    ------
    StructureError
        If it does not say which of the places, or none is near what it says, or the plate can be laid nowhere.
    """
    at, places = _begun(search, near)
    own = [(math.degrees(float(np.angle(one.along)[0, 0])) - angle) for one in places]
    own = [(one + 180.0) % 360.0 - 180.0 for one in own]
    listed = ", ".join(f'"{one:.6g} deg"' for one in own)
    unit = "deg" if search.sweep.turns else "mm"
    where = f'"{at if search.sweep.turns else 1000.0 * at:.6g} {unit}"'
    if not places:
        raise StructureError(
            said(
                "group {name}: its three legs cannot reach link {plate} wherever the drive was tried: change "
                "lengths",
                name=search.group.name,
                plate=link,
            )
            if near is None or near.at is None
            else said(
                "group {name} cannot be assembled at {at}: give another coordinate of the drive as near_at",
                name=search.group.name,
                at=where,
            ),
            f"link {link}, near",
        )
    apart = [abs((one - (near.angle if near else 0.0) + 180.0) % 360.0 - 180.0) for one in own]
    order = sorted(range(len(own)), key=apart.__getitem__)
    if (
        near is None
        or apart[order[0]] > MEANT
        or (len(own) > 1 and apart[order[1]] < 2 * apart[order[0]])
    ):
        raise StructureError(
            said(
                "group {name} can be assembled in {count} ways at {letter} = {at}: give link {plate} the "
                "direction of its own x axis there, near = one of {listed}, and near_at = {at}",
                name=search.group.name,
                count=len(own),
                letter=search.sweep.letter,
                at=where,
                plate=link,
                listed=listed,
            ),
            f"link {link}, near" if near else f"link {link}",
        )
    return search.follow(places[order[0]], at)


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


def followed_plate(wheels: Wheels, group: PlateGroup, plate: Plate) -> Branch:
    """Return the place that a scene means of a plate, followed all over what the first drive goes through."""
    draft, near = wheels.draft, plate.link.near
    log, sweep = draft.board.construction(), wheels.pairs[0].sweep

    def loci(row: Reals) -> Loci:
        at = row[None, :]
        given = draft.given | {draft.mu_l: 1.0, wheels.row[0]: at} | standing(wheels, at)
        reading = execute(log, given, plate.loci)
        first, second, third = (reading[mark] for mark in plate.loci)
        return first, second, third

    search = Search(group, PlateSizes(plate.second, plate.third), loci, sweep)
    return branch_of(search, plate.angle, near, group.plate)
