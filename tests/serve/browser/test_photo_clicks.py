"""A photograph in the studio: dropped or chosen, clicked by mouse, keys, a finger; its report."""

from __future__ import annotations

import io
import re
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from support.own_sheets import Kind, Sheet, own_sheet
from support.studios import SIZES, Tab, expect, in_sight, serious

CASES = Path(__file__).parents[2] / "cases" / "check"
DULL = io.BytesIO()
Image.new("RGB", (1200, 900), (90, 90, 90)).save(DULL, "PNG")
ORIENTATION = 0x0112
DROP = """([data, name]) => {
  const file = new File([Uint8Array.from(data)], name);
  const moved = new DataTransfer();
  moved.items.add(file);
  document.querySelector(".photo").dispatchEvent(new DragEvent("drop", { dataTransfer: moved, bubbles: true }));
}"""


@pytest.fixture(scope="session")
def sheet() -> Sheet:
    """A photograph of a sheet of A4 with a plan of velocities and one of accelerations, Coriolis' left out."""
    return own_sheet(Kind("rpr", "k left out", "A4", wide=2800), 3)


@pytest.fixture
def lever(folder: Path, request: pytest.FixtureRequest) -> str:
    """Where the studio of a slotted lever is."""
    home = folder / re.sub(r"\W", "", request.node.name)[-40:]
    home.mkdir()
    shutil.copy(CASES / "rpr.toml", home / "scene.toml")
    return f"s/{home.name}/"


class Photo:
    """The photograph in a tab of the studio."""

    def __init__(self, tab: Tab, name: str, data: bytes) -> None:
        self.page: Any = tab.page
        self.page.get_by_role("tab", name="Check a photograph").click()
        self.side = self.page.locator(".photo-side")
        file = {"name": name, "mimeType": "image/*", "buffer": data}
        self.side.locator("input[type=file]").set_input_files(file)
        self.asks("Click the pole p: Velocity plan, position 0.")

    def asks(self, text: str) -> None:
        expect(self.page.locator(".prompt")).to_have_text(text)

    def place(self, at: complex) -> tuple[float, float]:
        """Return where on the screen a dot of the photograph is."""
        box = self.page.locator(".photo figure canvas").bounding_box()
        width = self.page.locator(".photo figure canvas").evaluate("one => one.width")
        many = box["width"] / width
        return box["x"] + (at.real + 0.5) * many, box["y"] + (at.imag + 0.5) * many

    def click(self, at: complex) -> None:
        self.page.mouse.click(*self.place(at))

    def plan(self, name: str) -> None:
        self.side.get_by_label("Plan and position").select_option(label=name)

    @property
    def rows(self) -> list[str]:
        return self.side.locator(".clicked span").all_inner_texts()  # type: ignore[no-any-return]

    @property
    def options(self) -> str:
        return str(self.side.locator("code").text_content())


def test_two_clicks_a_plan_and_the_report_of_the_command_is_there(
    sheet: Sheet, lever: str, tab_of: Callable[..., Tab]
) -> None:
    photo = Photo(tab_of(lever), "own.jpg", sheet.jpeg)
    photo.side.get_by_label("What is photographed").select_option("paper A4")
    for name, plan in (
        ("Velocity plan, 1", "velocities"),
        ("Acceleration plan, 1", "accelerations"),
    ):
        photo.plan(name)
        for at in sheet.plans[plan, "1"]:
            photo.click(at)
    assert photo.rows == ["Velocity plan, 1: p, a", "Acceleration plan, 1: π, a"]
    clicked = re.search(r"velocities:1=([\d.]+),([\d.]+),", photo.options)
    assert clicked is not None
    assert abs(complex(*map(float, clicked.groups())) - sheet.plans["velocities", "1"][0]) < 5.0
    photo.side.get_by_role("button", name="Check it").click()
    report = photo.page.frame_locator(".photo iframe")
    expect(report.get_by_role("heading", level=1)).to_have_text("Check: Slotted lever")
    says = photo.side.locator(".summary").inner_text()
    expect(report.locator(".summary")).to_have_text(says)
    assert serious(photo.page) == []
    photo.side.get_by_role("button", name="Photograph", exact=True).click()
    expect(photo.page.locator(".mark.seen.wrong b").first).to_be_visible()
    # what is clicked afterwards is another drawing: the report is of before
    photo.plan("Velocity plan, 2")
    photo.click(300 + 900j)
    expect(photo.side.get_by_text("Something was clicked since")).to_be_visible()
    expect(photo.page.locator(".mark.seen")).to_have_count(0)


