"""Every arm by which an equation multiplies has its letter in the figure beside it, however short it is."""

from __future__ import annotations

import re

import pytest
from support.each import each
from support.force_views import LOADED, loaded_drawing, views_of
from support.gallery import SHEETS, drawn
from support.loaded import weighed
from support.mechanisms import sample

from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.scene.read import otherwise, read
from graphic_tmm.studio import make

ARM = re.compile(r"h_\{[^}]+\}")


def multiplied(told: Drawing) -> set[str]:
    """Return the arms in equations, but for those that equations give."""
    lines = [label.text for label in told.labels]
    given = {found[0] for line in lines if (found := ARM.match(line))}
    return {arm for line in lines for arm in ARM.findall(line)} - given


def check(work: Drawn) -> int:
    views, count = {view.name: view for view in views_of(work)}, 0
    for name, told in views.items():
        if not name.startswith("equations-"):
            continue
        of = name.removeprefix("equations-")
        shown = views.get(f"group-{of}") or views[of]
        lettered = {arm for label in shown.labels for arm in ARM.findall(label.text)}
        assert multiplied(told) <= lettered, name
        count += len(multiplied(told))
    return count


@each("name", LOADED)
@pytest.mark.slow
def test_of_the_package(name: str) -> None:
    assert check(drawn(name))


@pytest.mark.slow
def test_in_all_positions() -> None:
    scene = otherwise(read(SHEETS / "lever" / "scene.toml"), {"forces.positions": "all"})
    work = make(scene).mechanism
    assert work is not None
    assert check(work)


@pytest.mark.turns(1)
@pytest.mark.parametrize("seed", range(3))
@pytest.mark.slow
def test_of_random_mechanisms(seed: int) -> None:
    for one in sample(6, 900 + seed, dyads=(1, 3)):
        check(loaded_drawing(weighed(one, seed), one, turned=True, ruler=0.5))
