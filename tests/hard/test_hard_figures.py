"""No figure of a table is plausible and wrong: rows of random mechanisms, one position near to where they lock.

Each figure is right to its last digits, or it is not there and a finding names it; what stands beside it in the
row changes nothing; far from a change point nothing is missing.
"""

from __future__ import annotations

import csv
import io
import math
import re
from collections import Counter
from collections.abc import Callable
from pathlib import Path

import pytest
from support.command import invoke
from support.figures_judge import OFFS, Told, dead_centre, drawn_at, figures, rows
from support.gallery import CASES
from support.hard_mechanisms import weighed
from support.mechanisms import sample
from support.scenes import written

from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError


def named(made: Drawn, told: Told) -> bool:
    """Whether a finding names the plan and the position of a figure that is left out."""
    plan = told.key[0]
    return any(
        told.place in finding.positions
        and (
            finding.step.it.view == plan
            or (plan == "forces" and finding.step.it.view in FORCES_PLAN.on(made).views)
        )
        for finding in made.findings()
        if finding.kind in ("lost", "undrawn")
    )


def _all_right(count: int, seed: int, most: int) -> Counter[str]:
    """Judge rows of random mechanisms; count figures, and those left out, far from a lock and near to one."""
    counts: Counter[str] = Counter()
    for loaded, angles in rows(sample(count, seed=seed, dyads=(1, most))):
        made, found = figures(loaded, angles)
        for told in found:
            # the first position is where the mechanism was drawn, far from any change point
            where = "far" if told.place == 0 else "near"
            counts[where] += 1
            if told.value is None:
                counts[f"{where} left out"] += 1
                assert named(made, told), (angles, told)
            else:
                assert told.right, (angles, told, told.off, told.unit)
    return counts


@pytest.mark.slow
def test_figures_of_random_rows_are_right_or_left_out_and_named(
    many: Callable[[int, int], int],
) -> None:
    count = many(300, len(OFFS))
    counts = _all_right(count, 5000, 3)
    assert counts["far"] > 17 * count
    assert counts["far left out"] == 0
    assert 0 < counts["near left out"] < counts["near"] / 10


@pytest.mark.slow
def test_figures_beside_a_dead_centre_are_right_and_all_there() -> None:
    """A speed that is all but zero is itself; at the dead centre, along with what follows, it is zero."""
    noughts = 0
    for seed in range(13):
        mechanism, angle = dead_centre(seed)
        _, found = figures(weighed(mechanism), [angle, (angle + 50.0) % 360.0])
        assert all(told.value is not None and told.right for told in found), (seed, angle)
        noughts += sum(told.value == 0.0 for told in found)
    assert noughts


@pytest.mark.slow
def test_a_row_gives_what_its_positions_give_alone() -> None:
    """To the digits that both have; where a digit is hardly sure, one of them may leave the figure out."""
    figures_, flips = 0, 0
    for loaded, angles in rows(sample(13, seed=6000, dyads=(1, 2))):
        _, together = drawn_at(loaded, angles)
        for place, angle in enumerate(angles):
            try:
                _, alone = drawn_at(loaded, [angle])
            except StructureError:
                # none of its positions can be drawn
                assert all(row.first_figures[1][place] is None for row in together)
                continue
            for row, one in zip(together, alone, strict=True):
                assert (row.plan, row.segment) == (one.plan, one.segment)
                value, due = row.first_figures[1][place], one.first_figures[1][0]
                figures_ += 1
                if value is None or due is None:
                    flips += (value is None) != (due is None)
                    continue
                step = max(_unit(row, place, value, due), _unit(one, 0, due, value))
                assert abs(value - due) <= 2.0 * step, (angles, row.segment, value, due)
    assert figures_ > 400
    assert flips <= figures_ / 100


def _unit(row: object, place: int, value: float, size: float) -> float:
    told = Told(("", ""), place, value, 0, size)
    return max(told.unit if value else 0.0, 1e-11 * max(abs(value), abs(size)))


# the cases found from outside


def _tables(
    path: Path, *options: str, of: tuple[str, ...]
) -> list[dict[tuple[str, str, str], str]]:
    result = invoke("table", path, "-f", "csv", *options)
    assert result.exit_code == 0, result.stderr
    lines = list(csv.DictReader(io.StringIO(result.stdout)))
    keys = [(row["plan"], row["position"], row["segment"]) for row in lines]
    return [{key: row[one] for key, row in zip(keys, lines, strict=True)} for one in of]


def _table(path: Path, *options: str) -> dict[tuple[str, str, str], str]:
    return _tables(path, *options, of=("value",))[0]


@pytest.mark.slow
def test_a_position_that_locks_takes_nothing_from_the_others(tmp_path: Path) -> None:
    """Rod half as long as the crank: the forces in line are found by hand, R12 with its weight's half.

    Along the line F3 and the inertia forces: -50 + 60 + 20 N and, on the way back, -50 + 20 N. In a polygon
    drawn by hand each of its six sides is laid off, or read, to half a division of the ruler.
    """
    due = {"G2": 9.81, "G3": 19.62, "F3": 50.0, "R12": math.hypot(30.0, 4.905), "R03": 24.525}
    text = (CASES / "tables" / "row12-lock.toml").read_text("utf-8")
    path = written(tmp_path, re.sub("place = .*", 'place = ["velocities", "forces"]', text))
    exact = _table(path, "--exact")
    found, lengths = _tables(path, of=("value", "mm"))
    for position in ("1", "7"):
        for segment, value in due.items():
            key = ("forces", position, segment)
            assert float(exact[key]) == pytest.approx(value, rel=1e-11)
            mu = float(found[key]) / float(lengths[key]) if lengths[key] else 0.0
            assert float(found[key]) == pytest.approx(value, rel=1e-9, abs=6 * 0.05 * mu)
    # where it locks the crank still turns and weights still weigh; nothing else is known
    assert float(found["velocities", "2", "omega1"]) == 10.0
    assert float(found["forces", "2", "G2"]) == 9.81
    assert ("velocities", "2", "pb") not in found
    assert ("forces", "2", "R12") not in found


def test_forces_of_no_sure_digit_are_left_out_and_named() -> None:
    path = CASES / "tables" / "equal-rods-89.999.toml"
    result = invoke("table", path, "--exact", "-f", "csv")
    found = _table(path, "--exact")
    for segment in ("R12", "R03", "R23", "R01", "M_bal_forces", "M_bal_lever", "Pi2"):
        assert ("forces", "89.999°", segment) not in found
        assert (
            segment.replace("R", "R_").replace("Pi2", "P_i2")[:4] in result.stderr
            or "M_b" in segment
        )
    assert float(found["forces", "89.999°", "G2"]) == 9.81
    assert float(found["velocities", "89.999°", "pb"]) == pytest.approx(2.0, rel=1e-3)
    assert float(found["forces", "1", "R03"]) == pytest.approx(0.475, rel=1e-9)


@pytest.mark.slow
def test_the_check_calls_right_readings_beside_a_lock_fine() -> None:
    paths = [str(CASES / "tables" / "row12-lock.toml"), str(CASES / "tables" / "row12-good.csv")]
    result = invoke("check", *paths, "--trials", "40")
    assert result.exit_code == 0, result.output
    assert "Fine 3, doubtful 0, wrong 0" in result.stdout
