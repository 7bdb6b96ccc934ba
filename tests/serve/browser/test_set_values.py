"""Values are set in the file from its form: by keys alone, refused beside the field, over nobody else's."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from support.served import SMALL
from support.studios import Tab, expect

from graphic_tmm.serve.edit import edited

if TYPE_CHECKING:
    from playwright.sync_api import Route


def put(scene: Path, text: str) -> None:
    scene.write_text(text, encoding="utf-8")


def written(studio: Tab, scene: Path, text: str) -> None:
    """Wait until the file says something."""
    for _ in range(200):
        if scene.read_text("utf-8") == text:
            return
        studio.page.wait_for_timeout(50)
    assert scene.read_text("utf-8") == text


def test_enter_writes_a_value_and_nothing_else(studio: Tab, scene: Path) -> None:
    first = studio.shown()
    field = studio.field("link 1, points.A[1]")
    assert field.input_value() == "0.1 m"
    field.fill("0.12 m")
    field.press("Enter")
    studio.another(first)
    assert scene.read_text("utf-8") == SMALL.replace('"0.1 m"', '"0.12 m"')
    expect(field).to_have_value("0.12 m")
    expect(field).to_be_focused()


def test_leaving_writes_and_escape_takes_back(studio: Tab, scene: Path) -> None:
    first = studio.shown()
    field = studio.field("drive.positions")
    field.fill("3")
    field.press("Escape")
    expect(field).to_have_value("2")
    field.press("Tab")
    assert scene.read_text("utf-8") == SMALL
    field.fill("3")
    field.press("Tab")
    studio.another(first)
    assert scene.read_text("utf-8") == SMALL.replace("positions = 2", "positions = 3")


def test_a_choice_that_was_not_there_is_written_and_taken_out_again(
    studio: Tab, scene: Path
) -> None:
    field = studio.field("hand.name")
    field.select_option("student")
    written(studio, scene, SMALL + '\n[hand]\nname = "student"\n')
    field = studio.field("hand.name")
    field.select_option("")
    expect(studio.field("hand.name")).to_have_value("")
    written(studio, scene, SMALL + "\n[hand]\n")


def test_a_refused_value_says_why_beside_it(studio: Tab, scene: Path) -> None:
    studio.allow("status of 422")
    field = studio.field("drive.speed")
    field.fill("400")
    field.press("Enter")
    studio.told("its angular speed: refused.")
    expect(field).to_have_attribute("aria-invalid", "true")
    expect(field).to_have_value("400")
    said = (field.get_attribute("aria-describedby") or "").split()
    wrong = studio.page.locator(f"#{said[1]}")
    expect(wrong).to_contain_text('"400" has no unit; write "400 rpm"')
    assert scene.read_text("utf-8") == SMALL
    field.press("Escape")
    expect(field).to_have_value("10 1/s")
    expect(wrong).to_be_empty()
    expect(field).to_have_attribute("aria-invalid", "false")


def meanwhile(scene: Path, text: str) -> Callable[[Route], None]:
    """Change the file just before what was typed arrives."""

    def pass_on(route: Route) -> None:
        if route.request.method == "POST" and scene.read_text("utf-8") == SMALL:
            put(scene, text)
        route.continue_()

    return pass_on


def test_a_value_that_was_changed_meanwhile_is_told_and_neither_is_lost(
    studio: Tab, scene: Path
) -> None:
    studio.allow("status of 409")
    other = SMALL.replace("10 1/s", "20 1/s")
    studio.page.route("**/form", meanwhile(scene, other))
    field = studio.field("drive.speed")
    field.fill("30 1/s")
    field.press("Enter")
    studio.page.get_by_text("It has 20 1/s here now").last.wait_for()
    expect(field).to_have_value("30 1/s")
    assert scene.read_text("utf-8") == other
    field.press("Enter")
    written(studio, scene, SMALL.replace("10 1/s", "30 1/s"))


def test_another_value_that_was_changed_meanwhile_stays(studio: Tab, scene: Path) -> None:
    studio.allow("status of 409")
    other = SMALL.replace("positions = 2", "positions = 3 # mine")
    studio.page.route("**/form", meanwhile(scene, other))
    field = studio.field("drive.speed")
    field.fill("30 1/s")
    field.press("Enter")
    written(studio, scene, other.replace("10 1/s", "30 1/s"))


def test_who_is_typing_is_told_of_a_change(studio: Tab, scene: Path) -> None:
    field = studio.field("drive.speed")
    field.fill("30 1/s")
    put(scene, SMALL.replace("10 1/s", "20 1/s"))
    studio.page.get_by_text("It has 20 1/s here now").last.wait_for()
    expect(field).to_have_value("30 1/s")
    field.press("Escape")
    expect(field).to_have_value("20 1/s")


def test_what_is_typed_elsewhere_stays_while_the_form_is_made_anew(
    studio: Tab, scene: Path
) -> None:
    field = studio.field("drive.speed")
    field.fill("30 1")
    field.evaluate("(input) => input.setSelectionRange(2, 2)")
    put(scene, SMALL + '\n[hand]\nname = "student"\n')
    section = studio.page.locator(".groups > details:not(.absent)")
    expect(section.filter(has_text="who draws")).to_have_count(1)
    expect(field).to_have_value("30 1")
    expect(field).to_be_focused()
    assert field.evaluate("(input) => input.selectionStart") == 2


@pytest.mark.parametrize("key", ["title", "link 1, name"])
def test_a_hostile_text_is_a_text(key: str, folder: Path, tab_of: Callable[..., Tab]) -> None:
    hostile = "</script><img src=x onerror=alert(1)>&amp;'\"<b>"
    file = folder / f"hostile {key.replace(',', '')} #50%" / "scene.toml"
    file.parent.mkdir()
    file.write_bytes(edited(SMALL.encode(), {key: hostile}, file))
    tab = tab_of()
    tab.page.get_by_role("link", name=file.parent.name).click()
    tab.shown()
    assert tab.field(key).input_value() == hostile
    assert tab.page.locator("main img").count() == 1
    assert tab.page.locator("b").count() == 0
