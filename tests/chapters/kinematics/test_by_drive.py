"""What each of several drives causes alone, and what comes of it together."""

from __future__ import annotations

import numpy as np
import pytest
from support.boards import drawn_of
from support.gallery import composed
from support.words_of_drives import SCENES

import graphic_tmm
from graphic_tmm.chapters.kinematics.by_drive import added_vector
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.task import BY_DRIVE, VELOCITIES
from graphic_tmm.chapters.kinematics.views import by_drive_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import TmmError

SEVERAL = [name for name, one in SCENES.items() if len(one.drives) > 1]
SHEET = '[[sheet]]\nformat = "A1"\nplace = ["velocities", "velocities by drive"]\n'


def drawn(name: str, sheet: str = SHEET) -> Drawn:
    told = f'title = "Scene"\nlanguage = "en"\n{SCENES[name].tables}\n{sheet}'
    return drawn_of(graphic_tmm.read(told), exact=True)


@pytest.mark.parametrize("name", SEVERAL)
def test_parts_come_to_the_velocity_of_every_point(name: str) -> None:
    made = drawn(name)
    plans, reading = KINEMATICS_PLAN.on(made), made.reading
    assert plans.velocities is not None
    images = plans.velocities.images
    every = dict.fromkeys(mark for own in images.by_letter.values() for mark in own.values())
    alone = [one.motion.images for one in plans.by_drive]
    moved = {
        image
        for number, own in images.by_letter.items()
        for letter, image in own.items()
        if all(part.by_letter[number].get(letter, part.pole) != part.pole for part in alone)
    }
    moving = [mark for mark in every if mark in moved]
    largest = max(np.abs(reading[mark]).max() for mark in moving)
    for image, one in zip(moving, plans.summed, strict=True):
        np.testing.assert_allclose(
            reading[one.ends[-1]], reading[image], atol=1e-12 * largest, err_msg=image.letter
        )


@pytest.mark.parametrize("name", SEVERAL)
def test_rates_of_links_add_up_too(name: str) -> None:
    made = drawn(name)
    plans = KINEMATICS_PLAN.on(made)
    total = dict[int, np.ndarray | float]()
    for one in plans.by_drive:
        for link, rate in one.motion.rates.items():
            total[link] = total.get(link, 0.0) + made.reading[rate]
    assert plans.velocities is not None
    for link, rate in plans.velocities.rates.items():
        np.testing.assert_allclose(total[link], made.reading[rate], rtol=1e-9, atol=1e-12)


def test_all_plans_of_one_sheet_have_one_scale() -> None:
    made = drawn("two cylinders")
    (first, *others) = (
        made.scales[one.motion.mu.view] for one in KINEMATICS_PLAN.on(made).by_drive
    )
    assert others == [first] == [made.scales[VELOCITIES]]


@pytest.mark.parametrize("name", ["two cylinders", "slider", "slider forces"])
def test_nothing_is_drawn_by_drive_where_it_is_not_asked_for(name: str) -> None:
    made = drawn(name, '[[sheet]]\nformat = "A1"\nplace = ["velocities"]\n')
    assert not [step for step in made.construction.steps if step.it.view.startswith(BY_DRIVE)]


def test_forces_of_several_drives_draw_plans_but_no_sums() -> None:
    made = drawn("two cylinders forces", '[[sheet]]\nformat = "A1"\nplace = ["lever"]\n')
    views = {step.it.view for step in made.construction.steps}
    assert {f"{BY_DRIVE} 3", f"{BY_DRIVE} 6"} <= views
    assert not [step for step in made.construction.steps if step.op is added_vector]


@pytest.mark.parametrize("name", ["slider", "two cylinders at rest"])
def test_sums_are_refused_where_there_is_nothing_to_add(name: str) -> None:
    if name == "slider":
        tables = SCENES[name].tables
    else:
        moving = SCENES["two cylinders"].tables
        tables = moving.replace('speed = "0.05 m/s"', "speed = 0").replace('"0.02 m/s"', "0")
    with pytest.raises(TmmError, match='"velocities by drive" adds up') as told:
        drawn_of(graphic_tmm.read(f'title = "Scene"\nlanguage = "en"\n{tables}\n{SHEET}'))
    assert "leave it out" in str(told.value)


def test_a_held_drive_leaves_no_mark_on_a_plan() -> None:
    """No vector of zero length: its points are the pole."""
    made = drawn("two cranks")
    for one in KINEMATICS_PLAN.on(made).by_drive:
        held = one.pairs[1].link
        assert set(one.motion.images.by_letter[held].values()) == {one.motion.images.pole}
        assert held not in one.motion.rates


def test_the_sheet_shows_parts_only_where_several_drives_move_a_point() -> None:
    """Of the excavator the boom moves by one of them alone."""
    views = {view.name: view for view in by_drive_views(composed("excavator")[0].boards[0], True)}
    shown = views[f"{BY_DRIVE.replace(' ', '-')}-1"]
    letters = {label.text for label in shown.labels}
    assert not any(text.startswith(("b", "h", "n")) for text in letters)
    assert any("′" in text for text in letters)
