"""On a phone every tool of the scheme stands in sight, large enough for a finger."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from support.scheme_hand import begun
from support.studios import SIZES, Tab, in_sight, serious

OUT_OF_REACH = """() => {
  const bar = document.querySelector(".scheme-tools");
  const scrolls = bar.scrollWidth > bar.clientWidth ? ["it scrolls"] : [];
  const { left, right } = bar.getBoundingClientRect();
  const out = [...bar.querySelectorAll(".tool")].filter((one) => {
    const box = one.getBoundingClientRect();
    const out = box.left < left - .5 || box.right > right + .5 || box.right > innerWidth;
    return out || Math.min(box.width, box.height) < 43.5;
  });
  return [...scrolls, ...out.map((one) => one.textContent || one.title)];
}"""
PAPER = (
    "() => document.querySelector('.scheme-window').getBoundingClientRect().height / innerHeight"
)


@pytest.mark.parametrize(("size", "share"), [("phone", 0.3), ("turned", 0.35), ("desk", 0.6)])
def test_every_tool_can_be_reached(
    size: str, share: float, scene: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme", viewport=SIZES[size])
    begun(tab)
    assert tab.page.locator(".scheme-tools .tool").count() > 11
    assert tab.page.evaluate(OUT_OF_REACH) == []
    assert tab.page.evaluate(PAPER) > share
    assert serious(tab.page) == []
    assert in_sight(tab.page) == []
