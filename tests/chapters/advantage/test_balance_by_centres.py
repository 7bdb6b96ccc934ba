"""What balances the drive by instantaneous centres: by virtual work of vector loops, by plans, dead places."""

from __future__ import annotations

import cmath
import math
import random
import tomllib
import warnings
from typing import Any, NamedTuple

import numpy as np
import pytest
from support.gallery import SHEETS
from support.random_mechanisms import drawn

import graphic_tmm as tmm
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.advantage.plan import ADVANTAGE_PLAN, Advantage
from graphic_tmm.chapters.advantage.table import columns
from graphic_tmm.chapters.advantage.views import arm_views, figure_marks
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.project import record
from graphic_tmm.readers.findings import warnings as told
from graphic_tmm.studio import make

Scene = dict[str, Any]
PLACES = ["positions", "velocities", "centres", "forces", "lever"]
CLOSE = 1e-9
"""Of the powers of all loads, by what drives."""


class Loop(NamedTuple):
    """A mechanism with its velocities for ω_1 = 1: by link its x axis, the velocity of its origin, ω."""

    scene: Scene
    links: dict[int, tuple[complex, complex, float]]

    def power(self, loads: list[Scene]) -> tuple[float, float]:
        """Return the power of loads, and the sum of the sizes of powers."""
        powers = [self._of(load) for load in loads]
        return sum(powers), sum(map(abs, powers))

    def _of(self, load: Scene) -> float:
        along, velocity, omega = self.links[load["link"]]
        if "moment" in load:
            return float(load["moment"]) * omega
        own = complex(*self.scene["link"][load["link"] - 1]["points"][load["point"]])
        speed = velocity + 1j * omega * along * own
        force = cmath.rect(load["force"], math.radians(float(load["direction"].split()[0])))
        return (force.conjugate() * speed).real


def table(pick: random.Random, links: list[Scene], phi: float, sense: int) -> Scene:
    """A scene of a crank that stands at an angle (rad) in its first position."""
    for link in links:
        link["points"][f"K{link['number']}"] = [pick.uniform(-0.2, 0.3), pick.uniform(-0.2, 0.2)]
    drive = {"link": 1, "speed": "7 rad/s", "positions": 6, "zero": f"{math.degrees(phi)!r} deg"}
    drive["turns"] = "counterclockwise" if sense > 0 else "clockwise"
    return {
        "title": "T",
        "language": "en",
        "link": links,
        "drive": {**drive, "first": 1},
        "hand": {"ruler": "exact"},
        "centres": {"positions": [1]},
        "forces": {"positions": [1], "balance": "moment"},
        "sheet": [{"format": "A1", "place": PLACES}],
    }


def four_bar(pick: random.Random) -> Loop:
    """A crank-rocker: loop OA + AB = OD + DB."""
    while True:
        a, b, c, d = (
            pick.uniform(*one) for one in ((0.05, 0.15), (0.2, 0.4), (0.2, 0.4), (0.3, 0.4))
        )
        if a + max(b, c, d) < a + b + c + d - a - max(b, c, d) - 0.02:
            break
    phi, pivot = pick.uniform(0, math.tau), complex(d, pick.uniform(-0.05, 0.05))
    pin = cmath.rect(a, phi)
    away = pivot - pin
    side = math.acos((b * b + abs(away) ** 2 - c * c) / (2 * b * abs(away)))
    rod = cmath.rect(1.0, cmath.phase(away) + side)  # B on the left of the line from A to D
    rocker = (pin + b * rod - pivot) / c
    # i·a·e + i·ω2·b·rod = i·ω3·c·rocker
    matrix = [[(b * rod).real, -(c * rocker).real], [(b * rod).imag, -(c * rocker).imag]]
    second, third = np.linalg.solve(matrix, [-pin.real, -pin.imag])
    links = [
        {"number": 1, "points": {"O": [0, 0], "A": [a, 0]}},
        {"number": 2, "points": {"A": [0, 0], "B": [b, 0]}},
        {"number": 3, "points": {"D": [0, 0], "B": [c, 0]}, "side": "left of AD"},
    ]
    scene = table(pick, links, phi, pick.choice((1, -1)))
    scene["frame"] = {"O": [0, 0], "D": [pivot.real, pivot.imag]}
    known = {
        1: (pin / a, 0j, 1.0),
        2: (rod, 1j * pin, float(second)),
        3: (rocker, 0j, float(third)),
    }
    return Loop(scene, known)


