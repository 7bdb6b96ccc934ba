"""Passive links on the plans, against closed forms; what does not fit is refused by how much and where."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of

import graphic_tmm
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.structure.table import aside_lines, link_rows, structure_lines
from graphic_tmm.errors import StructureError
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.readers.table import columns_of
from graphic_tmm.scene.read import read

R, BASE, OMEGA = 0.3, 0.75, 2.0 * np.pi
HEAD = """
title = "T"
language = "en"
[frame]
O = [0, 0]
{frame}
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.3, 0] }}
{links}
[drive]
link = 1
speed = "60 rpm"
zero = "17 deg"
positions = 8
accelerations = "all"
"""
CRANKS = """
[[link]]
number = 2
points = { A = [0, 0], B = [0.75, 0], C = [1.5, 0] }
[[link]]
number = 3
points = { D = [0, 0], B = [0.3, 0] }
side = "left of AD"
flips_at = ["0 deg", "180 deg"]
[[link]]
number = 4
passive = true
points = { E = [0, 0], C = [LONG, 0], K = [0.15, 0.12] }
"""
TRAMMEL = """
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0], C = [-0.3, 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right", flips_at = ["90 deg", "270 deg"] }
[[link]]
number = 4
passive = true
points = { C = [0, 0], K = [0.1, 0.05] }
slides = { on = "frame", along = "y" }
"""
GUIDES = 'x = { through = [0, 0], angle = 0 }\ny = { through = [OFF, 0], angle = "90 deg" }'


def scene_of(folder: Path, links: str, frame: str) -> Path:
    """Write a scene; return its file."""
    path = folder / "scene.toml"
    path.write_text(HEAD.format(frame=frame, links=links), encoding="utf-8")
    return path


def cranks(folder: Path, long: float = 0.3, at: float = 1.5) -> Path:
    """Write the scene of three parallel cranks; ``long``, ``at``: of the third, m."""
    return scene_of(folder, CRANKS.replace("LONG", repr(long)), f"D = [0.75, 0]\nE = [{at!r}, 0]")


def trammel(folder: Path, off: float = 0.0) -> Path:
    """Write the scene of a trammel with a second stone; ``off``: of its guide, m."""
    return scene_of(folder, TRAMMEL, GUIDES.replace("OFF", repr(off)))


ANGLES = np.array([3.0, 47.0, 91.0, 170.0, 222.0, 310.0])
TURN = np.exp(1j * np.radians(ANGLES))


@pytest.mark.parametrize("fast", [False, True])
def test_the_third_of_parallel_cranks_turns_as_the_first(tmp_path: Path, fast: bool) -> None:
    found = graphic_tmm.motion(cranks(tmp_path), ANGLES, exact=True, fast=fast)
    for letter, own in (("C", 0.3), ("K", 0.15 + 0.12j)):
        due = own * TURN
        np.testing.assert_allclose(found.places[letter, 4], 1.5 + due, atol=1e-12)
        np.testing.assert_allclose(found.velocities[letter, 4], 1j * OMEGA * due, atol=1e-11)
        np.testing.assert_allclose(found.accelerations[letter, 4], -(OMEGA**2) * due, atol=1e-9)
    np.testing.assert_array_equal(found.places["C", 4], found.places["C", 2])
    np.testing.assert_allclose(found.omega[4], OMEGA, rtol=1e-12)
    np.testing.assert_allclose(found.epsilon[4], 0.0, atol=1e-9)


def test_a_second_stone_goes_along_its_guide(tmp_path: Path) -> None:
    found = graphic_tmm.motion(trammel(tmp_path), ANGLES, exact=True)
    due = 2j * R * TURN.imag
    np.testing.assert_allclose(found.places["C", 4], due, atol=1e-12)
    # its own axis lies along the guide, which goes up
    np.testing.assert_allclose(found.places["K", 4] - due, 1j * (0.1 + 0.05j), atol=1e-12)
    for letter in ("C", "K"):
        np.testing.assert_allclose(
            found.velocities[letter, 4], 2j * R * OMEGA * TURN.real, atol=1e-11
        )
        np.testing.assert_allclose(found.accelerations[letter, 4], -(OMEGA**2) * due, atol=1e-9)


def test_it_counts_for_nothing_and_is_drawn_by_a_step_of_its_own(tmp_path: Path) -> None:
    drawn = drawn_of(read(cranks(tmp_path)))
    plans = KINEMATICS_PLAN.on(drawn)
    assert plans.structure.mobility == 1
    assert plans.structure.formula == "I(1) → II(2-3)"
    assert [one.link for one in plans.positions.passive] == [4]
    names = [f.name for f in drawn.construction.figures if f.kind == "link"]
    assert names == ["1", "2", "3", "4"]
    told = protocol(drawn, ["positions"], None, "en")
    assert any("Draw the line (EC) through E and C" in line for line in told)
    (line,) = aside_lines(plans.mechanism, plans.structure, "en")
    assert (
        "Link 4 is passive: with its pairs R_{E}(0,4), R_{C}(2,4) W would be 3·4 − 2·6 = 0" in line
    )
    assert line in structure_lines(plans.mechanism, plans.structure, "en")
    rows = link_rows(plans.mechanism, plans.structure, "en")
    assert ["4", "rocker", "passive"] in rows


def test_forces_are_those_without_it(tmp_path: Path) -> None:
    loads = """
[effects]
gravity = true
[[load]]
link = 3
moment = "40 N*m"
[forces]
"""
    heavy = CRANKS.replace("number = 2\n", 'number = 2\nmass = 20\ncentre = "C"\n')
    short = heavy[: heavy.index("[[link]]\nnumber = 4")]
    found = []
    for k, links in enumerate((heavy.replace("LONG", "0.3"), short)):
        folder = tmp_path / str(k)
        folder.mkdir()
        path = scene_of(folder, links + loads, "D = [0.75, 0]\nE = [1.5, 0]")
        found.append(graphic_tmm.motion(path, ANGLES, plans="forces", exact=True))
    whole, without = found
    assert whole.forces.keys() == without.forces.keys()
    for name, force in whole.forces.items():
        np.testing.assert_array_equal(force, without.forces[name])


@pytest.mark.parametrize("long", [0.3, 0.30002])
def test_what_is_off_by_rounding_fits(tmp_path: Path, long: float) -> None:
    drawn_of(read(cranks(tmp_path, long)))


def test_what_does_not_fit_is_refused_by_how_much_and_where(tmp_path: Path) -> None:
    with pytest.raises(
        StructureError, match=r"link 4.*length EC is 280 mm.*keeps 300 mm.*20 mm off"
    ):
        drawn_of(read(cranks(tmp_path, 0.28)))
    # C goes round (1500, 0) at 300 mm, E stands 40 mm to the right of that: 260 to 340 mm
    with pytest.raises(
        StructureError,
        match=r"260 mm \(at φ = 0°\) to 340 mm \(at φ = 180°\), so it is up to 40 mm off",
    ):
        drawn_of(read(cranks(tmp_path, at=1.54)))
    with pytest.raises(StructureError, match=r"offset from its guide is 0 mm.*write 20 mm"):
        drawn_of(read(trammel(tmp_path, 0.02)))
    off = TRAMMEL.replace('along = "y" }', 'along = "y", offset = 0.01 }')
    with pytest.raises(StructureError, match=r"is 10 mm, .* so it is 10 mm off; write 0 mm"):
        drawn_of(read(scene_of(tmp_path, off, GUIDES.replace("OFF", "0"))))


def test_pins_of_a_passive_link_rub_as_others_do() -> None:
    """The third crank turns as the first does, on a rod that does not turn: at ω in both of its pins."""
    frame = "D = [0.75, 0]\nE = [1.5, 0]"
    text = HEAD.format(frame=frame, links=CRANKS.replace("LONG", "0.3"))
    drawn = drawn_of(
        graphic_tmm.read(f'{text}[rows]\npins = {{ E = "10 mm", C = "20 mm" }}\n'), exact=True
    )
    told = {column.segment: column.value for column in columns_of(drawn)}
    np.testing.assert_allclose(told["vE04"], 0.01 * OMEGA, rtol=1e-9)
    np.testing.assert_allclose(told["vC24"], 0.02 * OMEGA, rtol=1e-9)
