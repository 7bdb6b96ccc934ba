"""``[joints]``: links told by the places of their joints, as a hand puts them, against scenes in own axes."""

from __future__ import annotations

import copy
import tomllib
from typing import Any

import numpy as np
import pytest
from support import gallery
from support.each import each
from support.sketched import Standing, apart, by_joints, standing

import graphic_tmm
from graphic_tmm.errors import SceneError
from graphic_tmm.scene.joints import expanded
from graphic_tmm.scene.packaged import FILE

WELDED = [
    name for name in gallery.NAMES if any(one.arms for one in gallery.scene(name).mechanism.links)
]  # type: ignore[union-attr]
PLAIN = [name for name in gallery.NAMES if name not in WELDED]
SLOTTED = """title = "Slotting machine"
language = "en"
[frame]
O = [0, 0]
B = [0, "-305 mm"]
y = { through = [0, "335 mm"], angle = "0 deg" }
[joints]
A = ["70 mm", "85 mm"]
C = ["117.31 mm", "344.23 mm"]
D = ["-23 mm", "335 mm"]
to = "1 mm"
near = "3 mm"
[[link]]
number = 1
points = ["O", "A"]
[[link]]
number = 2
points = ["A"]
slides = { on = 3, along = "BC" }
[[link]]
number = 3
points = ["B", "C"]
[[link]]
number = 4
points = ["C", "D"]
[[link]]
number = 5
points = ["D"]
slides = { on = "frame", along = "y" }
[drive]
link = 1
speed = "100 rpm"
zero = "joints"
"""


def _written(one: Standing, **more: Any) -> dict[str, Any]:
    """The tables of a scene of the gallery told by its joints; lengths as they come."""
    doc = copy.deepcopy(
        tomllib.loads((gallery.SHEETS / gallery_name(one) / FILE).read_text("utf-8"))
    )
    joints = by_joints(one, **more)
    told = {link["number"]: link for link in doc["link"]}
    kept = ("mass", "J", "rod", "centre", "name", "passive")
    links = [
        link | {k: told[link["number"]][k] for k in kept if k in told[link["number"]]}
        for link in joints["link"]
    ]
    # a synthesis, and the sheet that shows it, goes with its task
    drawn = ("synthesis", "sheet") if "synthesis" in doc else ()
    rest = {k: v for k, v in doc.items() if k not in ("lengths", "task", *drawn)}
    return {**rest, "frame": joints["frame"], "joints": joints["joints"], "link": links}


def gallery_name(one: Standing) -> str:
    return one.scene.source.split("/")[-2]


@each("name", PLAIN, turns=20)
def test_joints_say_the_mechanism_that_they_were_taken_from(name: str) -> None:
    """In three positions, the one time as they are, the other by the drawing's own guides and sides."""
    for one in standing(name):
        doc = _written(one)
        doc["joints"]["to"] = 0
        turns = not one.mechanism.drive.slides and not one.mechanism.drive.rack
        if isinstance(doc["drive"], dict) and turns and "zero" not in doc["drive"]:
            doc["drive"]["zero"] = f"{one.scene.row.zero} deg"
        read = graphic_tmm.read(doc)
        at = [other.at for other in standing(name)]
        assert apart(one.scene, read, at) < 1e-9


def test_what_a_hand_meant_is_written_as_a_person_would() -> None:
    """Whole millimetres; a stone that is nearly on its rocker is on it; the first letter is the origin."""
    doc, flaws = expanded(tomllib.loads(SLOTTED))
    assert not flaws
    crank, stone, rocker, rod, slider = doc["link"]
    assert crank["points"] == {"O": [0, 0], "A": ["110 mm", 0]}
    assert rocker["points"] == {"B": [0, 0], "C": ["660 mm", 0]}
    assert rod["points"] == {"C": [0, 0], "D": ["141 mm", 0]}
    assert stone["slides"] == {"on": 3, "along": "BC", "side": "+"}
    assert slider["slides"]["side"] == "-"
    assert "joints" not in doc
    assert float(doc["drive"]["zero"].removesuffix(" deg")) == pytest.approx(
        np.degrees(np.arctan2(85, 70)), abs=1e-9
    )
    table = graphic_tmm.draw(graphic_tmm.read(SLOTTED), exact=True).table("positions")
    assert table.positions[0] == "0"


