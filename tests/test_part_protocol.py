"""The protocol of a part tells every step where it has a value: a cam's rise where it rises."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from graphic_tmm.__main__ import main
from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.parts import Part, draw_parts
from graphic_tmm.readers.protocol import part_protocol
from graphic_tmm.scene.read import read

HEAD = 'title = "T"\nlanguage = "ru"\n[[sheet]]\nplace = ["{kind}"]\n[{kind}]\n'
PARTS = {
    "an offset roller": (
        "cam",
        'stroke = "20 mm"\nrise = 90\nfall = 100\nupper_dwell = 30\noffset = "8 mm"\n',
    ),
    "a rocker": (
        "cam",
        'stroke = "20 deg"\nrise = 110\nfall = 80\nlaw = "3-4-5"\nfollower = "rocker"\nlever = "80 mm"\n'
        'centres = "110 mm"\n',
    ),
    "a flat face": (
        "cam",
        'stroke = "15 mm"\nrise = 120\nfall = 120\nlaw = "cosine"\nfollower = "flat"\n'
        'least_curvature = "8 mm"\n',
    ),
    "a law by its diagram": (
        "cam",
        'stroke = "20 mm"\nrise = 90\nfall = 90\nlaw = "diagram"\n'
        "law_points = [[0, 1], [0.5, 1], [0.5, -1], [1, -1]]\n",
    ),
    "a pair of gears": (
        "gears",
        'z1 = 14\nz2 = 31\nm = "6 mm"\nx1 = 0.4\nx2 = -0.1\nstations = ["20 mm"]\n',
    ),
    "a train": (
        "planetary",
        'module = "4 mm"\nspeed = "100 1/s"\nratio = 4.6\nsatellites = [3, 4]\n',
    ),
}


def drawn(folder: Path, what: str) -> Part:
    kind, text = PARTS[what]
    path = folder / "scene.toml"
    path.write_text(HEAD.format(kind=kind) + text, encoding="utf-8")
    (part,) = draw_parts(read(path))
    return part


def lines(part: Part, language: str, position: str | None = None) -> list[str]:
    return list(part_protocol((part,), (part.kind,), language, position))


@pytest.mark.slow
@pytest.mark.parametrize("language", ["ru", "en"])
@pytest.mark.parametrize("what", PARTS)
def test_every_line_has_its_value(what: str, language: str, tmp_path: Path) -> None:
    found = lines(drawn(tmp_path, what), language)
    assert len(found) > 60
    for line in found:
        assert "—" not in line, line
        assert "nan" not in line
        assert "не строится" not in line, line
        assert "cannot be drawn" not in line, line
        assert "#" not in line


@pytest.mark.parametrize("what", PARTS)
def test_every_step_is_told_once_and_in_its_order(what: str, tmp_path: Path) -> None:
    part = drawn(tmp_path, what)
    due: list[int] = []
    for view in dict.fromkeys(step.it.view for step in part.construction.steps):
        due += range(1, 1 + sum(s.it.view == view for s in part.construction.steps))
    numbers: list[int] = []
    for line in lines(part, "ru"):
        if found := re.match(r" *(\d+)(?:–(\d+))?\. ", line):
            numbers += range(int(found[1]), int(found[2] or found[1]) + 1)
    assert numbers == due


def test_rise_and_return_are_told_in_the_middle_of_each(tmp_path: Path) -> None:
    part = drawn(tmp_path, "an offset roller")
    found = lines(part, "ru")
    assert found[0].endswith(", положение 6")  # of twelve parts of the rise
    told = {line.strip() for line in found if line.startswith("      [положение")}
    rows = [
        undefined(part.reading[s.it])[0] for s in part.construction.steps if s.it.kind is not Curve
    ]
    there = np.array([~row for row in rows if row.size == part.reading.positions])
    places = [int(re.sub(r"\D", "", text)) for text in told]
    covered = there[:, [6, *places]].any(axis=1)
    assert covered.all()
    assert "      [Подъём]" in found
    assert "      [Опускание]" in found


@pytest.mark.slow
def test_a_position_of_a_cam_can_be_asked_for(tmp_path: Path) -> None:
    drawn(tmp_path, "an offset roller")
    path = tmp_path / "scene.toml"
    done = CliRunner().invoke(main, ["steps", str(path), "-n", "20"])
    assert done.exit_code == 0
    assert done.stdout.splitlines()[0].endswith("положение 20")
    done = CliRunner().invoke(main, ["steps", str(path), "-n", "99"])
    assert done.exit_code == 2
    assert "--position: there is no 99; there are 0, 1" in done.stderr
