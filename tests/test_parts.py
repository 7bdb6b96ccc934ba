"""Cams, gears and planetary trains as scenes: tables, protocol, errors, beside a mechanism."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from support.boards import parts
from support.command import invoke
from support.gallery import SHEETS, made
from support.scenes import source, written

from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN
from graphic_tmm.language.units import known
from graphic_tmm.readers.findings import warnings
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.readers.table import table
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder
from graphic_tmm.studio import make, sheets

GIVEN = """teeth      = [25, "?", "?"]     # z1 is given, the others are found: 32 and 89
satellites = 3 """
COARSE = "teeth = [25, 31, 89]\nsatellites = 3 "
KINDS = {"cam": "cam", "gear-pair": "gears", "planetary": "planetary"}


def document(name: str, exact: bool = True) -> dict[str, Any]:
    text = table(made(name, exact=exact), "json")
    assert isinstance(text, str)
    found = json.loads(text)
    assert isinstance(found, dict)
    return found


def results(name: str) -> dict[str, float]:
    return {key: one["value"] for key, one in document(name)["results"].items()}


@pytest.mark.slow
def test_the_cams_results() -> None:
    found = results("cam")
    assert found["r0_min"] == pytest.approx(0.04903, abs=5e-5)
    assert found["r0"] == 0.0521
    assert found["roller_by_r0"] == pytest.approx(0.4 * 0.0521)
    assert found["pressure_rise"] < 30.0
    assert found["pressure_return"] > -30.0
    columns = {c["segment"]: c["value"] for c in document("cam")["columns"]}
    angles = [p["angle_deg"] for p in document("cam")["positions"]]
    assert angles[12] == pytest.approx(100.0)
    assert columns["S"][12] == pytest.approx(0.028, rel=1e-12)
    assert columns["S"][6] == pytest.approx(0.014, rel=1e-12)


@pytest.mark.slow
def test_the_gear_pairs_results() -> None:
    found = results("gear-pair")
    assert found["contact_ratio"] == pytest.approx(1.1581, abs=5e-5)
    assert found["contact_ratio_drawn"] == pytest.approx(found["contact_ratio"], rel=1e-9)
    assert found["a_w"] == pytest.approx(0.1686833, abs=1e-7)


def test_the_planetary_results() -> None:
    found = results("planetary")
    assert [found[f"planetary_z{k}"] for k in (1, 2, 3)] == [25, 32, 89]
    assert found["planetary_satellites"] == 3
    assert found["planetary_ratio"] == pytest.approx(4.56)
    assert found["planetary_ratio_drawn"] == pytest.approx(4.56, rel=1e-9)
    assert found["overall_ratio"] == pytest.approx(7.6)
    (part,) = parts(made("planetary"))
    assert PLANETARY_PLAN.on(part).order.teeth == (25, None, None)  # the others were found


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("name", KINDS)
@pytest.mark.parametrize("language", ["ru", "en"])
def test_a_part_speaks_both_languages(name: str, language: str) -> None:
    scene = replace(read(SHEETS / name), language=language)
    (part,) = parts(make(scene))
    lines = list(protocol(part, (KINDS[name],), None, language))
    assert len(lines) > 60
    assert not [line for line in lines if "{" in line or "}" in line]
    assert list(protocol(part, ("positions",), None, language)) == []
    assert sheets(scene)[1]


@pytest.mark.parametrize("name", KINDS)
def test_every_unit_of_a_part_has_its_russian_name(name: str) -> None:
    for part in parts(made(name)):
        log = part.construction
        assert all(known(m.unit) for m in (*log.given, *(s.it for s in log.steps)))
        assert all(s.it.view in captions("en") for s in log.steps)


@pytest.mark.slow
@pytest.mark.parametrize("name", KINDS)
def test_the_commands_take_a_part(name: str) -> None:
    for arguments in (["table", name], ["table", name, "-f", "csv"], ["steps", name]):
        done = invoke(*arguments)
        assert done.exit_code == 0, done.output
        assert done.stdout


@pytest.mark.slow
def test_a_part_stands_beside_a_mechanism() -> None:
    engine, cam = read(SHEETS / "engine"), read(SHEETS / "cam")
    both = replace(engine, sheets=(*engine.sheets, SheetOrder("A1", ("cam",)))).asking(
        cam=cam.tasks["cam"]
    )
    made, paper = sheets(both)
    assert made.mechanism is not None
    assert len(paper) == 2
    text = table(made, "json")
    assert isinstance(text, str)
    found = json.loads(text)["results"]
    assert {"J_fly", "r0_min"} <= set(found)


def scene_of(tmp_path: Path, name: str, *edits: tuple[str, str]) -> Path:
    text = source(name)
    for old, new in edits:
        assert old in text
        text = text.replace(old, new)
    path = written(tmp_path, text)
    return path


@pytest.mark.parametrize(
    ("name", "edit", "says"),
    [
        ("planetary", (GIVEN, COARSE), "another distance of the axes"),
        ("planetary", ("behind     = [15, 25]", "behind = [15]"), "two wheels"),
        ("planetary", ('scheme     = "ring"', 'scheme = "belt"'), "it is one of"),
        ("gear-pair", ("z1 = 15", "z1 = 2"), "gears.z1: the number 2"),
        ("gear-pair", ("z1 = 15", 'z1 = "15"'), "whole number"),
        ("gear-pair", ('m  = "8 mm"', 'm = "-8 mm"'), "not greater than 0"),
        ("cam", ('rise         = "100 deg"', 'rise = "300 deg"'), "shorten them"),
        ("cam", ('stroke       = "28 mm"', 'stroke = "20 deg"'), "moves along its guide"),
        (
            "cam",
            ('transmission = "60 deg"', 'transmission = "60 deg"\npressure = "30 deg"'),
            "says the same",
        ),
        ("cam", ('law          = "sine"', 'law = "diagram"'), "needs points"),
        ("cam", ("[cam]", "[kam]"), "cam"),
        ("cam", ('roller       = "16.8 mm"', 'roller = "-1 mm"'), "write 0 for a knife edge"),
        (
            "cam",
            ('follower     = "roller"', 'follower = "knife edge"'),
            "has no roller: leave it out",
        ),
    ],
)
def test_what_cannot_be_made_is_one_message(
    tmp_path: Path, name: str, edit: tuple[str, str], says: str
) -> None:
    done = invoke("table", scene_of(tmp_path, name, edit), "-l", "en")
    assert done.exit_code == 2
    assert says in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.slow
def test_a_cam_that_is_too_small_is_named_with_its_angle(tmp_path: Path) -> None:
    scene = read(scene_of(tmp_path, "cam", ('"52.1 mm"', '"40 mm"')))
    (part,) = parts(make(scene))
    told = warnings(part)
    assert any("pressure angle reaches" in text and "φ" in text for text in told)
    done = invoke("table", tmp_path / "scene.toml", "-l", "en")
    assert "pressure angle reaches" in done.stderr


@pytest.mark.slow
def test_a_rocker_and_a_flat_face_fill_their_sheets(tmp_path: Path) -> None:
    rocker = scene_of(
        tmp_path,
        "cam",
        ('stroke       = "28 mm"', 'stroke = "20 deg"'),
        ('follower     = "roller"', 'follower = "rocker"\nlever = "80 mm"\ncentres = "100 mm"'),
        ('transmission = "60 deg"', 'transmission = "50 deg"'),
        ('r0           = "52.1 mm"', ""),
        ('roller       = "16.8 mm"', ""),
    )
    assert sheets(read(rocker))[1]
    flat = scene_of(
        tmp_path,
        "cam",
        ('follower     = "roller"', 'follower = "flat"'),
        ('r0           = "52.1 mm"', ""),
        ('roller       = "16.8 mm"', ""),
        ('transmission = "60 deg"', ""),
    )
    assert sheets(read(flat))[1]
