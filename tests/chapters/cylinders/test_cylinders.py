"""Inertia of several cylinders against the pistons' own motion by FFT, and against the known tables."""

from __future__ import annotations

import math
import re
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
from support.boards import in_usual_size

from graphic_tmm.chapters.cylinders.plan import CYLINDERS_PLAN
from graphic_tmm.chapters.cylinders.table import cylinder_results, cylinder_table, rest_table
from graphic_tmm.chapters.cylinders.task_sheet import TASK_SHEET
from graphic_tmm.chapters.cylinders.views import cylinder_views
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.errors import SceneError
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read

MASS, CRANK, ROD, SPEED, SPACING = 0.8, 0.04, 0.16, 300.0, 0.1
FORCE, RATIO = MASS * CRANK * SPEED**2, CRANK / ROD
POINTS = 256


class Piston(NamedTuple):
    """A cylinder of the oracle: angles of crank and axis, degrees; place, m."""

    crank: float
    axis: float
    place: float


def scene_of(folder: Path, more: str, *, hand: str = "") -> Path:
    text = (
        f'title = "T"\nlanguage = "en"\n[cylinders]\nmass = {MASS}\ncrank = {CRANK}\nrod = {ROD}\n'
    )
    text += f"speed = {SPEED}\n{more}\n{hand}\n"
    path = folder / "scene.toml"
    path.write_text(text + '[[sheet]]\nformat = "A1"\nplace = ["cylinders"]\n', encoding="utf-8")
    return path


def drawn_of(folder: Path, more: str, *, hand: str = "") -> Drawn:
    (found,) = in_usual_size(read(scene_of(folder, more, hand=hand)), exact=not hand).boards
    return found


def figures_of(drawn: Drawn) -> dict[str, float]:
    return {
        name.removeprefix("cylinders_"): figure
        for name, (figure, _) in single(cylinder_results(drawn)).items()
    }


def shaking(pistons: list[Piston]) -> dict[str, tuple[float, float, complex, complex]]:
    """Greatest and least of each order, and its two parts, of where the pistons really are over a turn."""
    phi = np.arange(POINTS) * 2 * np.pi / POINTS
    force = np.zeros(POINTS, complex)
    moment = np.zeros(POINTS, complex)
    for one in pistons:
        beta = phi + math.radians(one.crank - one.axis)
        way = CRANK * np.cos(beta) + np.sqrt(ROD**2 - (CRANK * np.sin(beta)) ** 2)
        toward = way * np.exp(1j * math.radians(90.0 + one.axis))
        force += MASS * SPEED**2 * toward
        moment += MASS * SPEED**2 * toward * one.place
    found = {}
    for letter, row in (("F", force), ("M", moment)):
        parts = np.fft.fft(row) / POINTS
        for n in (1, 2):
            direct, reverse = n * n * parts[n], n * n * parts[-n]
            a, b = abs(direct), abs(reverse)
            found[f"{letter}{n}"] = a + b, abs(a - b), direct, reverse
    return found


def agrees(found: dict[str, float], pistons: list[Piston]) -> None:
    due = shaking(pistons)
    places = max(abs(one.place) for one in pistons)
    for name, (most, least, direct, reverse) in due.items():
        n = int(name[1])
        unit = FORCE * (RATIO if n == 2 else 1.0) * (places or 1.0 if name[0] == "M" else 1.0)
        # the second harmonic of a piston is λ + λ³/4 + …
        rel = 1e-9 if n == 1 else RATIO**2 / 2
        size = found.get(name, 0.0)
        assert size == pytest.approx(most, rel=rel, abs=1e-9 * unit), name
        if f"{name}_least" in found:
            assert found[f"{name}_least"] == pytest.approx(least, rel=rel, abs=rel * unit * 12), (
                name
            )
        if f"{name}_at" in found:
            # so far turned, the force is as great as it gets
            turn = np.exp(1j * n * math.radians(found[f"{name}_at"]))
            assert abs(direct * turn + reverse / turn) == pytest.approx(most, rel=1e-6), name


