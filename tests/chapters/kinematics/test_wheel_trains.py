"""Several wheels on links: what they are called, given, numbered; what cannot be drawn of a train."""

from __future__ import annotations

import math

import pytest
from support import gallery

import graphic_tmm as tmm
from graphic_tmm.chapters.forces.given import given as forces
from graphic_tmm.chapters.kinematics.findings import WARNINGS
from graphic_tmm.chapters.kinematics.given import given
from graphic_tmm.chapters.kinematics.ink_links import LinksInk
from graphic_tmm.chapters.kinematics.ink_numbers import link_numbers
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.chapters.structure.table import link_name
from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.studio import make

EPICYCLIC = """
title = "T"
language = "en"
[frame]
number = 9
O = [0, 0]
[[link]]
number = 1
points = { O = [0, 0], A = [0.06, 0] }
[[link]]
number = 2
points = { O = [0, 0], S = [0.02, 0] }
[[link]]
number = 3
points = { A = [0, 0], B = [0.03, 0] }
[[mesh]]
links = [2, 3]
centres = ["O", "A"]
teeth = [40, 20]
[[mesh]]
links = [9, 3]
centres = ["O", "A"]
teeth = [80, 20]
internal = true
[drive]
link = 2
speed = 10
"""


def test_a_train_driven_by_its_sun_is_told_to_drive_the_arm() -> None:
    """Where the arm follows, no wheel can stand before it: what to drive is named, and that is drawn."""
    mechanism = tmm.read(EPICYCLIC).mechanism
    assert mechanism is not None
    with pytest.raises(StructureError, match=r"drive link 1, which joins O and A, .*\[planetary\]"):
        dissect(mechanism)
    led = tmm.read(EPICYCLIC.replace("link = 2\nspeed", "link = 1\nspeed")).mechanism
    assert led is not None
    assert dissect(led).mobility == 1


def test_a_mesh_too_many_is_listed_among_the_pairs() -> None:
    """What may be left out is a mesh, too: K(2,4), as it is in the table of pairs."""
    text = (
        EPICYCLIC + EPICYCLIC[EPICYCLIC.index("[[mesh]]") : EPICYCLIC.index("[[mesh]]\nlinks = [9")]
    )
    mechanism = tmm.read(text).mechanism
    assert mechanism is not None
    with pytest.raises(StructureError, match=r"A\(1,3\), K1\(2,3\), K2\(3,9\), K3\(2,3\)"):
        dissect(mechanism)


TRAIN = """
title = "T"
language = "en"
[frame]
O = [0, 0]
D = [0.1, 0]
G = [0.1, -0.08]
[[link]]
number = 1
points = { O = [0, 0], A = [0.03, 0] }
[[link]]
number = 2
points = { D = [0, 0] }
[[link]]
number = 3
points = { G = [0, 0], T = [0.02, 0] }
[[link]]
number = 4
points = { A = [0, 0], B = [0.15, 0] }
[[link]]
number = 5
points = { T = [0, 0], B = [0.15, 0] }
side = "right of AT"
[[mesh]]
links = [1, 2]
centres = ["O", "D"]
teeth = [30, 20]
[[mesh]]
links = [2, 3]
centres = ["D", "G"]
teeth = [20, 31]
[drive]
link = 1
speed = 10
positions = 8
accelerations = [2]
"""
STEPPED = TRAIN.replace("[20, 31]", "[45, 31]")


@pytest.mark.parametrize(
    ("text", "count"), [(TRAIN, 1), (TRAIN.replace("[20, 31]", "[20, 20]"), 0), (STEPPED, 0)]
)
def test_one_wheel_has_one_pitch_radius(text: str, count: int) -> None:
    """30:20 on 100 mm leave 40 mm to wheel 2, 20:31 on 80 mm 31.4 mm, 20:20 its 40; 45 are another wheel."""
    drawn = make(tmm.read(text)).mechanism
    assert drawn is not None
    told = list(WARNINGS.warnings(drawn, "en"))
    assert len(told) == count, told
    assert all("link 2 about D" in says and "4 ≠ 3.137 mm" in says for says in told)
    assert all("4 ≠ 3,137 мм" in says for says in WARNINGS.warnings(drawn, "ru"))


@pytest.mark.parametrize(("language", "wheel"), [("en", "wheel"), ("ru", "колесо")])
def test_a_wheel_is_called_so_and_bears_its_number(language: str, wheel: str) -> None:
    """Wheels that turn right round are no rockers; one without a line has its number at its pitch circle."""
    drawn = make(tmm.read(TRAIN)).mechanism
    assert drawn is not None
    mechanism = drawn.scene.mechanism
    assert mechanism is not None
    structure = dissect(mechanism)
    links = mechanism.by_number
    called = {k: link_name(mechanism, structure, links[k], language) for k in range(1, 6)}
    assert [k for k, name in called.items() if name == wheel] == [2, 3], called
    ink = LinksInk(drawn.construction, drawn.reading, reaches(drawn))
    (number,) = (one for one in link_numbers(ink, drawn.main, [], [], 3.5, ["2"]))
    centre, pitch = (ink.at(mark, drawn.main) for mark in next(ink.of("2", "wheel")).marks)
    (x, y, _), *_ = number.strokes[2].path
    assert math.isclose(abs(complex(x, y) - centre), abs(pitch - centre), rel_tol=1e-9)


def test_sizes_of_a_stepped_wheel_have_names_of_their_own() -> None:
    """The task sheet and the log name them alike: link 2 bears z2 and z2′, others one wheel without a prime."""
    scene = tmm.read(STEPPED)
    drawn = make(scene).mechanism
    assert drawn is not None
    sizes = {"z_1": 30.0, "z_2": 20.0, "z_{2′}": 45.0, "z_3": 31.0}
    own = {one.symbol: one.value for one in given(scene) if one.symbol.startswith("z")}
    log = {
        mark.name: value
        for mark, value in drawn.given.items()
        if mark.name.startswith("z") and mark.view == "positions"
    }
    assert own == log == sizes


def test_the_angle_at_which_teeth_press_is_given_where_forces_are_asked() -> None:
    """α_w stands in the table once, in degrees; a task without forces has no use for it."""
    scene = gallery.scene("geared-five-bar")
    assert [one for one in forces(scene) if one.symbol == "α_w"] == [("α_w", 20.0, "°")]
    assert not [one for one in given(scene) if one.symbol == "α_w"]


def test_letters_of_several_pitch_points_keep_their_numbers_below() -> None:
    """Each v of the equations is one letter with one index: v_{K1}, not v_K and a 1 behind it."""
    drawn = make(tmm.read(TRAIN)).mechanism
    assert drawn is not None
    told = "".join(step.note for step in drawn.construction.steps if step.it.view == "velocities")
    assert "v_{K1} = ω_2·l_{DK1},  v_{K1} ⊥ DK1" in told, told
