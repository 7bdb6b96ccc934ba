"""Motion as Python users ask for it: of what `draw` takes, as a data frame; what a line or a cell shows."""

from __future__ import annotations

import base64
import sys
import tomllib
import types
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.scenes import SECTIONS, slider_crank

import graphic_tmm as tmm

TEXT = slider_crank('speed = "30 1/s"\npositions = 4\n') + SECTIONS["load"] + SECTIONS["forces"]
ANGLES = np.array([20.0, 140.0, 275.0])


@pytest.fixture
def pandas(monkeypatch: pytest.MonkeyPatch) -> None:
    """What of pandas is asked for, where it may be missing."""
    frames = types.SimpleNamespace(DataFrame=dict)
    monkeypatch.setitem(sys.modules, "pandas", frames)


def test_motion_takes_what_draw_takes(tmp_path: Path) -> None:
    file = tmp_path / "scene.toml"
    file.write_text(TEXT, encoding="utf-8")
    due = tmm.motion(tmm.read(TEXT), ANGLES, "B", exact=True)["B"].place
    for source in (TEXT, TEXT.encode(), tomllib.loads(TEXT), file, str(file), tmp_path):
        np.testing.assert_array_equal(tmm.motion(source, ANGLES, "B", exact=True)["B"].place, due)
    # r cos φ + √(l² − r² sin² φ), by hand
    phi = np.radians(ANGLES)
    np.testing.assert_allclose(due, 0.1 * np.cos(phi) + np.sqrt(0.35**2 - (0.1 * np.sin(phi)) ** 2))
    with pytest.raises(tmm.SceneError, match="nowhere"):
        tmm.motion("nowhere", 0.0)


def test_motion_is_a_data_frame(pandas: None) -> None:
    found = tmm.motion(
        TEXT, ANGLES, ["A", "B"], exact=True, plans=["positions", "velocities", "forces"]
    )
    frame: dict[str, Any] = found.to_pandas()
    names = [
        "angle_deg",
        "A.x",
        "A.y",
        "A.vx",
        "A.vy",
        "B.x",
        "B.y",
        "B.vx",
        "B.vy",
        "omega1",
        "omega2",
    ]
    assert set(names) <= set(frame)
    assert not any("epsilon" in name or ".a" in name for name in frame)
    phi = np.radians(ANGLES)
    np.testing.assert_allclose(frame["A.x"], 0.1 * np.cos(phi))
    np.testing.assert_allclose(frame["A.vy"], 30.0 * 0.1 * np.cos(phi))
    np.testing.assert_array_equal(frame["angle_deg"], ANGLES)
    # virtual power: the force at the crank pin gives what the load, against the velocity, takes
    power = frame["P_bal_lever"] * 30.0 * 0.1
    load = -120.0 * np.abs(frame["B.vx"])
    np.testing.assert_allclose(power + load, 0.0, atol=1e-9)
    assert {"R12.x", "R12.y"} <= set(frame)
    assert {len(row) for row in frame.values()} == {3}


def test_points_that_links_differ_in_are_told_with_their_link(pandas: None) -> None:
    frame = tmm.motion("tangent-mechanism", [30.0, 50.0]).to_pandas()
    letters = {name.partition(".")[0] for name in frame}
    assert not {name.partition("(")[0] for name in letters if "(" in name} & letters


def test_motion_without_pandas_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(tmm.MissingError, match="pip install pandas"):
        tmm.motion(TEXT, 0.0).to_pandas()


def test_what_is_shown_of_large_scenes_is_a_line() -> None:
    points = "".join(f", Z{k} = [0.0{k}, 0.01]" for k in range(1, 10))
    scene = tmm.read(slider_crank('speed = "30 1/s"\npositions = 4\n', points=points))
    shown = [repr(scene), repr(tmm.draw(scene)), repr(tmm.motion(scene, ANGLES))]
    for one in (*shown, repr(tmm.read("project"))):
        assert len(one) < 200
        assert "\n" not in one
    assert shown[0] == "<Scene 'T' of scene, 3 moving links>"
    assert "points O, A, B, Z1, Z2, ...;" in shown[2]


def test_a_notebook_shows_the_first_sheet_of_what_is_drawn() -> None:
    title = "<script>alert(1)</script>"
    drawn = tmm.draw(tmm.read(TEXT).with_(title=title))
    shown = drawn._repr_html_()
    assert "<script" not in shown
    data = shown.partition("base64,")[2].partition('"')[0]
    assert base64.b64decode(data).decode() == drawn.sheets[0].svg
    more = len(drawn.sheets) - 1
    assert (f"and {more} more: .sheets" in shown) == (more > 0)


@pytest.mark.slow
def test_a_notebook_is_told_why_there_is_no_sheet() -> None:
    scene = tmm.read(TEXT).with_({"title": "<b>T", "scales.mu_l": "0.00001 m/mm"})
    shown = tmm.draw(scene)._repr_html_()
    assert "<b>T" not in shown
    assert "&lt;b&gt;T" in shown
    assert "<img" not in shown
    assert "mu_l" in shown
