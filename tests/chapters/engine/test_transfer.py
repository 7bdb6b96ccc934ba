"""The figure of all forces: its vectors against plain trigonometry, its ink against the log."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import shapely
from support.boards import drawn_of
from support.each import each
from support.engines import SCENE
from support.gallery import SHEETS, asking, drawn
from support.graphs import assert_read_off_the_log
from support.scenes import edited

from graphic_tmm.chapters.engine.ink_transfer import TransferFigure, draw_all_forces
from graphic_tmm.chapters.engine.record import BESIDE
from graphic_tmm.chapters.engine.table import engine_columns
from graphic_tmm.chapters.engine.task import TRANSFER as VIEW
from graphic_tmm.chapters.engine.transfer import Transfer
from graphic_tmm.chapters.engine.views import transfer_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.scene.read import read

R, LAMBDA = 0.115, 0.182
"""The book's locomobile: m, R/l."""
ENGINES = asking("engine")


@cache
def exact() -> Drawn:
    return drawn_of(read(SHEETS / "locomobile"), exact=True)


def column(made: Drawn, name: str) -> np.ndarray:
    return next(one for one in engine_columns(made) if one.segment == name).value[0]


def vectors(made: Drawn) -> dict[str, np.ndarray]:
    """The vectors of the figure as complex forces along the row, by where they act and their letter."""
    found, reading = BESIDE.on(made).transfer, made.reading
    mu = made.scales[VIEW].value
    named: dict[str, np.ndarray] = {}
    for one in found.vectors:
        sign = "-" if one.against else ""
        at = "OABCD"[found.points.index(one.start)]
        named[f"{sign}{one.letter}@{at}"] = (reading[one.end] - reading[one.start])[0] * mu
    return named


def by_trigonometry(p_gas: np.ndarray, p: np.ndarray, phi: np.ndarray) -> dict[str, np.ndarray]:
    """The same of a level engine, its crank turning counter-clockwise from the dead centre at the right."""
    beta = np.arcsin(LAMBDA * np.sin(phi))
    q = p / np.cos(beta) * np.exp(1j * (math.pi - beta))
    normal = -1j * p * np.tan(beta)
    tangent = p * np.sin(phi + beta) / np.cos(beta) * 1j * np.exp(1j * phi)
    radial = -p * np.cos(phi + beta) / np.cos(beta) * np.exp(1j * phi)
    return {
        "P@C": -p_gas + 0j,
        "-P@D": p_gas + 0j,
        "P′@B": -p + 0j,
        "Q@B": q,
        "N@B": normal,
        "Q@A": q,
        "T@A": tangent,
        "K@A": radial,
        "Q@O": q,
        "-Q@O": -q,
        "P′@O": -p + 0j,
        "-N@O": -normal,
    }


def assert_forces(made: Drawn, turned: np.ndarray) -> None:
    p_gas, p = column(made, "P"), column(made, "P′")
    due = by_trigonometry(p_gas, p, turned)
    found = vectors(made)
    assert found.keys() == due.keys()
    for name, values in due.items():
        np.testing.assert_allclose(found[name], values, atol=4e-6 * np.abs(p).max(), err_msg=name)


def test_every_force_is_where_and_as_trigonometry_has_it() -> None:
    assert_forces(exact(), np.radians(np.arange(12) * 30.0))


def test_forces_add_up_as_the_book_says() -> None:
    """P′ = Q + N at the crosshead, Q = T + K at the pin, Q = P′ − N at the bearing; P, −P and Q, −Q cancel."""
    found = vectors(exact())
    for whole, parts in (("P′@B", "Q N"), ("Q@A", "T K")):
        one, other = (found[f"{part}@{whole[-1]}"] for part in parts.split())
        np.testing.assert_allclose(found[whole], one + other, atol=1e-8)
    np.testing.assert_allclose(found["Q@O"], found["P′@O"] + found["-N@O"], atol=1e-8)
    for one, other in (("P@C", "-P@D"), ("Q@O", "-Q@O"), ("N@B", "-N@O")):
        np.testing.assert_allclose(found[one] + found[other], 0.0, atol=1e-8)


def test_both_couples_are_the_turning_moment() -> None:
    """M = T·R = Q·h and M′ = N·OB: formulas (343) and (344)."""
    made = exact()
    found = BESIDE.on(made).transfer
    for mark in found.moments:
        np.testing.assert_allclose(made.reading[mark][0], column(made, "M"), atol=1e-8)
    phi = np.radians(np.arange(12) * 30.0)
    beta = np.arcsin(LAMBDA * np.sin(phi))
    p = column(made, "P′")
    m = p * R * np.sin(phi + beta) / np.cos(beta)
    np.testing.assert_allclose(made.reading[found.moments[1]][0], m, atol=1e-6 * np.abs(m).max())


def test_the_figure_reads_what_the_triangles_read() -> None:
    made = exact()
    read_ = BESIDE.on(made).transfer.read
    for name in "QNTK":
        np.testing.assert_allclose(
            made.reading[read_[name]][0], column(made, name), atol=1e-8, err_msg=name
        )


def test_the_piston_stands_in_its_cylinder() -> None:
    """The cover stands still; the piston comes nearest at the dead centre, by the clearance, and never out."""
    made = exact()
    *_, piston, cover = (made.reading[mark][0] for mark in BESIDE.on(made).transfer.points)
    gaps = (cover - piston).real
    assert np.ptp(np.broadcast_to(cover, 12).real) == 0.0
    assert gaps.argmin() == 0
    assert gaps[0] == pytest.approx(12.0)
    assert gaps[6] - gaps[0] == pytest.approx(2 * R / made.scales["positions"].value)


