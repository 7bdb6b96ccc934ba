"""The protocol of a part tells every step where it has a value: a cam's rise where it rises."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from support.command import invoke
from support.parts import PARTS, part_of

from graphic_tmm.board.values import Curve, undefined
from graphic_tmm.drawn import Drawn
from graphic_tmm.readers.protocol import BESIDE, plans, protocol


def lines(part: Drawn, language: str, position: str | None = None) -> list[str]:
    drawn = [plan for plan in plans() if plan not in BESIDE]
    return list(protocol(part, drawn, position, language))


@pytest.mark.slow
@pytest.mark.parametrize("language", ["ru", "en"])
@pytest.mark.parametrize("what", PARTS)
def test_every_line_has_its_value(what: str, language: str, tmp_path: Path) -> None:
    found = lines(part_of(tmp_path, what), language)
    assert len(found) > 60
    for line in found:
        assert "—" not in line, line
        assert "nan" not in line
        assert "не строится" not in line, line
        assert "cannot be drawn" not in line, line
        assert "#" not in line


@pytest.mark.parametrize("what", PARTS)
def test_every_step_is_told_once_and_in_its_order(what: str, tmp_path: Path) -> None:
    part = part_of(tmp_path, what)
    due: list[int] = []
    for view in dict.fromkeys(step.it.view for step in part.construction.steps):
        due += range(1, 1 + sum(s.it.view == view for s in part.construction.steps))
    numbers: list[int] = []
    for line in lines(part, "ru"):
        if found := re.match(r" *(\d+)(?:–(\d+))?\. ", line):
            numbers += range(int(found[1]), int(found[2] or found[1]) + 1)
    assert numbers == due


def test_rise_and_return_are_told_in_the_middle_of_each(tmp_path: Path) -> None:
    part = part_of(tmp_path, "an offset roller")
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
    part_of(tmp_path, "an offset roller")
    path = tmp_path / "scene.toml"
    done = invoke("steps", path, "-n", "20")
    assert done.exit_code == 0
    assert any(line.endswith("положение 20") for line in done.stdout.splitlines())
    done = invoke("steps", path, "-n", "99", "-l", "en")
    assert done.exit_code == 2
    assert "--position: there is no 99; there are 0, 1" in done.stderr
