"""A page of a mechanism of one's own: no letters collide on a phone, it begins in the main position."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from support.browser import FRAMES
from support.gallery import ROOT

from graphic_tmm.page.page import page as written
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets

CASE = ROOT / "tests" / "cases" / "sheets" / "upright.toml"
PHONES = [(360, 740), (390, 844)]
HEADER = 48
STILL = ("#positions/all/0", "#positions/all/1", "#positions/all/999", "#velocities//999")
MAIN = "3"
"""The one of all 12 in which motion is passed on best; no plan of accelerations is asked for."""
SHEET = """
[[sheet]]
format = "A1"
place = ["positions", "velocities"]
"""
MEETING = """() => {
  const letters = [...document.querySelectorAll("svg .label, .stays .glyph, .inset text")];
  const seen = letters.filter((one) => one.checkVisibility({ visibilityProperty: true }));
  const boxes = seen.map((one) => one.getBoundingClientRect());
  const across = (a, b) => a.left < b.right - 1 && b.left < a.right - 1;
  const meet = (a, b) => across(a, b) && a.top < b.bottom - 1 && b.top < a.bottom - 1;
  return [seen.length, boxes.flatMap((a, k) => boxes.slice(0, k).filter((b) => meet(a, b))).length];
}"""
"""How many letters are seen, how many pairs of them meet by more than a pixel."""


@pytest.fixture(scope="module", params=["en", "ru"])
def file(request: Any, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("phone")
    scene = folder / "scene.toml"
    text = CASE.read_text(encoding="utf-8").partition("[forces]")[0]
    text = text.replace('language = "en"', f'language = "{request.param}"')
    scene.write_text(text + SHEET, encoding="utf-8")
    found = folder / "page.html"
    found.write_text(written(*sheets(read(scene)), practised=True), encoding="utf-8")
    return found


def shown(opened: Any, file: Path, address: str, width: int, height: int) -> Any:
    phone = width < 500
    size = {"width": width, "height": height}
    page = opened(file, address, viewport=size, has_touch=phone, is_mobile=phone).page
    page.locator(".ready").first.wait_for()
    page.evaluate(FRAMES)
    return page


def went(page: Any, file: Path, address: str) -> None:
    """Go to another address of the page, which is not read anew for it."""
    page.goto(file.as_uri() + address)
    page.evaluate(FRAMES)


@pytest.mark.turns(2)
@pytest.mark.parametrize("size", PHONES)
def test_nothing_collides_on_a_phone(size: tuple[int, int], file: Path, opened: Any) -> None:
    page = shown(opened, file, "#positions/all/999", *size)
    for tab in page.get_by_role("tab").all():
        tab.click()
        page.evaluate(FRAMES)
        assert page.locator("header").bounding_box()["height"] <= HEADER
        assert page.evaluate("document.scrollingElement.scrollWidth") <= size[0]
    for address in (*STILL, "#lecture:velocities//999", "#crank:"):
        went(page, file, address)
        seen, meeting = page.evaluate(MEETING)
        assert seen > 1, address
        assert meeting == 0, address


def test_it_begins_in_the_main_position_with_an_empty_desk(file: Path, opened: Any) -> None:
    page = shown(opened, file, "#velocities", 1280, 800)
    assert page.locator("#play .places select option:checked").text_content() == MAIN
    assert page.locator("#play .values").is_hidden()
    page.get_by_role("tab").nth(4).click()
    page.locator("#practice .goal").wait_for()
    assert page.locator("#practice .places select option:checked").text_content() == MAIN
    goal = page.locator("#practice .goal").inner_text()
    assert all(f" {word}" in goal for word in (MAIN, "pc", "ω2")), goal
    page.locator("#practice .places select").select_option(label="0")
    assert goal != page.locator("#practice .goal").inner_text()
    page = shown(opened, file, page.evaluate("location.hash"), 1280, 800)
    assert page.locator("#practice .places select option:checked").text_content() == "0"


def test_the_table_tells_what_was_read(file: Path, opened: Any) -> None:
    page = shown(opened, file, "#velocities/4/999", 1280, 800)
    whole = page.locator("#play .values tbody tr:visible").count()
    last = int(page.locator("#play .stage").get_attribute("data-step"))
    counts = []
    for n in range(0, last + 1, 3):
        went(page, file, f"#velocities/4/{n}")
        rows = page.locator("#play .values tbody tr:visible")
        counts.append(rows.count())
        assert all(rows.nth(k).locator("td:visible").count() == 3 for k in range(rows.count()))
    assert counts == sorted(counts)
    assert counts[0] == 0
    assert len(set(counts)) > 2
    assert max(counts) <= whole


def test_practice_says_its_task_first_and_shows_its_mechanism(file: Path, opened: Any) -> None:
    page = shown(opened, file, "#practice:velocities", 1280, 800)
    goal, palette = (
        page.locator(f"#practice .{name}").bounding_box() for name in ("goal", "palette")
    )
    assert goal["y"] + goal["height"] <= palette["y"] + 1
    beside, sketch = (
        page.locator(f"#practice .{name}").bounding_box() for name in ("beside", "sketch")
    )
    assert beside["width"] * beside["height"] > 0.3 * sketch["width"] * sketch["height"]
    apart = beside["x"] + beside["width"] <= sketch["x"] + 1
    assert apart or beside["y"] + beside["height"] <= sketch["y"] + 1
    page = shown(opened, file, "#practice:positions", 1280, 800)
    assert page.locator("#practice .inset").is_visible()
    page = shown(opened, file, "#practice:positions", 390, 844)
    assert not page.locator("#practice .inset").is_visible()
