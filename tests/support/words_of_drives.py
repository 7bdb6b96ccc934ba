"""Small scenes of every drive, and what each may say: words, letters and units that would be of another."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

import graphic_tmm as tmm
from graphic_tmm.classroom.tasks.task import task_sheets
from graphic_tmm.page.crank import crank
from graphic_tmm.page.page import page_data
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.letters import plain
from graphic_tmm.scene.read import read
from support.command import printed

BOOM = """
[frame]
O = [0, 0]
G = [0.4, 0]
[[link]]
number = 1
points = { O = [0, 0], N = [0.5, 0], C = [1.0, 0], S1 = [0.6, 0.05] }
centre = "S1"
mass = "40 kg"
J = "2 kg*m^2"
[[link]]
number = 2
side = "left of OG"
points = { G = [0, 0] }
guides = { z = { through = [0, 0], angle = "0 deg" } }
[[link]]
number = 3
points = { N = [0, 0] }
slides = { on = 2, along = "z", side = "+" }
"""
ARM = """
[[link]]
number = 4
points = { C = [0, 0], M = [-0.15, 0.05], T = [0.6, 0] }
mass = "10 kg"
centre = "T"
[[link]]
number = 5
points = { H = [0, 0] }
side = "left of HC"
guides = { w = { through = [0, 0], angle = "0 deg" } }
[[link]]
number = 6
points = { M = [0, 0] }
slides = { on = 5, along = "w", side = "+" }
"""
EXCAVATOR = BOOM.replace("C = [1.0, 0],", "C = [1.0, 0], H = [0.55, 0.2],") + ARM
SLIDER = """
[frame]
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { B = [0, 0] }
mass = "3 kg"
centre = "B"
slides = { on = "frame", along = "x", side = "right" }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0], S2 = [0.1, 0] }
side = "left of BO"
mass = "2 kg"
J = "0.02 kg*m^2"
[[link]]
number = 3
points = { O = [0, 0], A = [0.1, 0], C = [0.15, 0.05] }
"""
FIVE_BAR = """
[frame]
O = [0, 0]
D = [0.3, 0]
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0] }
mass = "2 kg"
centre = "B"
[[link]]
number = 3
points = { C = [0, 0], B = [0.3, 0] }
side = "left of AC"
[[link]]
number = 4
points = { D = [0, 0], C = [0.1, 0] }
"""
SLIDER_AND_CRANK = """
[frame]
O = [0, 0]
x = { through = [0.3, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0] }
mass = "2 kg"
centre = "B"
[[link]]
number = 3
points = { C = [0, 0], B = [0.3, 0] }
side = "left of AC"
[[link]]
number = 4
points = { C = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
"""
PRESS = """
[frame]
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0] }
mass = "2 kg"
centre = "B"
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
"""
FORCES = """
[effects]
gravity = true
inertia = true
[forces]
positions = [1]
[[load]]
link = 3
point = "B"
force = "500 N"
direction = "180 deg"
"""
ROW = 'positions = 4\naccelerations = "all"\n'
ROD = '[drive]\nlink = 3\nfrom = "600 mm"\nto = "850 mm"\n' + ROW
SLIDES = '[drive]\nlink = 1\nfrom = "250 mm"\nto = "350 mm"\n' + ROW
OPEN_CRANK = '[drive]\nlink = 1\nfrom = "20 deg"\nto = "75 deg"\n' + ROW
RACK = OPEN_CRANK.replace('"20 deg"', '"10 mm"').replace("75 deg", "120 mm")
RACK += 'speed = "0.2 m/s"\nrack = "40 mm"\n'
FURTHER = "[[drive]]\nlink = {link}\nspeed = {speed}\nat = {at}\n"
BOOM_FORCES = FORCES.replace("link = 3", "link = 1").replace('"B"', '"C"')


def _drives(first: str, *, link: int, speed: str, at: str) -> str:
    return first.replace("[drive]", "[[drive]]") + FURTHER.format(link=link, speed=speed, at=at)


class Scene(NamedTuple):
    """A scene: its tables; what drives it (crank, slider, rod, rack), that of its row first."""

    tables: str
    drives: tuple[str, ...]
    rests: bool = False

    @property
    def turns(self) -> bool:
        """Whether a link is driven that turns about a fixed pivot."""
        return not {"crank", "rack"}.isdisjoint(self.drives)

    @property
    def driven(self) -> list[tuple[int, str]]:
        """The links that are driven, each with what drives it."""
        told = tomllib.loads(self.tables)["drive"]
        links = [one["link"] for one in (told if isinstance(told, list) else [told])]
        return list(zip(links, self.drives, strict=True))

    def text(self, language: str) -> str:
        """Return the scene as a person writes it."""
        places = ["positions", "given", "velocities", "velocity equations", "structure"]
        places += ["groups of structure", "velocity table", "position table"]
        if "accelerations" in self.tables and not self.rests:
            places += ["accelerations", "acceleration table", "acceleration equations"]
        if "[forces]" in self.tables:
            places += ["forces", "lever", "force table"]
        sheets = "".join(f'[[sheet]]\nplace = ["{one}"]\nformat = "A2"\n' for one in places)
        return f'title = "Scene"\nlanguage = "{language}"\n{self.tables}\n{sheets}'


def _scene(drives: str, *tables: str, rests: bool = False) -> Scene:
    return Scene("\n".join(tables), tuple(drives.split()), rests)


SPEED, TURNS = 'speed = "0.05 m/s"\n', "speed = 5\n"
REST, AT_REST = 'speed = "0 m/s"\n', "speed = 0\n"
TWO = _drives(OPEN_CRANK + TURNS, link=4, speed="10", at='"60 deg"')
CRANK_AND_SLIDER = _drives(OPEN_CRANK + TURNS, link=4, speed='"0.2 m/s"', at='"100 mm"')
SLIDER_AND_CRANK_DRIVE = _drives(
    '[drive]\nlink = 4\nfrom = "50 mm"\nto = "100 mm"\n' + ROW + SPEED,
    link=1,
    speed="5",
    at='"60 deg"',
)
RODS = _drives(ROD + SPEED, link=6, speed='"0.02 m/s"', at='"500 mm"')
SCENES: Mapping[str, Scene] = {
    "cylinder": _scene("rod", BOOM, ROD + SPEED),
    "cylinder gaining": _scene("rod", BOOM, ROD + SPEED + 'acceleration = "0.3 m/s^2"\n'),
    "cylinder path": _scene("rod", '[plans]\ntrajectories = ["C"]', BOOM, ROD + SPEED),
    "cylinder forces": _scene("rod", BOOM, ROD + SPEED, BOOM_FORCES),
    "cylinder at rest": _scene("rod", BOOM, ROD + REST, BOOM_FORCES, rests=True),
    "cylinder places": _scene(
        "rod",
        BOOM,
        '[drive]\nlink = 3\nspeed = "0.05 m/s"\npositions = ["600 mm", "700 mm", "710 mm"]\n',
    ),
    "two cylinders": _scene("rod rod", EXCAVATOR, RODS),
    "two cylinders forces": _scene("rod rod", EXCAVATOR, RODS, BOOM_FORCES),
    "two cylinders gaining": _scene(
        "rod rod", EXCAVATOR, RODS.replace(SPEED, SPEED + 'acceleration = "0.3 m/s^2"\n', 1)
    ),
    "slider": _scene("slider", SLIDER, SLIDES + SPEED),
    "slider gaining": _scene("slider", SLIDER, SLIDES + SPEED + 'acceleration = "0.3 m/s^2"\n'),
    "slider path": _scene("slider", '[plans]\ntrajectories = ["C"]', SLIDER, SLIDES + SPEED),
    "slider forces": _scene(
        "slider", SLIDER, SLIDES + SPEED, FORCES.replace("link = 3", "link = 1")
    ),
    "slider at rest": _scene(
        "slider", SLIDER, SLIDES + REST, FORCES.replace("link = 3", "link = 1"), rests=True
    ),
    "slider places": _scene(
        "slider",
        SLIDER,
        '[drive]\nlink = 1\nspeed = "0.05 m/s"\npositions = ["260 mm", "300 mm"]\n',
    ),
    "two cranks": _scene("crank crank", FIVE_BAR, TWO),
    "two cranks forces": _scene("crank crank", FIVE_BAR, TWO, FORCES),
    "crank and slider": _scene("crank slider", SLIDER_AND_CRANK, CRANK_AND_SLIDER),
    "slider and crank": _scene("slider crank", SLIDER_AND_CRANK, SLIDER_AND_CRANK_DRIVE),
    "open crank": _scene("crank", PRESS, OPEN_CRANK + TURNS, FORCES),
    "crank at rest": _scene("crank", PRESS, OPEN_CRANK + AT_REST, FORCES, rests=True),
    "rack": _scene("rack", PRESS, RACK),
    "crank places": _scene(
        "crank", PRESS, '[drive]\nlink = 1\nspeed = 5\npositions = ["0 deg", "35 deg"]\n'
    ),
}
"""Scenes by what drives them and what they show."""

ANY = (r"(?-i:None)\b", r"\bnan\b", r"degree C", r"class II, order 2, kind (6|7)")
"""What nobody may say."""
SUM_WITH_ITSELF = (r"([va]_\S+) = \1 ?\+",)
"""An equation that is none."""
NO_CRANK = (
    *(r"\bcrank", r"кривошип", r"\brpm\b", r"об/мин", r"\bturns? a minute", r"оборот"),
    *(
        r"\bwhole turns?\b",
        r"\b(one|full) turns?\b",
        r"\bsense of turning",
        r"направлени\w+ вращения",
    ),
)
"""What is said of cranks only."""
NO_ANGLES = (r"angle_deg", r"°", r"\bdeg(rees?)?\b", r"градус")
"""What is measured along a turn only."""
NO_STROKE = (r"\bv_\{?r", r"\brods? runs?\b", r"\bшток\w* выдвига", r"length_m")
"""What is said of what slides only."""
NO_ROD = (r"\brods? runs?\b", r"шток\w* выдвига", r"\bcylinder", r"\bцилиндр")
"""What is said of rods in their cylinders only."""
OPEN = (r"equally spaced positions of the cranks?", r"равноотстоящ\w+ положени\w+ кривошип")
"""What is said of a whole turn only."""
DRAWN_AT = re.compile(
    r"at\s+the\s+angle\s+(\", \")?[−\d.,]+°(\",)?\s+\"? ?to\s+the\s+x\s+axis"
    r"|под\s+углом\s+(\", \")?[−\d.,]+°(\",)?\s+\"? ?к\s+оси\s+x"
    r"|(Protractor|Транспортир)[^\"]*°|turned by 90°|[Пп]овёрнут\w* на 90°"
)
"""Angles that a line is drawn at, however the mechanism is driven; the plan of velocities that is turned."""
KEYS = re.compile(r'"crank": \[\]')
"""What only code reads: that a page has no crank to be dragged."""
GIVEN = re.compile(
    "task sheet|sheet (Given|Equations of (vel|acc)|Plan of pos|Исходн|Уравнения [су]|План пол)"
)
"""What tells how the mechanism is driven."""


def wrong(scene: Scene, where: str, text: str) -> list[tuple[str, str]]:
    """Return the patterns of what a scene says there and may not, with what stands around each."""
    plain_text = DRAWN_AT.sub("", KEYS.sub("", text))
    return [
        (pattern, plain_text[max(0, found.start() - 60) : found.end() + 40])
        for pattern in amiss(scene, where)
        for found in re.finditer(pattern, plain_text, re.IGNORECASE)
    ]


def amiss(scene: Scene, where: str) -> Iterator[str]:
    """Yield the patterns of what a scene may not say there, large letters or small."""
    yield from (*ANY, *SUM_WITH_ITSELF, *OPEN)
    if not scene.turns:
        yield from NO_CRANK
        yield from NO_ANGLES
    elif scene.drives[0] != "crank":
        yield NO_ANGLES[0]
    if set(scene.drives) == {"crank"}:
        yield from NO_STROKE
    if "rod" not in scene.drives:
        yield from NO_ROD
    yield from (_rate(link) for link, drive in scene.driven if drive == "slider")
    if not scene.turns and GIVEN.search(where):
        yield r"[ωΩ]|ε(?!\w)|omega|epsilon"


def _rate(link: int) -> str:
    """A rate of turning of a link, as it is written in words, tables, formulas and on sheets."""
    low = chr(ord("₀") + link)
    return rf"(?:[ωε]|omega|epsilon)_?(?:\{{?{link}\b|{low})"


NAMED = re.compile(r"<(?:title|desc)[^>]*>([^<]*)<")
"""What stands on a sheet, and what its strokes are called, as its file tells it."""
TAGS = re.compile(r"<style.*?</style>|<[^>]*>", re.DOTALL)


def told(scene: Scene, language: str, folder: Path) -> Iterator[tuple[str, str]]:
    """Yield all that a scene says, by where: sheets, task sheet, note, protocol, tables, data of the page."""
    file = folder / "scene.toml"
    file.write_text(scene.text(language), encoding="utf-8")
    drawn = tmm.draw(file)
    made, paper = drawn._work.composed[0], drawn._work.composed[1].sheets
    for one in drawn.sheets:
        yield f"sheet {one.views[-1]}", "\n".join(NAMED.findall(one.svg))
    yield "warnings", "\n".join(drawn.warnings)
    yield "protocol", str(drawn.steps(why=True))
    (note,) = drawn.note(folder / "note.html")
    yield "note", TAGS.sub(" ", note.read_text(encoding="utf-8"))
    document = file.read_text(encoding="utf-8")
    task = task_sheets(read(file), document, tomllib.loads(document), readings=False)
    yield "task sheet", "\n".join(_lettering(sheet.drawings) for sheet in task)
    data = page_data(made, paper)
    turned = crank(made, paper)
    data |= {"turned": turned and turned.data, "words": None}
    yield "page", json.dumps(data, ensure_ascii=False, default=str)
    for form in ("csv", "json"):
        yield form, printed("table", file, "--format", form)


def _lettering(drawings: Iterable[Drawing]) -> str:
    return "\n".join(plain(label.text) for view in drawings for label in view.labels)
