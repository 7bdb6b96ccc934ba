"""Force triangles of an upright engine with other letters: P′ = Q + N, Q = K + T, tip to tail."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path

import pytest
from support.engines import SCENE

from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.views import alone
from graphic_tmm.readers.table import scene_results
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make, sheets


@pytest.fixture(scope="module")
def views(tmp_path_factory: pytest.TempPathFactory) -> list[Drawing]:
    path = tmp_path_factory.mktemp("engine") / "upright.toml"
    path.write_text(SCENE, encoding="utf-8")
    _, paper = sheets(read(path))
    found = [d for s in paper for d in s.drawings if d.name.startswith("engine-")]
    assert len(found) == 8
    return found


def arrows(view: Drawing) -> dict[str, list[tuple[complex, complex]]]:
    """The arrows of a view by their letters: where they begin, and the tips of their heads."""
    found: dict[str, list[tuple[complex, complex]]] = {}
    strokes = [s for s in view.strokes if isinstance(s, Stroke)]
    for shaft, head in pairwise(strokes):
        if "segment" in dict(shaft.data):
            ends = complex(*shaft.path[0][:2]), complex(*head.path[0][:2])
            found.setdefault(dict(shaft.data)["segment"], []).append(ends)
    return found


@pytest.mark.slow
def test_the_pressure_on_the_guide_ends_where_the_whole_force_does(views: list[Drawing]) -> None:
    triangles = [found for found in map(arrows, views) if {"P′", "N", "Q", "T", "K"} <= set(found)]
    assert (
        len(triangles) >= 4
    )  # there is no N and no T at the dead centres, nor where P′ is too small
    for found in triangles:
        (whole,), (pressure,) = found["P′"], found["N"]
        along, carried = found["Q"]
        assert along[0] == pytest.approx(whole[0], abs=1e-6)  # P′ = Q + N, tip to tail
        assert along[1] == pytest.approx(pressure[0], abs=1e-6)
        assert pressure[1] == pytest.approx(whole[1], abs=1e-6)
        run = pressure[1] - pressure[0]
        assert abs(run.imag) < 1e-6 * abs(run)  # square to the upright guide
        (tangential,), (radial,) = found["T"], found["K"]
        assert carried[1] - carried[0] == pytest.approx(along[1] - along[0], abs=1e-6)
        assert radial[1] == pytest.approx(carried[1], abs=1e-6)
        assert tangential[0] == pytest.approx(carried[0], abs=1e-6)


def test_the_words_say_the_same(views: list[Drawing]) -> None:
    for view in views:
        own = alone(view).labels
        assert any("\\bar{P}′ = \\bar{Q} + \\bar{N}" in label.text for label in own)
    assert captions("en")["view engine N"] == "Pressure N on the guide"
    assert captions("ru")["view engine N"] == "Давление на направляющую N"


def test_pins_bear_the_letters_of_the_scene_and_the_slider_lies_along_its_guide(
    views: list[Drawing],
) -> None:
    for view in views:
        texts = [label.text for label in view.labels if label.size == 5.0]
        assert {"M", "K", "E"} <= {part for text in texts for part in text.split(", ")}
        (box,) = [s for s in view.strokes if isinstance(s, Stroke) and s.pen == "body"]
        corners = [complex(x, y) for x, y, _ in box.path]
        assert abs((corners[1] - corners[0]).real) < 1e-9


@pytest.mark.slow
def test_the_arms_of_the_rod_are_told_by_its_pins_and_not_by_the_order_of_its_letters(
    tmp_path: Path,
) -> None:
    path = tmp_path / "upright.toml"
    lines = SCENE.replace('D = ["0.1 m", 0] }', 'D = ["0.1 m", 0], F = ["1 m", 0] }')
    shuffled = lines.replace('E = ["0 mm", 0], K', 'F2 = ["-1 m", 0], E = ["0 mm", 0], K')
    found = []
    for text in (SCENE, shuffled):
        path.write_text(text, encoding="utf-8")
        found.append(scene_results(make(read(path)))["m_rod_at_slider"][0][0])
    assert found == pytest.approx([3 * 0.3 / 0.4] * 2, rel=1e-9)  # D is 300 mm from K
