"""A student draws a plan on the page: by keys alone, by pointer, with help; what he did is kept and saved."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from support import gallery, pages
from support.axe import serious
from support.looks import PHONE

from graphic_tmm.checking.cells import cells, points
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.page.page import page as written

SCENE, PLAN, POSITION = "crank-rocker", "velocities", "2"
ADDRESS = f"#practice:{PLAN}/all/{POSITION}"


class Student:
    """Someone who draws on the page, and knows the plan from Python."""

    def __init__(self, page: Any) -> None:
        self.page, self.room = page, page.locator("#practice")
        made = gallery.exact(SCENE)
        self.mm = {
            key[1]: one.mm for key, one in cells(made).items() if key[::2] == (PLAN, POSITION)
        }
        self.spots = {key[1]: z for key, z in points(made).items() if key[::2] == (PLAN, POSITION)}

    def told(self) -> str:
        """What is asked for, and how the last was judged."""
        found = [self.room.locator(part).inner_text() for part in (".prompt", ".judged", ".hinted")]
        return " | ".join(" ".join(text.split()) for text in found)

    def score(self) -> str:
        return self.room.locator(".score").inner_text()

    def keys(self, *keys: str) -> None:
        for key in keys:
            self.page.keyboard.press(key)

    def reach(self, letter: str) -> None:
        """Go to a mark of the list by arrows, and pick it by Enter."""
        for _ in range(30):
            if self.focused().split(" = ")[0] == letter:
                return self.keys("Enter")
            self.keys("ArrowRight")
        raise AssertionError(letter)

    def focused(self) -> str:
        return str(self.page.evaluate("() => document.activeElement.textContent"))

    def lay(self, key: str, *letters: str, whole: bool = False) -> None:
        """Take an instrument by its key, lay it to marks of the list."""
        self.keys(key)
        for letter in letters:
            self.reach(letter)
        if whole:
            self.keys("Enter")

    def write(self, text: str) -> None:
        """Write a figure where the keyboard is."""
        self.page.keyboard.insert_text(text)
        self.keys("Enter")

    def mark(self, x: float, y: float) -> None:
        """Mark a point by its coordinates."""
        for axis, value in (("x", x), ("y", y)):
            self.room.get_by_label(axis, exact=True).fill(f"{value:.2f}")
        self.keys("Enter")

    def screen(self, x: float, y: float) -> tuple[float, float]:
        """Where a place of the board is on the screen."""
        at = self.room.locator("svg.sketch").evaluate(
            "(svg, [x, y]) => { const to = new DOMPoint(x, -y).matrixTransform(svg.getScreenCTM());"
            " return [to.x, to.y]; }",
            [x, y],
        )
        return at[0], at[1]


@pytest.fixture(scope="session")
def practised(tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("practised") / "page.html"
    text = written(*pages.on_sheets(SCENE, "en"), practised=True)
    file.write_text(text, encoding="utf-8")
    return file


@pytest.fixture
def student(opened: Callable[..., Any], practised: Path) -> Callable[..., Student]:
    def begin(address: str = ADDRESS, before: str = "", **options: Any) -> Student:
        page = opened(practised, address, **options).page
        if before:
            page.add_init_script(before)
            page.reload()
        page.locator("html.ready").wait_for()
        return Student(page)

    return begin


def first_steps(student: Student) -> None:
    """The velocity of the crank's pin, its length on the plan, its line: by keys alone."""
    student.lay("0", "ω1", "lOA", whole=True)
    student.write(f"{student.mm['pa'] * MU:.5g}")
    student.lay("0", "vA", whole=True)
    student.write(f"{student.mm['pa']:.2f}")
    student.lay("3", "p", "(OA)")


MU = 0.0
"""The scale factor of the plan, set where the scene is drawn."""


@pytest.fixture(scope="module", autouse=True)
def _scale() -> None:
    global MU
    scale = gallery.exact(SCENE).mechanism.scales[PLAN]
    MU = scale.value


