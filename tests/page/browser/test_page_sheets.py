"""Sheets on the canvas of the page: the ink of the SVG, its layers, what hands and keys do to it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from support import pages
from support.canvas import by_svg, picture, seen, size, unlike, without

from graphic_tmm.paper.write.svg import ids, svg

TRUE = 96 / 25.4
NAME = "windrower"
ADDRESS = "#sheets:"
LARGE = "Letters and lines large enough for the screen"
ALIKE = 2e-4
"""The share of points that may be otherwise: where ends of strokes are smoothed by two programs."""


@pytest.fixture
def sheets_of(page_of):
    """Open the sheets of a scene in English; no view is chosen: the ground beside the paper is touched."""

    def begin(name: str = NAME, **options: Any) -> Any:
        page = page_of(name, "en", ADDRESS, **options).page
        page.locator(".desk").click(position={"x": 2, "y": 2})
        return page

    return begin


@pytest.fixture
def as_svg(browser, tmp_path):
    """Draw a sheet's SVG by the browser itself, as it is looked at on a page."""
    context: list[Any] = []

    def drawn(page: Any, text: str) -> Any:
        ratio = page.evaluate("devicePixelRatio")
        wide, high = size(page)
        context.append(
            browser.new_context(viewport={"width": wide, "height": high}, device_scale_factor=ratio)
        )
        return by_svg(context[-1].new_page(), text, seen(page), wide, high, tmp_path / "sheet.html")

    yield drawn
    for one in context:
        one.close()


def text_of(number: int = 0, name: str = NAME) -> str:
    return svg(pages.on_sheets(name, "en")[1][number])


def at_true_size(page: Any) -> None:
    page.get_by_role("button", name="1 : 1", exact=True).click()


def over(page: Any, x: float, y: float) -> tuple[float, float]:
    """Where a point of the sheet (mm, y downward) stands in the window, px."""
    box = page.locator(".desk canvas").bounding_box()
    px, py = seen(page).spot(x, y)
    return box["x"] + px, box["y"] + py


def ticked(page: Any, name: str, on: bool) -> None:
    page.get_by_role("checkbox", name=name, exact=True).set_checked(on)


@pytest.mark.turns(1)
@pytest.mark.parametrize(("ratio", "steps", "number"), [(1, 5, 1), (2, 0, 0), (3, -5, 2)])
def test_the_canvas_shows_what_the_svg_shows(ratio, steps, number, sheets_of, as_svg):
    page = sheets_of(device_scale_factor=ratio)
    page.get_by_role("combobox", name="Sheet", exact=True).select_option(str(number))
    page.keyboard.press("1")
    for _ in range(abs(steps)):
        page.keyboard.press("+" if steps > 0 else "-")
    if steps < 0:
        ticked(page, LARGE, False)
    assert seen(page).zoom == pytest.approx(TRUE * 1.25**steps)
    for keys in ((), ("ArrowLeft", "ArrowLeft", "ArrowUp")):
        for key in keys:
            page.keyboard.press(key)
        found, due = picture(page), as_svg(page, text_of(number))
        assert found.shape == due.shape
        assert (due < 128).mean() > 0.001
        assert unlike(found, due) < ALIKE


def test_letters_and_lines_are_seen_where_the_paper_s_would_be_too_small(sheets_of):
    page = sheets_of(viewport={"width": 390, "height": 844}, device_scale_factor=3, has_touch=True)
    large = picture(page)
    ticked(page, LARGE, False)
    small = picture(page)
    assert np.count_nonzero(large < 64) > 2 * np.count_nonzero(small < 64)


