"""A link welded to another is an arm of it: the same motion and forces as of one link written at once."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import numpy as np
import pytest

import graphic_tmm
from graphic_tmm.chapters.structure.table import aside_lines, link_rows
from graphic_tmm.errors import SceneError
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.scene.read import read

HEAD = """
title = "T"
language = "en"
[frame]
O = [0, 0]
F = [0.35, -0.1]
x = { through = [0, 0], angle = 0 }
z = { through = [0, 0], angle = "90 deg" }
"""
REST = """
[[link]]
number = 2
points = { A = [0, 0], B = [0.25, 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
mass = 5
centre = "B"
[[link]]
number = 4
points = { C = [0, 0], D = [0.22, 0], S4 = [0.1, 0.02] }
mass = 2
centre = "S4"
[[link]]
number = 5
points = { D = [0, 0] }
slides = { on = "frame", along = "z", side = "above" }
[drive]
link = 1
speed = "60 rpm"
accelerations = "all"
zero = "10 deg"
[effects]
gravity = true
inertia = true
[forces]
"""
ECCENTRICS = """
[[link]]
number = 1
points = { O = [0.01, 0.02], A = [0.09, 0.02] }
[[link]]
number = 6
weld = { to = 1, angle = "120 deg" }
points = { O = [0, 0.03], C = [0.06, 0.03] }
"""
"""Two eccentrics on one shaft; neither has its origin at it."""
ANGLES = np.array([5.0, 77.0, 130.0, 222.0, 301.0])


def written(folder: Path, text: str, name: str = "scene") -> Path:
    path = folder / f"{name}.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_the_second_eccentric_goes_round_at_its_angle(tmp_path: Path) -> None:
    found = graphic_tmm.motion(written(tmp_path, HEAD + ECCENTRICS + REST), ANGLES, exact=True)
    turn = np.exp(1j * np.radians(ANGLES))
    due = 0.06 * np.exp(1j * np.radians(120.0)) * turn
    omega = 2.0 * np.pi
    np.testing.assert_allclose(found.places["C", 1], due, atol=1e-13)
    np.testing.assert_allclose(found.velocities["C", 1], 1j * omega * due, atol=1e-12)
    np.testing.assert_allclose(found.accelerations["C", 1], -(omega**2) * due, atol=1e-11)
    # D: above its eccentric, on the vertical guide
    height = due.imag + np.sqrt(0.22**2 - due.real**2)
    np.testing.assert_allclose(found.places["D", 5], 1j * height, atol=1e-12)


def same(folder: Path, welded: str, whole: str) -> None:
    """See that motion and forces of two scenes are alike."""
    plans = ("positions", "velocities", "accelerations", "forces")
    found, due = (
        graphic_tmm.motion(written(folder, text, name), ANGLES, exact=True, plans=plans)
        for name, text in (("welded", welded), ("whole", whole))
    )
    for kind in ("places", "velocities", "accelerations", "forces", "omega", "epsilon"):
        first, second = getattr(found, kind), getattr(due, kind)
        assert first.keys() == second.keys()
        size = max(float(np.nanmax(np.abs(one))) for one in second.values())
        for name, values in first.items():
            np.testing.assert_allclose(values, second[name], atol=1e-10 * size, err_msg=f"{name}")


def test_arms_are_one_body_in_forces_too(tmp_path: Path) -> None:
    at = cmath.rect(0.06, math.radians(120.0))
    one = f"""
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.08, 0], C = [{at.real!r}, {at.imag!r}] }}
"""
    same(tmp_path, HEAD + ECCENTRICS + REST, HEAD + one + REST)


BELL = """
[[link]]
number = 1
points = { O = [0, 0], A = [0.08, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0] }
side = "left of AF"
[[link]]
number = 3
points = { F = [0, 0], B = [0.2, 0]WHOLE }
GUIDES
ARM
[[link]]
number = 4
points = { G = [0, 0] }
slides = { on = "frame", along = "w", side = "left" }
[[link]]
number = 5
points = { G = [0, 0], S5 = [0.05, 0.01] }
mass = 3
centre = "S5"
slides = { on = ON, along = "q" }
[drive]
link = 1
speed = "60 rpm"
accelerations = "all"
zero = "10 deg"
[effects]
gravity = true
[forces]
"""


def bell(whole: str, guides: str, arm: str, on: int) -> str:
    """Return a bell crank whose second arm carries a guide; a stone on it is led along another."""
    text = BELL.replace("WHOLE", whole).replace("GUIDES", guides).replace("ARM", arm)
    head = HEAD + 'w = { through = [0, -0.3], angle = "20 deg" }\n'
    return head + text.replace("ON", str(on)).replace('along = "w", side = "left"', 'along = "w"')


def test_a_guide_and_what_slides_on_an_arm_come_along(tmp_path: Path) -> None:
    arm = """