def test_a_crank_that_is_shorter_than_near_is_a_crank() -> None:
    """Only what lies off a line may be put on it."""
    short = SLOTTED.replace('A = ["70 mm", "85 mm"]', 'A = ["1.2 mm", "1.6 mm"]')
    doc, _ = expanded(tomllib.loads(short))
    assert doc["link"][0]["points"]["A"] == ["2 mm", 0]


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ('points = ["C", "D"]', 'points = ["C", "E"]', '"E" has no place'),
        ('points = ["C", "D"]', 'points = ["C", 3]', "a list of letters is wanted"),
        ('C = ["117.31 mm", "344.23 mm"]', 'C = ["117.31 mm"]', "a point is a list of two lengths"),
        ('near = "3 mm"', 'naer = "3 mm"', "naer"),
        (
            'points = ["B", "C"]',
            'points = ["B", "C"]\nweld = { to = 4, angle = 0 }',
            "leave .joints. out",
        ),
        (
            'points = ["C", "D"]',
            "points = { F = [0, 0], G = [1, 0] }",
            "nobody sees how links 4 lie",
        ),
    ],
)
def test_what_is_wrong_with_joints_is_told(old: str, new: str, says: str) -> None:
    assert old in SLOTTED
    with pytest.raises(SceneError, match=says) as refused:
        graphic_tmm.read(SLOTTED.replace(old, new))
    # what would come of it is not told besides
    assert len(refused.value.faults) == 1


def test_a_joint_of_no_link_is_remarked_only() -> None:
    text = SLOTTED.replace('to = "1 mm"', 'to = "1 mm"\nQ = [0, 0]')
    assert any("no link has this joint" in one for one in graphic_tmm.read(text).remarks)


FLAT = """title = "Four bars"
language = "en"
[frame]
O = [0, 0]
D = ["400 mm", 0]
[joints]
A = ["100 mm", 0]
B = ["250 mm", "{height} mm"]
[[link]]
number = 1
points = ["O", "A"]
[[link]]
number = 2
points = ["A", "B"]
[[link]]
number = 3
points = ["B", "D"]
{side}[drive]
link = 1
speed = "10 rad/s"
"""


def test_a_group_that_is_drawn_in_line_has_no_side_that_anybody_sees() -> None:
    for height, side, fine in (
        (1.0, "", False),
        (60.0, "", True),
        (1.0, 'side = "left of AD"\n', True),
    ):
        text = FLAT.format(height=height, side=side)
        if fine:
            assert graphic_tmm.read(text).mechanism is not None
            continue
        with pytest.raises(SceneError, match="so near to where both its assemblies meet"):
            graphic_tmm.read(text)


def test_a_side_that_is_written_wins() -> None:
    below = graphic_tmm.read(FLAT.format(height=60.0, side='side = "right of AD"\n'))
    assert graphic_tmm.motion(below, [0.0], plans=("positions",)).places["B", 2][0].imag < 0.0
    above = graphic_tmm.read(FLAT.format(height=60.0, side=""))
    assert graphic_tmm.motion(above, [0.0], plans=("positions",)).places["B", 2][0].imag > 0.0


@pytest.mark.slow
@each("name", PLAIN, turns=20)
def test_a_hand_that_is_off_draws_the_same_assembly(name: str) -> None:
    """Joints clicked half a millimetre off on a drawing 150 mm wide: seldom far off, never the other side."""
    near = count = 0
    for one in standing(name):
        # what is held twice, or comes through change points, has lengths that nobody clicks; where a rod stands
        # is no more exact than its pins
        flips = any(link.side is not None and link.side.flips_at for link in one.mechanism.links)
        if one.mechanism.passive or one.mechanism.drive.slides or flips:
            return
        for seed in range(7):
            try:
                doc = _written(one, noise=one.size / 300.0, seed=seed)
                doc["joints"] |= {"to": one.size / 1000.0, "near": one.size / 50.0}
                read = graphic_tmm.read(doc)
                found = graphic_tmm.motion(read, [one.at], exact=True, plans=("positions",))
            except SceneError as error:
                assert "both its assemblies meet" in str(error)  # noqa: PT017
                continue
            off = max(abs(z[0] - one.places[k[0]]) for k, z in found.places.items()) / one.size
            count += 1
            near += off < 0.03
    assert near >= 0.9 * count


def test_joints_of_an_imperial_scene_stand_where_they_are_written() -> None:
    """A scene that is kept in feet has the same motion, in feet."""
    metres, feet = (
        graphic_tmm.read(SLOTTED.replace("[frame]", f"{units}[frame]", 1))
        for units in ("", IMPERIAL)
    )
    one, other = (
        graphic_tmm.motion(scene, [40.0], plans=("positions",)).places for scene in (metres, feet)
    )
    for key, place in one.items():
        assert abs(other[key] * 0.3048 - place) < 1e-12


IMPERIAL = 'units = "imperial"\n'
