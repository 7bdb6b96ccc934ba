"""Photographs of students' own sheets (`tests/support/own_sheets.py`): clicked plans, read as drawn, judged.

    python tests/benchmarks/own_sheets.py --first 0 --count 48

Every plan is clicked at its pole, the first of each kind at the end of its first vector, too (``--both``: all
of them), a standard deviation of 0.3 mm off. The paper's edges are looked for; ``--corners``: they are clicked,
1.5 dots off. Counted are points that stand by themselves, no other one within 3 mm: read, if they are given as
seen; right, if they are then within a millimetre of where they were drawn, from the pole, in the student's own
mm. A point is wrongly drawn if the mistake moves it by more than 2 mm.

Before that plans are proposed without any click: right, if p is within 2 mm and a within 3; plans of which all
points are within 3 mm of one line cannot be.
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path
from typing import NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.own_sheets import KINDS, WRONGLY, Sheet, own_sheet

from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.own_sheet.clicked import ClickedPlan
from graphic_tmm.checking.pencil.points import SEEN
from graphic_tmm.checking.photo.picture import Sent
from graphic_tmm.checking.photographed import judged, photographed, proposed
from graphic_tmm.checking.pictures import Laid, laid
from graphic_tmm.checking.report.findings import headline
from graphic_tmm.errors import SheetError
from graphic_tmm.scene.read import read

CASES = Path(__file__).parents[1] / "cases" / "check"
NEAR = 1.0


class Outcome(NamedTuple):
    """Of a sheet: plans read and clicked; errors of points read, of how many; of wrongly drawn ones the same.

    ``mu``: how far the student's own are off, as a share; ``status``: 0, 1 or 3; ``edges``: how far the paper's
    corners are off, dots; ``proposed``: without clicks, rightly, of how many, falsely.
    """

    plans: tuple[int, int]
    errors: tuple[float, ...]
    points: int
    wrong: tuple[int, int]
    mu: tuple[float, ...]
    status: int
    says: str
    seconds: float
    edges: float = 0.0
    proposed: tuple[int, int, int] = (0, 0, 0)


def shaped(sheet: Sheet, at: tuple[str, str]) -> bool:
    """Whether the points of a plan do not lie on one line."""
    spots = np.array([0, *(t.spot for k, t in sheet.points.items() if (k[0], k[2]) == at)])
    off = spots - spots.mean()
    return float(np.linalg.svd(np.stack([off.real, off.imag]), compute_uv=False)[-1]) > 3.0


def proposals_of(sheet: Sheet, shown: Laid) -> tuple[int, int, int]:
    """Return how many plans are proposed rightly, how many could be, how many are proposed falsely."""
    dots = abs(sheet.edges[1] - sheet.edges[0]) / sheet.size[0]
    plans = proposed(shown, "student", "en").plans
    right = 0
    for one in plans:
        pole, first = sheet.plans.get((one.plan, one.position), (np.inf, np.inf))
        assert one.first is not None
        right += abs(one.pole - pole) < 2.0 * dots and abs(one.first - first) < 3.0 * dots
    return right, sum(shaped(sheet, at) for at in sheet.plans), len(plans) - right


def clicks(sheet: Sheet, both: bool, rng: np.random.Generator) -> list[ClickedPlan]:
    """Return every plan as it is clicked: dots."""
    dots = abs(sheet.edges[1] - sheet.edges[0]) / sheet.size[0]
    seen: set[str] = set()
    found = []
    for (plan, position), (pole, first) in sheet.plans.items():
        off = 0.3 * dots * rng.standard_normal(4)
        end = first + complex(*off[2:]) if both or plan not in seen else None
        seen.add(plan)
        found.append(ClickedPlan(plan, position, pole + complex(*off[:2]), end))
    return found


def outcome(sheet: Sheet, seed: int, *, both: bool, corners: bool) -> Outcome:
    """Return what is read and said of a sheet."""
    rng = np.random.default_rng(seed)
    scene = read(CASES / f"{sheet.kind.machine}.toml")
    begun = time.process_time()
    given = ""
    if corners:
        at = sheet.edges + 1.5 * (rng.standard_normal(4) + 1j * rng.standard_normal(4))
        given = " ".join(f"{z.real:.1f},{z.imag:.1f}" for z in at)
    clicked = clicks(sheet, both, rng)
    shown = laid(scene, Sent("own.jpg", sheet.jpeg), given, paper=sheet.kind.size)
    edges = float(abs(shown.flat.corners - sheet.edges).max())
    seen = photographed(shown, {}, "student", clicked)
    assert seen is not None
    report = judged(scene, seen, hand="student", trials=400, limits=Limits(), source="own.jpg")
    seconds = time.process_time() - begun
    without = proposals_of(sheet, shown)
    errors, total, wrongly, right = [], 0, 0, 0
    by = {one.name: one for one in seen.found.points}
    for key, truth in sheet.points.items():
        if not truth.plain:
            continue
        total += 1
        wrongly += truth.off > WRONGLY
        one = by.get(key)
        if one is not None and one.how == SEEN:
            errors.append(abs(one.spot - truth.spot))
            right += truth.off > WRONGLY and errors[-1] < NEAR
    assert seen.sight is not None
    mine = {one.plan: one.mu for one in seen.scales}
    mu = tuple(abs(mine[plan] / due - 1) for plan, due in sheet.mu.items() if plan in mine)
    missing = len(seen.found.missing)
    status = 1 if report.wrong else 0 if seen.sight.whole else 3
    plans = len(clicked) - missing, len(clicked)
    says = headline(report)
    return Outcome(
        plans, tuple(errors), total, (right, wrongly), mu, status, says, seconds, edges, without
    )


def main() -> None:
    """Print a row a sheet, and the sums."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=len(KINDS))
    parser.add_argument("--both", action="store_true")
    parser.add_argument("--corners", action="store_true")
    given = parser.parse_args()
    several: list[tuple[int, Outcome]] = []
    for number in range(given.first, given.first + given.count):
        kind = KINDS[number % len(KINDS)]
        sheet = own_sheet(kind, number)
        try:
            one = outcome(sheet, number, both=given.both, corners=given.corners)
        except SheetError as error:
            print(f"{number} {kind.machine} {kind.size}: {error}")
            one = Outcome((0, len(sheet.plans)), (), 0, (0, 0), (), 2, "", 0.0)
        several.append((number, one))
        far = sum(error > NEAR for error in one.errors)
        told = f"{kind.machine} {kind.size} {kind.frame}: {kind.wrong or 'right'}"
        print(
            f"{number} {told}: plans {one.plans}, points {len(one.errors)} of {one.points}, {far} far, "
            f"wrong {one.wrong[0]} of {one.wrong[1]}, mu {[f'{100 * m:.1f} %' for m in one.mu]}, "
            f"status {one.status}, "
            f"proposed {one.proposed}, {one.seconds:.1f} s, edges {one.edges:.1f}: {one.says[:150]}",
            flush=True,
        )
    print(table(several))