[[link]]
number = 7
weld = { to = 3, angle = "-75 deg" }
points = { F = [0.02, 0], H = [0.12, 0] }
guides = { q = { through = [0.12, 0.01], angle = "10 deg" } }
"""
    back = cmath.rect(1.0, math.radians(-75.0))
    through, h = (0.1 + 0.01j) * back, 0.1 * back
    whole = f", H = [{h.real!r}, {h.imag!r}]"
    guides = f'guides = {{ q = {{ through = [{through.real!r}, {through.imag!r}], angle = "-65 deg" }} }}'
    same(tmp_path, bell("", "", arm, 7), bell(whole, guides, "", 3))


def test_it_is_one_link_of_two_arms_in_structure(tmp_path: Path) -> None:
    mechanism = read(written(tmp_path, HEAD + ECCENTRICS + REST)).mechanism
    assert mechanism is not None
    structure = dissect(mechanism)
    assert (structure.moving, len(structure.pairs), structure.mobility) == (5, 7, 1)
    assert ["1", "crank, arms OA, OC", "movable"] in link_rows(mechanism, structure, "en")
    (line,) = aside_lines(mechanism, structure, "en")
    assert line == "Links 1 and 6 are welded at O: one link, 1"


@pytest.mark.parametrize(
    ("old", "new", "key", "says"),
    [
        ("to = 1", "to = 9", "link 6, weld.to", "another link that moves"),
        ("to = 1", "to = 6", "link 6, weld.to", "another link that moves"),
        ("O = [0, 0.03], C", "E = [0, 0.03], C", "link 6, points", "share no letter"),
        ("O = [0, 0.03], C", "A = [0, 0.06], O = [0, 0.03], C", "link 6, points", "share A, O"),
        ("number = 6", "number = 6\nmass = 3", "link 6, mass", "write mass in link 1"),
        ("C = [0.06, 0.03]", "C = [-0.04, -0.0392820323]", "link 6, weld.angle", "C lies on A of link 1"),
        ("[drive]\nlink = 1", "[drive]\nlink = 6", "drive.link", "one body with it; write 1"),
        ("[forces]", "[[load]]\nlink = 6\nmoment = 3\n[forces]", "load 1, link", "write 1"),
    ],
)  # fmt: skip
def test_what_an_arm_cannot_be_is_refused(
    tmp_path: Path, old: str, new: str, key: str, says: str
) -> None:
    text = HEAD + ECCENTRICS + REST
    assert old in text
    with pytest.raises(SceneError) as error:
        read(written(tmp_path, text.replace(old, new)))
    (fault,) = error.value.faults
    assert fault.key == key
    assert says in fault.message


def test_a_load_at_a_letter_of_the_arm_stands_on_the_body(tmp_path: Path) -> None:
    more = '[[load]]\nlink = 1\npoint = "C"\nforce = 10\ndirection = 90\n[forces]'
    text = (HEAD + ECCENTRICS + REST).replace("[forces]", more)
    assert read(written(tmp_path, text)).tasks


def test_what_stands_on_an_arm_stands_on_its_link(tmp_path: Path) -> None:
    text = (HEAD + ECCENTRICS + REST).replace("O = [0, 0.03], C", "O = [0, 0.03], K = [1, 1], C")
    more = """[[spring]]
between = ["K", "F"]
rate = "2 kN/m"
free = 0.1
[[load]]
link = 3
point = "B"
force = 10
direction = "along OC"
[friction]
f = 0.1
radius = 0.01
pairs = { PIN = 0.2 }
[forces]"""
    assert read(written(tmp_path, text.replace("[forces]", more.replace("PIN", "C")))).tasks
    with pytest.raises(SceneError, match='"K" is none'):
        read(written(tmp_path, text.replace("[forces]", more.replace("PIN", "K"))))
