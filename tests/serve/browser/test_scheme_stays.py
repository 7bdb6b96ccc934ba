"""A scheme stays where it is seen, behind its first length and saved; where that is stands on the paper."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from support import scheme_hand
from support.scheme_hand import SchemeHand, begun
from support.studios import Tab, expect, serving

NEAR = 2.5
"""Dots: half a millimetre, on which lengths are rounded, of a mechanism of 200 mm on 300 dots, and the pen."""


def off(hand: SchemeHand, were: dict[str, tuple[float, float]]) -> float:
    now = {letter: hand.pin(letter) for letter in were}
    return max(abs(x - u) for one in were for x, u in zip(were[one], now[one], strict=True))


def test_it_stays_where_it_is_behind_its_first_length_and_when_it_is_saved(
    tmp_path: Path, tab_of: Callable[..., Tab]
) -> None:
    with serving(tmp_path) as address:
        tab = tab_of("draw", gallery=address)
        page = tab.page
        hand = SchemeHand(tab)
        scheme_hand.shaper(hand)
        page.locator(".scheme[aria-busy=false]").wait_for()
        were = {letter: hand.pin(letter) for letter in "OABCD"}
        tools = [one.bounding_box() for one in page.locator("[data-tool]").all()]
        hand.length("OA", "400 mm")
        assert off(hand, were) < NEAR
        page.locator("[data-tool=undo]").click()
        page.locator(".scheme[aria-busy=false]").wait_for()
        assert hand.lengths()["OA"] != "400 mm"
        assert off(hand, were) < NEAR
        page.locator("[data-tool=redo]").click()
        page.locator(".scheme[aria-busy=false]").wait_for()
        assert hand.lengths()["OA"] == "400 mm"
        assert off(hand, were) < NEAR
        angle = page.locator(".scheme-turn output").text_content()
        page.locator(".scheme-save button").click()
        page.wait_for_url("**/s/*/#scheme")
        hand.whole("I(1) → II(2-3) → II(4-5)")
        expect(page.locator(".scheme-turn output")).to_have_text(angle)
        assert off(hand, were) < NEAR
        assert [one.bounding_box() for one in page.locator("[data-tool]").all()] == tools
        page.goto("about:blank")


def test_what_was_looked_at_is_not_seen_where_another_scheme_lies(
    scene: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    tab.page.locator(".scheme-paper").focus()
    text = scene.read_text("utf-8")
    scene.write_text(text.replace("0.1 m", "10 m").replace("0.3 m", "30 m"), encoding="utf-8")
    tab.page.reload()
    hand = begun(tab)
    for letter in "OAB":
        x, y = hand.pin(letter)
        assert 0 < x < hand.box["width"]
        assert 0 < y < hand.box["height"]


def test_millimetres_are_counted_from_the_first_support(
    scene: Path, tab_of: Callable[..., Tab]
) -> None:
    text = scene.read_text("utf-8").replace("O = [0, 0]\nx", 'O = ["40 mm", 0]\nx')
    scene.write_text(text, encoding="utf-8")
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    x, y = hand.pin("O")
    page = tab.page
    page.mouse.move(hand.box["x"] + x, hand.box["y"] + y)
    expect(page.locator(".scheme-at")).to_have_text("x = 0, y = 0 mm")
    nought = page.locator(".scheme-paper text.below", has_text="0 mm").filter(has_text="0 mm")
    middles = nought.evaluate_all(
        "(them) => them.map((one) => one.getBBox().x + one.getBBox().width / 2)"
    )
    assert min(abs(one - x) for one in middles) < 2
    figures = page.locator(".scheme-paper text.beside").all_text_contents()
    assert {"0", "100", "−100"} <= set(figures)
    u, v = hand.pin("B")
    page.mouse.move(hand.box["x"] + u, hand.box["y"] + v)
    expect(page.locator(".scheme-at")).to_contain_text(", y = 0 mm")
    assert u > x


def test_numbers_of_links_stand_clear_of_letters_and_of_other_bars(
    tmp_path: Path, tab_of: Callable[..., Tab]
) -> None:
    """A short crank under a long rocker, a mass centre in the middle of the rod."""
    with serving(tmp_path) as address:
        tab = tab_of("draw", gallery=address)
        page = tab.page
        hand = SchemeHand(tab)
        hand.drag((400, 342), (452, 310))
        hand.take("support")
        hand.click((400, 342))
        hand.drag((400, 525), (501, 110))
        hand.drag((501, 110), (704, 108))
        hand.take("centre")
        hand.click((602, 109))
        hand.says("W = ")
        page.locator(".scheme[aria-busy=false]").wait_for()
        boxes = """(them) => them.map((one) => one.getBBox()).map((b) => [b.x, b.y, b.width, b.height])"""
        numbers = page.locator(".scheme-paper text.number")
        names = numbers.all_text_contents()
        assert names == ["1", "2", "3"]
        for x, y, width, height in numbers.evaluate_all(boxes):
            for u, v, w, h in page.locator(".scheme-paper text.letter").evaluate_all(boxes):
                assert x + width < u or u + w < x or y + height < v or v + h < y
        one, two, _ = ((x + w / 2, y + h / 2) for x, y, w, h in numbers.evaluate_all(boxes))
        # neither on the bar of the other, which they are drawn along
        assert _from_bar(one, hand.pin("C"), hand.pin("B")) > 10
        assert _from_bar(two, (400, 342), (452, 310)) > 10
        letter = page.locator(".scheme-paper text.letter", has_text="A").bounding_box()
        page.mouse.move(hand.box["x"] + 700, hand.box["y"] + 400)
        page.mouse.down()
        page.mouse.move(hand.box["x"] + 500, hand.box["y"] + 350)
        page.mouse.move(hand.box["x"] + 452, hand.box["y"] + 310)
        joined = page.locator(".scheme-paper text.says").bounding_box()
        assert (
            joined["y"] + joined["height"] <= letter["y"]
            or letter["x"] + letter["width"] < joined["x"]
        )
        page.mouse.up()
        page.goto("about:blank")


def _from_bar(
    spot: tuple[float, float], start: tuple[float, float], end: tuple[float, float]
) -> float:
    """How far a spot is from a bar, dots."""
    p, a, b = complex(*spot), complex(*start), complex(*end)
    share = min(max(((p - a) / (b - a)).real, 0.0), 1.0)
    return abs(p - a - share * (b - a))
