"""The judge of kinetostatics on random mechanisms and loads: equilibrium, power, brute force."""

from __future__ import annotations

import itertools
import random
from contextlib import suppress
from dataclasses import replace
from typing import Any

import mpmath  # type: ignore[import-untyped]
import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from support import dynamics
from support.dynamics import Friction, Loaded, Statics, loads, put_loads, statics
from support.examples import most
from support.mechanisms import Sampled, mechanisms, sample
from support.oracle import State, solve, solve_fast
from support.wrenches import StaticsError

from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import dissect

EPS = float(np.finfo(float).eps)


def letters(mechanism: Mechanism) -> dict[str, str]:
    """A letter of the slider for every guide."""
    pairs = [pair for pair in dissect(mechanism).pairs if pair.kind == "P"]
    return {p.name: next(iter(mechanism.by_number[p.links[0]].points)) for p in pairs}


def rough(mechanism: Mechanism, size: float, f: float) -> Friction:
    names = [pair.name for pair in dissect(mechanism).pairs]
    return Friction(dict.fromkeys(names, f), dict.fromkeys(names, 0.03 * size))


def judged(loaded: Loaded, state: State, f: float | None, **how: Any) -> Statics:
    """All effects; friction of coefficient f in every pair."""
    mechanism = loaded.mechanism
    way: Any = {"gravity": True, "inertia": True, "balance": "force"} | how
    friction = None if f is None else rough(mechanism, state.size, f)
    at = letters(mechanism)
    return statics(mechanism, state, loaded.forces, loaded.moments, **way, friction=friction, at=at)


def drawn_loads(count: int, seed: int) -> list[tuple[Sampled, Loaded, State]]:
    source = random.Random(seed)
    return [
        (drawn, put_loads(lambda most: source.randint(0, most), drawn.mechanism), state)
        for drawn in sample(count, seed=seed)
        for state in [solve_fast(drawn.mechanism, drawn.phi, drawn.poses)]
    ]


def unbalanced(loaded: Loaded, state: State, found: Statics) -> float:
    """Largest sum of forces or moments on a link, summed anew from what is reported; of the sum
    of the magnitudes on all links.
    """
    mechanism, size = loaded.mechanism, state.size
    at, structure = letters(mechanism), dissect(mechanism)
    pushes = [(k, state.points[letter, k].r, f) for k, letter, f in loaded.forces]
    couples = [*loaded.moments]
    for link in mechanism.links:
        if link.inertia is not None:
            couples.append((link.number, -link.inertia * state.epsilon[link.number]))
        if link.mass is not None and link.centre is not None:
            centre = state.points[link.centre, link.number]
            pushes.append((link.number, centre.r, link.mass * (-9.81j - centre.a)))
    for pair in structure.pairs:
        letter = pair.name if pair.kind == "R" else at[pair.name]
        table = found.drags if pair.kind == "R" else found.couples
        for i, j in (pair.links, pair.links[::-1]):
            place = state.points[letter, pair.links[0]].r
            pushes.append((j, place, found.reactions[i, j]))
            couples.append((j, table[i, j]))
    o, a = (
        state.points[letter, structure.first.link].r
        for letter in (structure.origin, structure.first.pin)
    )
    pushes.append((structure.first.link, a, found.balance * 1j * (a - o) / abs(a - o)))
    scale = sum(abs(f) for *_, f in pushes) + sum(abs(m) / size for _, m in couples) or 1.0
    sums = []
    for link in mechanism.links:
        about = state.points[next(iter(link.points)), link.number].r
        mine = [(r - about, f) for k, r, f in pushes if k == link.number]
        sums.append(abs(sum(f for _, f in mine)))
        turning = sum((r.conjugate() * f).imag for r, f in mine)
        sums.append(abs(turning + sum(m for k, m in couples if k == link.number)) / size)
    return max(sums) / scale


@pytest.mark.slow
def test_links_are_in_equilibrium_and_loads_do_no_work() -> None:
    """Rounding: some tens of terms to a sum, and velocities as good as their condition."""
    for _, loaded, state in drawn_loads(200, seed=3):
        for f in (None, 0.0, 0.1):
            found = judged(loaded, state, f)
            assert unbalanced(loaded, state, found) <= 200 * EPS
            assert abs(found.power) <= EPS * (found.condition + state.condition) * found.work


