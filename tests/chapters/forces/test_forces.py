"""Effects that are called for and those that are not; friction; hard cases; both methods against each other."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from support.boards import drawn_of
from support.dynamics import Loaded
from support.gallery import SHEETS
from support.loaded import RATIO, errors, order_of, solve, weighed
from support.mechanisms import Sampled, sample
from support.wrenches import StaticsError

from graphic_tmm.board.record import Construction
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.task import ForcesTask, Friction, Load
from graphic_tmm.drawn import Drawn
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.project import record
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import sheets

WINDROWER = read(SHEETS / "windrower")


def rubbing(drawn: Sampled, f: float, passes: int) -> Friction:
    """Friction in every pair, pins of 2 % of the mechanism's size."""
    links = drawn.mechanism.links
    size = max(abs(point) for link in links for point in link.points.values())
    pairs = dissect(drawn.mechanism).pairs
    pins = {pair.name: 0.02 * size for pair in pairs if pair.kind == "R"}
    return Friction({pair.name: f for pair in pairs}, pins, passes)


@pytest.mark.slow
def test_friction_settles_at_the_judges_equilibrium(many: Callable[[int, int], int]) -> None:
    for k, drawn in enumerate(sample(many(200, 16), seed=2000, dyads=(1, 2))):
        one = weighed(drawn, k)
        order = order_of(one, gravity=True, inertia=True, friction=rubbing(drawn, 0.1, 20))
        solved = solve(one, drawn.phi, drawn.poses, order, turned=bool(k % 2))
        assert math.isfinite(solved.number(solved.forces.first.balance)), (k, drawn.kinds)
        assert max(errors(solved).values()) <= RATIO, (k, drawn.kinds)


@pytest.mark.slow
def test_after_two_passes_the_rest_is_within_what_is_reported(
    many: Callable[[int, int], int],
) -> None:
    told, count = 0, many(150, 40)
    for k, drawn in enumerate(sample(count, seed=77, dyads=(1, 2))):
        one = weighed(drawn, k)
        order = order_of(one, gravity=True, inertia=True, friction=rubbing(drawn, 0.08, 2))
        solved = solve(one, drawn.phi, drawn.poses, order)
        open_ = solved.forces.first.open
        assert open_ is not None
        found, rest = solved.number(solved.forces.first.balance), solved.number(open_)
        if not math.isfinite(found):
            continue
        told += 1
        noise = 1e-11 * max(abs(f) for f in solved.judge.reactions.values())
        assert abs(found - solved.judge.balance) <= 1.5 * rest + noise, (k, drawn.kinds)
    assert told > 0.93 * count


def test_no_friction_equals_none() -> None:
    for k, drawn in enumerate(sample(20, seed=3, dyads=(1, 2))):
        one = weighed(drawn, k)
        without = solve(one, drawn.phi, drawn.poses, order_of(one, gravity=True))
        nothing = order_of(one, gravity=True, friction=rubbing(drawn, 0.0, 2))
        with_ = solve(one, drawn.phi, drawn.poses, nothing)
        for a, b in zip(without.forces.reactions, with_.forces.reactions, strict=True):
            assert without.number(a.value) == with_.number(b.value)
        assert without.number(without.forces.first.balance) == with_.number(
            with_.forces.first.balance
        )


@pytest.mark.slow
def test_friction_opposes_and_costs_power(many: Callable[[int, int], int]) -> None:
    for k, drawn in enumerate(sample(many(60, 10), seed=9, dyads=(1, 2))):
        one = weighed(drawn, k)
        plain = solve(one, drawn.phi, drawn.poses, order_of(one, gravity=True))
        rough = order_of(one, gravity=True, friction=rubbing(drawn, 0.05, 12))
        solved = solve(one, drawn.phi, drawn.poses, rough)
        speed = drawn.mechanism.drive.speed
        more = (
            solved.number(solved.forces.first.balance) - plain.number(plain.forces.first.balance)
        ) * speed
        top = max(abs(f) for f in solved.judge.reactions.values()) * abs(speed)
        if abs(plain.number(plain.forces.first.balance) * speed) > 1e-9 * top:
            assert more >= -1e-9 * top, (k, drawn.kinds)