def ink_of(view: Drawing, part: str) -> list[shapely.LineString]:
    """The straight strokes of a part of the machine."""
    strokes = [s for s in view.strokes if isinstance(s, Stroke) and s.part == part]
    paths = [[(x, y) for x, y, _ in (*s.path, *s.path[: s.closed])] for s in strokes]
    return [shapely.LineString(path) for path in paths]


def test_the_piston_rod_ends_at_the_piston_and_does_not_enter_it() -> None:
    """From the crosshead to the middle of the piston's face on that side."""
    made = exact()
    *_, crosshead, piston, _ = (made.reading[mark][0] for mark in BESIDE.on(made).transfer.points)
    for k, view in enumerate(pictures(made)[:7:3]):
        (head,) = ink_of(view, "piston")
        rod = ink_of(view, "link")[-1]
        reach = abs(piston[3 * k] - crosshead[3 * k])
        assert rod.length == pytest.approx(reach - np.ptp(np.array(head.coords)[:, 0]), abs=1e-9)
        assert rod.intersection(shapely.Polygon(head.coords)).length < 1e-9
        assert rod.distance(head) < 1e-9


def pictures(work: Drawn) -> list[Drawing]:
    """The figure in every position of the row."""
    made: Transfer = BESIDE.on(work).transfer
    log, reading = work.construction, work.reading
    sense = work.scene.mechanism.drive.sense  # type: ignore[union-attr]
    shown = [TransferFigure(k, 40.0, "N", sense) for k in range(work.project.count)]
    return [draw_all_forces(Subject(log, reading, "X"), made, one) for one in shown]


@each("name", ENGINES)
@pytest.mark.slow
def test_it_is_read_off_the_log(name: str) -> None:
    work = drawn(name, exact=True)
    assert_read_off_the_log(work.construction, map(finished, pictures(work)), {"measure"})


@each("crank", ["0.05", "0.19"])
@pytest.mark.slow
def test_upright_engines_with_other_letters(crank: str, tmp_path: Path) -> None:
    path = tmp_path / "upright.toml"
    path.write_text(SCENE.replace('"100 mm"', crank), encoding="utf-8")
    work = drawn_of(read(path), exact=True)
    assert_read_off_the_log(work.construction, map(finished, pictures(work)), {"measure"})


def arrow_tips(view: Drawing) -> dict[str, complex]:
    """The tips of the told arrows by segment: the head follows its shaft."""
    found = {}
    strokes = [one for one in view.strokes if isinstance(one, Stroke)]
    for shaft, head in pairwise(strokes):
        if "segment" in dict(shaft.data):
            found.setdefault(dict(shaft.data)["segment"], complex(*head.path[0][:2]))
    return found


def test_the_arrows_are_the_vectors() -> None:
    made = exact()
    found, k = BESIDE.on(made).transfer, 2
    tips = arrow_tips(pictures(made)[k])
    for one in found.vectors:
        if not one.against and one.letter in "TKN":
            due = complex(made.reading[one.end][0, k])
            assert abs(tips[one.letter] - due) < 1e-9, one.letter


def test_a_clockwise_crank_mirrors_the_figure(tmp_path: Path) -> None:
    path = edited(tmp_path, ('"counterclockwise"', '"clockwise"'), name="locomobile")
    other, one = vectors(drawn_of(read(path), exact=True)), vectors(exact())
    for name, values in one.items():
        np.testing.assert_allclose(other[name], np.conj(values), atol=1e-6, err_msg=name)


def test_other_cranks_and_rods_by_trigonometry(tmp_path: Path) -> None:
    """Positions between the twelve, too: 17 of them."""
    scene = read(SHEETS / "locomobile")
    made = drawn_of(replace(scene, row=replace(scene.row, count=17)), exact=True)
    assert_forces(made, np.arange(17) * 2 * math.pi / 17)


def test_its_letters_are_all_there() -> None:
    (view,) = transfer_views(exact(), True)
    assert view.shows == (VIEW,)
    texts = [label.text for label in view.labels]
    for part in ("φ", "β", "φ + β", "M", "M′", "h", "OB", "−\\bar{P}", "−\\bar{Q}", "−\\bar{N}"):
        assert part in texts, part


def test_the_protocol_tells_it_with_reasons() -> None:
    text = "\n".join(protocol(exact(), ("engine",), "2", "ru", why=True))
    for part in ("Передача усилий", "M′ = N·OB", "R·sin(φ + β)", "−P"):
        assert part in text, part


def test_the_angles_are_drawn_as_they_are() -> None:
    """The arc of φ begins on the cylinder's line and ends on the crank, that of φ + β on the rod's line."""
    made = exact()
    view, k = pictures(made)[2], 2
    reading, points = made.reading, BESIDE.on(made).transfer.points
    o, a, b, *_ = (
        complex(reading[mark][0, k if reading[mark].shape[1] > 1 else 0]) for mark in points
    )
    arcs = [s for s in view.strokes if isinstance(s, Stroke) and s.part == "angle"]
    ends = [[complex(x, y) for x, y, _ in (s.path[0], s.path[-1])] for s in arcs]
    ways = ((o, 1, a - o), (b, o - b, a - b), (a, o - a, a - b))
    for (vertex, first, last), (start, end) in zip(ways, ends, strict=True):
        assert cmath.phase((start - vertex) / first) == pytest.approx(0.0, abs=1e-9)
        assert cmath.phase((end - vertex) / last) == pytest.approx(0.0, abs=1e-9)
