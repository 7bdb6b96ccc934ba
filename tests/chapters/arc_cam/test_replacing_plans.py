"""The plans of the replacing linkage on the sheet: when they are there, letters, what their vectors say."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.arc_cams import KINDS
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.once import read_once

import graphic_tmm
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.arc_cam.ink import TRACELESS
from graphic_tmm.chapters.arc_cam.linkage import ACCELERATIONS, VELOCITIES
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN
from graphic_tmm.chapters.arc_cam.record import BESIDE
from graphic_tmm.chapters.arc_cam.task import ArcTask, Flank
from graphic_tmm.chapters.arc_cam.task_sheet import asks
from graphic_tmm.chapters.arc_cam.views import arc_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

CAM = 'base = "20 mm"\ndistance = "22 mm"\nnose = "7 mm"\nflank = "60 mm"\n'
FOLLOWERS = {
    "central": 'roller = "10 mm"',
    "offset": 'roller = "10 mm"\noffset = "4 mm"',
    "edge": "",
    "flat": 'follower = "flat"',
    "against": 'roller = "10 mm"\nfollower = "rocker"\nlever = "60 mm"\ncentres = "70 mm"',
    "tilted": 'follower = "flat rocker"\ncentres = "70 mm"\nface = "6 mm"',
    "tilted along": 'follower = "flat rocker"\ncentres = "70 mm"\nsense = "along"',
    "along": 'roller = "10 mm"\nfollower = "rocker"\nlever = "60 mm"\ncentres = "70 mm"\nsense = "along"',
}


def scene(folder: Path, rest: str, cam: str = CAM) -> Path:
    found = folder / "scene.toml"
    found.write_text(f'title = "T"\nlanguage = "en"\n[arc_cam]\n{cam}{rest}\n')
    return found


def drawn(path: Path) -> Drawn:
    (work,) = make(read_once(path), exact=True).boards
    return work


@pytest.mark.parametrize("flank", ['"60 mm"', '"straight"'])
def test_steps_of_the_plans_are_their_ink(flank: str, tmp_path: Path) -> None:
    path = scene(tmp_path, 'roller = "10 mm"\naccelerations = "all"', CAM.replace('"60 mm"', flank))
    work = drawn(path)
    views = [one for one in arc_views(work, True) if one.name in (VELOCITIES, ACCELERATIONS)]
    assert [one.name for one in views] == [VELOCITIES, ACCELERATIONS]
    for view in views:
        assert not without_ink(work.construction, [view], TRACELESS)
        assert not without_source(view)
        assert_pictures_make_the_view(work.construction, view)


@pytest.mark.parametrize("kind", KINDS)
def test_heavy_vectors_are_the_derivatives_of_the_positions_asked_for(
    kind: str, tmp_path: Path
) -> None:
    asked = 'accelerations = [3, "I", 8]'
    work = drawn(scene(tmp_path, f"{FOLLOWERS[kind]}\n{asked}"))
    plans, names = BESIDE.on(work).plans, work.names
    assert [names[k] for k in plans.asked] == ["3", "8", "I"]
    for view in (one for one in arc_views(work, True) if one.name in (VELOCITIES, ACCELERATIONS)):
        heavy = [s for s in view.strokes if isinstance(s, Stroke) and s.data and s.pen == "main"]
        for k in plans.asked:
            found = {float(dict(s.data)["value"]) for s in heavy if s.position == k}
            due = [size for size in vectors(work, view.name, k) if size > 2e-4]
            assert sorted(found) == pytest.approx(
                sorted({float(f"{x:.6g}") for x in due}), rel=1e-5
            )


def vectors(work: Drawn, view: str, k: int) -> list[float]:
    """How long the follower's vectors are by the derivatives in the table, m: on each arc there is one."""
    made, plans, reading = ARC_CAM_PLAN.on(work), BESIDE.on(work).plans, work.reading
    there = [
        n for n, one in plans.linkages.items() if np.isfinite(value(work, one.velocities.end, k))
    ]
    found = []
    for name, mark in zip(there, plans.second if len(there) > 1 else plans.second[:1], strict=True):
        rate, second = (float(reading.figure(one)[0, k]) for one in (plans.first, mark))
        arm, normal = 1.0, 0.0
        if made.order.rocks:
            assert made.follower.pivots is not None
            centre = made.contour.arcs[name].centre
            assert centre is not None
            ends = [value(work, one, k) for one in (made.follower.pivots, centre)]
            real = abs(ends[1] - ends[0]) * work.value(made.contour.mu)
            arm = made.order.lever or real
            normal = arm * rate**2
        found.append(
            abs(arm * rate) if view == VELOCITIES else float(np.hypot(arm * second, normal))
        )
    return found


def value(work: Drawn, mark: Mark, k: int) -> complex:
    row = work.reading[mark][0]
    return complex(row[k if row.size > 1 else 0])


def test_at_a_change_of_arcs_both_accelerations_are_drawn(tmp_path: Path) -> None:
    work = drawn(scene(tmp_path, FOLLOWERS["central"] + '\naccelerations = ["I"]'))
    view = next(one for one in arc_views(work, True) if one.name == ACCELERATIONS)
    letters = {label.text for label in view.labels}
    assert {"b′_{I}", "b′_{I+}"} <= letters


def test_the_task_asks_for_them_by_their_positions() -> None:
    order = ArcTask(0.02, 0.022, 0.007, Flank(0.06), Flank(0.06), accelerations=("3", "I"))
    told = [*asks(Scene("", "T", "en").asking(arc_cam=order), "en")]
    assert sum("in the positions 3, I." in one for one in told) == 1
    plain = replace(order, accelerations=())
    assert len([*asks(Scene("", "T", "en").asking(arc_cam=plain), "en")]) == len(told) - 1


def test_without_positions_asked_for_there_is_no_plan_but_the_table(tmp_path: Path) -> None:
    path = scene(tmp_path, FOLLOWERS["central"])
    names = {one.name for one in arc_views(drawn(path), True)}
    assert not names & {VELOCITIES, ACCELERATIONS}
    table = graphic_tmm.draw(path, exact=True).table("arc_cam")
    apart = np.asarray(table["ddS_off"].value, dtype=float)[0]
    chords, before = (np.asarray(table[n].value, dtype=float)[0] for n in ("ddS", "ddS_K"))
    assert apart[2] == pytest.approx(chords[2] - before[2], rel=1e-9)
    assert apart[2] != 0.0


def test_a_position_that_is_not_there_is_refused_by_its_key(tmp_path: Path) -> None:
    path = scene(tmp_path, FOLLOWERS["central"] + "\naccelerations = [17]")
    with pytest.raises(SceneError, match=re.escape("accelerations")) as told:
        graphic_tmm.draw(path)
    assert "0 to 16" in str(told.value)


@pytest.mark.slow
@pytest.mark.turns(2)
@pytest.mark.parametrize("kind", KINDS)
def test_a_note_tells_the_plans(kind: str, tmp_path: Path) -> None:
    work = graphic_tmm.draw(scene(tmp_path, f"{FOLLOWERS[kind]}\naccelerations = [4]"))
    text = "".join(
        one.read_text() for one in work.note(tmp_path / "note.md") if one.suffix == ".md"
    )
    assert "Velocities of the replacing linkage" in text
    assert "Accelerations of the replacing linkage" in text
