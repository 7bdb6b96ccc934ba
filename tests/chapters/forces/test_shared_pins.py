"""Reactions at a pin of three links: which are meant is told, and they are those of Newton and Euler.

The judge frees the pin as a body of its own, so that it takes no link's side: it knows the force of the pin on
each of the three links, and that these and the load on the pin are in balance.
"""

from __future__ import annotations

import cmath
import random
from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of

import graphic_tmm
from graphic_tmm.chapters.forces.friction import pin_sentences, shared_pins
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.table import polygon_equation
from graphic_tmm.chapters.forces.views import force_table, force_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read

TEXT = """
title = "A pin of three links"
language = "en"
[frame]
number = 0
O = [0, 0]
C = [{c!r}, {lift!r}]
y = {{ through = [0, {y!r}], angle = "0 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [{r!r}, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{rod!r}, 0], S2 = [{half!r}, 0.01] }}
mass = 2.0
centre = "S2"
side = "left of AC"
[[link]]
number = 3
points = {{ C = [0, 0], B = [{rocker!r}, 0] }}
[[link]]
number = 4
points = {{ B = [0, 0], D = [{long!r}, 0] }}
[[link]]
number = 5
points = {{ D = [0, 0], S5 = [0.02, 0] }}
mass = 3.0
centre = "S5"
slides = {{ on = "frame", along = "y", side = "right" }}
[drive]
link = 1
speed = "60 rpm"
positions = 1
zero = {zero!r}
[effects]
gravity = true
[[load]]
link = {link}
point = "B"
force = {force!r}
direction = {way!r}
[forces]
positions = "all"
[hand]
ruler = "exact"
[[sheet]]
format = "A1"
place = ["positions", "forces", "force table"]
"""


def scene_of(seed: int, link: int, folder: Path) -> tuple[Path, complex]:
    """Write a mechanism at random, with a load at the pin on one of its links; return that load."""
    pick = random.Random(seed)
    r = pick.uniform(0.06, 0.1)
    force, way = pick.uniform(50.0, 200.0), pick.uniform(0.0, 360.0)
    values = {
        "r": r, "c": 4.0 * r, "lift": pick.uniform(-0.5, 0.5) * r, "rod": pick.uniform(3.6, 4.4) * r,
        "half": 1.5 * r, "rocker": pick.uniform(2.0, 2.6) * r, "long": pick.uniform(5.0, 6.0) * r,
        "y": pick.uniform(0.0, 0.8) * r, "zero": pick.uniform(0.0, 360.0), "link": link,
        "force": force, "way": way,
    }  # fmt: skip
    path = folder / "scene.toml"
    path.write_text(TEXT.format(**values), encoding="utf-8")
    return path, cmath.rect(force, np.radians(way))


def judged(path: Path, load: complex, loaded: int) -> dict[str, complex]:
    """Return the forces of the pin B on links 2, 3, 4, by equilibrium of five links and of the pin.

    The load stands on the link that it is given on; the pin has none of its own.
    """
    scene = read(path)
    angle = next(float(a) for a in drawn_of(scene).project.coordinates if a is not None)
    spots = {k: z[0] for k, z in graphic_tmm.motion(scene, [angle], exact=True).places.items()}
    o, a, b, d = spots["O", 1], spots["A", 1], spots["B", 2], spots["D", 5]
    assert scene.mechanism is not None
    c = scene.mechanism.frame.points["C"]
    rows, right = np.zeros((17, 17)), np.zeros(17)
    # unknowns: forces at O on 1, A on 2, pin on 2, 3, 4, C on 3, D of 4 on 5 (x, y); N, M on 5; P at A
    acting: dict[int, list[tuple[int, complex, float]]] = {
        1: [(0, o, 1.0), (2, a, -1.0)],
        2: [(2, a, 1.0), (4, b, 1.0)],
        3: [(6, b, 1.0), (10, c, 1.0)],
        4: [(8, b, 1.0), (12, d, -1.0)],
        5: [(12, d, 1.0)],
    }

    def enter(link: int, force: complex, at: complex, k: int, sign: float) -> None:
        e = 3 * (link - 1)
        rows[e, k] += sign * force.real
        rows[e + 1, k] += sign * force.imag
        rows[e + 2, k] += sign * (at.conjugate() * force).imag

    for link, there in acting.items():
        for k, at, sign in there:
            enter(link, 1.0 + 0j, at, k, sign)
            enter(link, 1j, at, k + 1, sign)
    enter(5, 1j, d, 14, 1.0)
    rows[14, 15] = 1.0
    enter(1, 1j * (a - o) / abs(a - o), a, 16, 1.0)
    for k in (4, 6, 8):
        rows[15, k] = rows[16, k + 1] = 1.0
    known = [
        (2, -2.0 * 9.81j, spots["S2", 2]),
        (5, -3.0 * 9.81j, spots["S5", 5]),
        (loaded, load, b),
    ]
    for link, force, at in known:
        e = 3 * (link - 1)
        right[e : e + 3] -= [force.real, force.imag, (at.conjugate() * force).imag]
    x = np.linalg.solve(rows, right)
    return {n: complex(x[k], x[k + 1]) for n, k in (("R_{2}", 4), ("R_{23}", 6), ("R_{24}", 8))}


