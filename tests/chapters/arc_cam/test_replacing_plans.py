"""The plans of the replacing linkage on the sheet: when they are there, letters, what their vectors say."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from support.arc_cams import KINDS
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.once import read_once

import graphic_tmm
from graphic_tmm.chapters.arc_cam.ink import TRACELESS
from graphic_tmm.chapters.arc_cam.linkage import ACCELERATIONS, VELOCITIES
from graphic_tmm.chapters.arc_cam.record import BESIDE
from graphic_tmm.chapters.arc_cam.views import arc_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.studio import make

CAM = 'base = "20 mm"\ndistance = "22 mm"\nnose = "7 mm"\nflank = "60 mm"\n'
FOLLOWERS = {
    "central": 'roller = "10 mm"',
    "offset": 'roller = "10 mm"\noffset = "4 mm"',
    "edge": "",
    "flat": 'follower = "flat"',
    "against": 'roller = "10 mm"\nfollower = "rocker"\nlever = "60 mm"\ncentres = "70 mm"',
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
    arm = 0.060 if kind in ("against", "along") else 1.0
    due = {VELOCITIES: [plans.first], ACCELERATIONS: [*plans.second]}
    for view in (one for one in arc_views(work, True) if one.name in due):
        heavy = [s for s in view.strokes if isinstance(s, Stroke) and s.data and s.pen == "main"]
        found: dict[int | None, set[float]] = {}
        for stroke in heavy:
            found.setdefault(stroke.position, set()).add(float(dict(stroke.data)["value"]))
        for k in plans.asked:
            rates = {abs(float(work.reading.figure(mark)[0, k])) for mark in due[view.name]}
            ends = sorted(found.get(k, set()))
            if arm == 1.0 or view.name == VELOCITIES:
                wanted = sorted({float(f"{arm * r:.6g}") for r in rates if arm * r > 1e-4})
                assert ends == pytest.approx(wanted, rel=1e-5)
            else:  # a lever has a normal part, too
                omega = float(work.reading.figure(plans.first)[0, k])
                wanted = sorted({arm * float(np.hypot(r, omega**2)) for r in rates})
                assert ends == pytest.approx(wanted, rel=1e-5)


def test_at_a_change_of_arcs_both_accelerations_are_drawn(tmp_path: Path) -> None:
    work = drawn(scene(tmp_path, FOLLOWERS["central"] + '\naccelerations = ["I"]'))
    view = next(one for one in arc_views(work, True) if one.name == ACCELERATIONS)
    letters = {label.text for label in view.labels}
    assert {"b′_{I}", "b′_{I+}"} <= letters


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
