"""The sections [indicator] and [flywheel]: what they say, what they may not say."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import SHEETS

from graphic_tmm.chapters.flywheel.task import Rim
from graphic_tmm.chapters.indicator.task import Gas, Stretch
from graphic_tmm.errors import SceneError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

ENGINE = (SHEETS / "engine" / "scene.toml").read_text(encoding="utf-8")


def scene(folder: Path, *edits: tuple[str, str]) -> Scene:
    text = ENGINE
    for old, new in edits:
        assert old in text
        text = text.replace(old, new, 1)
    (folder / "scene.toml").write_text(text, encoding="utf-8")
    return read(folder)


def test_the_engine_asks_for_its_flywheel(tmp_path: Path) -> None:
    order = scene(tmp_path).tasks["flywheel"]
    assert order is not None
    assert (order.delta, order.A.pole, order.mu_M, order.constant) == (0.23, 40.0, 8.0, "resisting")
    assert order.rim == Rim(0.45, 0.85, 110.0, 7800.0, 0.056, 3, 0.016, 0.38)
    assert order.indicator.cover.pressures[:3] == (300e3, 300e3, 240e3)
    assert (order.indicator.mu, order.indicator.height) == (1500.0, 200.0)
    assert order.indicator.shaft is None


def test_other_words_and_units(tmp_path: Path) -> None:
    shaft = "shaft = [" + ", ".join(['"1 bar"'] * 12) + ']\nrod = "30 mm"\n'
    made = scene(
        tmp_path,
        (
            'constant = "resisting"\ndelta = 0.23',
            'delta = "4 %"\nconstant = "движущий"\nintegration = "хорды"\ntangents = "нет"',
        ),
        ('D_e   = "0.45 m"', 'D_e = "450 мм"\nmaterial = "чугун"\nshaft = "60 mm"\nstuds = 4'),
        ('mu_p   = "1500 Pa/mm"', shaft + 'mu_p = "1.5 kPa/mm"'),
    ).tasks["flywheel"]
    assert made is not None
    assert (made.delta, made.constant, made.integration, made.tangents) == (
        0.04, "driving", "chords", None,
    )  # fmt: skip
    assert made.rim is not None
    assert (made.rim.speed_limit, made.rim.density) == (35.0, 7200.0)
    assert (made.rim.shaft, made.rim.studs) == (0.06, 4)
    assert made.indicator.shaft == Gas((1e5,) * 12, 0.12, 0.03)
    assert made.indicator.mu == 1500.0


COVER = ENGINE[ENGINE.index("cover  = [") : ENGINE.index("mu_p   =")]


def test_the_diagram_by_points(tmp_path: Path) -> None:
    points = (
        'cover_points = { out = [[0, "3 bar"], [0.4, "2.6 bar"], [1, "60 kPa"]], '
        'back = [[1, "30 kPa"], [0, "1.5 bar"]] }\n'
    )
    order = scene(tmp_path, (COVER, points)).tasks["flywheel"]
    assert order is not None
    assert order.indicator.cover.stretches == (
        Stretch("out", 0.0, 0.4, 300e3, None, 260e3),
        Stretch("out", 0.4, 1.0, 260e3, None, 60e3),
        Stretch("back", 1.0, 0.0, 30e3, None, 150e3),
    )


def test_the_diagram_by_polytropic_strokes(tmp_path: Path) -> None:
    order = scene(tmp_path, (COVER, STROKES)).tasks["flywheel"]
    assert order is not None
    assert order.indicator.cover == Gas((), 0.12, 0.0, (
        Stretch("out", 0.0, 0.3, 600e3, 0.0),
        Stretch("out", 0.3, 1.0, 600e3, 1.0),
        Stretch("back", 1.0, 0.25, 110e3, 0.0),
        Stretch("back", 0.25, 0.0, 110e3, 1.2),
    ), 0.08)  # fmt: skip


STROKES = """clearance = "8 %"
cover_strokes = [
  { stroke = "out",  to = 0.3,  p = "600 kPa", n = 0 },
  { stroke = "out",  to = 1,    p = "600 kPa", n = 1 },
  { stroke = "back", to = 0.25, p = "110 kPa", n = 0 },
  { stroke = "back", to = 0,    p = "110 kPa", n = 1.2 },
]
"""


@pytest.mark.parametrize(
    ("text", "key", "says"),
    [
        ("", "indicator.cover", "cover_points, or cover_strokes"),
        (COVER + STROKES, "indicator.cover_strokes", "leave one of them out"),
        (STROKES.replace("to = 1, ", "to = 0.2,"), "indicator.cover_strokes[2].to", "come to 0.3"),
        (
            STROKES.replace("to = 0,   ", "to = 0.1, "),
            "indicator.cover_strokes",
            "add the last part",
        ),
        (STROKES.replace("8 %", "0 %"), "indicator.clearance", "clearance = 0.08"),
        (STROKES.replace("n = 1.2", "n = 9"), "indicator.cover_strokes[4].n", "0 to 3"),
        (
            STROKES.replace('"out",  to = 1', '"up",  to = 1'),
            "indicator.cover_strokes[2].stroke",
            "out",
        ),
        (
            'cover_points = { out = [[0, "3 bar"], [1, "1 bar"]], back = [[0.9, "1 bar"], [0, "2 bar"]] }\n',
            "indicator.cover_points.back",
            "from 1 to 0",
        ),
        (
            'cover_points = { out = [[0, "3 bar"], [1, "1 bar"]] }\n',
            "indicator.cover_points.back",
            "missing",
        ),
        (
            "cover_points = { out = 3, back = 4 }\n",
            "indicator.cover_points.back",
            "points of the stroke",
        ),
    ],
)
def test_parts_that_do_not_fit_are_told(tmp_path: Path, text: str, key: str, says: str) -> None:
    with pytest.raises(SceneError) as refused:
        scene(tmp_path, (COVER, text))
    told = {fault.key: fault.message for fault in refused.value.faults}
    assert key in told
    assert says in told[key]


def test_without_a_rim_there_is_no_sketch(tmp_path: Path) -> None:
    order = scene(tmp_path, ('D_e   = "0.45 m"', ""), ('D_i   = "0.38 m"', "")).tasks["flywheel"]
    assert order is not None
    assert order.rim is None


@pytest.mark.parametrize(
    ("edit", "key", "says"),
    [
        (("delta = 0.23", "delta = 0"), "flywheel.delta", "greater than 0"),
        (("delta = 0.23", "delta = -0.1"), "flywheel.delta", "greater than 0"),
        (("delta = 0.23", "delta = true"), "flywheel.delta", "greater than 0"),
        (("delta = 0.23\n", ""), "flywheel.delta", "write for example delta = 0.04"),
        (('H     = "40 mm"', 'H = "0 mm"'), "flywheel.H", "60 mm"),
        (('H     = "40 mm"', 'h = "40 mm"'), "flywheel.h", '"H"'),
        (('"144 kPa"]', "]"), "indicator.cover", "11 pressures for 12 positions"),
        (('"144 kPa"]', '"144 kg"]'), "indicator.cover", "kPa"),
        (('point  = "B"', 'point  = "Q"'), "indicator.point", "points of moving links are"),
        (('bore   = "0.12 m"', 'bore = "0 m"'), "indicator.bore", "not greater than 0"),
        (('bore   = "0.12 m"', 'bore = "0.12 m"\nrod = "20 mm"'), "indicator.rod", "write shaft"),
        (('D_e   = "0.45 m"', 'D_e = "0.45 m"\nmaterial = "wood"'), "flywheel.material", "steel"),
        (('D_e   = "0.45 m"', 'D_e = "0.45 m"\nratio = 1.2'), "flywheel.ratio", "less than 1"),
        (('D_e   = "0.45 m"', 'D_e = "0.45 m"\nstuds = 0'), "flywheel.studs", "1"),
    ],
)
def test_what_cannot_be_meant_is_told_with_a_remedy(
    tmp_path: Path, edit: tuple[str, str], key: str, says: str
) -> None:
    with pytest.raises(SceneError) as refused:
        scene(tmp_path, edit)
    told = [(fault.key, fault.message) for fault in refused.value.faults]
    assert [found for found, _ in told] == [key]
    assert says in told[0][1]


def test_a_flywheel_needs_the_pressures(tmp_path: Path) -> None:
    start, end = ENGINE.index("[indicator]"), ENGINE.index("[flywheel]")
    (tmp_path / "scene.toml").write_text(ENGINE[:start] + ENGINE[end:], encoding="utf-8")
    with pytest.raises(SceneError, match=r"write a section \[indicator\]"):
        read(tmp_path)


def test_a_flywheel_that_is_placed_has_to_be_asked_for(tmp_path: Path) -> None:
    start, end = ENGINE.index("[indicator]"), ENGINE.index("[plans]")
    (tmp_path / "scene.toml").write_text(ENGINE[:start] + ENGINE[end:], encoding="utf-8")
    with pytest.raises(SceneError, match=r"write a section \[flywheel\]"):
        read(tmp_path)