def slider_crank(pick: random.Random) -> Loop:
    """An offset slider-crank along x: loop OA + AB = x + i·e."""
    a, e = pick.uniform(0.05, 0.12), pick.uniform(-0.04, 0.04)
    b, phi = pick.uniform(0.25, 0.4), pick.uniform(0, math.tau)
    pin = cmath.rect(a, phi)
    sine = (e - pin.imag) / b
    rod = complex(math.sqrt(1 - sine * sine), sine)
    second = -pin.real / (b * rod.real)
    speed = 1j * pin + 1j * second * b * rod
    links = [
        {"number": 1, "points": {"O": [0, 0], "A": [a, 0]}},
        {"number": 2, "points": {"A": [0, 0], "B": [b, 0]}},
        {
            "number": 3,
            "points": {"B": [0, 0]},
            "slides": {"on": "frame", "along": "x", "side": "right"},
        },
    ]
    scene = table(pick, links, phi, pick.choice((1, -1)))
    scene["frame"] = {"O": [0, 0], "x": {"through": [0, e], "angle": "0 deg"}}
    known = {
        1: (pin / a, 0j, 1.0),
        2: (rod, 1j * pin, second),
        3: (1 + 0j, complex(speed.real, 0.0), 0.0),
    }
    return Loop(scene, known)


def loads_of(pick: random.Random) -> list[Scene]:
    """Forces and moments on all links."""
    found = list[Scene]()
    for link in (1, 2, 3):
        way = f"{pick.uniform(-180, 180)!r} deg"
        found.append(
            {"link": link, "point": f"K{link}", "force": pick.uniform(50, 500), "direction": way}
        )
        found.append({"link": link, "moment": pick.uniform(-40, 40)})
    return pick.sample(found, pick.randint(1, len(found)))


def drawn_of(scene: Scene) -> tuple[Drawn, Advantage]:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        (found,) = make(tmm.read(scene)).boards
    return found, ADVANTAGE_PLAN.on(found)


class Trial:
    """A scene recorded and executed, its scale factors 1: without its sheets."""

    def __init__(self, scene: Scene) -> None:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            project = record(tmm.read(scene))
            self.made, self.forces = ADVANTAGE_PLAN.on(project), FORCES_PLAN.on(project)
            log = project.construction
            given = {**dict.fromkeys(log.given, 1.0), **project.given}
            self.reading = execute(log, given, [step.it for step in log.steps])

    @property
    def gain(self) -> Any:
        """The mechanical advantage of the only external load."""
        (mark,) = self.made.gains.values()
        return mark

    def of(self, mark: Any, at: int = 0) -> float:
        """Return a figure in a position (index)."""
        assert mark is not None
        value = self.reading[mark][0]
        return float(value[at if value.size > 1 else 0])


def figure_of(found: Drawn, mark: Any, at: int = 0) -> float:
    assert mark is not None
    value = found.reading.figure(mark)[0]
    return float(value[at if value.size > 1 else 0])


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("kind", [four_bar, slider_crank])
def test_virtual_work_of_vector_loops(kind: Any, seed: int) -> None:
    pick = random.Random(f"{kind.__name__} {seed}")
    for _ in range(4):
        loop, loads = kind(pick), loads_of(pick)
        power, size = loop.power(loads)
        if size == 0.0:
            continue
        trial = Trial({**loop.scene, "load": loads})
        assert not trial.made.lacks
        assert abs(trial.of(trial.made.balance) + power) <= CLOSE * size
        assert trial.made.balance is not None
        assert trial.made.balance.unit == "N·m"


