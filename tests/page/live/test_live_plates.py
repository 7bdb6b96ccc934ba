"""Plates on three legs whose lengths are changed on a page: they keep their place, or are nowhere."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from support.plates import machine

from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.branches import Search
from graphic_tmm.chapters.kinematics.closings import PlateClosing
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.sides import standing
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.chapters.kinematics.tracings import PlateTracing
from graphic_tmm.project import record
from graphic_tmm.scene.read import read

ROW = np.arange(0.0, 360.0, 2.0)[None]
ALIKE = 1e-2


class Turn(NamedTuple):
    """How a plate stands over a turn, as its line's direction: by what the page is given, and followed anew."""

    live: np.ndarray
    due: np.ndarray


def tried(seed: int, folder: Path) -> Survey:
    path = folder / "scene.toml"
    path.write_text(machine(seed).text, "utf-8")
    return KINEMATICS_PLAN.on(record(read(path), wanted={"positions"})).tried


def turn(made: Survey, changed: dict[Mark, object]) -> Turn:
    closing = next(one for one in made.positions.closings if isinstance(one, PlateClosing))
    given, log = {**made.given, **changed}, made.construction
    row = {made.positions.row[0]: ROW}
    reading = execute(log, given | row | standing(made, ROW), closing.points[:2])
    b, c = (reading[pin] for pin in closing.points[:2])
    step = log.step(closing.root)
    assert step is not None
    loci, sizes = step.uses[:3], step.uses[3:6]

    def at(coordinates: np.ndarray) -> tuple[object, ...]:
        found = execute(log, given | {made.positions.row[0]: coordinates[None]}, loci)
        return tuple(found[mark] for mark in loci)

    read_off = execute(log, given | row, sizes)
    apart, x, y = (float(np.ravel(read_off[mark])[0]) for mark in sizes)
    plate = made.mechanism.by_number[closing.plate]
    tracing = PlateTracing(closing.group, plate, tuple(loci), 0.0, (apart, complex(x, y)))
    search = Search(tracing, at, closing.branch.sweep)  # type: ignore[arg-type]
    middle = closing.branch.at.size // 2
    begun = float(closing.branch.at[middle])
    leg, plate = (
        np.exp(1j * np.radians(row[middle])) for row in (closing.branch.leg, closing.branch.plate)
    )
    places = search.places(begun)
    if not places:
        return Turn(np.full(ROW.size, np.nan), np.full(ROW.size, np.nan))
    start = min(places, key=lambda one: abs(one.along[0, 0] - plate) + abs(one.at[0, 0] - leg))
    _, angles = search.follow(start, begun).near(ROW)
    with np.errstate(invalid="ignore"):
        return Turn((c - b)[0] / abs(c - b)[0], np.exp(1j * np.radians(angles))[0])


def lengths(made: Survey) -> Iterator[Mark]:
    return (mark for mark in made.given if mark.unit == "m" and mark.name.startswith("l_"))


@pytest.mark.parametrize("seed", [3, 10])
@pytest.mark.parametrize(("share", "lost"), [(0.05, 0.01), (0.2, 0.6)])
def test_a_changed_length_leads_to_no_other_place(
    seed: int, share: float, lost: float, tmp_path: Path
) -> None:
    """Measured on six machines: 0.2 % of the places that are there are not found at 5 %, 8 % at 20 %.

    With corrections up to 18°, whatever way it is held, 4 % and 21 % were not found; 20 of 9927 were others.
    """
    made = tried(seed, tmp_path)
    there = gone = 0
    for mark in lengths(made):
        for times in (1.0 - share, 1.0 + share):
            found = turn(made, {mark: float(np.ravel(made.given[mark])[0]) * times})
            known = np.isfinite(found.due)
            drawn = known & np.isfinite(found.live)
            assert np.abs(found.live[drawn] - found.due[drawn]).max(initial=0.0) < ALIKE, (
                mark,
                times,
            )
            there, gone = there + int(known.sum()), gone + int((known & ~drawn).sum())
    assert there > 500
    assert gone <= lost * there
