"""Which curves are smooth and which are taut: by the plans that record them, and by random mechanisms."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.flywheels import crank, scene_of, slopes
from support.scenes import written

from graphic_tmm.board.operations import graph_curves as c
from graphic_tmm.board.operations.graphs import erect
from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read

Motion = Callable[[np.ndarray], np.ndarray]


def slider(rng: np.random.Generator) -> Motion:
    """The travel of a crank's slider, m per m of the crank."""
    ratio, offset = rng.uniform(0.15, 0.5), rng.uniform(-0.3, 0.3)
    return lambda phi: np.cos(phi) + np.sqrt(1 / ratio**2 - (offset - np.sin(phi)) ** 2)


def shaper(rng: np.random.Generator) -> Motion:
    """That of a shaper's tool: a rocker driven by a crank at a distance, and a rod."""
    far, arm = rng.uniform(1.3, 2.5), rng.uniform(1.0, 3.0)
    rod = arm * rng.uniform(1.0, 3.0)

    def travel(phi: np.ndarray) -> np.ndarray:
        way = far + 1j * np.exp(-1j * phi)
        tip = arm * way / np.abs(way)
        return np.asarray(tip.imag + np.sqrt(rod**2 - (tip.real - 0.9 * arm) ** 2))

    return travel


def velocity(travel: Motion, phi: np.ndarray) -> np.ndarray:
    return (travel(phi + 1e-4) - travel(phi - 1e-4)) / 2e-4


def acceleration(travel: Motion, phi: np.ndarray) -> np.ndarray:
    return (travel(phi + 1e-3) - 2 * travel(phi) + travel(phi - 1e-3)) / 1e-6


def by_chords(kind: str, travel: Motion, count: int, phase: float) -> tuple[float, float]:
    """The error at the boundaries, and how far the curve leaves its neighbours; shares of the largest."""
    step = 2 * np.pi / count
    phi = phase + np.arange(count) * step
    v = velocity(travel, phi)
    middles = (np.roll(v, -1) - v) / step
    x = np.arange(count) + 0.5
    op = c.taut_graph if kind == "taut" else c.closed_graph
    curve = op.run((x + 1j * middles)[None, :], np.array([[float(count)]]), row=count)
    if kind == "spline":
        m = slopes(middles)
        curve = curve._replace(tangents=1 + 1j * np.concatenate([m[-1:], m, m[:1]])[None, :])
    read = erect.run(curve, np.arange(count)[None, :] + 0j).imag[0]
    due = acceleration(travel, phi)
    size = np.abs(acceleration(travel, np.linspace(0, 2 * np.pi, 1440))).max()
    fine = np.linspace(0, count, 40 * count + 1)
    along = erect.run(curve, fine[None, :-1] + 0j).imag[0]
    k = np.floor(fine[:-1] - 0.5).astype(int)
    ends = np.array([middles[k % count], middles[(k + 1) % count]])
    out = np.maximum(along - ends.max(axis=0), ends.min(axis=0) - along).max()
    return float(np.abs(read - due).max() / size), float(out / size)


def measured(make: Callable[[np.random.Generator], Motion], count: int) -> dict[str, np.ndarray]:
    found: dict[str, list[tuple[float, float]]] = {"spline": [], "smooth": [], "taut": []}
    rng = np.random.default_rng(count)
    for _ in range(60):
        travel, phase = make(rng), rng.uniform(0, 2 * np.pi)
        for kind, rows in found.items():
            rows.append(by_chords(kind, travel, count, phase))
    return {kind: np.array(rows) for kind, rows in found.items()}


@pytest.mark.parametrize("count", [12, 24])
def test_accelerations_of_a_slider_crank_need_the_smooth_curve(count: int) -> None:
    """A taut one is as wrong as the peak that it cuts off; the smooth one is the spline within a hair."""
    found = {kind: np.median(rows[:, 0]) for kind, rows in measured(slider, count).items()}
    assert found["taut"] > 1.7 * found["smooth"]
    assert found["smooth"] == pytest.approx(found["spline"], rel=0.05)