def throws(count: int, *, offset: float = 0.0) -> list[float]:
    return [(k - (count - 1) / 2) * SPACING + offset for k in range(count)]


@pytest.mark.parametrize("seed", range(60))
def test_any_engine_shakes_as_its_pistons_do(seed: int, tmp_path: Path) -> None:
    random = np.random.default_rng(seed)
    layout = ("in line", "V", "opposed")[seed % 3]
    pins = int(random.integers(1, 13 if layout == "in line" else 7))
    cranks = [float(30 * random.integers(-12, 13)) for _ in range(pins)]
    if seed % 2:
        cranks = [float(random.uniform(-360, 360)) for _ in range(pins)]
    angle, offset = float(random.uniform(10, 180)), float(random.uniform(0, 0.05))
    more = f'layout = "{layout}"\ncranks = {cranks}\nspacing = {SPACING}\n'
    count = pins if layout == "in line" else 2 * pins
    more += f"count = {count}\n"
    more += f"angle = {angle}\n" if layout == "V" else ""
    more += f"offset = {offset}\n" if layout != "in line" else ""
    if layout == "in line":
        pistons = [Piston(c, 0.0, z) for c, z in zip(cranks, throws(pins), strict=True)]
    else:
        half = angle / 2 if layout == "V" else 90.0
        more_turn = 180.0 if layout == "opposed" else 0.0
        left = zip(cranks, throws(pins, offset=-offset / 2), strict=True)
        right = zip(cranks, throws(pins, offset=offset / 2), strict=True)
        pistons = [Piston(c, half, z) for c, z in left]
        pistons += [Piston(c + more_turn, -half, z) for c, z in right]
    agrees(figures_of(drawn_of(tmp_path, more)), pistons)


ROOT3, ROOT10 = math.sqrt(3), math.sqrt(10)
KNOWN = {
    "one": ("count = 1\ncranks = [0]", {"F1": 1, "F2": 1}),
    "two, cranks opposite": ("count = 2\ncranks = [0, 180]", {"M1": 1, "F2": 2}),
    "two, cranks together": ("count = 2\ncranks = [0, 0]", {"F1": 2, "F2": 2}),
    "three": ("count = 3\ncranks = [0, 240, 120]", {"M1": ROOT3, "M2": ROOT3}),
    "four": ("count = 4\ncranks = [0, 180, 180, 0]", {"F2": 4}),
    "four by firing": ("count = 4\nfiring = [1, 3, 4, 2]", {"F2": 4}),
    "five by firing": ("count = 5\nfiring = [1, 2, 4, 5, 3]", {"M1": 0.4490, "M2": 4.9798}),
    "six by firing": ("count = 6\nfiring = [1, 5, 3, 6, 2, 4]", {}),
    "eight": ("count = 8\ncranks = [0, 180, 90, 270, 270, 90, 180, 0]", {}),
    "twelve": ("count = 12\ncranks = [0, 120, 240, 240, 120, 0, 0, 120, 240, 240, 120, 0]", {}),
    "two-stroke twin": ("count = 2\nfiring = [1, 2]\nstrokes = 2", {"M1": 1, "F2": 2}),
    "V twin, 90°": ('layout = "V"\ncount = 2\ncranks = [0]', {"F1": 1, "F2": math.sqrt(2)}),
    "V twin, 60°": (
        'layout = "V"\ncount = 2\ncranks = [0]\nangle = 60', {"F1": 1.5, "F2": ROOT3 / 2},
    ),
    "V8, cross plane": ('layout = "V"\ncount = 8\ncranks = [0, 90, 270, 180]', {"M1": ROOT10}),
    "V8, flat plane": (
        'layout = "V"\ncount = 8\ncranks = [0, 180, 180, 0]', {"F2": 4 * math.sqrt(2)},
    ),
    "V12, 60°": ('layout = "V"\ncount = 12\nangle = 60\ncranks = [0, 120, 240, 240, 120, 0]', {}),
    "boxer twin": (
        f'layout = "opposed"\ncount = 2\ncranks = [90]\noffset = {SPACING}', {"M1": 1, "M2": 1},
    ),
    "boxer four": (
        f'layout = "opposed"\ncount = 4\ncranks = [90, 270]\noffset = {SPACING / 2}', {"M2": 1},
    ),
    "boxer six": ('layout = "opposed"\ncount = 6\ncranks = [0, 120, 240]', {}),
}  # fmt: skip
"""In m·r·ω² (λ times that of the second order), moments by the spacing: Taylor, Heywood, Rattan, Norton."""


