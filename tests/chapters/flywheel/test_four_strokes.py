"""A four-stroke engine: its cycle of two turns against numpy alone; what contradicts it is refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.flywheels import Crank, crank, graphs, scene_of, taut
from support.gallery import SHEETS
from support.graphs import assert_read_off_the_log
from support.scenes import edited, source, written

import graphic_tmm
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.flywheel.table import flywheel_columns, flywheel_results
from graphic_tmm.chapters.flywheel.views import flywheel_views
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.table import plan_columns
from graphic_tmm.chapters.kinematics.views import position_views, velocity_views
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.errors import SceneError
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.readers.task_sheet import given_rows
from graphic_tmm.scene.read import read

R, L, S, CLEARANCE, BORE = 0.06, 0.24, 0.08, 0.15, 0.11
MASSES, J_ROD, J_CRANK, SPEED, DELTA = (1.6, 1.1), 0.016, 0.02, 50 * np.pi, 0.02
"""The scene `four-stroke`: m, kg, kg·m², 1/s."""
AIR = 100e3


@cache
def exact() -> Drawn:
    return drawn_of(read(SHEETS / "four-stroke"), exact=True)


def share(phi: np.ndarray) -> np.ndarray:
    """How far the piston is from the cover, as a share of its stroke; φ from the dead centre there."""
    reach = R * np.cos(phi) + np.sqrt(L**2 - (R * np.sin(phi)) ** 2)
    return (R + L - reach) / (2 * R)


def pressure(phi: np.ndarray) -> np.ndarray:
    """Suction, compression, expansion and exhaust over 4π, at a boundary that of the stroke that begins."""
    turn, x = np.floor(phi / np.pi + 1e-9).astype(int) % 4, share(phi) + CLEARANCE
    of = [
        np.full_like(x, 90e3),
        90e3 * ((1 + CLEARANCE) / x) ** 1.32,
        3.2e6 * (CLEARANCE / x) ** 1.28,
        np.full_like(x, 110e3),
    ]
    # a stroke out goes on to its end, where it counts; that back begins behind it
    ended = np.isclose(phi % (2 * np.pi), np.pi)
    turn = np.where(ended, turn - 1, turn)
    return np.choose(turn, of)


def machine(phi: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The reduced moment (N·m) and the energy of the links (J), by the closed formulas of the slider-crank."""
    of = Crank(
        R, L, 0.0, S, MASSES, J_ROD, np.pi * BORE**2 / 4, SPEED, lambda at: pressure(at) - AIR
    )
    moment, energy = of(phi)
    return moment, energy + J_CRANK * SPEED**2 / 2


def column(made: Drawn, name: str) -> np.ndarray:
    return next(one for one in flywheel_columns(made) if one.segment == name).value[0]


def results(made: Drawn) -> dict[str, float]:
    return {name: value for name, (value, _) in single(flywheel_results(made)).items()}


PHI = np.arange(24) * np.pi / 6


def test_the_pressures_are_those_of_the_four_strokes() -> None:
    np.testing.assert_allclose(column(exact(), "pk"), pressure(PHI), rtol=1e-5)
    np.testing.assert_allclose(column(exact(), "pv"), AIR, rtol=1e-12)


def test_the_moment_over_two_turns_is_that_of_the_gas() -> None:
    due, _ = machine(PHI)
    np.testing.assert_allclose(column(exact(), "M"), due, atol=2e-5 * np.abs(due).max())


def test_the_flywheel_is_what_the_graphs_over_4_pi_give() -> None:
    """J, and the constant moment and its power, from ordinates that numpy alone found."""
    found, found_graphs = results(exact()), graphs(*machine(PHI), turns=2)
    due = np.ptp(found_graphs.own) / (DELTA * SPEED**2)
    assert found["J_fly"] == pytest.approx(due, rel=1e-5)
    moment, _ = machine(PHI)
    steps = np.pi / 6
    m = taut(moment)
    after = np.roll(moment, -1)
    work = np.sum((moment + after) / 2 + (m - np.roll(m, -1)) / 12) * steps
    assert found["M_mean"] == pytest.approx(work / (4 * np.pi), rel=1e-5)
    assert found["power"] == pytest.approx(work / (4 * np.pi) * SPEED, rel=1e-5)


