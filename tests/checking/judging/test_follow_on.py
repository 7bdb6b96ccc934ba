"""What a student finds rightly from what was read or calculated wrongly is not punished, and says from what."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from support.another_hand import MACHINES, Pencil, Rows, Sheet, csv_of, rows_of
from support.gallery import CASES
from support.verdicts import Verdicts, verdicts

from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import FINE, WRONG, Taken
from graphic_tmm.scene.read import read

TOO_LONG = 15.0
"""One length of a drawing is read so many mm too long."""
A = "accelerations"


class Misreading(Pencil):
    """Reads one length, the ``bad``-th of a drawing, too long."""

    bad = 0
    count = 0

    def read(self, way: complex) -> float:
        self.count += 1
        return super().read(way) + (TOO_LONG if self.count == self.bad else 0.0)


class HalfCoriolis(Pencil):
    """Forgets the 2 of Coriolis."""

    def ray(self, name: str, along: complex) -> complex:
        return super().ray(name, along) * (0.5 if name == "ak2" else 1.0)


def reports(name: str, drawn: list[Rows], folder: Path) -> Iterator[Verdicts]:
    def files() -> Iterator[tuple[str, tuple[Taken, ...]]]:
        path = folder / "readings.csv"
        for k, rows in enumerate(drawn):
            path.write_text(csv_of(rows), "utf-8")
            yield str(k), read_readings(path)

    return verdicts(read(CASES / "check" / f"{name}.toml"), files(), trials=150)


def drawings(name: str, place: int) -> Iterator[tuple[str, dict[int, Sheet]]]:
    """Yield drawings of one position, each with one length misread, and which."""
    machine = MACHINES[name]
    bad = count = 0
    while bad <= count:
        both = []
        for misread in (0, bad + 1):
            pen = Misreading(np.random.default_rng(bad), 0.5)
            pen.bad = misread
            both.append(machine.draw(pen, place * np.pi / 4.0, True, 1))
            count = pen.count
        moved = {
            at: abs(both[1].lengths[at] - both[0].lengths[at]) / TOO_LONG for at in both[0].lengths
        }
        bad += 1
        first = next((at[1] for at, much in moved.items() if abs(much - 1.0) < 1e-6), None)
        if first is not None:
            yield first, {place: both[1]}


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", MACHINES)
@pytest.mark.parametrize("mode", ["mm", "quantities"])
def test_only_the_length_that_was_misread_is_wrong(name: str, mode: str, tmp_path: Path) -> None:
    """Rates, normals and Coriolis components found from it are right, and so is what is drawn with them."""
    found = list(drawings(name, 1))
    assert len(found) >= 6
    pen = Pencil(np.random.default_rng(0), 0.5)
    rows = [rows_of(name, pen, sheets, mode) for _, sheets in found]
    followed = 0
    for (segment, _), report in zip(found, reports(name, rows, tmp_path), strict=True):
        wrong = {one.taken.segment for one in report.readings if one.verdict == WRONG}
        assert wrong == {segment}
        rates = [one for one in report.readings if one.taken.segment.startswith(("omega", "eps"))]
        assert all(one.verdict == FINE for one in rates)
        followed += sum(one.follows is not None for one in rates)
        assert all(one.follows.segment != "pa" for one in report.readings if one.follows)
    assert followed >= 2


@pytest.mark.slow
@pytest.mark.parametrize("name", ["rpr", "six"])
def test_what_follows_from_a_wrong_coriolis_component_says_so(name: str, tmp_path: Path) -> None:
    drawn = []
    places = MACHINES[name].accelerated[:2]
    for place in places:
        pen = HalfCoriolis(np.random.default_rng(place), 0.5)
        sheet = MACHINES[name].draw(pen, place * np.pi / 4.0, True, 1)
        sheet.lengths[A, "ak2"] *= 0.5
        drawn.append(rows_of(name, pen, {place: sheet}, "mm"))
    for report in reports(name, drawn, tmp_path):
        verdicts = {one.taken.segment: one.verdict for one in report.readings}
        assert verdicts["ak2"] == WRONG
        assert WRONG not in (verdicts["epsilon3"], verdicts["k2a3"], verdicts["n3a3"])
        from_it = {
            one.taken.segment
            for one in report.readings
            if one.follows is not None and one.follows.segment == "ak2"
        }
        assert from_it & {"k2a3", "n3a3"}
