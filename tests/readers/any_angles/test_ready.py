"""A slice that is made ready says at every call what a scene says that was never asked before, to the byte."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from dataclasses import fields, replace

import numpy as np
import pytest
from support.gallery import SHEETS
from support.linkages import four_bar

import graphic_tmm
from graphic_tmm.board.compile.run import LAYOUTS, LEAST
from graphic_tmm.chapters.forces.task import ASKED, ForcesTask, Friction, Load
from graphic_tmm.readers.any_angles.motion import PLANS, recorded
from graphic_tmm.readers.any_angles.ready import QUANTITIES
from graphic_tmm.readers.any_angles.results import Motion
from graphic_tmm.readers.any_angles.turn import Plan
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

pytest.importorskip("llvmlite")
ANGLES = np.random.default_rng(11).uniform(-400.0, 800.0, LEAST + 1)
FORCES: tuple[Plan, ...] = (*PLANS, "forces")


def numbers(found: Motion) -> list[np.ndarray]:
    told = (getattr(found, quantity) or {} for quantity in QUANTITIES)
    return [one for by_key in told for one in by_key.values()]


def bytes_of(found: Motion) -> list[bytes]:
    return [one.tobytes() for one in numbers(found)]


def loaded(scene: Scene, *loads: Load) -> Scene:
    return scene.asking(forces=ForcesTask(("all",), loads), flywheel=None)


def rubbed() -> Scene:
    scene = read(SHEETS / "windrower")
    order = ASKED.of(scene)
    assert order is not None
    friction = Friction({"y": 0.1, "A": 0.1}, {"A": 0.01}, 2)
    return scene.asking(forces=replace(order, friction=friction), flywheel=None)


def by_angle() -> Scene:
    sizes = tuple((30.0 * k, float(k % 7)) for k in range(12))
    return loaded(read(SHEETS / "engine"), Load(3, "B", 0.0, 0.0, by_angle=sizes))


def flips() -> Scene:
    """A parallelogram that becomes an antiparallelogram, and back: the side of its group varies."""
    return Scene("flips", "", "en", four_bar(0.1, 0.3, 0.1, 0.3, flips=(0.0, 180.0)))


def windrower() -> Scene:
    return read(SHEETS / "windrower")


SCENES = {"windrower": windrower, "flips": flips, "friction": rubbed, "by angle": by_angle}
"""The crank's angle alone varies; sides do; one number makes others unknown; a load varies."""


def plans(name: str) -> tuple[Plan, ...]:
    return FORCES if name in ("friction", "by angle") else PLANS


@pytest.mark.turns(2)
@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("name", SCENES)
@pytest.mark.slow
def test_a_call_says_what_the_first_of_a_scene_says(name: str, exact: bool) -> None:
    """Counts go up and down, so that nothing of a call can be left in the next."""
    scene = SCENES[name]()
    for count in (12, 0, 300, 1, 7, 12, 8, 9, 2, LEAST, LEAST - 1, 3):
        rows = ANGLES[:count]
        found = graphic_tmm.motion(scene, rows, plans=plans(name), exact=exact)
        fresh = graphic_tmm.motion(SCENES[name](), rows, plans=plans(name), exact=exact)
        assert bytes_of(found) == bytes_of(fresh), count
        assert {one.shape for one in numbers(found)} == {(count,)}


@pytest.mark.parametrize("name", SCENES)
def test_an_angle_says_the_same_whoever_stands_beside_it(name: str) -> None:
    scene = SCENES[name]()
    whole = numbers(graphic_tmm.motion(scene, ANGLES, plans=plans(name), exact=True))
    for part in (slice(0, 1), slice(5, 6), slice(3, 9), slice(100, 113), slice(1, LEAST)):
        some = numbers(graphic_tmm.motion(scene, ANGLES[part], plans=plans(name), exact=True))
        for one, other in zip(some, whole, strict=True):
            assert one.tobytes() == other[part].tobytes()


@pytest.mark.parametrize("name", SCENES)
def test_compiled_and_executed_are_the_same(name: str) -> None:
    # away from where the parallelogram changes: digits are lost there
    scene, rows = SCENES[name](), ANGLES[:200][np.abs(np.sin(np.radians(ANGLES[:200]))) > 0.2]
    plain, fast = (
        graphic_tmm.motion(scene, rows, plans=plans(name), exact=True, fast=fast)
        for fast in (False, True)
    )
    assert scene.mechanism is not None
    speed = abs(scene.mechanism.drive.speed)
    for quantity in QUANTITIES:
        one, other = (
            np.array(list((getattr(of, quantity) or {}).values())) for of in (plain, fast)
        )
        if one.size:
            # the links of a parallelogram turn as its crank does, or not at all
            top = max(np.nanmax(np.abs(one)), speed**2 if quantity == "epsilon" else 0.0)
            np.testing.assert_allclose(one, other, rtol=0.0, atol=1e-11 * top)


def test_threads_on_one_scene_do_not_meet() -> None:
    scene = read(SHEETS / "lever")
    counts = [3 + 5 * k % 97 for k in range(400)]
    due = {
        count: bytes_of(graphic_tmm.motion(read(SHEETS / "lever"), ANGLES[:count], exact=True))
        for count in set(counts)
    }
    with ThreadPoolExecutor(6) as pool:
        found = pool.map(
            lambda count: bytes_of(graphic_tmm.motion(scene, ANGLES[:count], exact=True)), counts
        )
        assert all(one == due[count] for count, one in zip(counts, found, strict=True))


def test_what_was_handed_out_is_the_callers() -> None:
    """A later call leaves it alone, and what a caller writes is in no later one."""
    scene = read(SHEETS / "crank-rocker")
    first = graphic_tmm.motion(scene, ANGLES[:12], exact=True)
    before = bytes_of(first)
    second = graphic_tmm.motion(scene, ANGLES[12:24], exact=True)
    assert bytes_of(first) == before
    for one in numbers(second):
        if one.flags.writeable:
            one[:] = 7.0
        else:
            assert one.strides == (0,)
    assert bytes_of(first) == before
    assert bytes_of(graphic_tmm.motion(scene, ANGLES[:12], exact=True)) == before


def test_what_is_kept_of_counts_does_not_grow() -> None:
    scene = read(SHEETS / "crank-rocker")
    for count in range(1, 3 * LAYOUTS):
        graphic_tmm.motion(scene, ANGLES[:count], exact=True)
    made = recorded(scene, frozenset(PLANS), exact=True).slices[None]
    assert made._loop is not None
    assert 0 < len(made._loop._layouts) <= LAYOUTS
    assert 0 < len(made._standing) <= LAYOUTS


def test_the_angle_is_handed_on_as_it_is_or_every_chapter_is_asked() -> None:
    """Whatever `plain` says, it is what the chapters say at these angles."""
    for name in SCENES:
        scene = SCENES[name]()
        graphic_tmm.motion(scene, ANGLES[:12], plans=plans(name), exact=True)
        of = recorded(scene, frozenset(plans(name)), exact=True)
        made = of.slices[None]
        known = of.known(ANGLES[None, :50])
        same = [np.array_equal(known[mark], ANGLES[None, :50]) for mark in made.entering]
        assert made.entering
        assert made.plain == all(same)
        assert made.plain == (name in ("windrower", "friction"))


def test_a_motion_takes_its_quantities_in_their_order() -> None:
    assert tuple(one.name for one in fields(Motion))[2:] == QUANTITIES