def test_plans_are_looked_for_and_wait_to_be_confirmed(
    sheet: Sheet, lever: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(lever)
    photo = Photo(tab, "own.jpg", sheet.jpeg)
    photo.side.get_by_label("What is photographed").select_option("paper A4")
    look = photo.side.get_by_role("button", name="Look for the plans")
    look.click()
    tab.told("See in the photograph whether each stands right")
    assert "Velocity plan, 1: p, a" in photo.rows
    assert photo.page.locator(".photo iframe").count() == 0
    photo.side.get_by_role("button", name="Remove: Velocity plan, 1").click()
    # what is clicked stays as it was clicked
    photo.plan("Velocity plan, 1")
    photo.click(sheet.plans["velocities", "1"][0])
    look.click()
    tab.told("See in the photograph whether each stands right")
    assert "Velocity plan, 1: p" in photo.rows


def test_what_is_said_of_plans_outlasts_the_drawing_of_the_scene(
    sheet: Sheet, lever: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(lever)
    photo = Photo(tab, "own.jpg", sheet.jpeg)
    # plans that are found at once, whatever the machine: the scene's page is drawn a while longer
    tab.page.route("**/proposals?*", lambda route: route.fulfill(json={"plans": []}))
    photo.side.get_by_role("button", name="Look for the plans").click()
    tab.told("Plans found: 0")
    tab.page.locator("body:not(.busy)").wait_for()
    expect(tab.page.locator("#told")).to_contain_text("Plans found: 0")


def test_marks_are_set_moved_taken_back_and_removed(lever: str, tab_of: Callable[..., Tab]) -> None:
    photo = Photo(tab_of(lever), "dull.png", DULL.getvalue())
    check = photo.side.get_by_role("button", name="Check it")
    expect(check).to_be_disabled()
    keys = photo.page.keyboard
    expect(photo.page.locator(".photo .desk")).to_be_focused()
    keys.press("Enter")
    photo.asks("Click a, the end of its first vector: Velocity plan, position 0.")
    before = photo.options
    keys.press("ArrowRight")
    assert photo.options != before
    keys.press("ArrowLeft")
    assert photo.options == before
    photo.click(700 + 300j)
    # the second plan of a kind has its scale factor from the first
    photo.asks("Click the pole p: Velocity plan, position 1.")
    keys.press("Enter")
    photo.asks("Click the pole p: Velocity plan, position 2.")
    assert photo.rows == ["Velocity plan, 0: p, a", "Velocity plan, 1: p"]
    photo.side.get_by_role("button", name="Click a, too").click()
    photo.asks("Click a, the end of its first vector: Velocity plan, position 1.")
    photo.click(200 + 300j)
    assert photo.rows == ["Velocity plan, 0: p, a", "Velocity plan, 1: p, a"]
    keys.press("Backspace")
    photo.asks("Click a, the end of its first vector: Velocity plan, position 1.")
    photo.side.get_by_role("button", name="Take back").click()
    photo.asks("Click the pole p: Velocity plan, position 1.")
    assert photo.rows == ["Velocity plan, 0: p, a"]
    # a drag moves the photograph, and sets no mark
    x, y = photo.place(500 + 500j)
    photo.page.mouse.move(x, y)
    photo.page.mouse.down()
    photo.page.mouse.move(x + 40, y + 40)
    photo.page.mouse.up()
    assert photo.page.locator(".mark").count() == 2
    photo.side.get_by_role("button", name="Remove: Velocity plan, 0").click()
    assert photo.rows == []
    expect(check).to_be_disabled()


def test_what_is_not_found_is_told_and_corners_can_be_clicked(
    lever: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(lever)
    tab.allow("status of 422")
    photo = Photo(tab, "dull.png", DULL.getvalue())
    photo.side.get_by_label("What is photographed").select_option("paper A4")
    photo.click(500 + 300j)
    photo.click(700 + 300j)
    photo.side.get_by_role("button", name="Check it").click()
    expect(photo.side.get_by_text("give its corners with --corners")).to_be_visible()
    photo.side.get_by_role("button", name="Click the corners").click()
    for n, at in enumerate((20 + 870j, 1170 + 870j, 1170 + 30j, 20 + 30j)):
        photo.asks(f"Click corner {n + 1} of 4 of the paper.")
        photo.click(at)
    photo.asks("Click the pole p: Velocity plan, position 1.")
    assert "Corners: 4 of 4" in photo.rows
    corners = re.search(r'--corners "(.*?)"', photo.options)
    assert corners is not None
    assert len(corners[1].split()) == 4


def test_a_photograph_is_dropped_and_what_is_none_is_told(
    lever: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(lever)
    page = tab.page
    page.get_by_role("tab", name="Check a photograph").click()
    page.evaluate(DROP, [list(b"no picture"), "words.txt"])
    tab.told("words.txt is no picture that a browser shows: save it as JPEG or PNG.")
    page.evaluate(DROP, [list(DULL.getvalue()), "dull.png"])
    expect(page.locator(".photo figure canvas")).to_be_visible()
    expect(page.get_by_text("no picture that a browser shows")).to_have_count(0)


def turned_and_large() -> bytes:
    """A photograph that is shown smaller and that a camera has turned by a quarter: upright 3500 × 5000."""
    made, exif = io.BytesIO(), Image.Exif()
    exif[ORIENTATION] = 6
    Image.new("RGB", (5000, 3500), (90, 90, 90)).save(made, "JPEG", exif=exif)
    return made.getvalue()


def test_dots_are_those_of_the_photograph_as_a_camera_turned_it(
    lever: str, tab_of: Callable[..., Tab]
) -> None:
    photo = Photo(tab_of(lever), "large.jpg", turned_and_large())
    box = photo.page.locator(".photo figure canvas").bounding_box()
    photo.page.mouse.click(box["x"] + box["width"] / 4, box["y"] + 3 * box["height"] / 4)
    clicked = re.search(r"velocities:0=([\d.]+),([\d.]+)", photo.options)
    assert clicked is not None
    dot = 5000 / box["height"]
    assert abs(complex(*map(float, clicked.groups())) - (875 + 3750j)) < 1.5 * dot


def test_a_wrong_scene_is_told_and_clicks_outlast_it(
    lever: str, folder: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(lever)
    tab.allow("status of 422")
    photo = Photo(tab, "dull.png", DULL.getvalue())
    photo.click(500 + 300j)
    file = folder / lever.split("/")[1] / "scene.toml"
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("[drive]", "[drives]"), encoding="utf-8")
    expect(photo.side.locator(".wrong span").first).to_contain_text("drive")
    file.write_text(text.replace("[drive]", "# mended\n[drive]"), encoding="utf-8")
    expect(photo.side.locator(".wrong span")).to_have_count(0)
    assert photo.rows == ["Velocity plan, 0: p"]
    photo.side.get_by_label("What is photographed").select_option("sheet 1")
    photo.side.get_by_role("button", name="Remove: Velocity plan, 0").click()
    photo.asks(
        "Nothing has to be clicked on this sheet: check it. A plan that stands elsewhere is clicked."
    )
    expect(photo.side.get_by_role("button", name="Check it")).to_be_enabled()


@pytest.mark.parametrize(
    ("size", "scheme"), [("phone", "dark"), ("turned", "light"), ("desk", "light")]
)
def test_it_fits_and_a_finger_does(
    size: str, scheme: str, lever: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(lever, viewport=SIZES[size], color_scheme=scheme, has_touch=True)
    photo = Photo(tab, "dull.png", DULL.getvalue())
    photo.page.touchscreen.tap(*photo.place(900 + 400j))
    photo.asks("Click a, the end of its first vector: Velocity plan, position 0.")
    assert serious(photo.page) == []
    assert in_sight(photo.page) == []
    # what is about the mark is seen in the loupe; a press there moves the mark
    before = photo.options
    photo.page.locator(".own-loupe canvas").tap(position={"x": 100, "y": 50})
    assert photo.options != before
    assert photo.page.locator(".mark").count() == 1
