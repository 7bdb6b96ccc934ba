"""Scenes that are right: the shipped ones, every key, Russian words."""

import json
import math
import pickle
import subprocess
import sys
from pathlib import Path

import pytest
from support.gallery import SHEETS

import graphic_tmm.scene
from graphic_tmm.mechanism.records import Extreme, Guide, Side
from graphic_tmm.scene.new import schema, schema_text
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scales, SheetOrder

pytestmark = pytest.mark.every

SHIPPED = Path(graphic_tmm.scene.__file__).with_name("scene.schema.json")

HEAD = """
title = "T"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = 0 }
v = { through = ["1 m", 0], angle = "270 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0] }
"""
SLIDER = """[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
"""
DRIVE = """[drive]
link = 1
speed = 10
"""


@pytest.fixture
def scene(tmp_path):
    def make(*parts):
        file = tmp_path / "scene.toml"
        file.write_text("".join(parts), encoding="utf-8")
        return read(file)

    return make


def test_engine():
    engine = read(SHEETS / "engine")
    crank, rod, piston = engine.mechanism.links
    assert engine.source.endswith("scene.toml")
    assert (engine.language, engine.turned, engine.trajectories) == ("ru", True, ("S2",))
    assert crank.points == {"O": 0, "A": 0.3}
    assert rod.points == {"A": 0, "B": 0.64, "S2": 0.22}
    assert (crank.inertia, crank.centre, crank.mass) == (0.012, "O", None)
    assert (rod.mass, rod.inertia, rod.centre) == (2.4, 0.020, "S2")
    assert (piston.mass, piston.centre) == (1.9, "B")
    assert piston.slides[0].guide == Guide("x", 0, 0.0)
    assert piston.slides[0].side == Side(1)
    assert engine.mechanism.frame.number == piston.slides[0].on == 0
    assert engine.mechanism.drive.speed == 50
    assert (engine.row.count, engine.row.first, engine.row.zero) == (12, 1, 0.0)
    assert engine.row.accelerations == ("2", "5")
    assert engine.scales == Scales(mu_l=0.005, pa=60.0)
    assert engine.sheets == (SheetOrder("A1", (
        "positions", "given", "velocities", "flywheel", "accelerations", "equations",
        "velocity table")),)  # fmt: skip


def test_windrower():
    drive = read(SHEETS / "windrower" / "scene.toml")
    links = drive.mechanism.by_number
    assert links[1].points["A"] == pytest.approx(0.13657, abs=5e-6)
    arm = abs(links[3].points["C"])
    assert arm == pytest.approx(0.16694, abs=5e-6)
    assert links[4].points["D"] == arm
    assert links[3].points["S3"] == links[3].points["C"]
    assert links[1].points["S1"] == links[1].points["A"] / 2
    frame = drive.mechanism.frame
    assert (frame.number, frame.points["B"]) == (6, -0.48j)
    assert frame.guides[0].through == pytest.approx(-0.48j - 1.25j * arm, abs=1e-15)
    stone, knife = links[2].slides[0], links[5].slides[0]
    assert (stone.on, stone.guide, stone.side) == (3, Guide("BC", 0, 180.0), Side(-1))
    assert (knife.on, knife.guide.name, knife.side) == (6, "y", Side(1))
    assert drive.task is not None
    assert drive.task.given == {"K_v": 1.45, "stroke": 0.095, "OB": 0.48}
    assert drive.mechanism.drive.speed == pytest.approx(380 * math.pi / 30, rel=1e-15)
    assert drive.row.zero == Extreme("D", "left")
    assert drive.row.extra == (Extreme("D", "right"),)
    assert drive.row.accelerations == ("2", "6", "8")
    assert drive.scales.mu_l == 0.004


def test_windrower_as_published():
    published = read(SHEETS / "windrower-published").mechanism
    assert published.by_number[1].points["A"] == 0.1176
    assert abs(published.by_number[3].points["C"]) == 0.1938
    assert published.frame.guides[0].through == pytest.approx(-0.72225j, abs=1e-15)


@pytest.mark.parametrize("name", ["engine", "windrower", "windrower-published"])
def test_shipped_scenes_begin_with_a_comment_and_their_schema(name):
    folder = SHEETS / name
    first, second, *_ = (folder / "scene.toml").read_text(encoding="utf-8").split("\n")
    assert first.startswith("# ")
    assert second.startswith("#:schema ")
    assert (folder / second.removeprefix("#:schema ")).resolve() == SHIPPED.resolve()


def test_the_shipped_schema_is_the_one_of_the_models():
    assert SHIPPED.read_text(encoding="utf-8") == schema_text()


def test_the_schema_describes_every_key_and_refuses_others():
    found = schema()
    assert found["additionalProperties"] is False
    assert set(found["required"]) == {"title"}
    drive = found["$defs"]["DriveTable"]
    assert drive["additionalProperties"] is False
    assert all(part.get("description") for part in drive["properties"].values())
    assert '"null"' not in json.dumps(found)