@pytest.mark.parametrize("count", [12, 24])
def test_accelerations_of_a_quick_return_do_not_ring(count: int) -> None:
    found = measured(shaper, count)
    error = {kind: np.median(rows[:, 0]) for kind, rows in found.items()}
    out = {kind: np.max(rows[:, 1]) for kind, rows in found.items()}
    assert out["spline"] > 0.15
    assert out["smooth"] < out["spline"] / 1.5
    assert out["taut"] < 1e-12
    assert error["smooth"] < 1.05 * error["spline"]


def test_a_given_peak_is_met(tmp_path: Path) -> None:
    """Two equal chords at a slider's dead centre: 105.8 and 105.8 m/s² of 123.4 read 118, not 106."""
    phi = 2 * np.pi * np.arange(8) / 8
    travel: Motion = lambda x: 0.15 * np.cos(x) + np.sqrt(0.75**2 - (0.15 * np.sin(x)) ** 2)  # noqa: E731
    v = velocity(travel, phi) * 250 * np.pi / 30
    middles = (np.roll(v, -1) - v) / (60 / 250 / 8)
    points = (np.arange(8) + 0.5 + 1j * middles)[None, :]
    read = {
        op.name: erect.run(op.run(points, np.array([[8.0]]), row=8), np.zeros((1, 1), complex))
        for op in (c.closed_graph, c.taut_graph)
    }
    assert abs(read["closed_graph"].imag[0, 0]) == pytest.approx(118.3, abs=0.1)
    assert abs(read["taut_graph"].imag[0, 0]) == pytest.approx(105.8, abs=0.1)


def curves(made: Drawn) -> dict[str, str]:
    log = made.project.construction
    names = {"taut_graph", "closed_graph", "open_graph", "graph_of_rays", "graph_of_differences"}
    return {
        f"{s.it.view} {s.it.letter}": s.op.name
        for s in log.steps
        if s.op.name in names | {"curve_of_two"}
    }


def test_what_drives_is_taut_and_what_moves_is_smooth(tmp_path: Path) -> None:
    text = scene_of(crank(1), 12)
    more = '[engine]\npoint = "B"\n[diagrams]\npoint = "B"\nstart = "velocity"\n[hand]'
    text = text.replace("[hand]", more).replace(
        '"flywheel"]', '"flywheel", "engine diagrams", "diagrams"]'
    )
    file = written(tmp_path, text)
    found = curves(drawn_of(read(file), exact=True))
    smooth = {"diagram V (v–v)", "diagram a (a′–a′)", "energy (l–l)", "engine P (f–f)"}
    taut = {"moment (k–k)", "engine P (p–p)", "engine P (p′–p′)"}
    taut |= {f"engine {x} ({x.lower()}–{x.lower()})" for x in "NQTK"} | {"engine M (z–z)"}
    assert {key for key, op in found.items() if op == "closed_graph"} == smooth
    assert {key for key, op in found.items() if op == "taut_graph"} == taut
    assert found["work (A–A)"] == found["energy (g–g)"] == "graph_of_rays"
    assert found["energy (f–f)"] == "graph_of_differences"
    assert found["energy-mass (e–e)"] == "curve_of_two"
    assert found["diagram S (s′–s′)"] == "open_graph"


def test_a_constant_pressure_over_three_positions_is_a_level_line(tmp_path: Path) -> None:
    text = scene_of(crank(2), 12)
    row = text[text.index("cover = [") : text.index("]", text.index("cover = ["))]
    level = "cover = [" + ", ".join(["9e5"] * 3 + ["5e5", "3e5", "2e5", "1e5"] + ["1e5"] * 5)
    text = text.replace(row, level).replace("[hand]", '[engine]\npoint = "B"\n[hand]')
    file = written(tmp_path, text.replace('"flywheel"', '"engine diagrams"'))
    made = drawn_of(read(file), exact=True)
    step = next(
        s for s in made.project.construction.steps
        if s.it.view == "engine P" and s.op.name == "taut_graph"
    )  # fmt: skip
    curve = made.reading[step.it]
    x = curve.knots[0].real
    along = erect.run(curve, np.linspace(x[1], x[3], 50)[None, :] + 0j).imag[0]
    assert np.ptp(along) <= 1e-12 * along.max()
    behind = erect.run(curve, np.linspace(x[7], x[12], 50)[None, :] + 0j).imag[0]
    assert np.ptp(behind) <= 1e-12 * along.max()
