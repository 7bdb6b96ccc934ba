"""Sizes by rule: what a teacher tells holds on random mechanisms; one step a sheet; nothing is composed."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from support import asked
from support.gallery import SHEETS
from support.mechanisms import sample
from support.rewritten import text_of
from support.scenes import edited, written
from support.sheets_of_random import FORCES

from graphic_tmm.chapters.kinematics.scales import CRANK, LARGEST, ruling
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.errors import ViewError
from graphic_tmm.fitting.compose import Composed, composed
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.rooms import Rooms
from graphic_tmm.fitting.rule import STEPS, by_rule
from graphic_tmm.fitting.sizes import all_sizes, usual
from graphic_tmm.fitting.tried import Mechanism
from graphic_tmm.paper.compose import sheets as composing
from graphic_tmm.paper.formats import FORMATS
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import composed_sheets, make

PLACES = ("positions", "velocities", "accelerations", "forces", "lever")


def scenes(folder: Path, count: int, *orders: tuple[str, tuple[str, ...]]) -> list[Scene]:
    """Return random mechanisms with forces in two positions, on sheets (format, places)."""
    found = []
    for k, one in enumerate(sample(count, 47, dyads=(1, 2))):
        tail = "accelerations = [1, 5]\n" + FORCES + "positions = [1, 5]\n"
        for format, places in orders:
            listed = ", ".join(f'"{place}"' for place in places)
            tail += f'[[sheet]]\nformat = "{format}"\nplace = [{listed}]\n'
        folder.joinpath(f"{k}.toml").write_text(
            text_of(one.mechanism, one.phi, 8, tail), encoding="utf-8"
        )
        found.append(read(folder / f"{k}.toml"))
    return found


@cache
def drawn(scene: str) -> DrawnScene:
    return make(read(SHEETS / scene / "scene.toml"), exact=True)


def longest(drawn: Drawn, plan: str) -> float:
    return float(getattr(drawn.reach["kinematics"], plan)) / drawn.scales[plan].value


@pytest.mark.parametrize("format", ["A1", "A3"])
@pytest.mark.slow
def test_groups_are_no_smaller_than_the_plan_and_link_1_no_larger_than_they(
    format: str, tmp_path: Path
) -> None:
    """Arms are measured on a group; link 1 with its three forces needs no more room."""
    for scene in scenes(tmp_path, 6, (format, PLACES)):
        work = make(scene, exact=True).boards[0]
        plan = work.scales["positions"].value
        groups = {v: s.value for v, s in work.scales.items() if v.startswith("group ")}
        alone = groups.pop("group 1")
        assert groups
        assert max(*groups.values(), alone) <= plan * (1 + 1e-9), scene.source
        assert alone >= min(groups.values()) * (1 - 1e-9), scene.source


@pytest.mark.slow
def test_a_crank_can_be_measured_as_far_as_its_plan_goes_on_the_sheet(tmp_path: Path) -> None:
    for scene in scenes(tmp_path, 6, ("A1", PLACES[:1])):
        work = make(scene, exact=True).boards[0]
        arm = work.project.recorded["kinematics"]
        pivot, pin = (
            work.reading[arm.positions.bodies[arm.structure.first.link].marks[name]]
            for name in (arm.structure.origin, arm.structure.first.pin)
        )
        crank = float(np.nanmax(np.abs(pin - pivot)))
        # the next larger scale is up to twice as large, and would take more than a plan may
        assert crank >= CRANK or 2.0 * longest(work, "positions") > LARGEST, scene.source


@pytest.mark.slow
def test_sizes_hang_on_the_format_and_not_on_the_hand(tmp_path: Path) -> None:
    (large,) = scenes(tmp_path, 1, ("A1", PLACES[:3]))
    small = replace(large, sheets=tuple(replace(one, format="A3") for one in large.sheets))
    rows = [{v: s.value for v, s in make(one).boards[0].scales.items()} for one in (large, small)]
    assert all(rows[0][view] <= rows[1][view] for view in rows[0])
    assert rows[0] != rows[1]
    exact = {v: s.value for v, s in make(large, exact=True).boards[0].scales.items()}
    assert exact == rows[0]
    assert {name: usual(small)[name] / usual(large)[name] for name in PLACES[:3]} == dict.fromkeys(
        PLACES[:3], FORMATS["A3"].share
    )


def test_nothing_is_composed_to_find_a_scale(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A table, a protocol, a task need scale factors and no sheet."""
    (scene,) = scenes(tmp_path, 1, ("A1", PLACES))

    def refused(*args: object) -> None:
        raise AssertionError("a sheet is composed")

    monkeypatch.setattr(composing, "composed", refused)
    assert make(scene).boards[0].scales


@pytest.mark.parametrize("name", ["engine", "shaper", "offset-slider", "scotch-yoke", "cam"])
def test_a_sheet_that_is_ordered_wins_before_another_is_opened(name: str) -> None:
    scene = read(SHEETS / name / "scene.toml")
    assert len(composed_sheets(scene)[1].sheets) == len(scene.sheets) == 1


