"""Effects change what Newton and Euler say; what is not called for leaves no byte in the log."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from support.dynamics import Friction, Statics, statics
from support.gallery import scene as gallery
from support.oracle import State, solve_from_points
from support.tasks import effect, effects_known, effects_of, text_of, written

from graphic_tmm.accuracy.effects.effect_costs import Cost
from graphic_tmm.accuracy.effects.effect_study import Weighed, study_effects
from graphic_tmm.chapters.forces.task import ForcesTask
from graphic_tmm.project import Project, record
from graphic_tmm.scene.records import Scene, SheetOrder


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
@pytest.mark.slow
def test_what_is_not_called_for_changes_no_byte_of_the_log(
    tmp_path: Path, switch: tuple[str, str]
) -> None:
    """What an effect goes by may stand in the scene, coefficients or masses: nothing of it is recorded."""
    text = text_of("crank-press")
    off = written(tmp_path, text, switch)
    gone = [(switch[0], "")]
    if "friction" in switch[0]:
        gone.append(("[friction]" + text.partition("[friction]")[2].partition("[hand]")[0], ""))
    assert bytes_of(record(off)) == bytes_of(record(written(tmp_path, text, *gone)))
    assert bytes_of(record(off)) != bytes_of(record(gallery("crank-press")))
    found = effect(effects_of(off), switch[0].split()[0])
    assert found == Weighed(found.name, False, Cost(0, 0.0, None))


# the judge

FINE = 16
"""States of the judge's turn for each position: the largest value of a turn stands between these, too."""


def turning(
    points: Callable[[float], Mapping[str, complex]], scene: Scene, zero: float
) -> list[State]:
    """The states of the positions of a row, from closed forms of the places of points."""
    assert scene.mechanism is not None
    angles = [zero + 30.0 / FINE * k for k in range(12 * FINE)]
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
    """The largest change of the balance, and of any reaction, % of the largest, and the position where it is.

    The ``whole`` turn has `FINE` states for each position.
    """
    found = {}
    for name, values in (
        ("P_bal", lambda one: [one.balance]),
        ("R", lambda one: [abs(f) for (i, j), f in one.reactions.items() if i < j]),
    ):
        turn, rest = (np.array([values(one) for one in several]) for several in (whole, less))
        apart = np.abs(turn - rest)[::FINE].max(axis=1)
        largest = np.abs(turn).max()
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


@pytest.mark.slow
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
        against(state, "B", size if k <= 6 * FINE else 0.0)
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


@pytest.mark.slow
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


@pytest.mark.slow
def test_the_gas_on_a_piston_changes_what_newton_and_euler_say() -> None:
    own = gallery("engine")
    gas = own.tasks["flywheel"].indicator
    order = ForcesTask(("all",), gravity=True, inertia=True, gas=gas)
    sheets = (SheetOrder("A1", ("positions", "velocities", "forces")),)
    scene = replace(own, sheets=sheets).asking(forces=order, flywheel=None)
    found = effects_of(scene)
    states = turning(slider(0.3, 0.64, 1.0 + 0j), scene, 0.0)
    row = [*gas.cover.pressures, gas.cover.pressures[0]]
    between = np.interp(np.arange(12 * FINE) / FINE, np.arange(13), row)
    pushes = [-p * math.pi * 0.12**2 / 4 for p in between]

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


@pytest.mark.slow
def test_a_hand_that_slips_is_its_own_measure() -> None:
    found = study_effects(gallery("crank-press"), hand="student", trials=20, clock=False)
    assert not found.pencil
    assert all(one.pencil is None for own in found.effects for one in own.changes)
    assert not effect(found, "gravity").worth
    assert effect(found, "friction").worth
