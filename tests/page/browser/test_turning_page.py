"""Cams, wheels and trains in a browser: they turn by keys, range and button, where their moves bring them."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from shapely import Point
from support import pages
from support.browser import FRAMES, Opened
from support.turned import moved

from graphic_tmm.page.turning import RigidBody, turning_pictures

Begin = Callable[..., Opened]
NAMES = ("cam", "gear-pair", "planetary", "flat-rocker-cam")
PHONE = {"width": 360, "height": 740}
NEAR = 0.01
"""What rounding on the way to the page and in it may come to, mm."""
PLACES = """([x, y]) => [...document.querySelectorAll("#turning .rigid")].map((one) => {
  const all = one.transform.baseVal.consolidate();
  const by = all === null ? new DOMMatrix() : DOMMatrix.fromMatrix(all.matrix);
  const at = by.transformPoint(new DOMPoint(x, y));
  return [at.x, at.y];
})"""
"""Where one place comes with each body."""
INK = '() => [...document.querySelectorAll("#turning .rigid")].map((one) => one.getAttribute("transform"))'


def begun(page_of: Begin, name: str, language: str = "", **options: Any) -> Any:
    page = page_of(name, language, address="#turning:", **options).page
    page.wait_for_selector("#turning[data-ready]")
    return page


def angle(page: Any) -> str:
    return str(page.locator("#turning .angle").text_content())


def bodies(name: str) -> list[RigidBody]:
    made, _ = pages.on_sheets(name, pages.language(name))
    return [body for picture in turning_pictures(made) for body in picture.bodies]


@pytest.mark.parametrize("case", NAMES)
def test_bodies_are_where_their_moves_bring_them(page_of: Begin, case: str) -> None:
    page, spot = begun(page_of, case), (13.0, 21.0)
    page.keyboard.press("PageUp")
    for _ in range(7):
        page.keyboard.press("ArrowRight")
    assert angle(page) == "φ = 37°"
    due = [moved(Point(spot[0], -spot[1]), body, 37.0) for body in bodies(case)]
    seen = page.evaluate(PLACES, spot)
    np.testing.assert_allclose(seen, [(at.x, -at.y) for at in due], atol=NEAR)
    assert np.ptp(np.array(seen), axis=0).max() > 1.0


def test_keys_range_and_button_turn_it(page_of: Begin) -> None:
    page = begun(page_of, "planetary", "en")
    assert angle(page) == "φ = 0°"
    for keys, due in (("ArrowUp", "1"), ("ArrowLeft", "0"), ("ArrowDown", "−1"), ("PageUp", "29")):
        page.keyboard.press(keys)
        assert angle(page) == f"φ = {due}°"
    page.keyboard.press("0")
    first = page.evaluate(INK)
    range_ = page.get_by_role("slider", name="Angle of the turn")
    range_.fill("200")
    assert range_.get_attribute("aria-valuetext") == "φ = 200°"
    assert page.evaluate(INK) != first
    page.get_by_role("button", name="To the beginning").click()
    assert page.evaluate(INK) == first
    page.keyboard.press("Escape")
    page.locator("#turning .cards").click()
    page.keyboard.press("Space")
    page.get_by_role("button", name="Stop it").wait_for()
    page.wait_for_function(
        "() => !document.querySelector('#turning .angle').textContent.endsWith(' 0°')"
    )
    page.get_by_role("button", name="Stop it").click()
    stood = page.evaluate(INK)
    page.evaluate(FRAMES)
    assert page.evaluate(INK) == stood != first


def test_nothing_turns_by_itself_and_another_tab_stops_it(page_of: Begin) -> None:
    page = begun(page_of, "cam", "en", reduced_motion="reduce")
    page.evaluate(FRAMES)
    assert angle(page) == "φ = 0°"
    page.keyboard.press("Space")
    page.get_by_role("tab", name="Sheets").click()
    page.get_by_role("tab", name="Motion").click()
    page.get_by_role("button", name="Let it turn").wait_for()


def test_letters_stay_upright_on_their_wheels(page_of: Begin) -> None:
    page = begun(page_of, "planetary")
    page.keyboard.press("PageUp")
    ways = page.locator("#turning .carried").evaluate_all(
        "(all) => all.map((one) => one.getAttribute('transform'))"
    )
    assert len(ways) > 4
    assert all(re.fullmatch(r"translate\(\S+ \S+\)", way) for way in ways)


@pytest.mark.parametrize("case", NAMES)
def test_a_phone_shows_it_whole(page_of: Begin, case: str) -> None:
    page = begun(page_of, case, viewport=PHONE, has_touch=True, is_mobile=True)
    assert page.evaluate("() => document.documentElement.scrollWidth") <= PHONE["width"]
    box = page.locator("#turning .moving").first.bounding_box()
    assert box["x"] >= 0
    assert box["x"] + box["width"] <= PHONE["width"]
    assert box["height"] > 100
    for button in page.locator("#turning button, #turning select, #turning input").all():
        assert button.bounding_box()["height"] >= 44


def test_a_scene_without_such_a_chapter_has_no_such_way(page_of: Begin) -> None:
    page = page_of("crank-rocker", "en").page
    assert page.get_by_role("tab", name="Motion").count() == 0
    assert "turning" not in page.locator("style").first.text_content()