def test_the_reader_names_no_chapter():
    code = (
        "import sys, graphic_tmm.scene.read\n"
        "sys.exit(any(name.startswith('graphic_tmm.chapters.') for name in sys.modules))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def test_defaults(scene):
    plain = scene(HEAD, SLIDER, DRIVE)
    assert (plain.language, plain.turned, plain.ruler) == ("ru", False, 0.1)
    assert (plain.row.count, plain.row.first, plain.row.zero) == (12, 0, 0.0)
    assert plain.row.accelerations == plain.row.extra == plain.trajectories == ()
    assert plain.scales == Scales()
    assert plain.sheets[0].place == (
        *("positions", "given", "special points", "velocities", "accelerations"),
        *("equations", "structure", "results"),
    )
    assert (plain.common_pole, plain.main) == (False, None)
    assert plain.title_block == {}
    assert plain.task is None
    assert plain.mechanism.frame.number == 0


def test_everything_else(scene):
    full = scene(
        HEAD,
        """guides = { q = { through = [0, "2 mm"], angle = "90 deg" } }
side = "справа от OB"
flips_at = ["90 deg", 270]
[[link]]
number = 3
points = { B = [0, 0], C′1 = [0, 0.2], S = [0, 0.2] }
""".replace("C′1", '"C′1"'),
        """slides = [
    { on = 0, along = "v", side = "below", offset = "-5 mm", angle = "30 deg" },
    { on = 2, along = "q", side = "-", flips_at = [10.5] },
]
mass = "2 кг"
centre = "S"
""",
        DRIVE,
        """acceleration = "3 1/s^2"
turns = "по часовой стрелке"
positions = 24
first = 1
extra = ["другое крайнее", "105 deg", 7]
accelerations = [2, "6*", 24]
zero = { point = "B", at = "сверху" }
[plans]
velocities = "direct"
trajectories = ["B", "S"]
[scales]
mu_l = "1:5"
mu_v = "mu_l*omega1"
pi_a = "80 mm"
[hand]
ruler = "exact"
[[sheet]]
format = "А4"
place = ["structure"]
[[sheet]]
[title_block]
drawn_by = "Иванов"
group = ""
""".replace('group = ""\n', ""),
    )
    link = full.mechanism.by_number[3]
    first, second = link.slides
    assert (first.offset, first.angle, first.side) == (-0.005, 30.0, Side(1))
    assert second.guide == Guide("q", 0.002j, 90.0)
    assert second.side == Side(-1, flips_at=(10.5,))
    assert (link.mass, link.centre) == (2.0, "S")
    assert full.mechanism.by_number[2].side == Side(-1, ("O", "B"), (90.0, 270.0))
    assert (full.mechanism.drive.speed, full.mechanism.drive.acceleration) == (-10.0, -3.0)
    assert full.row.extra == (Extreme("B", "bottom"), 105.0, 7.0)
    assert full.row.accelerations == ("2", "6*", "24")
    assert full.row.zero == Extreme("B", "top")
    assert full.trajectories == ("B", "S")
    assert full.scales == Scales(mu_l=0.005, mu_v_is_mu_l_omega=True, pi_a=80.0)
    assert full.ruler is None
    assert [sheet.format for sheet in full.sheets] == ["A4", "A1"]
    assert full.title_block == {"drawn_by": "Иванов"}


@pytest.mark.parametrize(
    ("along", "side", "sign"),
    [
        ("x", "right", 1),
        ("x", "left", -1),
        ("x", "слева", -1),
        ("x", "+", 1),
        ("x", "−", -1),
        ("v", "above", -1),
        ("v", "ниже", 1),
        ("v", "выше", -1),
    ],
)
def test_sides_of_fixed_guides(scene, along, side, sign):
    slider = SLIDER.replace('"x"', f'"{along}"').replace('"right"', f'"{side}"')
    assert scene(HEAD, slider, DRIVE).mechanism.links[2].slides[0].side == Side(sign)


def test_all_accelerations_are_those_of_the_row(scene):
    row = scene(HEAD, SLIDER, DRIVE, 'positions = 3\nfirst = 1\naccelerations = "all"\n').row
    assert row.accelerations == ("1", "2", "3")


@pytest.mark.parametrize(
    ("end", "angle"),
    [("[0.1, 0]", 0.0), ("[0, 0.1]", 90.0), ("[-0.1, 0]", 180.0), ("[0, -0.1]", 270.0)],
)
def test_directions_along_the_axes_are_exact(scene, end, angle):
    head = HEAD.replace("B = [0.3, 0]", f"C = {end}, D = [0.1, 0.1]")
    slides = 'slides = [{ on = 2, along = "AC" }, { on = 2, along = "AD" }]\n'
    guides = scene(head, "[[link]]\nnumber = 3\n", slides, DRIVE).mechanism.links[2].slides
    assert (guides[0].guide.angle, guides[1].guide.angle) == (angle, 45.0)


def test_a_byte_order_mark_and_windows_line_ends_are_read(tmp_path):
    file = tmp_path / "scene.toml"
    file.write_bytes(b"\xef\xbb\xbf" + (HEAD + SLIDER + DRIVE).replace("\n", "\r\n").encode())
    assert read(file).title == "T"


def test_the_same_file_gives_the_same_scene():
    assert read(SHEETS / "windrower") == read(SHEETS / "windrower")


def test_a_scene_can_be_sent_to_another_process():
    scene = read(SHEETS / "windrower")
    assert pickle.loads(pickle.dumps(scene)) == scene
