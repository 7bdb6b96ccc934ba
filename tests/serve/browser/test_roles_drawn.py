"""Several drives, passive links and welds, drawn by mouse and by keys."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from support import scheme_hand
from support.scheme_hand import SchemeHand
from support.studios import Tab, expect, in_sight, serious, serving

MOST = 18
"""Acts by mouse that a mechanism of two groups and two drives may take."""
DRAWN = (scheme_hand.excavator, scheme_hand.parallel_cranks, scheme_hand.bell_crank)


@pytest.fixture(scope="module")
def gallery(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with serving(tmp_path_factory.mktemp("empty")) as found:
        yield found


def text_of(tab: Tab) -> str:
    tab.page.locator(".scheme[aria-busy=false]").wait_for()
    return str(tab.page.evaluate("JSON.parse(sessionStorage.getItem('scheme')).text"))


def long(hand: SchemeHand) -> float:
    """How far apart the pins of the second cylinder are seen, dots."""
    return math.dist(hand.pin("F"), hand.pin("E"))


@pytest.mark.parametrize("drawn", DRAWN, ids=lambda one: one.__name__)
def test_drives_passive_links_and_welds_are_drawn_in_few_acts(
    drawn: Callable[[SchemeHand], None], gallery: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    drawn(hand)
    assert hand.acts <= MOST
    assert serious(tab.page) == []
    assert in_sight(tab.page) == []


def test_a_drive_is_taken_away_and_taken_back(gallery: str, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    scheme_hand.excavator(hand)
    expect(tab.page.locator(".scheme-paper .drive")).to_have_count(2)
    whole = text_of(tab)
    assert whole.count("[[drive]]") == 2
    hand.take("drive")
    hand.click((372, 172))
    hand.says("or another link is driven, too: click it with the tool")
    expect(tab.page.locator(".scheme-paper .drive")).to_have_count(1)
    tab.page.locator("[data-tool=undo]").click()
    hand.whole("I(1-2), I(5-6) → II(2-3) → II(4-5)")
    assert text_of(tab) == whole
    hand.length("link 1: its angular speed", "0.02", shows="0.02 m/s")
    hand.length("link 6: its speed", "10 mm/s")
    # the second goes with the first: the length of its cylinder, seen on the paper, changes
    before = long(hand)
    tab.page.locator(".scheme-turn button").click()
    tab.page.wait_for_timeout(1500)
    assert abs(long(hand) - before) > 2


def test_one_length_of_parallel_cranks_is_that_of_all(
    gallery: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    scheme_hand.parallel_cranks(hand)
    assert 'A = ["r", 0]' in text_of(tab)
    hand.length("OA", "300 mm", shows="r")
    assert hand.lengths()["r"] == "300 mm"
    hand.length("b", "1500 mm")
    hand.whole("I(1) → II(2-3)")
    # a link that counts again is one too many
    hand.take("passive")
    (x, y), (u, v) = hand.pin("D"), hand.pin("E")
    hand.click(((x + u) / 2, (y + v) / 2))
    hand.says("links 1, 3, 4 go parallel")
    tab.page.locator("[data-tool=undo]").click()
    hand.whole("I(1) → II(2-3)")


def test_roles_are_given_by_keys_alone_in_russian(
    tab_of: Callable[..., Tab], tmp_path: Path
) -> None:
    with serving(tmp_path, language="ru") as address:
        tab = tab_of("draw", gallery=address)
        page = tab.page
        hand = SchemeHand(tab, "Начертите звено")
        page.locator(".scheme-paper").focus()

        def keys(*row: str) -> None:
            for key in row:
                page.keyboard.press(key)

        def tool(name: str, *row: str) -> None:
            button = page.locator(f"[data-tool={name}]")
            button.focus()
            button.press("Enter")
            keys(*row, "Enter", "Enter")

        left, right, up, down = (f"Shift+Arrow{way}" for way in ("Left", "Right", "Up", "Down"))
        keys(*[left] * 3, "Enter", left, down, "Enter")
        tool("support")
        keys(right, up, "Enter", *[right] * 2, up, "Enter")
        keys("Enter", *[right] * 2, down, "Enter", "Enter", right, down, "Enter")
        tool("support")
        hand.says("W = 2: укажите ведущие звенья, всего 2.")
        tool("drive")
        tool("drive", *[left] * 6)
        hand.whole("I(1), I(4) → II(2-3)")
        tool("weld", *[right] * 3, *[up] * 2)
        hand.says("W = 1, а ведущих звеньев 2")
        expect(page.locator(".scheme-paper .weld")).to_have_count(1)
        keys("Control+z")
        hand.whole("I(1), I(4) → II(2-3)")
        tool("passive")
        hand.says("W = 3")
        expect(page.locator(".scheme-paper .bar.passive")).to_have_count(1)
        keys("Control+z")
        hand.whole("I(1), I(4) → II(2-3)")
        tab.page.goto("about:blank")
