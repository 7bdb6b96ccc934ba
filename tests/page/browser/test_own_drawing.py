"""A person's own sheet, photographed by a camera of known place, read in a browser by keys and by pointer."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image
from support import gallery, pages, photographs
from support.axe import serious
from support.browser import FRAMES, Opened
from support.photographs import PAPER, Camera

from graphic_tmm.checking.cells import points
from graphic_tmm.page.page import page as written
from graphic_tmm.paper.sheet_frame import drawing_area

NAME, PLAN, POSITION = "crank-rocker", "positions", "0"
SIZE = 210.0, 297.0
CAMERA = Camera((6, -5, 3), 560, 2950, 1500, 2000, lens=0.002, middle=(105.0, 148.5))
SAME = 0.2
"""What a point may be off, mm: a dot of the loupe is 0.03 mm here, a click goes to a whole one."""


@cache
def page_text() -> str:
    return written(*pages.on_sheets(NAME, "en"), practised=True)


@pytest.fixture(scope="session")
def practised_page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("own") / "page.html"
    file.write_text(page_text(), encoding="utf-8")
    return file


@cache
def frame() -> np.ndarray:
    left, bottom, right, top = drawing_area("A4", "en", True).inner
    return np.array([left + 1j * bottom, right + 1j * bottom, right + 1j * top, left + 1j * top])


@cache
def taken() -> bytes:
    """The photograph of an A4 sheet with nothing but its frame: where points are the camera tells."""
    dots = photographs.DOTS
    drawn = np.full((int(SIZE[1] * dots), int(SIZE[0] * dots)), PAPER, dtype=np.float32)
    photographs.box(drawn, *frame()[0:1].view(float), *frame()[2:3].view(float), 0.7)
    return photographs.jpeg(photographs.photograph(CAMERA, drawn))


@cache
def spots() -> dict[str, complex]:
    """Where the points of the plan are from its pole, mm."""
    made = gallery.exact(NAME)
    found = points(made)
    return {key[1]: spot for key, spot in found.items() if (key[0], key[2]) == (PLAN, POSITION)}


class Hands:
    """Whoever draws: a sheet lies on the desk of the page."""

    def __init__(self, page: Any) -> None:
        self.page = page
        self.desk = page.locator("#own .desk")
        self.told = page.locator("#own .own-told")

    def put(self, content: bytes, name: str = "photo.jpg") -> None:
        file = {"name": name, "mimeType": "", "buffer": content}
        self.page.locator("#own input[type=file]").set_input_files(files=[file])

    def click(self, at: complex) -> None:
        """Click a place of what lies on the desk, in its own units."""
        self.page.evaluate(FRAMES)
        box = self.desk.bounding_box()
        x, y, zoom = map(float, self.desk.get_attribute("data-seen").split())
        rim = self.desk.evaluate("(one) => [one.clientLeft, one.clientTop]")
        self.page.mouse.click(
            box["x"] + rim[0] + (at.real - x) * zoom, box["y"] + rim[1] + (at.imag - y) * zoom
        )

    def corners(self) -> None:
        self.told.get_by_text("Corner 1 of 4").wait_for()
        for at in CAMERA.seen(frame()) + 6 - 5j:
            self.click(complex(at) + 0.5 + 0.5j)
        self.page.wait_for_selector("#own.laid")

    def take(self, spot: complex) -> None:
        """Click a point of the sheet, mm, y upward; move the cross onto it by clicks in the loupe; take it."""
        self.click(complex(spot.real, SIZE[1] - spot.imag))
        self.centre(complex(CAMERA.seen(np.array([spot]))[0]))

    def centre(self, due: complex) -> None:
        """Click a place of the photograph in the loupe, until it is in its middle; take it."""
        loupe = self.page.locator("#own .own-loupe canvas")
        loupe.wait_for()
        for _ in range(2):
            across, down = self.aside(due)
            box = loupe.bounding_box()
            self.page.mouse.click(
                box["x"] + box["width"] / 2 + across, box["y"] + box["height"] / 2 + down
            )
        self.page.locator("#own .own-take").click()
        loupe.wait_for(state="hidden")

    def aside(self, due: complex) -> tuple[float, float]:
        """How far a place of the photograph is from the middle of the loupe, dots of it."""
        told = self.page.locator("#own .own-loupe").get_attribute("data-at") or ""
        x, y, ax, ay, bx, by = map(float, told.split())
        off = due - complex(x, y)
        whole = ax * by - ay * bx
        return (off.real * by - off.imag * bx) / whole, (ax * off.imag - ay * off.real) / whole


@pytest.fixture
def hands(opened: Callable[..., Opened], practised_page: Path) -> Callable[..., Hands]:
    def begin(**options: Any) -> Hands:
        tab = opened(practised_page, "#own", **options)
        tab.page.get_by_role("tab").first.wait_for()
        return Hands(tab.page)

    return begin


def saved(found: Hands) -> list[dict[str, str]]:
    with found.page.expect_download() as kept:
        found.page.get_by_role("button", name="Save the readings").click()
    return list(csv.DictReader(io.StringIO(Path(kept.value.path()).read_text("utf-8"))))


def test_a_sheet_is_read_point_by_point(hands: Callable[..., Hands]) -> None:
    found = hands()
    found.put(taken())
    found.corners()
    assert "straight within 0.1 mm" in found.told.text_content()
    origin, slipped = 70 + 170j, 6.0 - 4.0j
    found.take(origin)
    due = dict(spots())
    due["B"] += slipped
    for name in due:
        assert f"Tap {name};" in found.told.text_content()
        found.take(origin + due[name])
    assert "All points of this plan are read." in found.told.text_content()
    rows = saved(found)
    assert [(row["plan"], row["position"], row["segment"]) for row in rows] == [
        (PLAN, POSITION, name) for name in due
    ]
    for row in rows:
        off = complex(float(row["x"]), float(row["y"])) - due[row["segment"]]
        assert abs(off) < SAME, row
    listed = found.page.locator("#own .own-points button").all_text_contents()
    assert len(listed) == len(due) + 1
    verdicts = dict(zip(due, listed[1:], strict=True))
    assert verdicts["A"].endswith("fine")
    assert verdicts["B"].endswith("wrong")
    # what follows from B is right as it stands: only the step that slipped is told
    assert sum(one.endswith("wrong") for one in verdicts.values()) <= 2


def test_keys_alone_read_a_point(hands: Callable[..., Hands]) -> None:
    found = hands()
    found.put(taken())
    found.corners()
    page = found.page
    page.keyboard.press("ArrowRight")
    before = page.locator("#own .own-loupe").get_attribute("data-at")
    for _ in range(4):
        page.keyboard.press("ArrowRight")
        page.wait_for_timeout(200)
    after = page.locator("#own .own-loupe").get_attribute("data-at")
    moved = [float(a) - float(b) for a, b in zip(after.split(), before.split(), strict=True)]
    assert 0.8 < np.hypot(*moved[:2]) < 1.2  # four dots of the loupe are one of the photograph
    page.keyboard.press("Enter")
    assert "Tap C;" in found.told.text_content()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("Enter")
    assert "C (−0.2; 0.0) mm: wrong, off by" in found.told.text_content()
    assert found.page.locator("#live").text_content() == found.told.text_content()


def test_what_cannot_be_read_is_told_by_name(hands: Callable[..., Hands]) -> None:
    found = hands()
    for content, words in (
        (b"%PDF-1.7\n", "This is a PDF"),
        (b"\0\0\0\x18ftypheic\0\0\0\0mif1heic", "HEIC photograph"),
        (b"II*\0\x08\0\0\0", "This is a TIFF"),
        (b"plan;position", "no photograph that can be read"),
        (b"", "no photograph that can be read"),
        (taken()[:300], "damaged"),
    ):
        found.put(content)
        found.told.get_by_text(words).wait_for()
    for kind in ("PNG", "WEBP"):
        made = io.BytesIO()
        Image.new("RGB", (640, 480), "white").save(made, kind)
        found.put(made.getvalue())
        found.told.get_by_text("Corner 1 of 4").wait_for()


def test_a_photograph_stands_as_its_camera_says(hands: Callable[..., Hands]) -> None:
    said = Image.Exif()
    said[0x0112] = 6
    turned = Image.open(io.BytesIO(taken())).transpose(Image.Transpose.ROTATE_90)
    made = io.BytesIO()
    turned.save(made, "JPEG", quality=80, exif=said)
    found = hands()
    found.put(made.getvalue())
    found.corners()
    assert "straight within 0.1 mm" in found.told.text_content()


def test_corners_that_make_no_rectangle_are_asked_for_again(hands: Callable[..., Hands]) -> None:
    found = hands()
    found.put(taken())
    found.told.get_by_text("Corner 1 of 4").wait_for()
    for at in (100 + 100j, 900 + 900j, 500 + 501j, 300 + 300j):
        found.click(at)
    found.told.get_by_text("make no quadrilateral").wait_for()
    found.corners()


def test_the_corners_of_a_paper_are_taken_by_the_loupe(hands: Callable[..., Hands]) -> None:
    found = hands()
    found.put(taken())
    found.told.get_by_text("Corner 1 of 4").wait_for()
    found.page.locator("#own .corner-choice select").select_option(label="the paper A4")
    ends = CAMERA.seen(np.array([0, SIZE[0], SIZE[0] + 1j * SIZE[1], 1j * SIZE[1]]))
    for n, at in enumerate(map(complex, ends)):
        found.told.get_by_text(f"Corner {n + 1} of 4: tap it, draw").wait_for()
        found.click(at + 0.5 + 0.5j)
        found.centre(at)
    found.page.wait_for_selector("#own.laid")
    assert "The photograph lies flat." in found.told.text_content()
    found.take(70 + 170j)
    found.take(70 + 170j + spots()["C"])
    (row,) = saved(found)
    # the lens is not found without lines: 0.2 % of 100 mm at the most
    assert abs(complex(float(row["x"]), float(row["y"])) - spots()["C"]) < 2 * SAME


@pytest.mark.parametrize("size", [{"width": 390, "height": 844}, {"width": 844, "height": 390}])
def test_a_phone_has_room_for_it(hands: Callable[..., Hands], size: dict[str, int]) -> None:
    found = hands(viewport=size, color_scheme="dark")
    found.put(taken())
    found.corners()
    found.take(70 + 170j)
    for one in found.page.locator("#own button:visible, #own select:visible").all():
        box = one.bounding_box()
        assert box["x"] >= 0
        assert box["x"] + box["width"] <= size["width"]
        assert box["height"] >= 24
    told, panel = found.told.bounding_box(), found.page.locator("#own .panel").bounding_box()
    assert told["height"] >= found.told.evaluate("(one) => one.scrollHeight")
    assert panel["y"] >= told["y"] + told["height"] or panel["x"] >= told["x"] + told["width"]
    assert serious(found.page) == []