def truth(count: int = 28_800) -> tuple[float, float]:
    """J and the work of the cycle by rectangles of the middles over 4π."""
    step = 4 * np.pi / count
    moment, _ = machine((np.arange(count) + 0.5) * step)
    _, t_links = machine(np.arange(count) * step)
    works = np.concatenate([[0.0], np.cumsum(moment) * step])
    own = works[:-1] - works[-1] * np.arange(count) / count - t_links
    return float(np.ptp(own)) / (DELTA * SPEED**2), float(works[-1])


def test_a_fine_row_comes_to_the_truth(tmp_path: Path) -> None:
    """72 positions in a turn: within 0.2 % of a numeric integration over the cycle, 12 within 10 %."""
    path = edited(tmp_path, ("positions     = 12 ", "positions     = 72 "), name="four-stroke")
    fine, (inertia, work) = results(drawn_of(read(path), exact=True)), truth()
    assert fine["J_fly"] == pytest.approx(inertia, rel=2e-3)
    assert fine["M_mean"] * 4 * np.pi == pytest.approx(work, rel=2e-3)
    assert results(exact())["J_fly"] == pytest.approx(inertia, rel=0.1)


def by_closed_form() -> float:
    """The work of the gas in a cycle, J: p·dV of the four strokes, the crankcase gives none."""
    face, c = np.pi * BORE**2 / 4 * 2 * R, CLEARANCE

    def polytropic(p: float, n: float, start: float, end: float) -> float:
        a, b = c + start, c + end
        return p * a**n * (b ** (1 - n) - a ** (1 - n)) / (1 - n)

    strokes = [90e3, polytropic(90e3, 1.32, 1, 0), polytropic(3.2e6, 1.28, 0, 1), -110e3]
    return float(face * sum(strokes))


def test_the_truth_is_the_closed_form_and_the_mean_pressure_does_its_work(tmp_path: Path) -> None:
    """The planimeter goes round the diagram twice and takes the loop of the gas exchange off."""
    work = by_closed_form()
    assert truth()[1] == pytest.approx(work, rel=1e-4)
    path = edited(tmp_path, ("positions     = 12 ", "positions     = 72 "), name="four-stroke")
    mean = results(drawn_of(read(path), exact=True))["p_mean_cover"]
    assert mean * np.pi * BORE**2 / 4 * 2 * R == pytest.approx(work, rel=0.01)


@pytest.mark.parametrize("seed", range(4))
def test_random_machines_with_pressures_by_positions(tmp_path: Path, seed: int) -> None:
    """The pressure has half the crank's frequency, too: no turn is as the other."""
    of = crank(seed)
    both = of._replace(pressure=_twice(of.pressure))
    count = 12
    phi = np.arange(2 * count) * 2 * np.pi / count
    pressures = [float(p) for p in both.pressure(phi)]
    text = scene_of(of, count, more="turns = 2")
    start = text.index("cover = ")
    text = (
        text[:start]
        + f"strokes = 4\ncover = {json.dumps(pressures)}\n"
        + text[text.index("[flywheel]") :]
    )
    made = drawn_of(read(written(tmp_path, text)), exact=True)
    moment, energy = both(phi)
    np.testing.assert_allclose(column(made, "M"), moment, atol=1e-8 * np.abs(moment).max())
    due = np.ptp(graphs(moment, energy, turns=2).own)
    found = made.reading[FLYWHEEL_PLAN.on(made).segment][0, 0] * made.scales["energy"].value
    assert found == pytest.approx(due, rel=1e-6)


def _twice(once: Callable[[np.ndarray], np.ndarray]) -> Callable[[np.ndarray], np.ndarray]:
    return lambda phi: once(phi) * (1.0 + 0.4 * np.cos(phi / 2 - 0.7))


def test_the_base_stands_for_4_pi_and_the_mechanism_is_drawn_once() -> None:
    made = exact()
    mu = made.reading[FLYWHEEL_PLAN.on(made).base.mu].item()
    assert mu == pytest.approx(4 * np.pi / 240.0)
    assert made.names == tuple(map(str, range(24)))
    plans = KINEMATICS_PLAN.on(made)
    assert plans.repeated == tuple(range(12, 24))
    assert len(velocity_views(made, False)) == 12
    (positions,) = position_views(made, True)
    texts = {label.text for label in positions.labels}
    assert {"0, 12", "6, 18"} <= texts
    speeds = next(one for one in plan_columns(made, "velocities") if one.segment == "pb")
    np.testing.assert_allclose(speeds.value[0, 12:], speeds.value[0, :12], atol=1e-9)


