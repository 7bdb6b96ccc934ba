"""Sections that chapters write themselves: every number stands in the log, whatever the scene asks of them."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import SHEETS
from support.notes import looked_up, stands_for, worth_of_a_last_digit

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.fitting.auto import formatted
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.note.document import Document, Heading, Number, Picture, Table, Text, numbers, walk
from graphic_tmm.note.note import note, wanted
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

CAMS = {
    "roller": "",
    "offset, on the move": 'offset = "8 mm"\nspeed = "120 rpm"',
    "other laws": 'law = "cosine"\nreturn_law = "3-4-5"',
    "by its diagram": 'law = "diagram"\nlaw_points = [[0, 1], [0.5, 1], [0.5, -1], [1, -1]]',
    "constant acceleration": 'law = "constant acceleration"',
    "rocker": 'follower = "rocker"\nstroke = "20 deg"\nlever = "80 mm"\ncentres = "100 mm"',
    "flat": 'follower = "flat"\nleast_curvature = "5 mm"',
}
CAM = """title = "Cam"
language = "{language}"
[cam]
{stroke}rise = "100 deg"
upper_dwell = "20 deg"
fall = "90 deg"
{keys}
[hand]
ruler = "0.1 mm"
[[sheet]]
format = "A1"
place = ["cam"]
"""


def told(path: Path, scene: str) -> tuple[DrawnScene, Document]:
    file = path / "scene.toml"
    file.write_text(scene, encoding="utf-8")
    asked = read(file)
    # figures are true in any size
    given = Composition(usual(formatted(asked)), ()) if "[cam]" in scene else None
    made = make(asked, wanted=wanted(asked), given=given)
    return made, note(made)


def wrong(made: DrawnScene, document: Document) -> list[Number]:
    return [
        one
        for one in numbers(document)
        if not stands_for(one.text, looked_up(made, one), worth_of_a_last_digit(made, one))
    ]


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("kind", sorted(CAMS))
def test_every_number_of_a_cam_stands_in_the_log(kind: str, tmp_path: Path) -> None:
    keys = CAMS[kind]
    stroke = "" if "stroke" in keys else 'stroke = "28 mm"\n'
    made, document = told(tmp_path, CAM.format(language="en", stroke=stroke, keys=keys))
    assert not wrong(made, document)
    shown = {block.id for block in walk(document.blocks) if isinstance(block, Picture)}
    assert {"fig-cam-diagrams", "fig-cam-centre", "fig-cam-profile"} <= shown
    heads = [b.runs[0] for b in document.blocks if isinstance(b, Heading)]
    assert Text("Diagrams of the motion") in heads


DIAGRAMS = {
    "displacements, tangents": 'start = "displacement"\nmethod = "tangents"',
    "displacements over the angle": 'start = "displacement"\nover = "angle"',
    "an integral": 'start = "velocity"\nH_S = "20 mm"',
    "a base, no scales": 'start = "velocity"\nbase = "100 mm"\nintegral = "none"',
}


@pytest.mark.turns(2)
@pytest.mark.parametrize("kind", sorted(DIAGRAMS))
@pytest.mark.slow
def test_every_number_of_diagrams_stands_in_the_log(kind: str, tmp_path: Path) -> None:
    text = (SHEETS / "slider-diagrams" / "scene.toml").read_text(encoding="utf-8")
    before, _, rest = text.partition("[diagrams]")
    _, _, after = rest.partition("[[sheet]]")
    scene = f'{before}[diagrams]\npoint = "B"\n{DIAGRAMS[kind]}\n\n[[sheet]]{after}'
    made, document = told(tmp_path, scene.replace('language = "ru"', 'language = "en"'))
    assert not wrong(made, document)
    tables = {block.id for block in walk(document.blocks) if isinstance(block, Table)}
    assert ("table-middles-a-0" in tables) == ("tangents" not in kind)


def test_a_slider_is_told_as_the_worked_example_tells_it(tmp_path: Path) -> None:
    """A turn of 0.24 s on 96 mm, 12 mm an interval, H = 15 mm; 122 m/s² drawn in position 0."""
    text = (SHEETS / "slider-diagrams" / "scene.toml").read_text(encoding="utf-8")
    made, document = told(tmp_path, text.replace('language = "ru"', 'language = "en"'))
    assert not wrong(made, document)
    figures = {(one.text, one.unit) for one in numbers(document)}
    due = {("0.24", "s"), ("96.0", "mm"), ("12.0", "mm"), ("15.0", "mm"), ("2", "(m/s²)/mm")}
    due |= {("0.003", "s/mm"), ("1.5", "(m/s²)/mm"), ("0.0025", "s/mm")}
    assert due <= figures