@pytest.mark.parametrize("engine", KNOWN)
def test_known_tables(engine: str, tmp_path: Path) -> None:
    more, due = KNOWN[engine]
    drawn = drawn_of(tmp_path, f"{more}\nspacing = {SPACING}")
    found = figures_of(drawn)
    for name in ("F1", "M1", "F2", "M2"):
        unit = FORCE * (RATIO if name[1] == "2" else 1.0) * (SPACING if name[0] == "M" else 1.0)
        size = found.get(name, 0.0)
        if name in due:
            assert size == pytest.approx(due[name] * unit, rel=1e-4), name
        else:
            assert size == 0.0, name  # not nearly nothing: nothing
            assert CYLINDERS_PLAN.on(drawn).rests[name].size is None
    balanced = any("balance one another" in one for one in warnings(drawn, "en"))
    assert balanced == (not due)


def test_what_turns_with_the_shaft_can_be_balanced(tmp_path: Path) -> None:
    drawn = drawn_of(tmp_path, 'layout = "V"\ncount = 2\ncranks = [0]')
    found = figures_of(drawn)
    assert found["F1_least"] == found["F1"]
    assert "F1_at" not in found
    assert any("counterweights can balance them" in one for one in warnings(drawn, "en"))
    apart = drawn_of(tmp_path, 'layout = "V"\ncount = 2\ncranks = [0]\nangle = 60')
    assert figures_of(apart)["F1_least"] == pytest.approx(0.5 * FORCE)
    assert not list(warnings(apart, "en"))


def test_nothing_is_told_to_the_size_that_the_ruler_shows(tmp_path: Path) -> None:
    more = f"count = 4\ncranks = [0, 180, 180, 0]\nspacing = {SPACING}"
    drawn = drawn_of(tmp_path, more, hand='[hand]\nruler = "0.5 mm"')
    texts = [label.text for label in rest_table(drawn).labels]
    mu = drawn.scales["cylinders-F1"].value
    assert f"0 (within {0.25 * mu:.2g})" in texts
    assert rest_table(drawn_of(tmp_path, more)).labels[-1].text != ""


def test_table_and_views(tmp_path: Path) -> None:
    more = f"count = 4\ncranks = [0, 180, 180, 0]\nspacing = {SPACING}"
    drawn = drawn_of(tmp_path, more)
    texts = [label.text for label in cylinder_table(drawn).labels]
    for told in ("1", "4", "180.0", "270.0", "90.0", "−150", "150"):
        assert told in texts, told
    names = [view.name for view in cylinder_views(drawn, lettered=True)]
    assert not {"450.0", "810.0"} & set(texts)  # a direction within one turn
    assert names == [
        "cylinders-shaft", "cylinders-star", "cylinders-F1", "cylinders-M1", "cylinders-F2",
        "cylinders-M2", "table-cylinders", "table-remains",
    ]  # fmt: skip


