"""Diagrams in a browser, lengths changed: their numbers are Python's, their ink follows or is hidden."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from support import pages
from support.browser import Opened

from graphic_tmm.board.execute import execute
from graphic_tmm.board.values import Point
from graphic_tmm.page.dense import dense

Begin = Callable[..., Opened]
NAME, POSITION, LENGTH = "slider-diagrams", 3, 0.11
FAR = 0.02
"""Ink is off by no more, mm: it is told in hundredths."""


def _diagrams(page_of: Begin) -> Any:
    page = page_of(NAME, "en", address="#crank:").page
    page.wait_for_selector("#crank[data-ready]")
    page.locator("#crank .row").get_by_role("button", name=str(POSITION), exact=True).click()
    page.locator("#crank .card:has(.cursor)").scroll_into_view_if_needed()
    page.wait_for_selector("#crank .card .cursor circle")
    return page


def _give(page: Any, text: str) -> None:
    page.locator(".lengths").evaluate("(one) => { one.open = true; }")
    field = page.get_by_role("textbox", name="l_OA, value")
    field.fill(text)
    field.press("Enter")
    page.locator(".lengths").evaluate("(one) => { one.open = false; }")
    page.locator("#crank .card:has(.cursor)").scroll_into_view_if_needed()


def _as_given(page: Any) -> None:
    page.locator(".lengths").evaluate("(one) => { one.open = true; }")
    page.get_by_role("button", name="As given").click()
    page.locator(".lengths").evaluate("(one) => { one.open = false; }")
    page.locator("#crank .card:has(.cursor)").scroll_into_view_if_needed()


def _told(page: Any) -> list[float]:
    texts = page.locator("#crank .card:has(.cursor) .values dd").all_text_contents()
    return [float(text.split()[0].replace("−", "-")) for text in texts]


def test_diagrams_follow_a_length(page_of: Begin) -> None:
    """The numbers beside are those of the points on Python's curves; as given they are what they were."""
    page = _diagrams(page_of)
    before = _told(page)
    _give(page, f"{1000 * LENGTH:g}")
    made, _ = pages.on_sheets(NAME, "en")
    assert made.mechanism is not None
    found = dense(made.mechanism)
    assert found is not None
    log = found.sheet.construction
    own = {mark: LENGTH for mark in log.given if mark.name == "l_{OA}"}
    reading = execute(log, {**found.sheet.given, **own})
    scales = {view.name: view.scale for view in log.views if view.name.startswith("diagram")}
    points = [s.it for s in log.steps if s.it.name in ("v", "a") and s.it.kind is Point]
    due = [
        reading[mark][0, POSITION].imag * reading[scale].item()
        for mark in points
        if (scale := scales.get(mark.view)) is not None
    ]
    told = _told(page)
    assert len(due) == len(told) == len(before)
    np.testing.assert_allclose(told, due, rtol=1e-3)
    assert not np.allclose(told, before, rtol=0.05)
    _as_given(page)
    assert _told(page) == before


def test_ink_of_the_sheet_that_moved_is_hidden_and_drawn_anew(page_of: Begin) -> None:
    """No ink is where it was; the cursor stands on a curve that is drawn anew."""
    page = _diagrams(page_of)
    seen = "#crank .card:has(.cursor) g:not(.lettering) > path[data-of]:not([visibility=hidden])"
    whole = page.locator(seen).count()
    _give(page, f"{1000 * LENGTH:g}")
    left = page.locator(seen).count()
    assert 0 < left < whole
    off = page.locator("#crank .card:has(.cursor) svg").first.evaluate(
        """(svg) => [...svg.querySelectorAll(".cursor circle")].map((dot) => {
          const [x, y] = [Number(dot.getAttribute("cx")), Number(dot.getAttribute("cy"))];
          const all = [...svg.querySelectorAll("path:not([data-of])")];
          const anew = all.filter((one) => /C/.test(one.getAttribute("d")));
          return Math.min(...anew.map((path) => {
            const long = path.getTotalLength();
            let least = Infinity;
            for (let s = 0; s <= long; s += 0.01) {
              const at = path.getPointAtLength(s);
              least = Math.min(least, Math.hypot(at.x - x, at.y - y));
            }
            return least;
          }));
        })"""
    )
    assert len(off) == len(_told(page))
    assert max(off) < FAR
    _as_given(page)
    assert page.locator(seen).count() == whole


def test_points_of_an_indicator_diagram_and_its_cursor_follow_a_length(page_of: Begin) -> None:
    """At a position both stand where Python has the point; as given they are where they were."""
    page = page_of("engine", address="#crank:", viewport={"width": 1400, "height": 9000}).page
    page.wait_for_selector("#crank[data-ready]")
    page.locator("#crank .row").get_by_role("button", name=str(POSITION), exact=True).click()
    for box in page.locator("#crank").get_by_role("checkbox").all():
        box.check()
    card = page.locator("#crank .card:has(.cursor)").first
    card.scroll_into_view_if_needed()
    card.locator(".cursor circle").first.wait_for()
    made, _ = pages.on_sheets("engine", pages.language("engine"))
    assert made.mechanism is not None
    sheet = dense(made.mechanism).sheet  # type: ignore[union-attr]
    log = sheet.construction
    point = next(s.it for s in log.steps if s.it.key == ("indicator", "k"))
    arm = next(mark for mark in log.given if mark.name == "l_{OA}")
    longer = 1.25 * float(np.ravel(sheet.given[arm])[0])
    at = [
        execute(log, {**sheet.given, **own})[point][0, POSITION - 1]
        for own in ({}, {m: longer for m in log.given if m.name == "l_{OA}"})
    ]

    def places() -> list[complex]:
        spots = card.locator("svg").first.evaluate(PLACES, [point.slot, POSITION - 1])
        return [complex(x, y) for x, y in spots]

    (first, *_), before = places(), places()
    page.locator(".lengths").evaluate("(one) => { one.open = true; }")
    field = page.get_by_role("textbox", name="l_OA", exact=False)
    field.fill(f"{1000 * longer:.6g}".replace(".", ","))
    field.press("Enter")
    card.scroll_into_view_if_needed()
    way = np.conj(at[1] - at[0])
    assert abs(way) > 1.0
    np.testing.assert_allclose(places(), np.add(before, way), atol=FAR)
    assert np.abs(np.subtract(before, first)).max() < FAR


PLACES = """(svg, [slot, at]) => {
  const all = [...svg.querySelectorAll(`path[data-of="${slot}"][data-at="${at}"]`)];
  const dot = all.find((one) => /Z$/.test(one.getAttribute("d")));
  const { x, y, width, height } = dot.getBBox();
  const [u = 0, v = 0] = (dot.style.translate || "").split(" ").map(parseFloat);
  const [cx, cy] = ["cx", "cy"].map((one) => Number(svg.querySelector(".cursor circle").getAttribute(one)));
  return [[x + width / 2 + (u || 0), y + height / 2 + (v || 0)], [cx, cy]];
}"""
"""Where the dot of a point in a position is, and where the cursor stands, mm of the sheet, y downward."""