@pytest.mark.slow
@pytest.mark.parametrize("f", [0.05, 0.3, 0.8, 1.2, 2.0])
def test_near_self_locking_the_answer_is_the_judges_or_none(
    f: float, many: Callable[[int, int], int]
) -> None:
    """Where the judge finds no equilibrium the plan has none either; where both find one it is the same."""
    refused = 0
    for k, drawn in enumerate(sample(many(40, 12), seed=4, dyads=(1, 1), kinds=["RRP", "RPR"])):
        one = weighed(drawn, k)
        guides = {s.guide.name: f for link in drawn.mechanism.links for s in link.slides}
        order = order_of(one, gravity=True, friction=Friction(guides, {}, 6))
        try:
            solved = solve(one, drawn.phi, drawn.poses, order)
        except StaticsError:
            refused += 1
            found = solve(one, drawn.phi, drawn.poses, order, judged=False)
            assert not math.isfinite(found.number(found.forces.first.balance)), (k, f)
            continue
        found_p = solved.number(solved.forces.first.balance)
        if math.isfinite(found_p) and f <= 0.3:
            assert max(errors(solved).values()) <= RATIO, (k, f)
    assert refused == 0 or f >= 0.3


# effects


def log_of(scene: Scene) -> Construction:
    return record(scene).construction


def forced(**options: object) -> Scene:
    assert WINDROWER.tasks.get("forces") is not None
    bare = replace(
        WINDROWER.tasks["forces"],
        loads=(),
        gravity=False,
        inertia=False,
        single=(),
        positions=("8",),
    )
    return WINDROWER.asking(forces=replace(bare, **options), flywheel=None)  # type: ignore[arg-type]


LOAD = (Load(5, "D", 190.0),)
EFFECTS = {
    "gravity": ("G_", {"gravity": True}),
    "inertia": ("i", {"inertia": True}),
    "load": ("F_5", {"loads": LOAD}),
    "friction": ("f", {"friction": Friction({"A": 0.1, "y": 0.1, "BC": 0.1}, {"A": 0.02})}),
}


@pytest.mark.parametrize("effect", EFFECTS)
def test_an_effect_that_is_not_called_for_records_no_step(effect: str) -> None:
    letters = {
        "gravity": lambda k: k.startswith("G_"),
        "inertia": lambda k: k.startswith(("P_{i", "M_{i")),
        "load": lambda k: k.startswith("F_5"),
        "friction": lambda k: k.startswith(("ρ_", "f_", "ΔP_b", "η")),
    }[effect]
    others = {
        key: value
        for name, (_, more) in EFFECTS.items()
        if name != effect
        for key, value in more.items()
    }
    without, with_ = log_of(forced(**others)), log_of(forced(**others, **EFFECTS[effect][1]))
    assert not [s for s in without.steps if letters(s.it.letter)]
    assert [s for s in with_.steps if letters(s.it.letter)]
    assert len(without.steps) < len(with_.steps)


@pytest.mark.slow
def test_a_scene_without_effects_has_the_bytes_of_one_that_never_heard_of_them() -> None:
    plain = WINDROWER.asking(forces=None, flywheel=None)
    places = [sheet for sheet in plain.sheets if "forces" not in sheet.place]
    others = ("flywheel", "load diagram")
    kept = tuple(replace(s, place=tuple(p for p in s.place if p not in others)) for s in places)
    never = replace(plain, sheets=kept)
    heard = never.asking(forces=ForcesTask(("8",)))
    shown = record(heard, wanted=heard.shown_places).construction
    assert len(log_of(never).steps) == len(shown.steps) < len(log_of(heard).steps)
    assert [svg(s) for s in sheets(never)[1]] == [svg(s) for s in sheets(heard)[1]]


@pytest.mark.parametrize("effect", EFFECTS)
def test_an_effect_that_is_switched_on_changes_what_it_should(effect: str) -> None:
    base = {"loads": LOAD} if effect != "load" else {"gravity": True}
    before, after = balance(forced(**base)), balance(forced(**base, **EFFECTS[effect][1]))
    assert before != pytest.approx(after, rel=1e-3)


def balance(scene: Scene, exact: bool = True) -> float:
    made = drawn_of(scene, exact=exact)
    assert FORCES_PLAN.of(made) is not None
    return float(made.reading[FORCES_PLAN.on(made).first.balance][0, 8])


# the windrower


@cache
def windrower(name: str, exact: bool) -> Drawn:
    return drawn_of(read(SHEETS / name), exact=exact)


def test_the_windrower_balances_with_1465_newtons() -> None:
    assert balance(WINDROWER) == pytest.approx(1465.0, rel=1e-3)