def test_a_plan_is_begun_by_keys_alone(student: Callable[..., Student]) -> None:
    """What is wrong is refused and may be told again; steps that are right count."""
    own = student()
    assert own.score().startswith("0 of ")
    own.lay("0", "ω1", "lOA", whole=True)
    given = own.room.locator(".data").inner_text()
    assert "ω1 = " in given
    assert "lOA = " in given
    due = own.mm["pa"] * MU
    own.write(f"{10 * due:.5g}")
    assert "Wrong." in own.told()
    assert "10 times too large." in own.told()
    own.page.locator("#practice-figure").fill("")
    own.page.locator("#practice-figure").focus()
    own.write(f"{due:.5g}")
    assert "Right." in own.told()
    own.lay("2", "p", "(OA)")
    assert "another instrument" in own.told()
    own.lay("0", "vA", whole=True)
    own.write(f"{own.mm['pa']:.2f}")
    own.lay("3", "p", "(OA)")
    assert "(pa) is drawn" in own.told()
    own.lay("6", "(pa)", "pa")
    assert own.room.locator(".pencil .ruler").count() == 1
    a = own.spots["a"]
    own.keys("Shift+ArrowRight", "ArrowLeft", "ArrowUp")
    assert [own.room.get_by_label(axis, exact=True).input_value() for axis in "xy"] == [
        "4.90",
        "0.10",
    ]
    own.mark(-a.real, -a.imag)
    assert re.search("Wrong|Missed", own.told())
    own.mark(a.real, a.imag)
    assert "Right." in own.told()
    assert own.score().startswith("4 of ")
    assert re.search(r"1 at once, 3 with help or again, 0 shown", own.score())
    live = own.page.locator("#live").inner_text()
    assert "Right." in live


def test_a_point_is_marked_by_the_pointer_with_the_loupe(student: Callable[..., Student]) -> None:
    """Picked on the board and on the mechanism; the loupe finds what the pointer cannot."""
    own = student()
    first_steps(own)
    own.keys("6")
    a = own.spots["a"]
    aside = a / 2 + 10j * a / abs(a)
    own.page.mouse.click(*own.screen(aside.real, aside.imag))
    assert "Nothing here" in own.told()
    own.page.mouse.click(*own.screen(a.real / 2, a.imag / 2))
    own.room.locator(".listing").get_by_role("button", name="pa =").click()
    assert "Mark a within 1 mm" in own.told()
    assert own.room.locator(".data").inner_text().strip().startswith("pa = ")
    loupe = own.room.locator("svg.loupe")
    assert not loupe.is_visible()
    own.page.mouse.click(*own.screen(a.real + 0.7, a.imag))
    assert loupe.is_visible()
    box = loupe.bounding_box()
    middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
    shown = own.room.get_by_label("x", exact=True)
    before = float(shown.input_value())
    own.page.mouse.move(*middle)
    own.page.mouse.down()
    own.page.mouse.move(middle[0] + 20, middle[1])
    own.page.mouse.up()
    moved = float(shown.input_value()) - before
    there, off = own.screen(0, 0), own.screen(10, 0)
    assert moved == pytest.approx(-20 / 4 * 10 / (off[0] - there[0]), abs=0.03)
    own.page.mouse.click(*own.screen(a.real, a.imag))
    own.room.get_by_role("button", name="Mark it").click()
    assert "Right." in own.told()
    head = own.room.locator(".pencil .head.now")
    assert head.count() == 1


def test_of_several_in_one_place_the_student_says_which(student: Callable[..., Student]) -> None:
    """In the extreme position crank and coupler lie on one line."""
    own = student(address=f"#practice:{PLAN}/all/0")
    own.keys("3")
    links = own.room.locator(".beside .segment")
    boxes = [links.nth(k).bounding_box() for k in range(links.count())]
    crank = min(boxes, key=lambda box: box["width"])
    own.page.mouse.click(crank["x"] + crank["width"] / 2, crank["y"] + crank["height"] / 2)
    asked = own.room.get_by_role("group", name="Which one?")
    assert asked.get_by_role("button").all_inner_texts() == ["(OA)", "(AB)"]
    asked.get_by_role("button", name="(AB)").click()
    assert not asked.is_visible()
    picked = own.room.locator(".listing [aria-pressed=true]")
    assert picked.all_inner_texts() == ["(AB)"]


def test_help_goes_from_why_to_what_to_the_step_itself(student: Callable[..., Student]) -> None:
    own = student()
    own.keys("h")
    assert "angular velocity" in own.told()
    own.keys("h")
    assert "Calculate vA" in own.told()
    assert "Instrument: Calculate." in own.told()
    assert own.score().startswith("0 of ")
    own.keys("h")
    assert re.match(r"1 of \d+ steps: 0 at once, 0 with help or again, 1 shown", own.score())
    assert own.told().startswith("Next step")
    assert "Calculate vA" in own.room.locator(".judged").inner_text()