def test_friction_takes_power_and_none_is_friction_of_nothing() -> None:
    for _, loaded, state in drawn_loads(60, seed=4):
        plain, none = judged(loaded, state, None), judged(loaded, state, 0.0)
        assert (plain.reactions, plain.balance) == (none.reactions, none.balance)
        found = judged(loaded, state, 0.1)
        at = letters(loaded.mechanism)
        for pair in dissect(loaded.mechanism).pairs:
            i, j = pair.links
            if pair.kind == "R":
                turning = state.omega[j] - state.omega[i]
                lost = found.drags[i, j] * turning
                moving = abs(turning) > 1e-9 * max(map(abs, state.omega.values()))
                assert abs(found.drags[i, j]) == pytest.approx(
                    moving * 0.1 * 0.03 * state.size * abs(found.reactions[i, j])
                )
            else:
                i, j = j, i
                at_j, at_i = (state.points[at[pair.name], k].v for k in (j, i))
                lost = (found.rubs[i, j].conjugate() * (at_j - at_i)).real
                normal = found.reactions[i, j] - found.rubs[i, j]
                assert abs(found.rubs[i, j]) == pytest.approx(0.1 * abs(normal))
                assert abs((normal.conjugate() * found.rubs[i, j]).real) <= 1e-12 * abs(normal) ** 2
            assert lost <= 0


@pytest.mark.slow
def test_friction_of_guides_is_that_of_one_choice_of_senses(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """With the senses of all N assumed the equations are linear; refused is what has no solution."""
    seen: list[Any] = []
    real = dynamics._rubbing

    def spy(matrix: Any, rubs: Any, right: Any, eps: Any) -> Any:
        seen[:] = [matrix, rubs, right]
        found = real(matrix, rubs, right, eps)
        seen.append(found[0])
        return found

    monkeypatch.setattr(dynamics, "_rubbing", spy)
    refused = 0
    for _, loaded, state in drawn_loads(300, seed=5):
        mechanism, at = loaded.mechanism, letters(loaded.mechanism)
        friction = Friction(dict.fromkeys(at, 0.15))
        way: Any = {"gravity": True, "inertia": True, "balance": "force"}
        found = None
        with suppress(StaticsError):
            found = statics(mechanism, state, loaded.forces, **way, friction=friction, at=at)
        matrix, rubs, right = seen[:3]
        roots = []
        for senses in itertools.product((1, -1), repeat=len(rubs)):
            linear = matrix.copy()
            for sense, (rub, column) in zip(senses, rubs, strict=True):
                linear[:, rub.among[0]] += sense * column
            x = np.linalg.solve(linear, right)
            slack = -1e-12 * max(abs(x))
            if all(s * x[rub.among[0]] >= slack for s, (rub, _) in zip(senses, rubs, strict=True)):
                roots.append(x)
        refused += found is None
        assert (found is None) == (not roots)
        if found is not None:
            assert min(max(abs(x - seen[3])) for x in roots) <= 1e-9 * max(abs(seen[3]))
    assert 0 < refused < 5


@pytest.mark.slow
def test_digits_tell_how_good_float64_is() -> None:
    for drawn, loaded, state in drawn_loads(12, seed=6):
        fine = solve(drawn.mechanism, drawn.phi, drawn.poses)
        how: Any = {"gravity": True, "inertia": True, "balance": "moment"}
        mechanism, at = loaded.mechanism, letters(loaded.mechanism)
        friction = rough(mechanism, state.size, 0.05)
        args = (loaded.forces, loaded.moments)
        quick = statics(mechanism, state, *args, **how, friction=friction, at=at)
        with mpmath.workdps(30):
            due = statics(mechanism, fine, *args, **how, friction=friction, at=at, digits=True)
        assert abs(due.power) <= 1e-24 * due.work
        scale = max(map(abs, due.reactions.values())) or 1
        # a_S is as good as the condition squared; the friction amplifies once more
        bound = EPS * quick.condition * state.condition**2
        for key, value in due.reactions.items():
            assert abs(value - quick.reactions[key]) <= bound * scale
        assert abs(due.balance - quick.balance) <= bound * scale * state.size


@pytest.mark.slow
@settings(max_examples=most(60), suppress_health_check=list(HealthCheck))
@given(data=st.data(), drawn=mechanisms())
def test_any_loads_on_any_mechanism(data: st.DataObject, drawn: Sampled) -> None:
    loaded = data.draw(loads(drawn.mechanism))
    state = solve_fast(drawn.mechanism, drawn.phi, drawn.poses)
    found = judged(loaded, state, None)
    assert unbalanced(loaded, state, found) <= 200 * EPS
    assert abs(found.power) <= EPS * (found.condition + state.condition) * found.work
    links = tuple(replace(link, mass=None, inertia=None) for link in drawn.mechanism.links)
    light = loaded._replace(mechanism=replace(drawn.mechanism, links=links))
    none = judged(light, state, None, gravity=False, inertia=False)
    assert judged(light, state, None).reactions == none.reactions
