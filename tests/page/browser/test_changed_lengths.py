"""Lengths changed in a browser: what is told follows as Python has it, what cannot be assembled is refused."""

from __future__ import annotations

import tomllib
from collections.abc import Callable
from typing import Any

import numpy as np
from support import pages
from support.browser import Opened

from graphic_tmm.board.execute import execute
from graphic_tmm.page.dense import dense

Begin = Callable[..., Opened]
NAME, POSITION = "crank-rocker", 3


def _opened(page_of: Begin, name: str = NAME, **options: Any) -> Any:
    tab = page_of(name, address="#crank:", **options)
    tab.page.wait_for_selector("#crank[data-ready]")
    tab.page.locator(".lengths > summary").click()
    return tab.page


def _field(page: Any, letter: str) -> Any:
    return page.get_by_role("textbox", name=f"{letter}, value")


def _give(page: Any, letter: str, text: str) -> None:
    field = _field(page, letter)
    field.fill(text)
    field.press("Enter")


def _velocities(page: Any) -> list[float]:
    texts = page.locator("#crank .card:not(.lead) .values").first.locator("dd").all_text_contents()
    return [float(text.split()[0].replace("−", "-")) for text in texts]


def test_values_follow_a_length(page_of: Begin) -> None:
    """The crank of 20 mm is made one of 24: pa is ω_1·l_OA, the others are Python's."""
    page = _opened(page_of)
    page.locator("#crank .row").get_by_role("button", name=str(POSITION), exact=True).click()
    _give(page, "l_OA", "24")
    made, _ = pages.on_sheets(NAME, "en")
    assert made.mechanism is not None
    found = dense(made.mechanism)
    assert found is not None
    given = found.given | {mark: 0.024 for mark in found.log.given if mark.name == "l_{OA}"}
    reading, told = execute(found.log, given), _velocities(page)
    due = {
        step.it.name: abs(reading[step.it]).ravel()[
            found.at[POSITION] if reading[step.it].size > 1 else 0
        ]
        for step in found.log.steps
        if step.it.view == "velocities" and not isinstance(reading[step.it], tuple)
    }
    scale = reading[found.log.view("velocities").scale].item()  # type: ignore[union-attr]
    np.testing.assert_allclose(told[:3], [scale * due[k] for k in ("pa", "ab", "pb")], rtol=0.005)
    assert abs(told[0] - 0.024 * 125.66370614) < 0.005


def test_what_cannot_be_assembled_is_refused_and_named(page_of: Begin) -> None:
    page = _opened(page_of)
    before = _velocities(page)
    _give(page, "l_AB", "26")
    says = page.locator(".lengths .told").text_content()
    assert "26 mm: extreme positions, step 7 'B_0': the arcs do not meet" in says
    assert _field(page, "l_AB").get_attribute("aria-invalid") == "true"
    assert _velocities(page) == before
    _give(page, "l_AB", "64")
    assert _velocities(page) != before
    page.get_by_role("button", name="As given").click()
    assert _velocities(page) == before
    assert _field(page, "l_AB").input_value() == "60"


def test_keys_of_the_scene_are_copied(page_of: Begin) -> None:
    page = _opened(page_of)
    copy = page.get_by_role("button", name="Copy as TOML")
    assert copy.is_disabled()
    for letter, text in (("l_OA", "24"), ("Y_E", "31.5"), ("X_C", "62")):
        _give(page, letter, text)
    copy.click()
    assert tomllib.loads(page.get_by_label("TOML", exact=True).input_value()) == {
        "frame": {"C": ["62 mm", "-10 mm"]},
        "link": [
            {"number": 1, "points": {"A": ["24 mm", "0 mm"]}},
            {"number": 2, "points": {"E": ["40 mm", "31.5 mm"]}},
        ],
    }


def test_a_range_is_moved_by_keys_alone(page_of: Begin) -> None:
    """By a key one four-hundredth of the range, 30 mm: to a step of 0.01 mm."""
    page = _opened(page_of)
    range_ = page.get_by_role("slider", name="l_OA")
    range_.focus()
    range_.press("ArrowRight")
    assert _field(page, "l_OA").input_value() == "20.08"
    assert range_.get_attribute("aria-valuetext") == "20.08 mm"


def test_a_joint_is_dragged_to_its_lengths(page_of: Begin) -> None:
    """The joint B stands at its place of a mechanism with the lengths that the fields then have."""
    page = _opened(page_of)
    page.locator("#crank .row").get_by_role("button", name="1", exact=True).click()
    grip = page.locator(".lead .grip").last  # C, B, E …: the first lies on top
    names = [_field(page, one).input_value() for one in ("X_C", "Y_C")]
    box = grip.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    assert box["width"] >= 1
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 12, y - 5)
    page.mouse.move(x + 24, y - 10)
    page.mouse.up()
    after = [float(_field(page, one).input_value()) for one in ("X_C", "Y_C")]
    assert after[0] > float(names[0]) + 2
    assert after[1] > float(names[1]) + 0.5
    now = grip.bounding_box()
    assert abs(now["x"] + now["width"] / 2 - x - 24) < 2
    assert abs(now["y"] + now["height"] / 2 - y + 10) < 2


def test_questions_are_answered_by_lengths(page_of: Begin) -> None:
    """A crank-rocker turns up to Grashof's bound; what is off it, or changes other letters, is no answer."""
    page = _opened(page_of)
    page.locator(".questions summary").click()
    asked = page.locator(".questions li").filter(has_text="at the most")
    bound = 60 + 45 - np.hypot(60, 10)
    answers = asked.get_by_role("status")
    _give(page, "l_OA", f"{bound - 0.02:.2f}")
    assert answers.text_content() == "Right."
    _give(page, "l_OA", f"{bound + 0.02:.2f}")
    assert answers.text_content() == "It does not turn round."
    _give(page, "l_OA", "30")
    assert answers.text_content() == "It turns round; lOA may go farther."
    _give(page, "l_CB", "46")
    assert answers.text_content() == "The rest has to be as given."
    page.get_by_role("button", name="As given").click()
    assert answers.text_content() == ""
