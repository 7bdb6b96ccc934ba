"""Loads are drawn on the scheme: a person sees what he has added, and it goes with what he turns and zooms."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from support.scheme_hand import begun
from support.served import SMALL
from support.studios import Tab, expect, serious

FORCE = '[[load]]\nlink = 3\npoint = "B"\nforce = "190 N"\ndirection = "against velocity"\n'
TIP = """() => {
  const head = document.querySelector('.load .head').getBoundingClientRect();
  return head.x + head.width / 2;
}"""


def test_a_load_that_is_added_stands_at_its_point(scene: Path, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    begun(tab)
    more = tab.page.locator(".more")
    expect(tab.page.locator(".load")).to_have_count(0)
    more.locator("select").first.select_option("load")
    keys = more.locator("form > .scheme-field")
    for at, value in ((0, "3"), (1, "B"), (2, "190 N")):
        keys.nth(at).locator("input").fill(value)
    more.get_by_role("button", name="Add it").click()
    expect(tab.page.locator(".load text")).to_have_text("F3")
    tab.page.locator("[data-tool=undo]").click()
    expect(tab.page.locator(".load")).to_have_count(0)


def test_a_load_goes_with_the_drive_and_keeps_its_size(
    scene: Path, tab_of: Callable[..., Tab]
) -> None:
    scene.write_text(SMALL + FORCE, encoding="utf-8")
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    slider = tab.page.locator(".scheme-turn input")
    slider.evaluate(
        "(one) => { one.value = 30; one.dispatchEvent(new Event('input')); }"
    )  # φ = 90°: the slider goes to the left
    tab.page.locator(".scheme-turn output", has_text="φ = 90°").wait_for()
    assert tab.page.evaluate(TIP) > hand.box["x"] + hand.pin("B")[0] + 40
    slider.evaluate("(one) => { one.value = 90; one.dispatchEvent(new Event('input')); }")
    tab.page.locator(".scheme-turn output", has_text="φ = 270°").wait_for()
    assert tab.page.evaluate(TIP) < hand.box["x"] + hand.pin("B")[0] - 40
    load = tab.page.locator(".load path").first
    before = load.bounding_box()
    tab.page.mouse.move(hand.box["x"] + 300, hand.box["y"] + 200)
    tab.page.mouse.wheel(0, -300)
    after = load.bounding_box()
    assert before is not None
    assert after is not None
    assert abs(after["width"] - before["width"]) < 0.5


def test_a_load_by_travel_is_entered_row_by_row(scene: Path, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    begun(tab)
    more = tab.page.locator(".more")
    more.locator("select").first.select_option("load")
    more.get_by_text("What else may be written").click()
    for label, value in (("number of the link *", "3"), ("where a force acts", "B")):
        more.locator("label", has_text=label).first.locator("input").fill(value)
    more.locator("label", has_text="by whose travel").locator("input").fill("B")
    table = more.locator("fieldset", has_text="on the stroke from the zero position")
    expect(table.locator("input")).to_have_count(2)
    for at, value in enumerate(("0", "0 N", "0.5", "190 N", "1", "190 N")):
        table.locator("input").nth(at).fill(value)
    expect(table.locator("input")).to_have_count(8)
    assert serious(tab.page) == []
    more.get_by_role("button", name="Add it").click()
    expect(tab.page.locator(".load text")).to_have_text("F3")
    assert 'out = [[0, "0 N"], [0.5, "190 N"], [1, "190 N"]]' in scene.read_text("utf-8")