@pytest.mark.parametrize("kind", [four_bar, slider_crank])
def test_a_balancing_force_stands_at_the_pin(kind: Any) -> None:
    pick = random.Random(kind.__name__)
    loop, loads = kind(pick), loads_of(pick)
    power, size = loop.power(loads)
    scene = {**loop.scene, "load": loads, "forces": {"positions": [1], "balance": "force"}}
    trial = Trial(scene)
    crank = loop.scene["link"][0]["points"]["A"][0]
    assert abs(trial.of(trial.made.balance) + power / crank) <= CLOSE * size / crank


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("kind", [four_bar, slider_crank])
def test_the_mechanical_advantage(kind: Any, seed: int) -> None:
    """Output force over input force at the crank pin, by their velocities; of a moment ω_in/ω_out."""
    pick = random.Random(f"advantage {kind.__name__} {seed}")
    loop = kind(pick)
    force = {"link": 2, "point": "K2", "force": 100.0, "direction": "35 deg"}
    trial = Trial({**loop.scene, "load": [force]})
    per = loop.power([force])[0] / 100.0
    crank = loop.scene["link"][0]["points"]["A"][0]
    assert trial.of(trial.gain) == pytest.approx(abs(crank / per), rel=CLOSE)
    trial = Trial({**loop.scene, "load": [{"link": 2, "moment": 5.0}]})
    assert trial.of(trial.gain) == pytest.approx(abs(1.0 / loop.links[2][2]), rel=CLOSE)


@pytest.mark.parametrize("drive", ["crank", "slider", "rod"])
def test_random_mechanisms_agree_with_the_force_plans(drive: str) -> None:
    """Weights, inertia, springs, loads of every kind, any drive."""
    judged = 0
    for seed in range(20):
        one = drawn(seed, (drive,), 1 + seed % 2)
        if one is None:
            continue
        scene = one.row(one.walked[0][0], one.walked[-1][0], 5)
        scene["forces"] = {**scene.get("forces", {}), "positions": [2], "balance": "force"}
        scene["effects"] = {"gravity": True, "inertia": True}
        scene |= {"centres": {"positions": [2]}, "hand": {"ruler": "exact"}}
        drives = scene["drive"] if isinstance(scene["drive"], list) else [scene["drive"]]
        drives[0]["accelerations"] = "all"
        scene["sheet"] = [{"format": "A1", "place": [*PLACES, "accelerations"]}]
        trial, at = Trial(scene), 2
        made, forces = trial.made, trial.forces.first
        if made.lacks or not made.loads:
            continue
        own = trial.of(made.balance, at)
        due = [trial.of(k, at) for k in (forces.lever.balance, forces.balance)]
        size = sum(abs(trial.of(k.value, at)) for k in made.loads)
        if all(map(math.isfinite, (own, *due))):
            assert np.abs(own - np.array(due)).max() <= 1e-7 * size, seed
            judged += 1
    assert judged >= 12


def packaged(name: str, **more: Any) -> Scene:
    """A scene of the package, drawn exactly, with its centres."""
    scene = tomllib.loads((SHEETS / name / "scene.toml").read_text(encoding="utf-8"))
    place = [*PLACES, "accelerations"] if name == "crank-press" else PLACES
    sheet = [{"format": "A1", "place": place}]
    return {**scene, "hand": {"ruler": "exact"}, "sheet": sheet, **more}