def test_moments_of_a_bank_are_headed_as_the_halves_that_they_are(tmp_path: Path) -> None:
    drawn = drawn_of(tmp_path, f'count = 4\nlayout = "V"\ncranks = [0, 180]\nspacing = {SPACING}')
    texts = [label.text for label in cylinder_table(drawn).labels]
    assert any("M_{II}/2" in text for text in texts), texts
    half = FORCE / 2 * SPACING / 2
    shown = [float(text.replace("−", "-")) for text in texts if re.fullmatch(r"−?[0-9.]+", text)]
    assert any(abs(one) == pytest.approx(half, rel=1e-3) for one in shown)
    alone = drawn_of(tmp_path, f"count = 4\ncranks = [0, 180, 180, 0]\nspacing = {SPACING}")
    assert not any("/2" in label.text for label in cylinder_table(alone).labels)


@pytest.mark.parametrize(
    ("firing", "apart"),
    [([1, 5, 4, 8, 6, 3, 7, 2], "1–5 (180°), 2–6 (180°)"), ([1, 8, 4, 3, 6, 5, 7, 2], "1–5 (")],
)
def test_an_order_that_no_pin_with_two_rods_gives_is_told(
    firing: list[int], apart: str, tmp_path: Path
) -> None:
    more = f'count = 8\nlayout = "V"\nfiring = {firing}\nspacing = {SPACING}'
    drawn = drawn_of(tmp_path, more)
    (line,) = (one for one in warnings(drawn, "en") if "cranks apart" in one)
    assert apart in line
    (stands, _) = TASK_SHEET.stated(drawn.scene, "en")
    assert "a crank for each" in stands


def test_an_order_that_puts_two_rods_on_each_pin_is_not_warned_of(tmp_path: Path) -> None:
    """The right bank is met 90° of the shaft before the left one."""
    more = f'count = 8\nlayout = "V"\nfiring = [5, 1, 8, 4, 7, 3, 6, 2]\nspacing = {SPACING}'
    drawn = drawn_of(tmp_path, more)
    assert not any("cranks apart" in one for one in warnings(drawn, "en"))
    (stands, _) = TASK_SHEET.stated(drawn.scene, "en")
    assert "two rods on each pin" in stands


@pytest.mark.parametrize(
    ("more", "key", "remedy"),
    [
        ('layout = "V"\ncount = 3\ncranks = [0]', "cylinders.count", "even number"),
        ("count = 2\nspacing = 0.1", "cylinders", "or firing"),
        ("count = 2\nspacing = 0.1\ncranks = [0, 180]\nfiring = [1, 2]", "cylinders", "either cranks"),
        ("count = 3\nspacing = 0.1\ncranks = [0, 180]", "cylinders.cranks", "3 are wanted"),
        ("count = 3\nspacing = 0.1\nfiring = [1, 2]", "cylinders.firing", "each of them once"),
        ("count = 3\nspacing = 0.1\nfiring = [1, 2, 2]", "cylinders.firing", "[1, 3, 4, 2]"),
        ("count = 2\ncranks = [0, 180]", "cylinders.spacing", 'write spacing = "100 mm"'),
        ("count = 1\ncranks = [0]\nstrokes = 3", "cylinders.strokes", "4 strokes, or 2"),
        ("count = 1\ncranks = [0]\nangle = 60", "cylinders.angle", 'write layout = "V"'),
        ("count = 1\ncranks = [0]\noffset = 0.02", "cylinders.offset", "or leave it out"),
        ("count = 1\ncranks = [0]\nstrokes = 2", "cylinders.strokes", "or write firing"),
        ("count = 13\ncranks = [0]\nspacing = 0.1", "cylinders.count", "12"),
    ],
)  # fmt: skip
def test_refusals_name_the_key_and_the_remedy(
    more: str, key: str, remedy: str, tmp_path: Path
) -> None:
    with pytest.raises(SceneError) as refused:
        read(scene_of(tmp_path, more))
    assert key in str(refused.value)
    assert remedy in str(refused.value)


def test_a_rod_is_longer_than_its_crank(tmp_path: Path) -> None:
    path = scene_of(tmp_path, "count = 1\ncranks = [0]")
    path.write_text(path.read_text().replace(f"rod = {ROD}", "rod = 0.04"))
    with pytest.raises(SceneError, match="change rod"):
        read(path)
