"""Tables of displacements at uneven angles: against a spline found by all its conditions at once."""

from __future__ import annotations

import json
import random
from pathlib import Path

import numpy as np
import pytest
from support.cam_tables import FALL, RISE, STROKE, by_differences, cam_of, read_off
from support.cams import SHAPES
from support.scenes import written

from graphic_tmm.chapters.cam.findings import of_tables
from graphic_tmm.chapters.cam.task import ASKED
from graphic_tmm.chapters.cam.task_motion import Law, law_of
from graphic_tmm.scene.read import read

HEAD = """title = "T"
language = "en"
[cam]
stroke = "20 mm"
rise = 100
fall = 100
"""


def spline(x: np.ndarray, y: np.ndarray, at: np.ndarray) -> np.ndarray:
    """A cubic to each gap, four unknowns each: through both lines, slope and curvature go on, level ends."""
    count = x.size - 1
    system, due = np.zeros((4 * count, 4 * count)), np.zeros(4 * count)
    rows = iter(range(4 * count))

    def put(k: int, place: float, order: int, row: int, sense: float = 1.0) -> None:
        t, powers = place - x[k], range(order, 4)
        for p in powers:
            factor = np.prod(np.arange(p - order + 1, p + 1, dtype=float))
            system[row, 4 * k + p] += sense * factor * t ** (p - order)

    for k in range(count):
        for end in (k, k + 1):
            row = next(rows)
            put(k, x[end], 0, row)
            due[row] = y[end]
    for k in range(count - 1):
        for order in (1, 2):
            row = next(rows)
            put(k, x[k + 1], order, row)
            put(k + 1, x[k + 1], order, row, -1.0)
    put(0, x[0], 1, next(rows))
    put(count - 1, x[-1], 1, next(rows))
    pieces = np.linalg.solve(system, due).reshape(count, 4)
    gap = np.clip(np.searchsorted(x, at) - 1, 0, count - 1)
    return np.asarray([np.polyval(pieces[k][::-1], a - x[k]) for k, a in zip(gap, at, strict=True)])


def uneven(draw: random.Random, count: int) -> np.ndarray:
    """Shares of a phase at uneven steps."""
    steps = np.cumsum([0.0, *(draw.uniform(0.5, 1.5) for _ in range(count))])
    return steps / steps[-1]


@pytest.mark.parametrize("seed", range(6))
def test_an_uneven_table_is_read_off_a_spline(seed: int) -> None:
    draw = random.Random(f"uneven {seed}")
    up, down = (uneven(draw, draw.randint(9, 30)) for _ in range(2))
    laws, heights = [], []
    for x, angle in ((up, RISE), (down, FALL)):
        name = draw.choice(["sine", "cosine", "3-4-5"])
        y = SHAPES[name][0](x)
        laws.append(law_of([(angle * a, STROKE * s) for a, s in zip(x, y, strict=True)]))
        heights.append(spline(x, y, np.linspace(0.0, 1.0, x.size)))
        shown = SHAPES[name][0](np.linspace(0.0, 1.0, x.size))
        assert np.abs(heights[-1] - shown).max() < 2e-3, "it is nearly the law"
    of = cam_of(*laws)
    for phase, (one, angle) in enumerate(zip(heights, (RISE, FALL), strict=True)):
        due = by_differences(one, angle)
        if phase:
            due = [due[0][::-1], -due[1][::-1], due[2][::-1]]
        for found, wanted in zip(read_off(of, phase), due, strict=True):
            np.testing.assert_allclose(found, wanted, atol=1e-8 * np.abs(wanted).max())


def test_an_uneven_table_of_even_motion_begins_with_its_velocity() -> None:
    x = uneven(random.Random("evenly"), 14)
    law = law_of([(RISE * a, STROKE * a) for a in x])
    of = cam_of(law, Law("sine"))
    _, speed, second = read_off(of, 0)
    np.testing.assert_allclose(speed, STROKE / np.radians(RISE), rtol=1e-9)
    assert np.abs(second).max() <= 1e-9
    begins, ends = of_tables(of.cam, "en")
    assert "begins phase 1 with the velocity" in begins
    assert "ends phase 1 with the velocity" in ends


LONG = [
    (0, 0),
    (10, 0.4),
    (20, 2),
    (30, 5),
    (40, 9),
    (50, 13),
    (60, 17),
    (70, 19.5),
    (80, 20),
    (100, 20),
]
FLAT = [(0, 0), (5, 5), (10, 10), (15, 15), (20, 20), (80, 20), (90, 20), (95, 20), (100, 20)]
FAR = [(0, 0), (1, 2), (2, 5), (3, 10), (60, 12), (70, 13), (80, 15), (90, 18), (100, 20)]


@pytest.mark.parametrize("lines", [LONG, FLAT, FAR])
def test_nothing_is_read_beyond_the_lines(lines: list[tuple[float, float]]) -> None:
    """A gap much longer than others, a table that stands for a while: no higher, no lower than its lines."""
    x, y = (np.array(row, dtype=float) for row in zip(*lines, strict=True))
    law = law_of([(RISE * a / 100.0, STROKE * s / 20.0) for a, s in lines])
    heights, _, _ = read_off(cam_of(law, Law("sine")), 0)
    at = np.linspace(0.0, 100.0, x.size)
    gap = np.clip(np.searchsorted(x, at) - 1, 0, x.size - 2)
    # a thousandth of the stroke is what a spline of a smooth law may swing
    assert (heights >= STROKE * (y[gap] / 20.0 - 1e-3)).all()
    assert (heights <= STROKE * (y[gap + 1] / 20.0 + 1e-3)).all()


DENSE = [
    (0, 0),
    (2, 0.1),
    (5, 0.5),
    (10, 1.9),
    (60, 16),
    (80, 19),
    (90, 19.8),
    (95, 19.95),
    (100, 20),
]


def test_a_table_is_at_rest_where_its_own_lines_say_so() -> None:
    """Dense lines at an end tell that it begins softly; those that are read off far apart could not."""
    law = law_of([(RISE * a / 100.0, STROKE * s / 20.0) for a, s in DENSE])
    assert not [one for one in of_tables(cam_of(law, Law("sine")).cam, "en") if "velocity" in one]
    quick = [(a, 20.0 * a / 100.0) for a, _ in DENSE]
    law = law_of([(RISE * a / 100.0, STROKE * s / 20.0) for a, s in quick])
    told = [one for one in of_tables(cam_of(law, Law("sine")).cam, "en") if "velocity" in one]
    assert len(told) == 2


def test_angles_that_are_rounded_are_even_ones(tmp_path: Path) -> None:
    """Twelfths of 110° with six figures; a line off by more than half of a digit stands where it says."""
    lines = [[f"{110 * k / 12:.6g} deg", f"{20 * k * k / 144:.3f} mm"] for k in range(13)]
    text = HEAD.replace("rise = 100", "rise = 110") + 'law = "table"\nlaw_table = {lines}\n'
    path = written(tmp_path, text.replace("{lines}", json.dumps(lines)))
    order = ASKED.of(read(path))
    assert order is not None
    np.testing.assert_allclose(
        [x for x, _ in order.rise_law.points], np.arange(13) / 12, atol=1e-11
    )
    lines[4][0] = "37.2 deg"
    order = ASKED.of(read(written(tmp_path, text.replace("{lines}", json.dumps(lines)))))
    assert order is not None
    assert order.rise_law.points[4][0] == pytest.approx(37.2 / 110, rel=1e-12)
