"""A rotor with its counterweights is free of force and moment; bearings hold it as statics says; refusals."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import pytest
from support.boards import in_usual_size

from graphic_tmm.chapters.rotors.plan import BEARING_MOMENTS, END, MOMENTS, ROTOR_PLAN
from graphic_tmm.chapters.rotors.table import rotor_results, weight_table
from graphic_tmm.chapters.rotors.views import rotor_views
from graphic_tmm.checking.cells import RESULTS
from graphic_tmm.checking.check import check
from graphic_tmm.checking.records import FINE, WRONG, Taken
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.errors import SceneError
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read

KHURMI = [(200, 0.08, 0, -0.1), (300, 0.07, 45, 0.2), (400, 0.06, 115, 0.3), (200, 0.08, 235, 0.6)]
"""Masses, radii, angles and places from plane I of example 21.3 of Khurmi, Theory of Machines."""
Masses = Sequence[tuple[float, float, float, float]]


def scene_of(folder: Path, masses: Masses, rotor: str, *, head: str = "") -> Path:
    text = f'title = "T"\nlanguage = "en"\n{head}\n[rotor]\n{rotor}\n'
    for mass, radius, angle, at in masses:
        text += f'[[unbalance]]\nmass = {mass!r}\nradius = {radius!r}\nangle = "{angle!r} deg"\nat = {at!r}\n'
    path = folder / "scene.toml"
    path.write_text(text + '[[sheet]]\nformat = "A1"\nplace = ["rotor"]\n', encoding="utf-8")
    return path


def drawn_of(folder: Path, masses: Masses, rotor: str, *, head: str = "") -> Drawn:
    scene = read(scene_of(folder, masses, rotor, head=head))
    (found,) = in_usual_size(scene, exact=True).boards
    return found


def figures_of(drawn: Drawn) -> dict[str, float]:
    return {name: figure for name, (figure, _) in single(rotor_results(drawn)).items()}


def turned(size: float, degrees: float) -> complex:
    return cmath.rect(size, math.radians(degrees))


def vectors(masses: Masses) -> list[tuple[complex, float]]:
    return [(turned(m * r, angle), at) for m, r, angle, at in masses]


def held(found: dict[str, float], name: str) -> complex:
    size = found.get(f"rotor_D_{name}", 0.0)
    return turned(size, found[f"rotor_alpha_{name}"]) if size else 0j


def family(seed: int) -> tuple[Masses, list[float]]:
    random = np.random.default_rng(seed)
    count = int(random.integers(1, 9))
    masses = [
        (
            float(random.uniform(0.1, 5)), float(random.uniform(0.01, 0.3)),
            float(random.uniform(-360, 360)), float(random.uniform(-1, 1)),
        )
        for _ in range(count)
    ]  # fmt: skip
    places = np.sort(random.uniform(-1, 1, 2))
    return masses, [float(places[0]), float(places[1]) + 0.05]


@pytest.mark.parametrize("seed", range(40))
def test_two_planes_leave_neither_force_nor_moment(seed: int, tmp_path: Path) -> None:
    masses, planes = family(seed)
    found = figures_of(drawn_of(tmp_path, masses, f"planes = {planes}\nradius = [0.1, 0.2]"))
    every = [*vectors(masses), *zip((held(found, n) for n in ("I", "II")), planes, strict=True)]
    size = sum(abs(v) for v, _ in every)
    assert abs(sum(v for v, _ in every)) < 1e-9 * size
    assert abs(sum(v * at for v, at in every)) < 1e-9 * size
    for name, radius in (("I", 0.1), ("II", 0.2)):
        assert found[f"rotor_m_{name}"] * radius == pytest.approx(abs(held(found, name)), rel=1e-9)


@pytest.mark.parametrize("seed", range(40, 60))
def test_bearings_hold_the_rotor_as_statics_says(seed: int, tmp_path: Path) -> None:
    masses, bearings = family(seed)
    more = f"radius = 0.1\nspeed = 12.5\nbearings = {bearings}"
    found = figures_of(drawn_of(tmp_path, masses, more))
    loads = np.array([v for v, _ in vectors(masses)]) * 12.5**2
    at = np.array([at for _, at in vectors(masses)])
    # forces on the shaft and their moments about the origin: those of the bearings cancel them
    due = np.linalg.solve([[1, 1], bearings], [-loads.sum(), -(loads * at).sum()])
    size = abs(loads).sum()
    for name, force in zip("AB", due, strict=True):
        read_off = turned(found[f"rotor_R_{name}"], found[f"rotor_alpha_{name}"])
        assert abs(read_off - force) < 1e-9 * size / (bearings[1] - bearings[0])


@pytest.mark.parametrize("seed", range(60, 80))
def test_one_plane_closes_the_polygon(seed: int, tmp_path: Path) -> None:
    masses, _ = family(seed)
    by_mass = seed % 2
    found = figures_of(drawn_of(tmp_path, masses, "mass = 2.5" if by_mass else "radius = 0.4"))
    total = sum(v for v, _ in vectors(masses))
    assert abs(held(found, "k") + total) < 1e-9 * sum(abs(v) for v, _ in vectors(masses))
    assert found["rotor_m_k"] * found["rotor_r_k"] == pytest.approx(abs(total), rel=1e-9)
    assert found["rotor_m_k" if by_mass else "rotor_r_k"] == (2.5 if by_mass else 0.4)


def test_a_published_shaft(tmp_path: Path) -> None:
    """355 kg at 145° and 182.5 kg at 12°, both clockwise from mass 1, were read off by hand."""
    found = figures_of(drawn_of(tmp_path, KHURMI, "planes = [0, 0.4]\nradius = 0.1"))
    assert found["rotor_m_I"] == pytest.approx(355, rel=0.01)
    assert found["rotor_m_II"] == pytest.approx(182.5, rel=0.01)
    assert found["rotor_alpha_I"] == pytest.approx(-145, abs=2.0)
    assert found["rotor_alpha_II"] == pytest.approx(-12, abs=1.0)


@pytest.mark.parametrize("count", range(2, 8))
def test_what_is_balanced_wants_nothing(count: int, tmp_path: Path) -> None:
    masses = [(1.3, 0.07, 17.0 + 360.0 * k / count, 0.2) for k in range(count)]
    drawn = drawn_of(
        tmp_path, masses, "planes = [0, 0.4]\nradius = 0.1\nspeed = 9\nbearings = [0, 1]"
    )
    assert figures_of(drawn) == {}
    assert any("no counterweight is wanted" in one for one in warnings(drawn, "en"))
    assert len(rotor_views(drawn, lettered=True)) == 8
    rotor = ROTOR_PLAN.on(drawn)
    assert all(one.force is None and one.angle is None for one in rotor.reactions)
    assert all(drawn.reading.figure(one.size) == 0.0 for one in rotor.polygons.values())


def test_masses_in_plane_one_leave_no_moment(tmp_path: Path) -> None:
    drawn = drawn_of(tmp_path, [(1.0, 0.1, 30.0, 0.2)], "planes = [0.2, 0.5]\nradius = 0.1")
    found = figures_of(drawn)
    assert MOMENTS not in ROTOR_PLAN.on(drawn).polygons
    assert "rotor_D_II" not in found
    assert found["rotor_m_I"] == pytest.approx(1.0)
    assert found["rotor_alpha_I"] == pytest.approx(-150.0)
    told = list(warnings(drawn, "en"))
    assert any("plane II wants no counterweight" in one for one in told)
    assert any("no moment is left about it" in one for one in told)


def test_a_couple_alone_is_no_matter_at_rest(tmp_path: Path) -> None:
    """Two equal masses opposite each other, apart along the axis: balanced at rest, not in motion."""
    masses = [(2.0, 0.1, 0.0, 0.0), (2.0, 0.1, 180.0, 0.3)]
    drawn = drawn_of(tmp_path, masses, "radius = 0.1\nspeed = 10\nbearings = [-0.1, 0.4]")
    told = list(warnings(drawn, "en"))
    assert any("no counterweight is wanted" in one for one in told)
    assert any("several planes" in one for one in told)
    found = figures_of(drawn)
    assert found["rotor_R_A"] == pytest.approx(found["rotor_R_B"])
    assert found["rotor_R_A"] * 0.5 == pytest.approx(2.0 * 0.1 * 100 * 0.3)
    assert BEARING_MOMENTS in ROTOR_PLAN.on(drawn).polygons


def test_a_product_stands_for_mass_and_radius(tmp_path: Path) -> None:
    path = scene_of(tmp_path, [], 'mass = "0.5 kg"')
    text = path.read_text().replace(
        "[[sheet]]",
        '[[unbalance]]\nD = "250 g*mm"\nangle = "20 deg"\n[[unbalance]]\nD = "40 г·см"\nangle = "110 deg"\n'
        "[[sheet]]",
    )
    path.write_text(text)
    (drawn,) = in_usual_size(read(path), exact=True).boards
    found = figures_of(drawn)
    assert found["rotor_D_k"] == pytest.approx(math.hypot(250e-6, 400e-6))
    assert found["rotor_r_k"] == pytest.approx(2 * math.hypot(250e-6, 400e-6))
    assert END in {view.name for view in rotor_views(drawn, lettered=True)}


def test_feet_and_slugs_are_the_same_rotor(tmp_path: Path) -> None:
    plain = figures_of(drawn_of(tmp_path, KHURMI, 'planes = ["0 m", "0.4 m"]\nradius = "0.1 m"'))
    text = [(m, r, a, z) for m, r, a, z in KHURMI]
    path = scene_of(
        tmp_path, text, 'planes = ["0 m", "0.4 m"]\nradius = "0.1 m"', head='units = "imperial"'
    )
    told = path.read_text()
    for m, r, _, z in KHURMI:
        told = told.replace(f"mass = {m!r}\n", f'mass = "{m} kg"\n')
        told = told.replace(f"radius = {r!r}\n", f'radius = "{r} m"\n').replace(
            f"at = {z!r}\n", f'at = "{z} m"\n'
        )
    path.write_text(told)
    (drawn,) = in_usual_size(read(path), exact=True).boards
    found = single(rotor_results(drawn))
    assert found["rotor_m_I"][0] * 14.593902937206365 == pytest.approx(plain["rotor_m_I"])
    assert found["rotor_alpha_II"][0] == pytest.approx(plain["rotor_alpha_II"])


def test_the_table_has_a_row_for_each_mass_and_counterweight(tmp_path: Path) -> None:
    drawn = drawn_of(tmp_path, KHURMI, "planes = [0, 0.4]\nradius = 0.1")
    texts = [label.text for label in weight_table(drawn).labels]
    for told in ("1", "2", "3", "4", "I", "II", "−100", "353", "184.1", "−1.6", "400"):
        assert told in texts, told


@pytest.mark.parametrize("due", [0.1, 179.9, -110.0])
def test_an_angle_is_judged_as_a_direction(due: float, tmp_path: Path) -> None:
    """A whole turn more is the same; half a turn is not, nor the other sense: also where signs change."""
    masses = [(1.0, 0.1, due + off, 0.0) for off in (160.0, 200.0)]
    scene = read(scene_of(tmp_path, masses, "radius = 0.1"))

    def verdict(angle: float) -> str:
        taken = Taken(RESULTS, "", "rotor_alpha_k", value=round(angle, 1), unit="°")
        return check(scene, [taken], trials=200).readings[0].verdict

    for turn in (-360.0, 0.0, 360.0):
        for off in (-0.4, 0.4):
            assert verdict(due + turn + off) == FINE, (turn, off)
    for angle in (due + 180.0, due - 9.0, due + 9.0, *([-due] if due == -110.0 else [])):
        assert verdict(angle) == WRONG, angle


@pytest.mark.parametrize(
    ("rotor", "key", "remedy"),
    [
        ("planes = [0.1, 0.1]\nradius = 0.1", "rotor.planes", "for balance at rest"),
        ("planes = [0.4, 0.1]\nradius = 0.1", "rotor.planes", "put the smaller place first"),
        ("planes = [0, 0.4]", "rotor", 'write radius = "60 mm"'),
        ("radius = 0.1\nmass = 2", "rotor.mass", "leave the one out that is sought"),
        ("radius = [0.1, 0.2]", "rotor.radius", "or two planes"),
        ("radius = 0.1\nbearings = [0, 1]", "rotor.speed", 'write speed = "1500 rpm"'),
        ("radius = 0.1\nspeed = 5\nbearings = [1, 1]", "rotor.bearings", "move one of them"),
        ("radius = 0.1\nspeed = 5\nbearings = 1", "rotor.bearings", "both bearings are wanted"),
        ("radius = -0.1", "rotor.radius", "one for each plane"),
        ('radius = 0.1\nspeed = "-600 rpm"', "rotor.speed", "is negative; write it positive"),
        ("radius = 0.1\nplanes = [0, 1, 2]", "rotor.planes", "one plane or two"),
    ],
)  # fmt: skip
def test_refusals_name_the_key_and_the_remedy(
    rotor: str, key: str, remedy: str, tmp_path: Path
) -> None:
    with pytest.raises(SceneError) as refused:
        read(scene_of(tmp_path, KHURMI, rotor))
    assert key in str(refused.value)
    assert remedy in str(refused.value)
    assert "turns" not in str(refused.value)  # no key of a rotor's


@pytest.mark.parametrize(
    ("change", "remedy"),
    [
        (("at = -0.1\n", ""), 'write at = "100 mm"'),
        (("mass = 200\n", ""), "or D alone"),
        (("mass = 200\n", "mass = 200\nD = 3\n"), "or D alone"),
        (("mass = 200\n", "mass = -2\n"), "not greater than 0"),
    ],
)
def test_an_unbalance_is_whole(change: tuple[str, str], remedy: str, tmp_path: Path) -> None:
    path = scene_of(tmp_path, KHURMI, "planes = [0, 0.4]\nradius = 0.1")
    path.write_text(path.read_text().replace(*change, 1))
    with pytest.raises(SceneError, match="unbalance") as refused:
        read(path)
    assert remedy in str(refused.value)


def test_no_unbalance_and_too_many_are_refused(tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=r"write \[\[unbalance\]\]"):
        read(scene_of(tmp_path, [], "radius = 0.1"))
    with pytest.raises(SceneError, match="no more than 12"):
        read(scene_of(tmp_path, KHURMI * 4, "radius = 0.1"))