def test_a_layer_that_is_off_takes_exactly_its_ink_away(sheets_of, as_svg):
    page = sheets_of(viewport={"width": 1600, "height": 900})
    ticked(page, LARGE, False)
    for details in ("Parts", "Views"):
        page.locator("summary", has_text=details).click()
    whole = text_of()
    layers = {
        "Letters": lambda one: one.get("class") == "label",
        "links": lambda one: one.get("data-part") == "link",
        "leaders of letters": lambda one: one.get("data-part") == "leader",
        "Velocity plan, position 2": lambda one: one.get("id") == "s-sheet-1-velocities-2",
    }
    full = picture(page)
    assert unlike(full, as_svg(page, whole)) < ALIKE
    for name, gone in layers.items():
        ticked(page, name, False)
        left = picture(page)
        assert unlike(left, as_svg(page, without(whole, gone))) < ALIKE
        assert (left != full).any()
        ticked(page, name, True)
    assert (picture(page) == full).all()


def test_one_position_is_shown_with_what_belongs_to_all(sheets_of, as_svg):
    page = sheets_of()
    ticked(page, LARGE, False)
    page.get_by_role("combobox", name="Position", exact=True).last.select_option("5")
    sheet = pages.on_sheets(NAME, "en")[1][0]
    ink = []
    for drawing in sheet.drawings:
        board = next((one.board for one in pages.views(NAME, "en") if one.drawing == drawing), None)
        row = [] if board is None else [board.names[k] for k in board.row(drawing.shows[-1])]

        def there(one: Any, row: list[str] = row) -> bool:
            return one.position is None or not row or row[one.position] == "5"

        strokes = tuple(filter(there, drawing.strokes))
        labels = tuple(filter(there, drawing.labels))
        ink.append(drawing._replace(strokes=strokes, labels=labels))
    due = svg(sheet._replace(drawings=tuple(ink)))
    assert len(due) < 0.9 * len(text_of())
    assert unlike(picture(page), as_svg(page, due)) < ALIKE


def test_what_was_rubbed_out_comes_back_under_its_view(sheets_of, as_svg):
    page = sheets_of()
    ticked(page, LARGE, False)
    ticked(page, "Helping lines that were rubbed out", True)
    sheet = pages.on_sheets(NAME, "en")[1][0]
    drawings = [
        part
        for drawing in sheet.drawings
        for part in (drawing._replace(name="before", strokes=drawing.rubbed, labels=()), drawing)
    ]
    found = picture(page)
    assert unlike(found, as_svg(page, svg(sheet._replace(drawings=tuple(drawings))))) < ALIKE
    assert unlike(found, as_svg(page, text_of())) > 5 * ALIKE


def test_keys_move_and_zoom(sheets_of):
    page = sheets_of()
    whole = seen(page)
    page.keyboard.press("1")
    true = seen(page)
    assert true.zoom == pytest.approx(TRUE)
    wide, high = size(page)
    for key, x, y in (
        ("ArrowRight", 1, 0),
        ("ArrowDown", 0, 1),
        ("ArrowLeft", -1, 0),
        ("ArrowUp", 0, -1),
    ):
        before = seen(page)
        page.keyboard.press(key)
        after = seen(page)
        assert after.x - before.x == pytest.approx(0.12 * x * wide / TRUE, abs=1e-9)
        assert after.y - before.y == pytest.approx(0.12 * y * high / TRUE, abs=1e-9)
    page.keyboard.press("+")
    assert seen(page).zoom == pytest.approx(1.25 * TRUE)
    page.keyboard.press("-")
    assert seen(page) == pytest.approx(true)
    page.keyboard.press("0")
    assert seen(page) == pytest.approx(whole)


def test_the_sheet_is_one_stop_of_the_keyboard_and_lets_go_of_it(sheets_of):
    page = sheets_of()
    page.locator(".desk").focus()
    page.keyboard.press("Tab")
    assert page.locator(".desk").evaluate("one => document.activeElement !== one")
    before = seen(page)
    page.get_by_role("combobox", name="Sheet", exact=True).focus()
    page.keyboard.press("1")
    assert seen(page) == before


