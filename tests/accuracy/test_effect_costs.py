"""Effects cost what logs recorded by hand cost, and change what Newton and Euler say; else they are nothing."""

from __future__ import annotations

import cmath
import math
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from itertools import accumulate, chain
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.dynamics import Friction, Statics, statics
from support.gallery import SHEETS
from support.gallery import scene as gallery
from support.oracle import State, solve_from_points
from support.tasks import drawing, effect, effects_known, effects_of

from graphic_tmm.accuracy import effect_costs
from graphic_tmm.accuracy.cost import MINUTES, done, varying
from graphic_tmm.accuracy.effect_costs import Cost, Weighed, study_effects
from graphic_tmm.accuracy.geometrography import elements, symbol
from graphic_tmm.chapters.forces.task import ForcesTask
from graphic_tmm.project import Project, record
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder

TEXT = {
    name: (SHEETS / name / "scene.toml").read_text("utf-8") for name in ("crank-press", "lever")
}


def written(tmp_path: Path, text: str, *changes: tuple[str, str]) -> Scene:
    """Read a scene whose text was changed by hand."""
    for old, new in changes:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    file = tmp_path / "scene.toml"
    file.write_text(text, encoding="utf-8")
    return read(file)


LOAD = "[[load]]" + TEXT["crank-press"].partition("[[load]]")[2].partition("[forces]")[0]
BY_HAND = [
    ("gravity", "gravity  = true", "gravity = false"),
    ("inertia", "inertia  = true", "inertia = false"),
    ("friction", "friction = true", "friction = false"),
    ("load 1, at B", LOAD, ""),
]


def minutes(log: Project) -> float:
    """The minutes of a log whose forces stand at one position: of views of forces each step once."""
    own = {view for view in log.told if view not in ("positions", "velocities", "accelerations")}
    total = 0.0
    for step in log.construction.steps:
        if step.it.view in own:
            done = elements(symbol(step.op), step.choice.get("row", 1))
            total += sum(n * MINUTES[name] for name, n in done.items())
    return total


@pytest.mark.parametrize(("name", "old", "new"), BY_HAND)
def test_an_effect_costs_what_the_log_has_less_without_it(
    tmp_path: Path, name: str, old: str, new: str
) -> None:
    whole = record(gallery("crank-press"))
    without = record(written(tmp_path, TEXT["crank-press"], (old, new)))
    found = effect(effects_known("crank-press"), name)
    assert found.called
    assert found.cost.steps == len(whole.construction.steps) - len(without.construction.steps) > 0
    assert found.cost.minutes == pytest.approx(minutes(whole) - minutes(without))


@pytest.mark.slow
def test_what_a_flywheel_takes_from_the_lever_is_drawn_at_all_positions() -> None:
    """The windrower's polygons stand at one position, its J goes by the moments of loads at all twelve."""
    log = record(gallery("windrower"))
    elsewhere = [step.it for step in log.construction.steps if step.it.view not in log.told]
    at = {view: len(rows) for view, rows in log.told.items()}
    varies, times = varying(log.given), Counter[int]()
    for own in (
        done(log.construction, varies, positions=12, only=at),
        done(log.construction, varies, elsewhere, positions=12),
    ):
        times |= Counter({one.step.it.slot: one.times for one in own})
    total = 0.0
    for one in done(log.construction, varies):
        each = elements(symbol(one.step.op), one.row)
        total += times[one.step.it.slot] * sum(n * MINUTES[name] for name, n in each.items())
    assert effects_known("windrower").whole.minutes == pytest.approx(total)


def test_a_log_that_stays_the_same_takes_no_longer() -> None:
    found = study_effects(gallery("crank-press"), trials=10)
    assert found.whole.seconds is not None
    assert found.whole.seconds > 0.0
    assert effect(found, "gas").cost.seconds == 0.0
    assert effect(found, "friction").cost.seconds != 0.0


