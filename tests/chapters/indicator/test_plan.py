"""Several cylinders: pressures by each piston's own travel; the judge is the closed form and the power."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.each import each
from support.scenes import written
from support.stars import Star

import graphic_tmm
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.read import read

OMEGA, BORE, ROD, CLEAR, COUNT = 50.0, 0.08, 0.03, 0.1, 24
AREA = np.pi * BORE**2 / 4
STEPS = """cover_strokes = [
  { stroke = "out", to = 0.2, p = "600 kPa", n = 0 },
  { stroke = "out", to = 1.0, p = "600 kPa", n = 1.2 },
  { stroke = "back", to = 0.3, p = "110 kPa", n = 0 },
  { stroke = "back", to = 0.0, p = "110 kPa", n = 1.3 },
]
"""
FOUR = """strokes = 4
cover_strokes = [
  { stroke = "out", to = 1.0, p = "90 kPa", n = 0 },
  { stroke = "back", to = 0.0, p = "90 kPa", n = 1.3 },
  { stroke = "out", to = 1.0, p = "3 MPa", n = 1.25 },
  { stroke = "back", to = 0.0, p = "110 kPa", n = 0 },
]
"""
SHAFT = """shaft_points = { out = [[0, 200e3], [1, 100e3]], back = [[1, 300e3], [0, 500e3]] }
rod = "30 mm"
"""
STARS = {
    "in-line twin, 180": Star((90.0, 90.0), cranks=(0.0, 180.0)),
    "in-line twin, 360": Star((90.0, 90.0), cranks=(0.0, 0.0)),
    "v": Star((135.0, 45.0)),
    "opposed": Star((180.0, 0.0), cranks=(0.0, 180.0)),
    "w": Star((150.0, 90.0, 30.0)),
    "three in line": Star((90.0, 90.0, 90.0), cranks=(0.0, 120.0, 240.0)),
    "four in line": Star((90.0,) * 4, cranks=(0.0, 180.0, 180.0, 0.0)),
    "radial": Star((90.0, 210.0, 330.0)),
    "offset": Star((90.0, 0.0), offsets=(0.01, -0.012)),
    "master rod": Star((90.0,), master=(0.045, 0.02, 0.15, 20.0)),
}
Pressure = Callable[[np.ndarray, np.ndarray, np.ndarray], np.ndarray]


def two_strokes(share: np.ndarray, out: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """STEPS, written down by hand."""
    going = np.where(share <= 0.2, 600e3, 600e3 * ((CLEAR + 0.2) / (CLEAR + share)) ** 1.2)
    coming = np.where(share >= 0.3, 110e3, 110e3 * ((CLEAR + 0.3) / (CLEAR + share)) ** 1.3)
    return np.where(out, going, coming)


def four_strokes(share: np.ndarray, out: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """FOUR, written down by hand."""
    compressed = 90e3 * ((CLEAR + 1.0) / (CLEAR + share)) ** 1.3
    expanded = 3e6 * (CLEAR / (CLEAR + share)) ** 1.25
    first = np.where(out, 90e3, compressed)
    return np.where(turn == 0, first, np.where(out, expanded, 110e3))


def cylinders(star: Star, steps: str, phases: tuple[int, ...] = (), more: str = "") -> str:
    found = []
    for k, piston in enumerate("BCDE"[: len(star.angles) + bool(star.master)]):
        own = f'bore = "80 mm"\nclearance = {CLEAR}\n{steps}{more}' if not k else 'same_as = "B"\n'
        phase = f'phase = "{phases[k]} deg"\n' if phases else ""
        found.append(f'[[indicator]]\npoint = "{piston}"\n{own}{phase}')
    return "".join(found)


def scene(star: Star, gas: str, *, omega: float = OMEGA, zero: str = '"17 deg"') -> str:
    way = "counterclockwise" if omega > 0 else "clockwise"
    return star.text(
        f'speed = "{abs(omega)} 1/s"\nturns = "{way}"\npositions = {COUNT}\nzero = {zero}\n'
        f'[effects]\ngas = true\n{gas}[forces]\npositions = [1]\nbalance = "moment"\n'
        '[flywheel]\nconstant = "resisting"\nJ = 5\ntangents = "none"\n'
    )


def drawing(folder: Path, text: str) -> Drawn:
    return drawn_of(read(written(folder, text)), exact=True)


def state(
    star: Star, k: int, phi: np.ndarray, omega: float, turns: int, phase: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Share of the stroke, way and turn of the cycle of a piston along a row of positions."""
    share, out = star.shares(k, phi), star.speed(k, phi, omega) < 1e-7
    fine = phi[0] + np.sign(omega) * np.linspace(0.0, 2 * np.pi, 200_000, endpoint=False)
    late = int(np.argmax(star.along(k, fine))) / 200_000
    passed = np.arange(len(phi)) * turns / len(phi) - late
    turn = (np.floor(passed + 1e-4) - phase // 360).astype(int) % turns
    return share, out, turn


def due(
    star: Star,
    pressure: Pressure,
    turns: int,
    phases: tuple[int, ...],
    omega: float,
    zero: float = 17.0,
) -> list[np.ndarray]:
    """The moment of every piston on the crank, by power alone."""
    phi = np.radians(zero) + np.sign(omega) * 2 * np.pi * np.arange(COUNT * turns) / COUNT
    found = []
    for k in range(len(star.angles) + bool(star.master)):
        told = state(star, k, phi, omega, turns, phases[k] if phases else 0.0)
        found.append(-pressure(*told) * AREA * star.speed(k, phi, omega) / abs(omega))
    return found


def moments(made: Drawn) -> tuple[np.ndarray, list[np.ndarray]]:
    """The sum as the flywheel has it, and the moments of which it is the sum."""
    flywheel, log = FLYWHEEL_PLAN.on(made), made.construction
    parts = [s.it for s in log.steps if s.op.name == "reduced_moment"]
    return made.reading[flywheel.moment][0], [made.reading[mark][0] for mark in parts]


@each("name", STARS)
@each("omega", [OMEGA, -OMEGA])
@pytest.mark.slow
def test_every_piston_has_the_pressures_of_its_own_travel(
    name: str, omega: float, tmp_path: Path
) -> None:
    star = STARS[name]
    made = drawing(tmp_path, scene(star, cylinders(star, STEPS), omega=omega))
    whole, parts = moments(made)
    wanted = due(star, two_strokes, 1, (), omega)
    for found, one in zip(parts, wanted, strict=True):
        np.testing.assert_allclose(found, one, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(whole, sum(wanted), rtol=1e-6, atol=1e-6)


def test_a_row_that_begins_at_the_inner_dead_centre_counts_strokes_from_the_cover(
    tmp_path: Path,
) -> None:
    star = STARS["v"]
    made = drawing(tmp_path, scene(star, cylinders(star, STEPS), zero='"315 deg"'))
    wanted = due(star, two_strokes, 1, (), OMEGA, 315.0)
    for found, one in zip(moments(made)[1], wanted, strict=True):
        np.testing.assert_allclose(found, one, rtol=1e-6, atol=1e-4)


def behind(share: np.ndarray, out: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """SHAFT, written down by hand, as a pressure on the other side: with the ring's share of the area."""
    return (1 - (ROD / BORE) ** 2) * np.where(out, 200e3 - 100e3 * share, 500e3 - 200e3 * share)


@each("name", ["v", "offset", "in-line twin, 180", "master rod"])
@each("omega", [OMEGA, -OMEGA])
@pytest.mark.slow
def test_the_gas_behind_each_piston_pushes_it_off_the_crank(
    name: str, omega: float, tmp_path: Path
) -> None:
    star = STARS[name]
    made = drawing(tmp_path, scene(star, cylinders(star, STEPS, more=SHAFT), omega=omega))
    parts = moments(made)[1]
    sides = (due(star, side, 1, (), omega) for side in (two_strokes, behind))
    for found, cover, shaft in zip(parts, *sides, strict=True):
        np.testing.assert_allclose(found, cover - shaft, rtol=1e-6, atol=1e-6)
        assert np.abs(shaft).max() > 10.0


@each("name", ["v", "w"])
def test_each_moment_is_read_off_a_graph_of_its_own(name: str, tmp_path: Path) -> None:
    star = STARS[name]
    made = drawing(tmp_path, scene(star, cylinders(star, STEPS)))
    flywheel = FLYWHEEL_PLAN.on(made)
    mu = float(made.reading[flywheel.axes.mu].ravel()[0])
    every = due(star, two_strokes, 1, (), OMEGA)
    for k, (part, wanted) in enumerate(zip(flywheel.parts, every, strict=True)):
        assert "BCD"[k] in part.name
        np.testing.assert_allclose(mu * made.reading[part][0], wanted, rtol=1e-6, atol=1e-6)


@each(
    "gas, highest",
    [
        (cylinders(Star((90.0,)), STEPS), 600e3),
        (cylinders(Star((90.0,)), STEPS, more=SHAFT.replace("500e3", "700e3")), 700e3),
        (cylinders(Star((90.0,)), STEPS, more=SHAFT.replace("[0, 200e3]", "[0, 900e3]")), 900e3),
        (f'[[indicator]]\npoint = "B"\nbore = 1\ncover = {[2e5, *[1e5] * (COUNT - 1)]}\n', 2e5),
    ],
)
def test_the_highest_pressure_of_a_task_is_that_of_all_sides(
    gas: str, highest: float, tmp_path: Path
) -> None:
    made = read(written(tmp_path, scene(Star((90.0,)), gas)))
    (told,) = {
        one.value
        for part in chapters()
        if (given := TaskSheet.of(part).given) is not None
        for one in given(made)
        if one.symbol == "p_{max}"
    }
    assert told == pytest.approx(highest, rel=1e-12)


@each("name", ["in-line twin, 360", "v", "opposed", "three in line", "four in line", "radial"])
@each(
    "phases, omega",
    [((0, 0, 0, 0), OMEGA), ((0, 360, 0, 360), -OMEGA), ((360, 0, 360, 0), OMEGA)],
)
@pytest.mark.slow
def test_four_strokes_fire_by_their_phases(
    name: str, phases: tuple[int, ...], omega: float, tmp_path: Path
) -> None:
    star = STARS[name]
    made = drawing(tmp_path, scene(star, cylinders(star, FOUR, phases), omega=omega))
    whole, parts = moments(made)
    wanted = due(star, four_strokes, 2, phases, omega)
    for found, one in zip(parts, wanted, strict=True):
        np.testing.assert_allclose(found, one, rtol=1e-6, atol=1e-6)
    np.testing.assert_allclose(whole, sum(wanted), rtol=1e-6, atol=1e-6)


def test_the_gas_of_all_is_balanced_at_the_crank(tmp_path: Path) -> None:
    """Kinetostatics and the lever balance what the flywheel is driven by."""
    for k, (star, steps) in enumerate(((STARS["w"], STEPS), (STARS["v"], FOUR))):
        folder = tmp_path / str(k)
        folder.mkdir()
        made = drawing(folder, scene(star, cylinders(star, steps, more=SHAFT * (not k))))
        whole, forces = moments(made)[0], FORCES_PLAN.on(made)
        for mark in (forces.first.balance, forces.first.lever.balance):
            np.testing.assert_allclose(made.reading[mark][0], -whole, rtol=1e-7, atol=1e-7)


def test_an_in_line_twin_is_the_sum_of_two_single_cylinders(tmp_path: Path) -> None:
    """Both pistons go together; the second one's cycle is a turn late."""
    zero, star = '{ point = "B", at = "top" }', STARS["in-line twin, 360"]
    single = Star((90.0,))
    gas = cylinders(single, FOUR).replace("[[indicator]]", "[indicator]")
    alone = moments(drawing(tmp_path, scene(single, gas, zero=zero)))[0]
    made = drawing(tmp_path, scene(star, cylinders(star, FOUR, (0, 360)), zero=zero))
    whole, (first, second) = moments(made)
    np.testing.assert_allclose(first, alone, rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(second, np.roll(alone, COUNT), rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(whole, alone + np.roll(alone, COUNT), rtol=1e-9, atol=1e-9)


def test_a_single_cylinder_in_a_list_draws_the_same(tmp_path: Path) -> None:
    single = Star((90.0,))
    gas = cylinders(single, FOUR)
    listed = drawing(tmp_path, scene(single, gas)).construction
    alone = drawing(tmp_path, scene(single, gas.replace("[[", "[").replace("]]\n", "]\n")))
    assert [str(step) for step in listed.steps] == [str(s) for s in alone.construction.steps]


def test_by_angle_tells_what_the_cylinders_do(tmp_path: Path) -> None:
    """A V compressor by its diagrams against the same by the turn of the crank, table by table."""
    star, zero = STARS["v"], '{ point = "B", at = "left" }'
    gas = cylinders(star, STEPS)
    whole = moments(drawing(tmp_path, scene(star, gas, zero=zero)))[0]
    phi = np.radians(135.0) + 2 * np.pi * np.arange(COUNT) / COUNT
    loads = ""
    for k, angle in enumerate((315, 225)):
        push = two_strokes(*state(star, k, phi, OMEGA, 1, 0.0)) * AREA
        table = ", ".join(f"[{i * 360 / COUNT}, {p!r}]" for i, p in enumerate(push.tolist()))
        loads += (
            f'[[load]]\nlink = {2 * k + 3}\npoint = "{"BC"[k]}"\ndirection = "{angle} deg"\n'
            f"by_angle = [{table}]\n"
        )
    told = moments(drawing(tmp_path, scene(star, loads, zero=zero).replace("gas = true", "")))[0]
    np.testing.assert_allclose(told, whole, rtol=1e-6, atol=1e-6)


def test_pressures_by_positions_stand_where_the_positions_do(tmp_path: Path) -> None:
    star = STARS["v"]
    rows = [[1e5 + 1e4 * k * j for k in range(COUNT)] for j in (1, 2)]
    gas = "".join(
        f'[[indicator]]\npoint = "{p}"\nbore = 0.08\ncover = {row}\n'
        for p, row in zip("BC", rows, strict=True)
    )
    phi = np.radians(17.0) + 2 * np.pi * np.arange(COUNT) / COUNT
    parts = moments(drawing(tmp_path, scene(star, gas)))[1]
    for k, found in enumerate(parts):
        wanted = -np.array(rows[k]) * AREA * star.speed(k, phi, OMEGA) / OMEGA
        np.testing.assert_allclose(found, wanted, rtol=1e-6, atol=1e-6)


@each("name", ["v", "master rod"])
def test_the_base_is_divided_as_each_piston_travels(name: str, tmp_path: Path) -> None:
    star = STARS[name]
    made = drawing(tmp_path, scene(star, cylinders(star, STEPS)))
    phi = np.radians(17.0) + 2 * np.pi * np.arange(COUNT) / COUNT
    for k, one in enumerate(INDICATOR_PLAN.on(made).every):
        feet = made.reading[one.indicator.feet][0]
        base = made.reading[one.indicator.end][0, 0].real
        np.testing.assert_allclose(feet / base, star.shares(k, phi), atol=1e-8)


def test_any_angle_is_read_off_each_diagram(tmp_path: Path) -> None:
    star = STARS["v"]
    made = read(written(tmp_path, scene(star, cylinders(star, STEPS))))
    at = 17.0 + 360.0 * np.arange(COUNT) / COUNT
    found = graphic_tmm.motion(made, at, plans=["forces"], exact=True).balance["M_bal_forces"]
    wanted = -sum(due(star, two_strokes, 1, (), OMEGA))
    np.testing.assert_allclose(found, wanted, rtol=1e-6, atol=1e-6)


V = partial(scene, STARS["v"])
PISTON_C = '[[indicator]]\npoint = "C"\n'
SAME = PISTON_C + 'same_as = "B"\n'
LISTED = f"shaft = {[1e5] * COUNT}\n"
"""Pressures towards the crank, position by position."""
OF_ANOTHER = (
    *("clearance = 0.2\n", "strokes = 4\n", 'rod = "20 mm"\n', f"cover = {[1e5] * COUNT}\n"),
    *(LISTED, "cover_points = { out = [[0, 1], [1, 2]], back = [[1, 2], [0, 1]] }\n"),
    *("shaft_points = { out = [[0, 1], [1, 2]], back = [[1, 2], [0, 1]] }\n", STEPS),
    STEPS.replace("cover", "shaft"),
)
"""What a cylinder has by the one whose pressures it has."""


@each(
    "gas, says",
    [
        (PISTON_C + cylinders(Star((0.0,)), STEPS), '"bore" is missing'),
        (cylinders(STARS["v"], STEPS) + PISTON_C + 'same_as = "B"\n', "a cylinder of C already"),
        (PISTON_C + 'same_as = "C"\n', "name the piston of one that has"),
        (cylinders(Star((0.0,)), STEPS) + PISTON_C + 'same_as = "Q"\n', 'no cylinder of "Q" has'),
        (
            '[[indicator]]\npoint = "B"\nsame_as = "C"\n' + PISTON_C + 'same_as = "B"\n',
            'no cylinder of "C" has',
        ),
        (
            cylinders(Star((0.0,)), STEPS) + '[[indicator]]\npoint = "Q"\nsame_as = "B"\n',
            '"Q" is no point of a moving link',
        ),
        *((cylinders(STARS["v"], STEPS) + one, "same_as gives it already") for one in OF_ANOTHER),
        (cylinders(STARS["v"], STEPS) + 'phase = "90 deg"\n', "a dead centre of its own piston"),
        (cylinders(STARS["v"], STEPS) + 'phase = "360 deg"\n', "a dead centre of its own piston"),
        (
            cylinders(Star((0.0,)), STEPS) + PISTON_C + "bore = 0.1\n" + FOUR,
            "as many strokes; write strokes = 2",
        ),
        (
            f'[[indicator]]\npoint = "B"\nbore = 1\ncover = {[1e5] * COUNT}\n'
            + PISTON_C
            + 'same_as = "B"\n',
            "by cover_points or cover_strokes",
        ),
        (
            f'[[indicator]]\npoint = "B"\nbore = 1\nphase = "360 deg"\ncover = {[1e5] * COUNT}\n',
            "leave the phase out",
        ),
        (cylinders(Star((0.0,)), STEPS, more=LISTED) + SAME, "by cover_points or cover_strokes"),
        (cylinders(Star((0.0,)), STEPS, (360,), more=LISTED), "leave the phase out"),
    ],
)
def test_what_contradicts_itself_is_refused(gas: str, says: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=says):
        read(written(tmp_path, V(gas)))


def test_an_engine_has_one_cylinder(tmp_path: Path) -> None:
    gas = cylinders(STARS["v"], STEPS)
    text = V(gas).replace("[flywheel]", '[engine]\npoint = "B"\n[flywheel]')
    with pytest.raises(SceneError, match="one crank, rod and piston"):
        read(written(tmp_path, text))
