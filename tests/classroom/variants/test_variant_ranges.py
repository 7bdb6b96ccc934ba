"""Ranges of variants: exact steps, keys of the scene, every fault at once with its line."""

from __future__ import annotations

import random
from contextlib import suppress
from pathlib import Path

import pytest
from support.each import each
from support.gallery import SHEETS, one_crank

from graphic_tmm.classroom.variants.ranges import Good, Range, read_ranges
from graphic_tmm.classroom.variants.variant import Base, base
from graphic_tmm.errors import SceneError

SHIPPED = sorted(path.parent.name for path in SHEETS.glob("*/ranges.toml"))
GOOD = """[ranges]
OA = { from = "90 mm", to = "110 mm", step = "5 mm" }
drive.speed = ["50 rpm", "60 rpm"]
"link 5, mass, kg" = { from = 40, to = 41, step = 0.1 }
links.3.points."S3[1]" = ["0.4 BC", "0.5 BC"]

[good]
transmission = "40 deg"
vector = "2.5 mm"
short = ["cd"]
"""


@pytest.fixture(scope="module")
def shaper() -> Base:
    return base(SHEETS / "shaper")


def file_of(tmp_path: Path, text: str) -> Path:
    file = tmp_path / "ranges.toml"
    file.write_text(text, encoding="utf-8")
    return file


def test_ranges_are_exact_in_decimals(shaper: Base, tmp_path: Path) -> None:
    found = read_ranges(file_of(tmp_path, GOOD), shaper)
    tenths = ("40", *(f"40.{k}" for k in range(1, 10)), "41")
    assert found.ranges == (
        Range("OA", ("90", "95", "100", "105", "110"), "mm"),
        Range("drive.speed", ("50", "60"), "rpm"),
        Range("link 5, mass", tenths, "kg"),
        Range("links.3.points.S3[1]", ("0.4 BC", "0.5 BC")),
    )
    assert found.good == Good(40.0, 2.5, ("cd",))
    assert found.all == 5 * 2 * 11 * 2


@each(
    "text, says",
    [
        ("", ["no key has a range"]),
        ("[ranges]\nOA = 5", ["ranges.toml:2: ranges.OA: write from"]),
        ('[ranges]\nOA = { from = "1 mm", to = "2 mm" }', ["from, to and step"]),
        ('[ranges]\nOA = { from = "1 mm", to = "2 cm", step = "1 mm" }', ["one unit"]),
        ('[ranges]\nOA = { from = "9 mm", to = "2 mm", step = "1 mm" }', ["step is above 0"]),
        ('[ranges]\nOA = { from = "1 mm", to = "2 mm", step = "0 mm" }', ["step is above 0"]),
        ("[ranges]\nOA = { from = 1, to = 2, step = 1e-300 }", ["too small"]),
        ("[ranges]\nOA = { from = 1, to = nan, step = inf }", ["too large"]),
        ("[ranges]\nOA = { from = 1, to = 1e9, step = 1 }", ["1000000000 values"]),
        ('[ranges]\nOA = ["90 mm", "90 mm"]', ["stands twice"]),
        ("[ranges]\nOA = []", ["write from"]),
        ('[ranges]\nAO = ["90 mm"]', [":2: ranges.AO: "]),
        ('[ranges]\nOA = ["90 kg"]', [":2: ranges.OA: "]),
        ('[ranges]\nOA = ["90 mm"]\n"lengths.OA" = ["80 mm"]', [":3: ", "line 2"]),
        ('[ranges]\nOA = ["90 mm"]\n[good]\nvector = "3 kg"', [":4: good.vector"]),
        ('[ranges]\nOA = ["90 mm"]\n[good]\ntransmission = 100', [":4: good.transmission"]),
        ('[ranges]\nOA = ["90 mm"]\n[good]\nshort = 5', [":4: good.short"]),
        ('[ranges]\nOA = ["90 mm"]\n[good]\nvektor = 5', ['did you mean "vector"']),
        ('[range]\nOA = ["90 mm"]', ['did you mean "ranges"']),
        ("ranges = 5", ["[ranges] is wanted"]),
        ("[ranges", ["ranges.toml:1"]),
        ("[ranges]\nOA = 5\nOB = []\n[good]\nx = 1", [":2: ", ":3: ", ":5: "]),
    ],
)
def test_what_is_wrong_is_told_at_its_line(
    text: str, says: list[str], shaper: Base, tmp_path: Path
) -> None:
    with pytest.raises(SceneError) as told:
        read_ranges(file_of(tmp_path, text), shaper)
    for one in says:
        assert one in str(told.value)


@pytest.mark.slow
def test_whatever_a_file_of_ranges_holds_is_told_or_read(shaper: Base, tmp_path: Path) -> None:
    random_ = random.Random(3)
    parts = [
        "5",
        '"5 mm"',
        "[]",
        "{}",
        "-1",
        "nan",
        '"a\\u0007"',
        "true",
        "[[1]]",
        "1e400",
        "OA",
        "\n",
    ]
    for _ in range(60):
        text = GOOD
        for _ in range(random_.randrange(1, 3)):
            words = text.split(" ")
            words[random_.randrange(len(words))] = random_.choice(parts)
            text = " ".join(words)
        with suppress(SceneError):
            assert read_ranges(file_of(tmp_path, text), shaper).ranges


@pytest.mark.slow
@each("name", SHIPPED)
def test_the_ranges_that_come_with_scenes_are_good(name: str) -> None:
    scene = base(SHEETS / name)
    found = read_ranges(SHEETS / name / "ranges.toml", scene)
    assert found.all > 1000
    assert found.good.vector >= 1.0
    # a cylinder and a toggle have their places near the dead one, where a crank that turns has none
    assert found.good.transmission >= (30.0 if one_crank(name) else 10.0)


def test_scenes_of_a_department_come_with_ranges() -> None:
    assert {"offset-slider", "crank-rocker", "shaper", "crank-press", "toggle-press"} < set(SHIPPED)
    assert {"tipper", "excavator", "gripper", "hand-clamp", "toggle-clamp"} < set(SHIPPED)
    assert {"v-engine", "two-stage-compressor"} < set(SHIPPED)