def test_friction_of_the_last_pass_counts() -> None:
    """What stands on the lever: the centres come to the same; the rod's is at infinity a quarter turn on."""
    trial = Trial(packaged("crank-press", centres={"positions": [4]}))
    lever = trial.forces.first.lever
    assert lever.loads[1], "couples of friction"
    for at in (1, 2, 5):
        own, due = (trial.of(mark, at) for mark in (trial.made.balance, lever.balance))
        assert own == pytest.approx(due, rel=CLOSE)
    assert math.isnan(trial.of(trial.made.balance, 3))
    assert len(trial.made.gains) == 1, "inertia and weights have none"


def test_a_force_that_is_sought_at_a_tool() -> None:
    trial = Trial(packaged("hand-clamp", centres={"positions": [0]}))
    tool = trial.forces.tool
    assert tool is not None
    assert trial.of(trial.made.balance) == pytest.approx(trial.of(tool.force.value), rel=CLOSE)
    assert trial.of(trial.gain) == pytest.approx(trial.of(tool.advantage), rel=CLOSE)


def test_a_dead_place_has_no_advantage() -> None:
    """Crank and rod in one line: the slider stands, nothing balances; a finding names the step."""
    pick = random.Random(0)
    loop = slider_crank(pick)
    scene = {**loop.scene, "frame": {"O": [0, 0], "x": {"through": [0, 0], "angle": "0 deg"}}}
    scene["drive"] = {**scene["drive"], "zero": "0 deg"}
    force = {"link": 3, "point": "B", "force": 100.0, "direction": "180 deg"}
    found, made = drawn_of({**scene, "load": [force]})
    assert math.isnan(figure_of(found, *made.gains.values()))
    assert any(
        one.step.it in made.gains.values() and 0 in one.positions for one in found.findings()
    )


def test_a_sheet_shows_arms_and_the_balance() -> None:
    pick = random.Random(1)
    loop = four_bar(pick)
    force = {"link": 3, "point": "K3", "force": 100.0, "direction": "35 deg"}
    for language in ("en", "ru"):
        found, made = drawn_of({**loop.scene, "load": [force], "language": language})
        names = [view.name for view in arm_views(found, True)]
        assert names == ["advantage-1", "table-advantage-1", "table-advantage-balance-1"]
        segments = [one.segment for one in columns(found)]
        assert segments[-4:] == [
            "M_bal_centres", "M_bal_difference", "M_bal_lever_difference", "iF3"
        ]  # fmt: skip
        assert set(figure_marks(found.project).values()) >= {made.balance, *made.gains.values()}


def test_what_cannot_be_balanced_is_told() -> None:
    pick = random.Random(2)
    loop = four_bar(pick)
    force = {"link": 3, "point": "K3", "force": 100.0, "direction": "35 deg"}
    scene = {**loop.scene, "load": [force], "centres": {"positions": [2]}}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        (found,) = make(tmm.read(scene)).boards
    assert any("no position has both" in one for one in told(found, "en"))


def test_any_angle_has_its_balance() -> None:
    """Asked for with centres and forces, held against both other ways."""
    loop = four_bar(random.Random(4))
    force = {"link": 3, "point": "K3", "force": 100.0, "direction": "35 deg"}
    scene = {**loop.scene, "load": [force]}
    found = tmm.motion(scene, [10.0, 70.0, 200.0], plans=["centres", "forces"], exact=True)
    for name in ("M_bal_forces", "M_bal_lever"):
        np.testing.assert_allclose(found.balance["M_bal_centres"], found.balance[name], rtol=1e-7)
    assert "M_bal_centres" not in tmm.motion(scene, [10.0], plans="forces", exact=True).balance


def test_scenes_without_forces_record_nothing() -> None:
    loop = four_bar(random.Random(3))
    scene = {k: v for k, v in loop.scene.items() if k != "forces"}
    scene["sheet"] = [{"format": "A1", "place": ["positions", "velocities", "centres"]}]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        (found,) = make(tmm.read(scene)).boards
    assert ADVANTAGE_PLAN.of(found) is None
    assert not arm_views(found, True)
