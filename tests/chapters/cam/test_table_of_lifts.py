"""A law given by a table of displacements: chords against differences, contact with the profile, findings."""

from __future__ import annotations

import json
import random
import re
from pathlib import Path

import numpy as np
import pytest
from support.cam_tables import FALL, RISE, STROKE, by_differences, cam_of, read_off, table
from support.cams import SHAPES, displaced, made
from support.each import each
from support.scenes import written

import graphic_tmm
from graphic_tmm.chapters.cam.findings import of_tables
from graphic_tmm.chapters.cam.kinds import FlatFollower, Follower, RockerFollower, RollerFollower
from graphic_tmm.chapters.cam.task import ASKED, CamTask
from graphic_tmm.chapters.cam.task_motion import Law, law_of
from graphic_tmm.errors import SceneError
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene


def smooth(draw: random.Random, count: int) -> np.ndarray:
    """A table that begins and ends at rest: a mixture of laws."""
    shares = [draw.random() for _ in SHAPES]
    u = np.linspace(0.0, 1.0, count)
    mixed = sum(share * of[0](u) for share, of in zip(shares, SHAPES.values(), strict=True))
    return np.asarray(mixed / sum(shares))


@pytest.mark.parametrize("seed", range(6))
def test_random_tables_are_differentiated_by_chords(seed: int) -> None:
    draw = random.Random(f"table {seed}")
    up, down = (smooth(draw, draw.randint(9, 40)) for _ in range(2))
    fall = [(a, STROKE - y) for a, y in table(down, FALL)]
    of = cam_of(law_of(table(up, RISE)), law_of(fall))
    for found, due in zip(read_off(of, 0), by_differences(up, RISE), strict=True):
        np.testing.assert_allclose(found, due, atol=1e-9 * np.abs(due).max())
    for found, due in zip(read_off(of, 1), by_differences(1.0 - down, FALL), strict=True):
        np.testing.assert_allclose(found, due, atol=1e-9 * np.abs(due).max())


@pytest.mark.parametrize("name", SHAPES)
def test_a_dense_table_of_a_law_is_that_law(name: str) -> None:
    """Chords are off by their step squared, next to a jump of the acceleration by half of it."""
    steps = 60
    u = np.linspace(0.0, 1.0, steps + 1)
    law = law_of(table(SHAPES[name][0](u), RISE))
    _, speed, second = read_off(cam_of(law, law_of(table(SHAPES[name][0](u), RISE), own=False)), 0)
    phase = np.radians(RISE)
    due = [STROKE * SHAPES[name][k](u) / phase**k for k in (1, 2)]
    assert np.abs(speed - due[0]).max() <= 0.03 * due[0].max()
    smooth_there = np.abs(np.diff(due[1], prepend=due[1][0], append=due[1][-1]))
    calm = np.maximum(smooth_there[1:], smooth_there[:-1]) < 0.2 * np.abs(due[1]).max()
    assert calm.sum() > 0.8 * steps
    assert np.abs(second - due[1])[calm].max() <= 0.02 * np.abs(due[1]).max()


FOLLOWERS: dict[str, tuple[Follower, float]] = {
    "central": (RollerFollower(), STROKE),
    "offset": (RollerFollower(0.005), STROKE),
    "lever": (RockerFollower(0.1, 0.13), 0.2),
    "flat": (FlatFollower(0.004), STROKE),
}


@each("kind", list(FOLLOWERS))
def test_the_profile_lifts_its_follower_by_the_table(kind: str) -> None:
    follower, stroke = FOLLOWERS[kind]
    u = np.linspace(0.0, 1.0, 25)
    law = law_of(table(SHAPES["cosine"][0](u), RISE, stroke))
    of = cam_of(law, law_of(table(SHAPES["sine"][0](u), FALL, stroke)), follower, stroke)
    angles = np.linspace(0.0, RISE, 25)[1:-1]
    due = stroke * SHAPES["cosine"][0](u)[1:-1]
    assert np.abs(displaced(of, angles) - due).max() <= 1e-3 * stroke


def told(heights: np.ndarray) -> list[str]:
    law = law_of(table(heights, RISE))
    return list(of_tables(cam_of(law, Law("sine")).cam, "en"))


