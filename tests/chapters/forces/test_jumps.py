"""Two places alike in a load's table are a jump: what holds there, at any angle, in its work, on the sheet."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.each import each
from support.scenes import slider_crank, written

import graphic_tmm
from graphic_tmm.chapters.forces.load_diagrams import load_views
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.travel import part_of_travel, size_at_turn
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError
from graphic_tmm.paper.drawing import Label, Stroke
from graphic_tmm.readers.table import results_of
from graphic_tmm.scene.read import read

CRANK, ROD, OMEGA = 0.1, 0.35, 20.0
STROKE = 2 * CRANK
BEGINS = 'speed = "20 1/s"\npositions = {count}\nzero = {{ point = "B", at = "right" }}\n'
LOAD = '[[load]]\nlink = 3\npoint = "B"\n{table}\n[forces]\npositions = [1]\n'
CUT = 'of = "B"\nout = [[0, 0], [0.25, 0], [0.25, "800 N"], [0.75, "600 N"], [0.75, 0], [1, 0]]'
BACK = 'back = [[0, 0], [0.5, 0], [0.5, "90 N"], [1, "90 N"]]'
TURNED = 'by_angle = [[0, "50 N"], [90, "50 N"], [90, "400 N"], [200, "400 N"], [200, 0], [360, 0]]'


def scene(
    folder: Path, table: str, *, count: int = 12, more: str = "", of_slider: str = ""
) -> Path:
    drive = BEGINS.format(count=count) + LOAD.format(table=table) + more
    return written(folder, slider_crank(drive, crank=CRANK, rod=ROD, of_slider=of_slider))


def sizes(made: Drawn) -> np.ndarray:
    """|F| at the positions, as the log has it."""
    return np.asarray(made.reading[FORCES_PLAN.on(made).loads.given[0]][0])


def share(phi: np.ndarray) -> np.ndarray:
    """Of the stroke, from the right, at crank angles (radians)."""
    x = CRANK * np.cos(phi) + np.sqrt(ROD**2 - (CRANK * np.sin(phi)) ** 2)
    return np.asarray((CRANK + ROD - x) / STROKE)


def cut(s: np.ndarray, *, out: np.ndarray) -> np.ndarray:
    """The force of CUT and BACK, written down by hand."""
    forward = np.where((s >= 0.25) & (s < 0.75), 800.0 - 400.0 * (s - 0.25), 0.0)
    return np.where(out, forward, np.where(s > 0.5, 90.0, 0.0))


def test_by_the_turn_the_size_behind_the_jump_holds(tmp_path: Path) -> None:
    made = drawn_of(read(scene(tmp_path, TURNED)))
    due = [50, 50, 50, 400, 400, 400, 400, 0, 0, 0, 0, 0]
    due[0] = 50
    np.testing.assert_allclose(sizes(made), due)


def test_a_table_that_does_not_close_jumps_where_the_turn_ends() -> None:
    """From 0 to 60° the size goes from 0 to 10, whatever it is at 360°."""
    points = ((0.0, 0.0), (60.0, 10.0), (360.0, 5.0))
    at = np.array([0.0, 30.0, 60.0, 210.0, 359.0, 360.0, 390.0])
    due = [0.0, 5.0, 10.0, 7.5, 5.0 + 5.0 / 300.0, 0.0, 5.0]
    np.testing.assert_allclose(size_at_turn(points, at), due, atol=1e-6)
    open_ends = ((90.0, 10.0), (270.0, 20.0))
    np.testing.assert_allclose(
        size_at_turn(open_ends, np.array([0.0, 180.0, 315.0])), [15, 15, 17.5]
    )


@each("of", range(1, 48))
def test_a_position_on_a_jump_stands_behind_it_whatever_rounding_makes_of_its_angle(
    of: int,
) -> None:
    points = ((0.0, 1.0), (360.0 * of / 48, 1.0), (360.0 * of / 48, 2.0), (360.0, 2.0))
    before, on = size_at_turn(points, np.array([of - 1, of]) * (360.0 / 48))
    assert (before, on) == (1.0, 2.0)


def test_by_the_travel_the_size_holds_that_the_motion_comes_to() -> None:
    points = ((0.0, 1.0), (0.3, 1.0), (0.3, 5.0), (1.0, 9.0), (1.0, 2.0))
    at = np.array([0.0, 0.3, 0.65, 1.0])
    for ahead, due in ((True, [1.0, 5.0, 7.0, 2.0]), (False, [1.0, 1.0, 7.0, 9.0])):
        a, b, p, q = part_of_travel(points, at, ahead=ahead)
        np.testing.assert_allclose(p + (q - p) * (at - a) / (b - a), due)


def test_the_force_of_a_slotter_at_every_position_and_its_work(tmp_path: Path) -> None:
    path = scene(tmp_path, f"{CUT}\n{BACK}")
    phi = np.arange(12) * np.pi / 6
    out = np.arange(12) <= 6
    made = drawn_of(read(path), exact=True)
    np.testing.assert_allclose(sizes(made), cut(share(phi), out=out), rtol=1e-9, atol=1e-9)

    count = 7200
    angles = (np.arange(count) + 0.5) * 360.0 / count
    found = graphic_tmm.motion(
        read(path), angles, plans=("positions", "velocities", "forces"), exact=True
    )
    power = -found.balance["P_bal_lever"] * OMEGA * CRANK
    phi = np.radians(angles)
    due = cut(share(phi), out=phi < np.pi) * np.abs(found["B"].velocity.real)
    np.testing.assert_allclose(np.abs(power), due, atol=1e-6 * due.max())
    # 700 N on half of the stroke out, 90 N on half of that back; a jump is met within one part of a turn
    work = np.abs(power).sum() * (2 * math.pi / count) / OMEGA
    met = 4 * 800.0 * CRANK * (2 * math.pi / count)
    assert work == pytest.approx((0.5 * 700.0 + 0.5 * 90.0) * STROKE, abs=met)


@pytest.mark.slow
def test_the_flywheel_of_a_load_that_jumps(tmp_path: Path) -> None:
    """ΔA of F·dx against a constant moment, by sums of 1e5 parts, over δ·ω²."""
    path = scene(
        tmp_path,
        f"{CUT}\n{BACK}",
        count=36,
        more='[flywheel]\ndelta = 0.05\nconstant = "driving"\n',
        of_slider='mass = "1e-6 kg"\ncentre = "B"\n',
    )
    found = results_of(drawn_of(read(path), exact=True))["J_fly"][0]
    phi = (np.arange(100_000) + 0.5) * 2 * np.pi / 100_000
    moment = cut(share(phi), out=phi < np.pi) * np.abs(np.gradient(STROKE * share(phi), phi))
    excess = np.cumsum(moment.mean() - moment) * 2 * np.pi / 100_000
    due = np.ptp(excess) / (0.05 * OMEGA**2)
    # each jump may lie half a part of the turn off: of 800 N·0.1 m over 2π/36 rad
    slack = 80.0 * (2 * np.pi / 36) / (0.05 * OMEGA**2)
    assert float(found[0]) == pytest.approx(due, abs=slack)
    assert slack < 0.3 * due


def test_a_jump_is_an_upright_line_of_the_diagram(tmp_path: Path) -> None:
    """Where a sheet of its own shows it; beside the guide it is the same."""
    alone = '[[sheet]]\nformat = "A4"\nplace = ["load diagram"]\n'
    (view,) = load_views(drawn_of(read(scene(tmp_path, CUT, more=alone))), True)
    (line,) = [s for s in view.strokes if s.part == "given" and isinstance(s, Stroke)]
    upright = [
        (x, y, v) for (x, y, _), (u, v, _) in zip(line.path, line.path[1:], strict=False) if x == u
    ]
    assert len(upright) == 2
    assert {min(y, v) for _, y, v in upright} == {0.0}


@pytest.mark.parametrize(
    "table",
    [
        'of = "B"\nout = [[0, 0], [0.5, 0], [0.5, 5], [0.5, 7], [1, 7]]',
        "by_angle = [[0, 0], [90, 0], [90, 5], [90, 7], [360, 7]]",
        "by_angle = [[0, 0], [90, 0], [80, 5], [360, 7]]",
    ],
)
def test_three_places_alike_and_disorder_are_refused(tmp_path: Path, table: str) -> None:
    with pytest.raises(SceneError, match="put them in order, two at a jump"):
        read(scene(tmp_path, table))


def figures(labels: tuple[Label, ...]) -> list[tuple[float, Label]]:
    """Labels that say a number."""
    found = []
    for one in labels:
        try:
            found.append((float(one.text.replace("−", "-")), one))
        except ValueError:
            continue
    return found


@pytest.mark.parametrize("seed", range(6))
def test_figures_stand_at_their_ticks_in_order(tmp_path: Path, seed: int) -> None:
    rng = np.random.default_rng(seed)
    angles = [0, *sorted(rng.choice(np.arange(5, 355), 6, replace=False).tolist()), 360]
    values = rng.choice([0, 200, 300, 3800, 3900, 4000, -150, -3700, 900], len(angles)).tolist()
    table = ", ".join(f"[{a}, {v}]" for a, v in zip(angles, values, strict=True))
    (view,) = load_views(drawn_of(read(scene(tmp_path, f"by_angle = [{table}]"))), True)
    caption = next(one.text for one in view.labels if one.text.startswith("μ_"))
    along, up = (float(part.split(" = ")[1].split(" ")[0]) for part in caption.split(", "))
    placed = [(v, one) for v, one in figures(view.labels) if one.position is None]
    left = sorted((one.at.imag + one.size / 2, v) for v, one in placed if one.anchor == "end")
    assert {v for _, v in left} <= {0.0, *map(float, values)}
    assert {0.0, max(map(float, values), key=abs)} <= {v for _, v in left}
    for height, value in left:
        assert height == pytest.approx(value / up, abs=1e-6)
    base = [(v, one) for v, one in placed if one.anchor == "start"]
    assert {v for v, _ in base} <= set(map(float, angles))
    assert 360.0 in {v for v, _ in base}
    for value, one in base:
        wide = 4.0 * len(one.text)
        assert -wide < one.at.real - value / along < 1.0
    ordered = sorted(base, key=lambda two: two[1].at.real)
    assert [v for v, _ in ordered] == sorted(v for v, _ in base)