def test_with_the_documents_lengths_it_takes_1786() -> None:
    published = read(SHEETS / "windrower-published")
    weighed = {link.number: link for link in WINDROWER.mechanism.links}  # type: ignore[union-attr]
    links = []
    for link in published.mechanism.links:  # type: ignore[union-attr]
        like = weighed[link.number]
        points = dict(link.points)
        if link.number == 1:
            points["S1"] = points["A"] / 2
        if link.number == 3:
            points.setdefault("S3", points["C"])
        links.append(
            replace(link, points=points, mass=like.mass, inertia=like.inertia, centre=like.centre)
        )
    mechanism = replace(published.mechanism, links=tuple(links))  # type: ignore[type-var]
    scene = replace(published, mechanism=mechanism, sheets=WINDROWER.sheets).asking(
        forces=WINDROWER.tasks["forces"]
    )
    assert balance(scene.asking(flywheel=None)) == pytest.approx(1786.0, rel=1e-3)


def test_with_a_ruler_of_half_a_millimetre_both_methods_agree_within_five_percent() -> None:
    made = drawn_of(replace(WINDROWER, ruler=0.5))
    assert FORCES_PLAN.of(made) is not None
    apart = float(made.reading[FORCES_PLAN.on(made).first.difference][0, 8])
    assert 0.0 < apart < 5.0


def test_one_force_for_force_and_couple_changes_no_answer() -> None:
    assert WINDROWER.tasks.get("forces") is not None
    apart = WINDROWER.asking(forces=replace(WINDROWER.tasks["forces"], single=()))
    assert balance(apart) == pytest.approx(balance(WINDROWER), rel=1e-12)


def test_couples_as_pairs_of_forces_change_no_answer() -> None:
    scene = read(SHEETS / "lever")
    assert scene.tasks.get("forces") is not None
    pairs = scene.asking(forces=replace(scene.tasks["forces"], couples="pair"))
    found = []
    for one in (scene, pairs):
        made = drawn_of(one, exact=True)
        assert FORCES_PLAN.of(made) is not None
        found.append(made.reading[FORCES_PLAN.on(made).first.lever.balance])
    np.testing.assert_allclose(*found, rtol=1e-11)


# hard cases


def test_no_load_at_all_is_a_polygon_of_a_point() -> None:
    drawn = next(iter(sample(1, seed=1, dyads=(2, 2))))
    links = tuple(replace(k, mass=None, inertia=None) for k in drawn.mechanism.links)
    one = Loaded(replace(drawn.mechanism, links=links), [], [])
    solved = solve(one, drawn.phi, drawn.poses, order_of(one, gravity=True, inertia=True))
    assert all(solved.number(r.value) == 0.0 for r in solved.forces.reactions)
    assert solved.number(solved.forces.first.balance) == 0.0


@pytest.mark.parametrize("size", [1e-6, 1.0, 1e9])
def test_forces_of_any_size(size: float) -> None:
    drawn = next(iter(sample(1, seed=6, dyads=(2, 2))))
    links = tuple(replace(k, mass=None, inertia=None) for k in drawn.mechanism.links)
    letter = next(iter(links[-1].points))
    one = Loaded(replace(drawn.mechanism, links=links), [(links[-1].number, letter, size + 0j)], [])
    solved = solve(one, drawn.phi, drawn.poses, order_of(one))
    assert max(errors(solved).values()) <= RATIO


def test_parallel_unknown_forces_are_a_finding() -> None:
    scene = read(SHEETS / "toggle-press")
    order = ForcesTask(("all",), (Load(scene.mechanism.links[-1].number, _last(scene), 100.0),))  # type: ignore[union-attr]
    places = replace(scene.sheets[0], place=(*scene.sheets[0].place, "forces"))
    made = drawn_of(replace(scene, sheets=(places,)).asking(forces=order), exact=True)
    assert FORCES_PLAN.of(made) is not None
    values = made.reading[FORCES_PLAN.on(made).first.balance]
    for k in range(values.shape[1]):
        named = [f for f in made.findings() if k in f.positions]
        assert np.isfinite(values[0, k]) or named


def _last(scene: Scene) -> str:
    assert scene.mechanism is not None
    return next(iter(scene.mechanism.links[-1].points))


def test_random_loads_are_not_trivial() -> None:
    pick = random.Random(0)
    drawn = next(iter(sample(1, seed=pick.randint(0, 99), dyads=(2, 2))))
    one = weighed(drawn, 1)
    solved = solve(one, drawn.phi, drawn.poses, order_of(one, gravity=True, inertia=True))
    assert max(abs(f) for f in solved.judge.reactions.values()) > 0.0