@pytest.mark.slow
def test_forces_take_no_more_sheets_than_in_natural_sizes(tmp_path: Path) -> None:
    """As composed in the end, with letters: what sizes are reckoned from plays no part."""
    found, natural = list[int](), list[int]()
    for k, one in enumerate(sample(12, 91, dyads=(2, 3))):
        tail = "accelerations = [1, 5]\n" + FORCES + "positions = [1, 4, 6]\n"
        for places in (PLACES[:2], PLACES[3:]):
            listed = ", ".join(f'"{place}"' for place in places)
            tail += f'[[sheet]]\nformat = "A1"\nplace = [{listed}]\n'
        file = tmp_path / f"{k}.toml"
        file.write_text(text_of(one.mechanism, one.phi, 8, tail), encoding="utf-8")
        work = make(read(file), given=Composition(usual(read(file)), ()))
        with suppress(ViewError):  # in natural sizes a plan may fit no sheet
            natural.append(_sheets_of_forces(composed(work.scene, work.boards)))
            found.append(_sheets_of_forces(composed_sheets(read(file))[1]))
    assert sum(count > 1 for count in found) > 5
    assert sum(found) <= sum(natural)
    # what a sheet of the other order takes over is not foreseen
    assert all(one <= other + 1 for one, other in zip(found, natural, strict=True))


def _sheets_of_forces(of: Composed) -> int:
    return sum(sheet.order == 1 for sheet in of.composition.sheets)


@pytest.mark.slow
def test_each_kind_takes_what_room_its_sheet_has(tmp_path: Path) -> None:
    for scene in scenes(tmp_path, 6, ("A1", PLACES[:3])):
        sizes, rooms = by_rule(scene, [Mechanism(scene)])
        assert rooms.fits(0, sizes), scene.source
        for name in rooms.names(0):
            most = min(all_sizes()[name].high, 1.25 * sizes[name] / usual(scene)[name])
            larger = {**sizes, name: most * usual(scene)[name]}
            # the next share is at most 1.22 times as large
            assert larger[name] <= sizes[name] * 1.01 or not rooms.fits(0, larger), name


def test_velocities_give_way_before_positions_do() -> None:
    for step, (first, last) in STEPS.items():
        assert first <= last, step
    assert all_sizes()["velocities"].first
    assert not any(all_sizes()[name].first for name in ("positions", "groups", "gears", "cam"))
    scene = read(SHEETS / "engine" / "scene.toml")  # more than its sheet holds in natural sizes
    board = Mechanism(scene)
    sizes, rooms = by_rule(scene, [board])
    assert rooms.fits(0, sizes)
    assert not rooms.fits(0, usual(scene))
    given = {name: sizes[name] / usual(scene)[name] for name in ("positions", "accelerations")}
    assert given["accelerations"] < given["positions"] <= 1.0


def test_a_size_takes_the_least_step_of_the_sheets_that_show_it(tmp_path: Path) -> None:
    orders = ("A1", PLACES[:1]), ("A4", ("velocities",)), ("A1", ("velocities", "accelerations"))
    (scene,) = scenes(tmp_path, 1, *orders)
    board = Mechanism(scene)
    sizes, rooms = by_rule(scene, [board])
    assert isinstance(rooms, Rooms)
    alone = replace(scene, sheets=scene.sheets[2:])
    assert sizes["velocities"] < by_rule(alone, [Mechanism(alone)])[0]["velocities"]


def test_what_nothing_is_drawn_in_keeps_its_size(tmp_path: Path) -> None:
    """Where the rod does not reach its guide there is no work of the cycle, and no curve of it."""
    scene = read(edited(tmp_path, ('l  = "0.64 m"', 'l  = "0.25 m"')))
    sizes, _ = by_rule(scene, [Mechanism(scene)])
    begun = usual(scene)
    known = all_sizes()
    assert all(0.0 < size <= known[name].high * begun[name] for name, size in sizes.items())


@pytest.mark.turns(1, "sizes")
@pytest.mark.slow
@pytest.mark.parametrize("kind", ["slider", "six"])
def test_twice_as_many_positions_take_no_larger_views(
    kind: str, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    for format in ("A1", "A2", "A3")[: many(3, 1)]:
        rows = []
        for count in (12, 24):
            text = asked.mechanism(kind, count, [(format, ("velocities",))])
            rows.append(make(read(written(tmp_path, text)), exact=True).boards[0])
        assert rows[1].scales["velocities"].value >= rows[0].scales["velocities"].value


def test_one_position_in_ten_does_not_rule_a_plan() -> None:
    lengths = np.array([1.0, 1.1, 0.9, 1.0, 1.2, 1.0, 0.8, 1.0, 1.0, np.nan, 5.0, 1.1])
    most, over = ruling(range(12), lengths)
    assert most == 1.2
    assert list(over) == [10]
    assert over[10] == pytest.approx(5.0 / 1.2)
    # twice as long is no outlier, nor are two positions in twelve
    assert ruling(range(12), np.where(lengths == 5.0, 2.3, lengths))[0] == 2.3
    assert ruling(range(12), np.where(lengths == 0.8, 5.0, lengths))[0] == 5.0
    assert ruling(range(3), np.full(3, np.nan)) == (0.0, {})