@pytest.mark.parametrize("name", SHAPES)
@pytest.mark.parametrize("steps", [8, 12, 30])
def test_of_a_sound_table_nothing_is_told(name: str, steps: int) -> None:
    assert told(SHAPES[name][0](np.linspace(0.0, 1.0, steps + 1))) == []


def test_few_lines_a_shock_and_noise_are_told() -> None:
    (few,) = told(SHAPES["cosine"][0](np.linspace(0.0, 1.0, 7)))
    assert "has 6 steps" in few
    begins, ends = told(np.linspace(0.0, 1.0, 13))
    assert "begins phase 1 with the velocity dS/dφ = 0.00955 (SI): a hard shock" in begins
    assert "ends phase 1" in ends
    digits = np.round(SHAPES["cosine"][0](np.linspace(0.0, 1.0, 61)), 2)
    noise = told(digits)[-1]
    assert "changes its sign" in noise
    assert "noise" in noise


def rounded(folder: Path, heights: np.ndarray, stroke: int, decimals: int) -> list[str]:
    """What is told of a table whose displacements are printed with so many decimals of mm."""
    steps = len(heights) - 1
    lines = [
        [f"{RISE * k / steps:.9f} deg", f"{stroke * y:.{decimals}f} mm"]
        for k, y in enumerate(heights)
    ]
    text = f'title = "T"\nlanguage = "en"\n[cam]\nstroke = "{stroke} mm"\nrise = "{RISE} deg"\nfall = 90\n'
    text += f'law = "table"\nlaw_table = {json.dumps(lines)}\nreturn_law = "sine"\n'
    order = ASKED.of(read(written(folder, text)))
    assert order is not None
    return list(of_tables(made(order).cam, "en"))


@pytest.mark.parametrize("seed", range(12))
def test_a_smooth_table_that_is_rounded_is_no_shock(tmp_path: Path, seed: int) -> None:
    """However its figures are rounded; an even motion is one, if a digit is no more than a hundredth."""
    draw = random.Random(f"rounded {seed}")
    steps, stroke = draw.randint(8, 72), draw.randint(8, 60)
    for decimals in range(4):
        smoothly = rounded(tmp_path, smooth(draw, steps + 1), stroke, decimals)
        assert not [one for one in smoothly if "shock" in one], (steps, stroke, decimals)
        evenly = rounded(tmp_path, np.linspace(0.0, 1.0, steps + 1), stroke, decimals)
        if 10.0**-decimals <= 0.01 * stroke:
            assert len([one for one in evenly if "shock" in one]) == 2, (steps, stroke, decimals)


@each(
    "steps, decimals, off",
    [(12, 1, 29), (12, 2, None), (24, 1, 67), (24, 2, 11), (24, 3, None)],
)
def test_how_far_rounding_spoils_accelerations_is_told(
    tmp_path: Path, steps: int, decimals: int, off: int | None
) -> None:
    """Two digits by the largest second difference of the rounded figures."""
    heights = SHAPES["cosine"][0](np.linspace(0.0, 1.0, steps + 1))
    found = rounded(tmp_path, heights, 20, decimals)
    if off is None:
        assert found == []
        return
    (says,) = found
    assert f"rounded to {10.0**-decimals:g} mm" in says
    assert f"by {off} % of its largest" in says
    due = 200.0 * 10.0**-decimals / np.diff(np.round(20.0 * heights, decimals), 2).max()
    assert abs(off - due) <= 1.0


def test_a_table_that_does_not_begin_at_rest_goes_on_straight() -> None:
    of = cam_of(law_of(table(np.linspace(0.0, 1.0, 13), RISE)), Law("sine"))
    _, speed, second = read_off(of, 0)
    np.testing.assert_allclose(speed, STROKE / np.radians(RISE), rtol=1e-9)
    assert np.abs(second).max() <= 1e-9


HEAD = """title = "T"
language = "en"
[cam]
stroke = "20 mm"
rise = 100
fall = 100
"""
LINES = (
    '[["0 deg", "0 mm"], [20, "2 mm"], [40, 0.008], [60, "15 mm"], [80, "19 mm"], [100, "2 cm"]]'
)
BACK = '[[0, "20 mm"], [25, "15 mm"], [50, "8 mm"], [75, "2 mm"], [100, 0]]'