def test_what_is_done_is_kept_and_saved(student: Callable[..., Student], tmp_path: Path) -> None:
    own = student()
    first_steps(own)
    own.lay("6", "(pa)", "pa")
    own.mark(own.spots["a"].real, own.spots["a"].imag)
    before = own.score()
    own.page.reload()
    own.page.locator("html.ready").wait_for()
    assert own.score() == before
    saved = {}
    for name in ("Record, JSON", "Readings, CSV"):
        with own.page.expect_download() as found:
            own.room.get_by_role("button", name=name).click()
        saved[name] = tmp_path / found.value.suggested_filename
        found.value.save_as(saved[name])
    record = json.loads(saved["Record, JSON"].read_text("utf-8"))
    assert record["score"]["once"] == 4
    assert [one["tries"][0]["verdict"] for one in record["steps"] if one["tries"]] == ["fine"] * 3
    rows = read_readings(saved["Readings, CSV"])
    assert {(one.plan, one.segment, one.position) for one in rows} == {
        (PLAN, "pa", POSITION),
        (PLAN, "a", POSITION),
    }
    own.room.get_by_role("button", name="Begin anew").click()
    assert own.score() == before
    own.room.get_by_role("button", name="Wipe all that is done?").click()
    assert own.score().startswith("0 of ")


REFUSED = (
    "Object.defineProperty(window, 'localStorage', { get() { throw new DOMException('no'); } })"
)


def test_where_nothing_may_be_kept_the_page_goes_on(student: Callable[..., Student]) -> None:
    own = student(before=REFUSED)
    first_steps(own)
    own.room.locator("select").first.select_option(index=0)
    assert own.score().startswith("0 of ")
    own.page.go_back()
    assert own.score().startswith("3 of ")


def test_the_mechanism_has_its_symbols_in_every_position(student: Callable[..., Student]) -> None:
    """Supports, and the sense of the crank about its pivot, though the sheet has it in one position."""
    turned = set()
    for at in ("1", "2"):
        own = student(address=f"#practice:{PLAN}/all/{at}")
        symbols = own.room.locator(".beside .kinematic")
        assert symbols.locator("[data-part=pivot]").count() >= 2
        arrow = symbols.locator("[data-part=turning]")
        assert arrow.count() == 2
        turned.add(arrow.first.get_attribute("transform"))
        frame, ink = own.room.locator(".beside").bounding_box(), symbols.bounding_box()
        assert frame["y"] <= ink["y"]
        assert ink["y"] + ink["height"] <= frame["y"] + frame["height"]
        pivot = own.room.locator(".beside .dot.bare").first.bounding_box()
        under = symbols.locator("[data-part=pivot]").last.bounding_box()
        assert abs(pivot["y"] - under["y"]) < under["height"] + 20
    assert len(turned) == 2


WIDE = "() => document.documentElement.scrollWidth - document.documentElement.clientWidth"
SMALL = """() => ["button", "select", "input", "summary"]
  .flatMap((name) => [...document.querySelectorAll(`#practice ${name}`)]).filter((one) => one.checkVisibility())
  .map((one) => [one.textContent, one.getBoundingClientRect()])
  .filter(([, { width, height }]) => width < 43.5 || height < 43.5).map(([name]) => name)"""


@pytest.mark.parametrize(
    "look", [{}, {"color_scheme": "dark"}, PHONE], ids=["desk", "dark", "phone"]
)
def test_every_state_is_for_everybody(
    student: Callable[..., Student], look: dict[str, Any]
) -> None:
    own = student(**look)
    states = [
        lambda: None,
        lambda: own.keys("3"),
        lambda: (own.keys("Escape"), first_steps(own), own.lay("6", "(pa)", "pa")),
        lambda: (own.mark(1.0, 1.0), own.keys("Escape", "h", "h")),
        lambda: own.room.locator("summary").click(),
    ]
    for k, state in enumerate(states):
        state()
        assert (k, own.page.evaluate(WIDE)) == (k, 0)
        assert (k, own.page.evaluate(SMALL)) == (k, [])
        assert (k, serious(own.page, "#practice")) == (k, [])


def test_a_plan_is_drawn_with_lengths_of_ones_own(student: Callable[..., Student]) -> None:
    """What the crank's pin does follows its length: what is right of the sheet is wrong of 24 mm for 20."""
    own = student("#crank:")
    page, goal = own.page, own.room.locator(".goal")
    page.locator(".lengths > summary").click()
    length = page.get_by_role("textbox", name="l_OA, value")
    length.fill("24")
    length.press("Enter")
    page.evaluate("(to) => { location.hash = to; }", ADDRESS)
    goal.filter(has_text="With lengths of your own: lOA = 24 mm.").wait_for()
    own.lay("0", "ω1", "lOA", whole=True)
    due = own.mm["pa"] * MU
    own.write(f"{due:.5g}")
    assert "Wrong." in own.told()
    page.locator("#practice-figure").fill("")
    page.locator("#practice-figure").focus()
    own.write(f"{1.2 * due:.5g}")
    assert "Right." in own.told()
    assert own.score().startswith("1 of ")
    page.get_by_role("tab", name="Crank").click()
    page.get_by_role("button", name="As given").click()
    page.get_by_role("tab", name="Practice").click()
    goal.filter(has_not_text="of your own").wait_for()
    assert own.score().startswith("0 of ")
