"""The crank in a browser: what belongs together is on the screen together, the wheel scrolls everywhere."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from support.browser import FRAMES, Opened

Begin = Callable[..., Opened]
ALONE, IN_STUDIO = {"width": 1280, "height": 800}, {"width": 896, "height": 711}
"""A usual window, and what the studio leaves of it beside its values."""
BOX = """(one) => { const { left, top, right, bottom } = one.getBoundingClientRect();
  return [left, top, right, bottom]; }"""
SCROLLED = """() => [...document.querySelectorAll("#crank, #crank *")]
  .reduce((sum, one) => sum + one.scrollTop, 0)"""


def _crank(page_of: Begin, name: str, window: dict[str, int], address: str = "#crank:") -> Any:
    page = page_of(name, "en", address, viewport=window).page
    page.wait_for_selector("#crank[data-ready]")
    page.evaluate(FRAMES)
    return page


def _boxes(page: Any, *chosen: str) -> list[list[float]]:
    return [page.locator(one).first.evaluate(BOX) for one in chosen]


@pytest.mark.parametrize("window", [ALONE, IN_STUDIO], ids=["alone", "studio"])
def test_a_length_and_the_velocities_that_it_changes_are_seen_together(
    page_of: Begin, window: dict[str, int]
) -> None:
    page = _crank(page_of, "crank-rocker", window)
    page.locator(".lengths summary").first.click()
    page.evaluate(FRAMES)
    lead, plan, field = boxes = _boxes(
        page, "#crank .lead", "#crank .cards .card", ".lengths .given input[type=text]"
    )
    for left, top, right, bottom in boxes:
        assert min(left, top) >= 0
        assert right <= window["width"]
        assert bottom <= window["height"]
    assert plan[0] >= lead[2]
    assert plan[0] >= field[2]
    assert field[1] >= lead[3]
    for chosen in ("#crank .cards .card svg", ".lengths .given input[type=text]"):
        seen = page.locator(chosen).first.evaluate(
            """(one) => { const { left, top, width, height } = one.getBoundingClientRect();
              return [0.02, 0.5, 0.98].every((share) =>
                one.contains(document.elementFromPoint(left + width / 2, top + share * height))); }"""
        )
        assert seen, chosen
    body, panel = _boxes(page, "#crank .lead svg", "#crank .lead")
    assert body[3] - body[1] > 0.6 * (panel[3] - panel[1])


@pytest.mark.parametrize("window", [IN_STUDIO, {"width": 700, "height": 700}], ids=["two", "one"])
@pytest.mark.parametrize("runs", [False, True], ids=["still", "running"])
def test_the_wheel_scrolls_over_every_plan(
    page_of: Begin, window: dict[str, int], runs: bool
) -> None:
    page = _crank(page_of, "crank-rocker", window)
    if runs:
        page.locator("#crank .bar button").first.click()
    for k in range(page.locator("#crank .card").count()):
        card = page.locator("#crank .card").nth(k)
        card.scroll_into_view_if_needed()
        left, top, right, bottom = card.evaluate(BOX)
        page.mouse.move((left + right) / 2, max(top, 60) / 2 + min(bottom, window["height"]) / 2)
        before = page.evaluate(SCROLLED)
        page.mouse.wheel(0, -120 if before > 0 else 120)
        page.wait_for_function(f"(before) => ({SCROLLED})() !== before", arg=before)


def test_home_and_end_scroll_unless_the_crank_has_the_focus(page_of: Begin) -> None:
    page = _crank(page_of, "crank-rocker", IN_STUDIO)
    angle = page.locator("#crank .angle")
    before = angle.text_content()
    page.locator("body").press("End")
    page.wait_for_function(f"() => ({SCROLLED})() > 0")
    page.locator("body").press("Home")
    page.wait_for_function(f"() => ({SCROLLED})() === 0")
    assert angle.text_content() == before
    page.locator("#crank .turn").press("End")
    assert page.locator("#crank .turn").input_value() == "359"
    page.locator("#crank .turn").press("Home")
    assert page.locator("#crank .turn").input_value() == "0"


LETTERS = """() => [...document.querySelectorAll("#crank .lead .stays, #crank .lead .letters > g")]
  .filter((one) => getComputedStyle(one).visibility !== "hidden").map((one) => {
    const boxes = [...one.querySelectorAll("path:not([stroke='var(--paper)'])")]
      .map((path) => path.getBoundingClientRect());
    return [Math.min(...boxes.map((box) => box.left)), Math.min(...boxes.map((box) => box.top)),
      Math.max(...boxes.map((box) => box.right)), Math.max(...boxes.map((box) => box.bottom))]; })"""
"""What letters of the mechanism take on the screen, px: without the white about them."""
PINS = """() => [...document.querySelectorAll("#crank .lead .handle, #crank .lead .joint")].map((one) => {
  const { left, top, right, bottom } = one.getBoundingClientRect();
  return [(left + right) / 2, (top + bottom) / 2]; })"""


def _meet(one: list[float], other: list[float]) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


@pytest.mark.parametrize("window", [ALONE, IN_STUDIO], ids=["alone", "studio"])
def test_letters_lie_on_no_pin_and_on_no_other_letter_in_any_position(
    page_of: Begin, window: dict[str, int]
) -> None:
    """However small the mechanism is drawn: its letters are the larger for it."""
    page = _crank(page_of, "crank-rocker", window)
    for opened in (False, True):
        if opened:
            page.locator(".lengths summary").first.click()
            page.evaluate(FRAMES)
        for button in page.locator("#crank .row button").all():
            button.click()
            letters, pins = page.evaluate(LETTERS), page.evaluate(PINS)
            assert len(letters) > 12
            assert len(pins) > 3
            where = f"{button.text_content()} {opened}"
            for k, one in enumerate(letters):
                assert [n for n in range(k) if _meet(one, letters[n])] == [], where
                assert [pin for pin in pins if _meet(one, [*pin, *pin])] == [], where


NUMBERS = """() => [...document.querySelectorAll("#crank .lead .stays")]
  .filter((one) => getComputedStyle(one).visibility !== "hidden").map((one) => {
    const { left, top, right, bottom } = one.getBoundingClientRect();
    return [(left + right) / 2, (top + bottom) / 2]; })"""


def test_numbers_of_positions_stay_about_the_circle_of_the_pin(page_of: Begin) -> None:
    """With another length they stand where the pin is then; what does not move the pin moves no number."""
    page = _crank(page_of, "crank-rocker", ALONE)
    page.locator(".lengths summary").first.click()
    rows = page.locator("#crank .row button")
    for letter, text in ("l_AB", "64"), ("l_OA", "24"):
        field = page.get_by_role("textbox", name=f"{letter}, value")
        field.fill(text)
        field.press("Enter")
        page.evaluate(FRAMES)
        numbers = page.evaluate(NUMBERS)
        assert len(numbers) == rows.count()
        for k, place in enumerate(numbers):
            rows.nth(k).click()
            x, y = page.evaluate(PINS)[0]
            assert abs(complex(*place) - complex(x, y)) < 40


def test_nothing_moves_when_a_message_comes_or_goes(page_of: Begin) -> None:
    page = _crank(page_of, "crank-rocker", ALONE)
    page.locator(".lengths summary").first.click()
    page.evaluate(FRAMES)
    field = page.get_by_role("textbox", name="l_AB, value")
    places = """() => [
      ...document.querySelectorAll(".lengths input, #crank .row button, #crank .lead svg")].map((one) => {
      const { left, top, width, height } = one.getBoundingClientRect();
      return [left, top, width, height]; })"""
    before = page.evaluate(places)
    said: set[str | None] = set()
    for text in ("64", "26", "many", "60"):
        field.fill(text)
        field.press("Enter")
        page.evaluate(FRAMES)
        said.add(page.locator(".lengths .told").text_content())
        assert page.evaluate(places) == before, text
    assert len(said) > 2