def test_of_several_runs_the_least_counts(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first run of each warms up: it is the shortest here, and does not count."""
    lasting = [1.0, 1.0, *([7.0, 9.0] * 6), 5.0, 8.0, *([6.0, 9.0] * effect_costs.RUNS)]
    ticks = accumulate(chain([0.0], *((one, 0.5) for one in lasting)))
    monkeypatch.setattr(effect_costs.time, "process_time", lambda: next(ticks))
    log = drawing("crank-rocker")
    assert effect_costs._seconds([log], [log]) == (5.0, 8.0)


def bytes_of(log: Project) -> bytes:
    """All that is recorded and given, but for numbers of slots."""
    told = [str(view) for view in log.construction.views]
    for step in log.construction.steps:
        used = [mark.key for mark in step.uses]
        told.append(f"{step.it.key} {step.op.name} {used} {sorted(step.choice.items())}")
    told += [f"{mark.key} {np.asarray(value).tobytes()!r}" for mark, value in log.given.items()]
    return "\n".join(told).encode()


OFF = [
    ("friction = true", "friction = false"),
    ("gravity  = true", "gravity = false"),
    ("inertia  = true", "inertia = false"),
]


@pytest.mark.parametrize("switch", OFF)
def test_what_is_not_called_for_changes_no_byte_of_the_log(
    tmp_path: Path, switch: tuple[str, str]
) -> None:
    """What an effect goes by may stand in the scene, coefficients or masses: nothing of it is recorded."""
    text = TEXT["crank-press"]
    off = written(tmp_path, text, switch)
    gone = [(switch[0], "")]
    if "friction" in switch[0]:
        gone.append(("[friction]" + text.partition("[friction]")[2].partition("[hand]")[0], ""))
    assert bytes_of(record(off)) == bytes_of(record(written(tmp_path, text, *gone)))
    assert bytes_of(record(off)) != bytes_of(record(gallery("crank-press")))
    found = effect(effects_of(off), switch[0].split()[0])
    assert found == Weighed(found.name, False, Cost(0, 0.0, None))


# the judge


def turning(
    points: Callable[[float], Mapping[str, complex]], scene: Scene, zero: float
) -> list[State]:
    """The states of the positions of a row, from closed forms of the places of points."""
    assert scene.mechanism is not None
    angles = [zero + 30.0 * k for k in range(12)]
    return [solve_from_points(scene.mechanism, a, points(math.radians(a))) for a in angles]


def slider(r: float, rod: float, guide: complex) -> Callable[[float], dict[str, complex]]:
    """A crank and slider in line, the slider on the side of ``guide`` (a unit vector)."""

    def places(phi: float) -> dict[str, complex]:
        a = cmath.rect(r, phi)
        own = a / guide
        return {"A": a, "B": (own.real + math.sqrt(rod**2 - own.imag**2)) * guide}

    return places


def six_bar(phi: float) -> dict[str, complex]:
    a, c = cmath.rect(0.096, phi), 0.33 - 0.09j
    along, at = (c - a) / abs(c - a), abs(c - a)
    x = (at**2 + 0.36**2 - 0.3**2) / (2 * at)
    b = a + along * (x + 1j * math.sqrt(0.36**2 - x**2))
    d = c + (b - c) * (0.22 / 0.3)
    e = complex(d.real + math.sqrt(0.42**2 - (0.09 - d.imag) ** 2), 0.09)
    return {"A": a, "B": b, "D": d, "E": e}


def change(whole: Sequence[Statics], less: Sequence[Statics]) -> dict[str, tuple[float, int]]:
    """The largest change of the balance, and of any reaction, % of the largest, and where it is first."""
    found = {}
    for name, values in (
        ("P_bal", lambda one: [one.balance]),
        ("R", lambda one: [abs(f) for (i, j), f in one.reactions.items() if i < j]),
    ):
        rows = [np.array([values(one) for one in several]) for several in (whole, less)]
        apart = np.abs(rows[0] - rows[1]).max(axis=1)
        largest = np.abs(rows[0]).max()
        found[name] = (
            100.0 * float(apart.max()) / float(largest),
            int(np.argmax(apart > 0.9999999 * apart.max())),
        )
    return found


def agree(found: Weighed, due: Mapping[str, tuple[float, int]], names: Sequence[str]) -> None:
    told = {one.quantity: one for one in found.changes}
    assert set(told) == set(due)
    for quantity, (percent, place) in due.items():
        assert told[quantity].percent == pytest.approx(percent, rel=1e-6), (found.name, quantity)
        assert told[quantity].position == names[place], (found.name, quantity)


def against(state: State, letter: str, size: float) -> complex:
    """A force against the velocity of a point; none where it stands."""
    v = complex(state.points[letter].v)
    return -size * v / abs(v) if abs(v) > 1e-9 else 0j


def test_friction_and_weights_of_a_press_change_what_newton_and_euler_say() -> None:
    """Twelve passes of friction have settled; the ram's load goes by its travel."""
    own = gallery("crank-press")
    order = own.tasks["forces"]
    scene = own.asking(forces=replace(order, friction=replace(order.friction, passes=12)))
    found = effects_of(scene)
    states = turning(slider(0.06, 0.24, -1j), scene, 90.0)
    top = states[0].points["B"].r.imag
    shares = [(top - state.points["B"].r.imag) / 0.12 for state in states]
    sizes = np.interp(shares, (0.0, 0.66, 0.7, 1.0), (0.0, 0.0, 24e3, 9e3))
    pushes = [
        against(state, "B", size if k <= 6 else 0.0)
        for k, (state, size) in enumerate(zip(states, sizes, strict=True))
    ]
    pins = dict.fromkeys("OAB", 0.04)
    rubbed = Friction({"O": 0.08, "A": 0.08, "B": 0.08, "v": 0.12}, pins)

    def judged(load: float = 1.0, **options: Any) -> list[Statics]:
        told: dict[str, Any] = {"gravity": True, "inertia": True, "friction": rubbed} | options
        return [
            statics(
                state.mechanism,
                state,
                [(3, "B", load * push)],
                balance="force",
                at={"v": "B"},
                **told,
            )
            for state, push in zip(states, pushes, strict=True)
        ]

    whole, names = judged(), [str(k) for k in range(12)]
    agree(effect(found, "friction"), change(whole, judged(friction=None)), names)
    agree(effect(found, "gravity"), change(whole, judged(gravity=False)), names)
    agree(effect(found, "inertia"), change(whole, judged(inertia=False)), names)
    agree(effect(found, "load 1, at B"), change(whole, judged(load=0.0)), names)


def test_weights_inertia_and_masses_of_a_six_bar_change_what_newton_and_euler_say() -> None:
    """The row begins where E stands farthest left, which is looked for here by halving."""
    scene = gallery("lever")
    fine = np.linspace(0.0, 2 * math.pi, 721)
    zero = float(fine[int(np.argmin([six_bar(phi)["E"].real for phi in fine]))])
    step = fine[1]
    while step > 1e-14:
        around = [zero - step, zero, zero + step]
        zero = min(around, key=lambda phi: six_bar(phi)["E"].real)
        step /= 2
    states = turning(six_bar, scene, math.degrees(zero))

    def judged(load: float = 1500.0, bare: int = 0, **options: bool) -> list[Statics]:
        acting = {"gravity": True, "inertia": True} | options
        solved = []
        for state in states:
            links = tuple(
                replace(link, mass=None, inertia=None) if link.number == bare else link
                for link in state.mechanism.links
            )
            mechanism = replace(state.mechanism, links=links)
            push = against(state, "E", load) if state is not states[0] else 0j
            solved.append(
                statics(
                    mechanism, state, [(5, "E", push)], balance="force", at={"y": "E"}, **acting
                )
            )
        return solved

    whole, names, found = judged(), [str(k) for k in range(12)], effects_known("lever")
    agree(effect(found, "gravity"), change(whole, judged(gravity=False)), names)
    agree(effect(found, "inertia"), change(whole, judged(inertia=False)), names)
    for number in (2, 3, 4, 5):
        agree(effect(found, f"masses of link {number}"), change(whole, judged(bare=number)), names)


def test_the_gas_on_a_piston_changes_what_newton_and_euler_say() -> None:
    own = gallery("engine")
    gas = own.tasks["flywheel"].indicator
    order = ForcesTask(("all",), gravity=True, inertia=True, gas=gas)
    sheets = (SheetOrder("A1", ("positions", "velocities", "forces")),)
    scene = replace(own, sheets=sheets).asking(forces=order, flywheel=None)
    found = effects_of(scene)
    states = turning(slider(0.3, 0.64, 1.0 + 0j), scene, 0.0)
    pushes = [-p * math.pi * 0.12**2 / 4 for p in gas.cover.pressures]

    def judged(load: float = 1.0, **options: bool) -> list[Statics]:
        acting = {"gravity": True, "inertia": True} | options
        return [
            statics(
                state.mechanism,
                state,
                [(3, "B", load * push + 0j)],
                balance="force",
                at={"x": "B"},
                **acting,
            )
            for state, push in zip(states, pushes, strict=True)
        ]

    whole, names = judged(), [str(k + 1) for k in range(12)]
    agree(effect(found, "gas"), change(whole, judged(load=0.0)), names)
    agree(effect(found, "inertia"), change(whole, judged(inertia=False)), names)
    assert not effect(found, "friction").called


def test_a_constant_moment_does_not_matter_to_a_flywheel() -> None:
    found = effect(effects_known("moment-cycle"), "moment 1")
    assert found.changes == ()
    assert not found.worth
    assert found.cost.steps == 1


def test_the_acceleration_of_the_crank_is_an_effect() -> None:
    """Without it the tangential acceleration of the pin is gone: r·ε of what is the largest."""
    (found,) = effects_known("accelerating-crank").effects
    assert found.name == "ε of the crank"
    assert found.changes[0].quantity == "a"


def test_a_hand_that_slips_is_its_own_measure() -> None:
    found = study_effects(gallery("crank-press"), hand="student", trials=20, clock=False)
    assert not found.pencil
    assert all(one.pencil is None for own in found.effects for one in own.changes)
    assert not effect(found, "gravity").worth
    assert effect(found, "friction").worth