def test_the_wheel_zooms_at_the_pointer_and_a_drag_moves_as_far_as_the_hand(sheets_of):
    page = sheets_of()
    at_true_size(page)
    box = page.locator(".desk canvas").bounding_box()
    x, y = round(box["x"] + 200), round(box["y"] + 150)
    before = seen(page)
    held = before.x + (x - box["x"]) / before.zoom, before.y + (y - box["y"]) / before.zoom
    page.mouse.move(x, y)
    page.mouse.wheel(0, -300)
    assert seen(page).zoom > 1.3 * TRUE
    assert over(page, *held) == pytest.approx((x, y), abs=0.01)
    page.mouse.down()
    page.mouse.move(x - 30, y + 10)
    page.mouse.move(x - 80, y + 45)
    page.mouse.up()
    assert over(page, *held) == pytest.approx((x - 80, y + 45), abs=0.01)


def test_two_fingers_zoom_about_their_middle_and_one_moves(sheets_of):
    page = sheets_of(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    driver = page.context.new_cdp_session(page)
    box = page.locator(".desk canvas").bounding_box()
    x, y = box["x"] + 150, box["y"] + 180

    def touch(kind: str, *spots: tuple[float, float]) -> None:
        points = [{"x": a, "y": b, "id": k} for k, (a, b) in enumerate(spots)]
        driver.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    at_true_size(page)
    before = seen(page)
    held = before.x + 150 / before.zoom, before.y + 180 / before.zoom
    touch("touchStart", (x - 20, y))
    touch("touchMove", (x - 20, y), (x + 20, y))
    touch("touchStart", (x - 20, y), (x + 20, y))
    for k in range(1, 9):
        touch("touchMove", (x - 20 - 5 * k, y), (x + 20 + 5 * k, y))
    touch("touchEnd")
    assert seen(page).zoom == pytest.approx(3 * before.zoom, rel=0.02)
    assert over(page, *held) == pytest.approx((x, y), abs=3)
    there = over(page, *held)
    touch("touchStart", (x, y))
    for k in range(1, 9):
        touch("touchMove", (x + 6 * k, y - 4 * k))
    touch("touchEnd")
    assert over(page, *held) == pytest.approx((there[0] + 48, there[1] - 32), abs=8)


def drawing_of(name: str, number: int = 0) -> Any:
    sheet = pages.on_sheets(NAME, "en")[1][number]
    return sheet.drawings[ids(sheet).index(f"s-{sheet.name}-{name}")]


def middle_of(name: str, number: int = 0) -> tuple[float, float, float]:
    """The middle of a view of a sheet, mm (y downward), and its height."""
    from graphic_tmm.paper.packing import bounds

    sheet = pages.on_sheets(NAME, "en")[1][number]
    left, low, right, top = bounds(drawing_of(name, number))
    return (left + right) / 2, sheet.height - (low + top) / 2, top - low


def blank_near(page: Any, x: float, y: float, clear: int = 16) -> tuple[float, float]:
    """The place in the window, px, nearest to a point of the sheet, about which a finger meets no ink."""
    white = (picture(page) == 255).all(axis=2)
    sums = np.pad(white.cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    edge = 2 * clear
    full = sums[edge:, edge:] - sums[:-edge, edge:] - sums[edge:, :-edge] + sums[:-edge, :-edge]
    down, across = np.nonzero(full == edge * edge)
    px, py = seen(page).spot(x, y)
    best = np.hypot(across + clear - px, down + clear - py).argmin()
    box = page.locator(".desk canvas").bounding_box()
    return box["x"] + float(across[best]) + clear, box["y"] + float(down[best]) + clear


def test_a_finger_on_a_view_fills_the_screen_with_it_and_once_more_plays_it(sheets_of):
    page = sheets_of(viewport={"width": 390, "height": 844}, has_touch=True, is_mobile=True)
    x, y, high = middle_of("velocities-3")
    page.touchscreen.tap(*over(page, x, y))
    where = seen(page)
    assert over(page, x, y)[0] == pytest.approx(390 / 2, abs=8)
    assert where.zoom > 2
    assert high * where.zoom < size(page)[1]
    assert "Velocity plan, position 3" in page.locator("#live").inner_text()
    page.touchscreen.tap(*blank_near(page, x, y))
    page.wait_for_url("**#velocities/3/0")


def test_enter_in_the_list_of_views_plays_one(sheets_of):
    page = sheets_of()
    entry = page.get_by_role("list", name="Views").get_by_role(
        "button", name="Acceleration plan, position 6"
    )
    entry.focus()
    page.keyboard.press("Enter")
    page.wait_for_url("**#accelerations/6/0")


def blue(points: Any) -> int:
    return int((points[:, :, 2] > points[:, :, 0] + 60).sum())


def test_a_vector_tells_what_it_is_and_its_mark_lights_up(sheets_of):
    page = sheets_of()
    at_true_size(page)
    page.keyboard.press("0")
    vector = next(
        one for one in drawing_of("velocities-3").strokes if dict(one.data).get("segment") == "pa"
    )
    high = pages.on_sheets(NAME, "en")[1][0].height
    (x0, y0, _), (x1, y1, _) = vector.path
    dark = picture(page)
    page.mouse.click(*over(page, x0 + 0.8 * (x1 - x0), high - (y0 + 0.8 * (y1 - y0))))
    told = page.locator(".pointed").inner_text()
    assert vector.title in told
    assert vector.title in page.locator("#live").inner_text()
    assert "Velocity plan, position 3" in told
    lit = picture(page)
    assert (blue(dark), blue(lit) > 40) == (0, True)
    page.mouse.click(*over(page, x0 + 0.3 * (x1 - x0), high - (y0 + 0.3 * (y1 - y0))))
    first = page.locator(".pointed").inner_text()
    page.mouse.click(*over(page, x0 + 0.3 * (x1 - x0), high - (y0 + 0.3 * (y1 - y0))))
    assert {told, first} != {told, page.locator(".pointed").inner_text()}
    page.get_by_role("button", name="Show step").click()
    assert "#velocities/3/" in page.url
    assert not page.url.endswith("/0")


def test_the_whole_sheet_stays_whole_when_a_telephone_is_turned(sheets_of):
    page = sheets_of(viewport={"width": 390, "height": 844})
    for wide, high in ((844, 390), (390, 844)):
        page.set_viewport_size({"width": wide, "height": high})
        where, (across, down) = seen(page), size(page)
        found = picture(page)
        assert found.shape[:2] == (down, across)
        assert where.zoom == pytest.approx(min((across - 16) / 841, (down - 16) / 594), rel=0.01)
        assert where.x + across / where.zoom / 2 == pytest.approx(420.5)


def test_paper_stays_white_in_the_dark(sheets_of):
    page = sheets_of(color_scheme="dark")
    found = picture(page)
    x, y = seen(page).spot(5, 300)
    assert tuple(found[round(y), round(x)]) == (255, 255, 255)
    dark = found[3, 3]
    assert dark.max() < 64
    page.evaluate("() => { document.documentElement.dataset.theme = 'light'; }")
    assert picture(page)[3, 3].min() > 192


def test_a_screen_is_measured_and_that_is_remembered_for_the_session_only(sheets_of):
    page = sheets_of()
    page.locator("summary", has_text="Size of the screen").click()
    line = page.locator(".check-line")
    assert line.bounding_box()["width"] == pytest.approx(100 * TRUE, abs=0.1)
    page.get_by_role("slider", name="A millimetre of this screen").fill("1.25")
    assert line.bounding_box()["width"] == pytest.approx(125 * TRUE, abs=0.1)
    at_true_size(page)
    assert seen(page).zoom == pytest.approx(1.25 * TRUE)
    page.reload()
    at_true_size(page)
    assert seen(page).zoom == pytest.approx(1.25 * TRUE)
    other = sheets_of()
    at_true_size(other)
    assert seen(other).zoom == pytest.approx(TRUE)