def table(several: list[tuple[int, Outcome]]) -> str:
    """Return the sums."""
    rows = [one for _, one in several]
    errors = np.array([error for one in rows for error in one.errors])
    plans, due = (sum(one.plans[k] for one in rows) for k in (0, 1))
    right, wrongly = (sum(one.wrong[k] for one in rows) for k in (0, 1))
    points = sum(one.points for one in rows)
    mu = np.array([off for one in rows for off in one.mu])
    bad = [one.status for n, one in several if KINDS[n % len(KINDS)].wrong]
    good = [one.status for n, one in several if not KINDS[n % len(KINDS)].wrong]
    rightly, could, falsely = (sum(one.proposed[k] for one in rows) for k in range(3))
    least, most = (
        sum(one.proposed[k] for n, one in several if not KINDS[n % len(KINDS)].wrong)
        for k in (1, 0)
    )
    small = [one.seconds for n, one in several if KINDS[n % len(KINDS)].size == "A4"]
    large = [one.seconds for n, one in several if KINDS[n % len(KINDS)].size != "A4"]
    return "\n".join(
        [
            f"plans read {plans} of {due}",
            f"points read {errors.size} of {points}, within 0.8 mm {100 * np.mean(errors <= 0.8):.1f} %",
            f"error: median {np.median(errors):.2f}, 95 % {np.quantile(errors, 0.95):.2f}, "
            f"> 1 mm {(errors > NEAR).sum()}",
            f"wrongly drawn points read as drawn {right} of {wrongly}",
            f"proposed without clicks {rightly} of {could} plans with a shape (of right drawings "
            f"{most} of {least}), falsely {falsely}",
            f"mu off: median {100 * np.median(mu):.2f} %, most {100 * mu.max():.2f} %, within 1 %: "
            f"{(mu < 0.01).sum()} of {mu.size}",
            f"wrong sheets {len(bad)}: something wrong {bad.count(1)}, not all seen {bad.count(3)}, "
            f"nothing wrong {bad.count(0)}",
            f"right sheets {len(good)}: nothing wrong {good.count(0)}, not all seen {good.count(3)}, "
            f"something wrong {good.count(1)}",
            f"seconds of the processor: A4 {np.median(small or [0]):.1f} (most {max(small, default=0):.1f}), "
            f"larger {np.median(large or [0]):.1f} (most {max(large, default=0):.1f})",
        ]
    )


if __name__ == "__main__":
    main()