def test_units_and_the_return(tmp_path: Path) -> None:
    order = ASKED.of(read(written(tmp_path, f'{HEAD}law = "table"\nlaw_table = {LINES}\n')))
    assert order is not None
    heights = [y for _, y in order.rise_law.points]
    np.testing.assert_allclose(heights, [0.0, 0.1, 0.4, 0.75, 0.95, 1.0], rtol=1e-12)
    assert order.return_law.points == order.rise_law.points
    text = f'{HEAD}law = "table"\nlaw_table = {LINES}\nreturn_table = {BACK}\n'
    order = ASKED.of(read(written(tmp_path, text)))
    assert order is not None
    np.testing.assert_allclose([y for _, y in order.return_law.points], [0.0, 0.1, 0.4, 0.75, 1.0])


def test_a_lever_and_a_phase_have_tables_too(tmp_path: Path) -> None:
    swing = '[[0, "0 deg"], [20, "1 deg"], [40, "5 deg"], [60, "9 deg"], [80, "10 deg"]]'
    phases = f"""title = "T"
language = "en"
[cam]
follower = "rocker"
lever = "100 mm"
centres = "130 mm"
[[cam.phase]]
rise = 80
stroke = "10 deg"
law_table = {swing}
[[cam.phase]]
dwell = 150
[[cam.phase]]
fall = 130
stroke = "10 deg"
"""
    one = read(written(tmp_path, phases))
    order = ASKED.of(one)
    assert order is not None
    assert order.phases[0].law == Law(
        "table", ((0.0, 0.0), (0.25, 0.1), (0.5, 0.5), (0.75, 0.9), (1.0, 1.0)),
        size=(80.0, np.radians(10.0)),
    )  # fmt: skip
    found = graphic_tmm.motion(one, [20.0, 40.0, 100.0], exact=True).columns["S"]
    np.testing.assert_allclose(found, np.radians([1.0, 5.0, 10.0]), atol=1e-9)


TURN = """title = "T"
language = "en"
[cam]
{cam}
[[cam.phase]]
rise = 100
stroke = "20 mm"
{rise}
[[cam.phase]]
fall = 120
stroke = "20 mm"
{fall}
[[cam.phase]]
dwell = 140
"""


def phases(folder: Path, cam: str = "", rise: str = "", fall: str = "") -> CamTask:
    order = ASKED.of(read(written(folder, TURN.format(cam=cam, rise=rise, fall=fall))))
    assert order is not None
    return order


def test_a_phase_without_a_law_takes_the_table_of_the_cam_by_its_own_size(tmp_path: Path) -> None:
    """Lines of 100° and 20 mm: of another phase the same shares; a law of its own goes before."""
    cam = f'law = "table"\nlaw_table = {LINES}'
    rise, fall, _ = phases(tmp_path, cam).phases
    assert rise.law is not None
    assert fall.law == rise.law
    assert rise.law.name == "table"
    of = made(phases(tmp_path, cam, fall='law = "table"'))
    due = STROKE * np.array([1.0, 0.95, 0.75, 0.4, 0.1, 0.0])
    np.testing.assert_allclose(read_off(of, 1)[0], due, atol=1e-12)
    _, fall, _ = phases(tmp_path, cam, fall='law = "cosine"').phases
    assert fall.law is not None
    assert fall.law.name == "cosine"


OWN = f"law_table = {LINES}"


@each(
    "cam, rise, fall, says",
    [
        ("", f'law = "cosine"\n{OWN}', "", 'only law = "table" takes a table'),
        ("", f"shares = [2, 1]\n{OWN}", "", 'only law = "table" takes a table'),
        ("", f"law_points = [[0, 1], [1, -1]]\n{OWN}", "", 'only law = "table" takes a table'),
        ("", 'law = "table"', "", "the law table needs its lines"),
        ('law = "table"', "", 'law = "sine"', "the law table needs its lines"),
        ("", "", OWN, "the table of a return goes down"),
        ("", f"law_table = {BACK}", "", "the table of a rise goes up"),
        ("", OWN.replace("2 cm", "21 mm"), "", "100° long and 21 mm high, its phase 100° and 20 mm"),
        ("", OWN.replace("15 mm", "15 deg"), "", "moves along its guide; write a length"),
        ("", "", f'law_table = {BACK}'.replace("2 mm", "2 deg"), "moves along its guide"),
    ],
)  # fmt: skip
def test_what_is_no_table_of_a_phase_is_refused(
    tmp_path: Path, cam: str, rise: str, fall: str, says: str
) -> None:
    with pytest.raises(SceneError, match=re.escape(says)):
        phases(tmp_path, cam, rise, fall)