def test_its_graphs_are_read_off_the_log() -> None:
    made = exact()
    shown = [one for one in flywheel_views(made, True) if one.shows and one.name != "flywheel"]
    assert any(one.name == "flywheel-graphs" for one in shown)
    indicator = next(one for one in shown if one.name == "indicator")
    assert_read_off_the_log(made.construction, [indicator])


def test_the_protocol_tells_the_cycle() -> None:
    text = "\n".join(protocol(exact(), ("flywheel",), "14", "ru", why=True))
    assert "μ_φ = 2π·n_t/L = 2π·2/240" in text


def test_strokes_and_the_highest_pressure_are_given() -> None:
    found = {one.symbol: one.value for one in given_rows(read(SHEETS / "four-stroke"))}
    assert found["p_{max}"] == pytest.approx(3.2e6)
    assert found["strokes of the cycle"] == 4
    published = {one.symbol: one.value for one in given_rows(read(SHEETS / "engine"))}
    assert published["p_{max}"] == pytest.approx(300e3)
    assert "strokes of the cycle" not in published


def test_diagrams_by_points_of_four_strokes(tmp_path: Path) -> None:
    text = (SHEETS / "four-stroke" / "scene.toml").read_text(encoding="utf-8")
    start, end = text.index("cover_strokes"), text.index("[flywheel]")
    points = {
        "out": [[0, 90e3], [1, 90e3]],
        "back": [[1, 90e3], [0.2, 0.6e6], [0, 1.3e6]],
        "out_2": [[0, 3.2e6], [0.3, 1.2e6], [1, 0.25e6]],
        "back_2": [[1, 110e3], [0, 110e3]],
    }
    told = ", ".join(f"{name} = {json.dumps(value)}" for name, value in points.items())
    new = text[:start] + f"cover_points = {{ {told} }}\n\n" + text[end:]
    made = drawn_of(read(written(tmp_path, new)), exact=True)
    side = INDICATOR_PLAN.on(made).indicator.sides[0]
    found = (made.reading[side.ordinate] * made.scales["indicator"].value)[0]
    ways = [np.array(points[name]) for name in ("out", "back", "out_2", "back_2")]
    for k, phi in enumerate(PHI):
        way = ways[(k - 1) // 6 if k % 12 == 6 else k // 6]
        order = np.argsort(way[:, 0])
        due = np.interp(share(phi), way[order, 0], way[order, 1])
        assert found[k] == pytest.approx(due, rel=1e-6), k


def test_forces_feel_the_gas_of_their_own_turn(tmp_path: Path) -> None:
    """Positions 2 and 14 have one velocity, but suction in the one and expansion in the other."""
    path = edited(
        tmp_path,
        ("[plans]\n", '[effects]\ngas = true\n\n[forces]\npositions = ["2", "14"]\n\n[plans]\n'),
        ('place  = ["flywheel"]', 'place  = ["flywheel", "forces"]'),
        name="four-stroke",
    )
    made = drawn_of(read(path), exact=True)
    force = made.reading[INDICATOR_PLAN.on(made).indicator.force][0]
    face = np.pi * BORE**2 / 4
    for k in (2, 14):
        due = (pressure(PHI[k : k + 1])[0] - AIR) * face
        assert force[k] == pytest.approx(due, rel=1e-5)


LAST = '  { stroke = "back", to = 0.0, p = "110 kPa", n = 0 },\n'
WRONG = [
    # what is replaced, by what, words of the message: the key, what is wrong, what to do
    ("strokes   = 4", "strokes   = 3", ["indicator.strokes", "2 strokes or 4"]),
    ("strokes   = 4", "strokes   = 6", ["indicator.strokes"]),
    ("turns    = 2", "turns    = 1", ["flywheel.turns", "strokes = 2", "leave turns out"]),
    ("turns    = 2", "turns    = 3", ["flywheel.turns"]),
    ("strokes   = 4\n", "", ["flywheel.turns", "strokes = 4"]),
    (LAST, "", ["indicator.cover_strokes", "end at 1", "add the last part"]),
    ("[plans]\n", '[diagrams]\nof = "B"\n\n[plans]\n', ["indicator.strokes", "[diagrams]"]),
    ("[plans]\n", '[engine]\npoint = "B"\n\n[plans]\n', ["indicator.strokes", "[engine]"]),
]


@pytest.mark.parametrize(("old", "new", "words"), WRONG)
def test_a_wrong_cycle_is_refused(tmp_path: Path, old: str, new: str, words: list[str]) -> None:
    path = edited(tmp_path, (old, new), name="four-stroke")
    with pytest.raises(SceneError) as error:
        read(path)
    for word in words:
        assert word in str(error.value), str(error.value)


def test_two_strokes_for_four_are_refused(tmp_path: Path) -> None:
    text = (SHEETS / "four-stroke" / "scene.toml").read_text(encoding="utf-8")
    third = text.index('  { stroke = "out",  to = 1.0, p = "3.2 MPa"')
    cut = text[:third] + text[text.index("]\nshaft_strokes") :]
    with pytest.raises(SceneError, match=r"four strokes are wanted.*there are 2"):
        read(written(tmp_path, cut))


@pytest.mark.parametrize(
    ("points", "word"),
    [
        ({"out_2": [[0, 3e6], [1, 3e5]]}, "back_2"),
        ({}, "out_2"),
        ({"out_2": [[0.1, 3e6], [1, 3e5]], "back_2": [[1, 1e5], [0, 1e5]]}, "out_2"),
    ],
)
def test_points_of_strokes_that_are_not_there_are_refused(
    tmp_path: Path, points: dict[str, object], word: str
) -> None:
    given = {"out": [[0, 9e4], [1, 9e4]], "back": [[1, 9e4], [0, 1e6]], **points}
    told = ", ".join(f"{name} = {json.dumps(value)}" for name, value in given.items())
    text = (SHEETS / "four-stroke" / "scene.toml").read_text(encoding="utf-8")
    start, end = text.index("cover_strokes"), text.index("[flywheel]")
    with pytest.raises(SceneError, match=word):
        read(written(tmp_path, text[:start] + f"cover_points = {{ {told} }}\n\n" + text[end:]))


def test_a_third_stroke_of_two_is_refused(tmp_path: Path) -> None:
    old = 'mu_p   = "1500 Pa/mm"'
    text = (SHEETS / "engine" / "scene.toml").read_text(encoding="utf-8")
    start, end = text.index("cover  = ["), text.index(old)
    two = "out = [[0, 3e5], [1, 3e4]], back = [[1, 3e4], [0, 1e5]]"
    told = f"cover_points = {{ {two}, out_2 = [[0, 1], [1, 1]] }}\n"
    with pytest.raises(SceneError, match=r"out_2.*only a cycle of four strokes"):
        read(written(tmp_path, text[:start] + told + text[end:]))


def test_pressures_are_wanted_for_both_turns(tmp_path: Path) -> None:
    path = edited(tmp_path, ("[flywheel]\n", "[flywheel]\nturns = 2\n"))
    text = path.read_text(encoding="utf-8").replace("bore   =", "strokes = 4\nbore   =")
    with pytest.raises(SceneError, match="12 pressures for 24 positions"):
        read(written(tmp_path, text))


def test_a_cycle_of_loads_alone_takes_one_turn(tmp_path: Path) -> None:
    path = edited(tmp_path, ("delta", "turns = 2\ndelta"), name="windrower")
    with pytest.raises(SceneError, match=r"flywheel.turns.*leave turns out"):
        read(path)


@pytest.mark.slow
def test_a_cycle_of_loads_by_time_takes_the_turns_of_their_times(tmp_path: Path) -> None:
    """At 380 rpm two turns take 6/19 s; a wheel for them is that of the same loads by the angle."""
    turn = 3.0 / 19.0
    tables = {
        "by_angle": '[[0, "0 N"], [200, "190 N"], [600, "40 N"], [720, "0 N"]]',
        "by_time": f'[[0, "0 N"], ["{200 / 360 * turn!r} s", "190 N"], ["{600 / 360 * turn!r} s", '
        f'"40 N"], ["{2 * turn!r} s", "0 N"]]',
    }
    inertia = []
    for key, table in tables.items():
        folder = tmp_path / key
        folder.mkdir()
        text = source("windrower").replace('force = "190 N"', f"{key} = {table}")
        text = text.replace("delta ", "turns = 2\ndelta ")
        diagrams = text.index("[diagrams]")
        text = text[:diagrams] + text[text.index("\n[", diagrams + 1) :].replace('"diagrams", ', "")
        made = graphic_tmm.draw(written(folder, text), exact=True)
        inertia.append(made.results["J_fly"].value)
    assert inertia[0] == pytest.approx(inertia[1], rel=1e-9)
