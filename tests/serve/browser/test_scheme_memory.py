"""A page that is loaded anew has what was done on the scheme: acts to take back, and the picture below."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from PIL import Image
from support.scheme_hand import SchemeHand, begun
from support.served import SMALL
from support.studios import Tab, expect, serving

UNDO, REDO = "[data-tool=undo]", "[data-tool=redo]"
LIES = """() => {
  const { x, y, width, height } = document.querySelector('.scheme-window > canvas').getBoundingClientRect();
  return [x, y, width, height].map(Math.round);
}"""


@pytest.fixture(scope="module")
def gallery(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    with serving(tmp_path_factory.mktemp("blank")) as found:
        yield found


def again(tab: Tab) -> SchemeHand:
    tab.page.reload()
    return begun(tab)


def test_acts_are_taken_back_behind_a_reload(scene: Path, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    hand.length("AB", "0.32 m")
    hand.length("OA", "0.12 m")
    larger = SMALL.replace("0.3 m", "0.32 m")
    hand = again(tab)
    for button, text in ((UNDO, larger), (UNDO, SMALL), (REDO, larger)):
        tab.page.locator(button).click()
        tab.page.locator(".scheme[aria-busy=false]").wait_for()
        assert scene.read_text("utf-8") == text
        hand = again(tab)
    assert hand.lengths()["AB"] == "0.32 m"


def test_acts_on_another_text_are_forgotten(scene: Path, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    begun(tab).length("AB", "0.32 m")
    tab.page.goto("about:blank")
    other = SMALL.replace("0.3 m", "0.35 m")
    scene.write_text(other, encoding="utf-8")
    tab.page.go_back()
    assert begun(tab).lengths()["AB"] == "0.35 m"
    expect(tab.page.locator(UNDO)).to_be_disabled()
    scene.write_text(SMALL, encoding="utf-8")
    expect(tab.page.locator(".lengths input").nth(1)).to_have_value("0.3 m")
    again(tab)
    expect(tab.page.locator(UNDO)).to_be_disabled()


def test_the_picture_lies_where_it_lay(
    scene: Path, tmp_path: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    begun(tab)
    Image.effect_noise((600, 400), 90).convert("RGB").save(tmp_path / "task.png")
    tab.page.locator(".file-tool input").set_input_files(str(tmp_path / "task.png"))
    tab.page.locator(".scheme-window > canvas").wait_for()
    tab.page.locator("[data-tool=whole]").click()
    tab.page.wait_for_timeout(500)
    before = tab.page.evaluate(LIES)
    again(tab)
    tab.page.locator(".scheme-window > canvas").wait_for()
    assert tab.page.evaluate(LIES) == pytest.approx(before, abs=1)
    tab.page.get_by_role("button", name="Take it away").click()
    tab.page.wait_for_timeout(300)
    again(tab)
    tab.page.wait_for_timeout(300)
    expect(tab.page.locator(".scheme-window > canvas")).to_have_count(0)


def test_what_is_drawn_is_taken_back_behind_a_reload(
    gallery: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    hand.drag((250, 250), (300, 320))
    hand.drag((250, 250), (520, 160))
    tab.page.locator(".scheme[aria-busy=false]").wait_for()
    tab.page.reload()
    expect(tab.page.locator(".scheme-paper .bar")).to_have_count(2)
    tab.page.locator(UNDO).click()
    expect(tab.page.locator(".scheme-paper .bar")).to_have_count(1)