@each("table", ["law_table", "return_table"])
def test_lines_of_a_lever_are_angles(tmp_path: Path, table: str) -> None:
    """Even where they are as many metres as the stroke is radians."""
    lines = [[20 * k, f"{20 * k / 5} cm"] for k in range(6)]
    turned = [[a, high] for (a, _), (_, high) in zip(lines, reversed(lines), strict=True)]
    given = {"law_table": lines, "return_table": turned}[table]
    other = '["0 deg", "0 rad"], [50, "0.1 rad"], [100, "0.2 rad"]'
    text = HEAD.replace("20 mm", "0.2 rad") + f'law = "table"\n{table} = {json.dumps(given)}\n'
    text += 'follower = "rocker"\nlever = "100 mm"\ncentres = "130 mm"\n'
    text += f"law_table = [{other}]\n" if table == "return_table" else ""
    with pytest.raises(SceneError, match=f"cam.{table}: a rocker swings through an angle"):
        read(written(tmp_path, text))


def test_between_its_lines_the_curve_is_read() -> None:
    """A cosine law in 24 steps, read off the curves between its lines."""
    u = np.linspace(0.0, 1.0, 25)
    law = law_of(table(SHAPES["cosine"][0](u), RISE))
    order = cam_of(law, Law("sine")).cam.order
    one = Scene("table", "", "en", tasks={"cam": order})
    share = np.linspace(0.02, 0.98, 97)
    found = graphic_tmm.motion(one, share * RISE, exact=True).columns
    phase = np.radians(RISE)
    for k, (name, off) in enumerate((("S", 2e-4), ("dS", 5e-3), ("ddS", 5e-3))):
        due = STROKE * SHAPES["cosine"][k](share) / phase**k
        assert np.abs(found[name] - due).max() <= off * np.abs(due).max(), name


@each(
    "more, says",
    [
        ('law = "table"\n', "the law table needs its lines"),
        (f"law_table = {LINES}\n", 'only law = "table" takes a table'),
        (f'law = "table"\nlaw_table = {LINES}\nreturn_law = "sine"\nreturn_table = {BACK}\n',
         'only return_law = "table" takes a table'),
        ('law = "table"\nlaw_table = 3\n', "write lines of the table"),
        ('law = "table"\nlaw_table = [[0, 0], 3]\n', "a line is an angle and a displacement"),
        ('law = "table"\nlaw_table = [[0, 0], [100, "20 mm"]]\n', "has 4 to 360 steps, not 1"),
        (f'law = "table"\nlaw_table = {LINES.replace("20, ", "50, ")}\n', "lines of the table go up"),
        (f'law = "table"\nlaw_table = {LINES.replace("2 cm", "21 mm")}\n', "make them the same"),
        (f'law = "table"\nlaw_table = {LINES.replace("2 cm", "21 mm")}\n', "21 mm high, its phase"),
        (f'law = "table"\nlaw_table = {LINES.replace("15 mm", "15 deg")}\n', "write a length"),
        (f'law = "table"\nlaw_table = {BACK}\n', "the table of a rise goes up"),
        (f'law = "table"\nlaw_table = {LINES}\nreturn_table = {LINES}\n', "a return goes down"),
        (f'law = "table"\nlaw_table = {LINES.replace("15 mm", "25 mm")}\n', "and not beyond"),
        (f'law = "table"\nlaw_table = {LINES.replace("0 mm", "1 mm")}\n', "go from 0 to the stroke"),
    ],
)  # fmt: skip
def test_what_is_no_table_is_refused(tmp_path: Path, more: str, says: str) -> None:
    with pytest.raises(SceneError, match=says.replace("(", r"\(")):
        read(written(tmp_path, HEAD + more))