def vectors(drawn: Drawn) -> dict[str, complex]:
    """Return the reactions as they stand in the polygons, N."""
    found = {}
    for one in FORCES_PLAN.on(drawn).reactions:
        mu = drawn.scales[one.tail.view].value
        found[one.letter] = (
            complex(drawn.reading[one.head].item() - drawn.reading[one.tail].item()) * mu
        )
    return found


@pytest.mark.parametrize("link", [2, 3, 4])
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_the_reactions_meant_are_those_of_the_link_that_bears_the_pin(
    seed: int, link: int, tmp_path: Path
) -> None:
    path, load = scene_of(seed, link, tmp_path)
    drawn = drawn_of(read(path), exact=True)
    (pin,) = shared_pins(drawn)
    assert pin == ("B", 2, (3, 4))
    due, found = judged(path, load, link), vectors(drawn)
    size = max(abs(one) for one in due.values())
    for letter in ("R_{23}", "R_{24}", "R_{42}"):
        if letter in found:
            sign = -1.0 if letter == "R_{42}" else 1.0
            assert abs(sign * found[letter] - due["R_{24}" if sign < 0 else letter]) < 1e-9 * size
    assert {"R_{23}", "R_{24}"} <= found.keys()


def test_it_is_told_below_figures_and_table_and_in_the_protocol(tmp_path: Path) -> None:
    path, _ = scene_of(1, 3, tmp_path)
    drawn = drawn_of(read(path))
    (says,) = pin_sentences(drawn, "en")
    assert "Links 2, 3, 4 meet in pin B" in says
    assert "R_{23}, R_{24}" in says
    first = FORCES_PLAN.on(drawn).polygons[0].view
    assert "R23, R24" in polygon_equation(drawn, first, "en")[0].replace("_", "")
    (table,) = force_table(drawn, lettered=True)
    words = " ".join(label.text for label in table.labels)
    assert "counted to link 2" in words
    figures = [view for view in force_views(drawn, True) if view.name.startswith("group-")]
    said = {
        view.name: any("pin B is counted" in one.text for one in view.labels) for view in figures
    }
    assert said == {"group-4-5-0": True, "group-2-3-0": True, "group-1-0": False}


CRANK_PIN = """
title = "Two rods on one crank pin"
language = "en"
[frame]
O = [0, 0]
x = {{ through = [0, 0.01], angle = "0 deg" }}
z = {{ through = [0.02, 0], angle = "90 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.08, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [0.3, 0], S2 = [0.1, 0.02] }}
mass = 2.0
centre = "S2"
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "right" }}
[[link]]
number = 4
points = {{ A = [0, 0], D = [0.25, 0], S4 = [0.12, -0.01] }}
mass = 3.0
centre = "S4"
[[link]]
number = 5
points = {{ D = [0, 0] }}
slides = {{ on = "frame", along = "z", side = "above" }}
[drive]
link = 1
speed = "60 rpm"
positions = 1
zero = {zero!r}
[effects]
gravity = true
[[load]]
link = {link}
point = "A"
force = 120.0
direction = 200.0
[forces]
positions = "all"
[hand]
ruler = "exact"
"""


@pytest.mark.parametrize("link", [1, 2, 4])
@pytest.mark.parametrize("zero", [25.0, 160.0, 290.0])
def test_at_the_crank_pin_the_crank_bears_it(zero: float, link: int, tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(CRANK_PIN.format(zero=zero, link=link), encoding="utf-8")
    scene = read(path)
    drawn = drawn_of(scene, exact=True)
    (pin,) = shared_pins(drawn)
    assert pin == ("A", 1, (2, 4))
    places = graphic_tmm.motion(scene, [zero], exact=True).places
    a, load = places["A", 1][0], cmath.rect(120.0, np.radians(200.0))
    found = vectors(drawn)
    # each rod with its slider by itself: the guide's force has no part along the guide, no moment about its pin
    for rod, end, mass, along in ((2, "B", 2.0, 1.0), (4, "D", 3.0, 1j)):
        centre, far = places[f"S{rod}", rod][0], places[end, rod][0]
        weight, own = -9.81j * mass, load if rod == link else 0j
        normal = (
            -(((centre - a).conjugate() * weight).imag) / ((far - a).conjugate() * 1j * along).imag
        )
        due = -(own + weight + normal * 1j * along)
        assert abs(found[f"R_{{1{rod}}}"] - due) < 1e-9 * 120.0
