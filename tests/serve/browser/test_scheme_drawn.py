"""Mechanisms drawn by mouse, by keys and by fingers, in few acts, then on sheets without touching a file."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from support import scheme_hand
from support.scheme_hand import SchemeHand, begun
from support.served import SMALL
from support.studios import SIZES, Tab, expect, in_sight, serious, serving

import graphic_tmm

MOST = 15
"""Acts by mouse that a mechanism of two groups may take."""
DRAWN = (
    scheme_hand.shaper,
    scheme_hand.crank_rocker,
    scheme_hand.swinging_cylinder,
    scheme_hand.v_engine,
)


@pytest.fixture(scope="module")
def empty(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("empty")


@pytest.fixture(scope="module")
def gallery(empty: Path) -> Iterator[str]:
    with serving(empty) as found:
        yield found


@pytest.mark.parametrize("drawn", DRAWN, ids=lambda one: one.__name__)
def test_a_mechanism_is_drawn_in_few_acts(
    drawn: Callable[[SchemeHand], None], gallery: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    drawn(hand)
    assert hand.acts <= MOST
    assert serious(tab.page) == []
    assert in_sight(tab.page) == []


def test_an_empty_folder_begins_with_a_scheme_and_ends_with_sheets(
    tmp_path: Path, tab_of: Callable[..., Tab]
) -> None:
    with serving(tmp_path) as address:
        tab = tab_of("", gallery=address)
        hand = SchemeHand(tab)
        scheme_hand.shaper(hand)
        hand.length("OA", "110 mm")
        assert hand.lengths()["BD"].endswith(" mm")
        tab.page.locator(".scheme-save input").fill("Slotting machine: №1/../x")
        tab.page.locator(".scheme-save button").click()
        tab.page.wait_for_url("**/s/slotting-machine-1-x/#scheme")
        hand.whole("I(1) → II(2-3) → II(4-5)")
        unit = "(one) => getComputedStyle(one, '::after').content"
        label = tab.page.get_by_text("link 1: its angular speed", exact=True)
        assert "rad/s" in label.evaluate(unit)
        hand.length("link 1: its angular speed", "60", shows="60 rad/s")
        assert "rad/s" not in label.evaluate(unit)
        hand.length("link 1: its angular speed", "60 rpm")
        tab.page.get_by_role("tab", name="Sheets").click()
        tab.shown()
        tab.page.get_by_role("tab", name="Plans step by step").click()
        tab.page.locator("iframe:not(.coming)").wait_for()
        with tab.page.expect_download() as told:
            tab.page.get_by_role("tab", name="Sheets").click()
            tab.page.get_by_text("Explanatory note (DOCX)").click()
        assert Path(told.value.path()).read_bytes()[:2] == b"PK"
        (folder,) = tmp_path.iterdir()
        scene = graphic_tmm.read(folder)
        assert scene.title == "Slotting machine: №1/../x"
        assert abs(scene.mechanism.links[0].points["A"]) == 0.11
        tab.page.goto("about:blank")


def test_a_scheme_is_drawn_by_keys_alone(gallery: str, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    page = tab.page
    page.locator(".scheme-paper").focus()

    def keys(*row: str) -> None:
        for key in row:
            page.keyboard.press(key)

    def tool(name: str) -> None:
        button = page.locator(f"[data-tool={name}]")
        button.focus()
        button.press("Enter")

    left, right, up, down = (f"Shift+Arrow{way}" for way in ("Left", "Right", "Up", "Down"))
    keys(left, left, left, left, "Enter", left, down, "Enter")
    tool("support")
    keys("Enter", "Enter", right, up, "Enter", *[right] * 4, down, "Enter", "c")
    hand.says("W = 2")
    letters = page.locator(".scheme-paper text.letter")
    before = letters.all_text_contents()
    keys("a")
    hand.says("W = 2")
    exchanged = {"A": "C", "C": "A"}
    expect(letters).to_have_text([exchanged.get(one, one) for one in before])
    keys("c")
    expect(letters).to_have_text(before)
    assert letters.filter(has_text="C").count() == 1
    tool("slider")
    keys("Enter", right, "Enter")
    hand.says("say which link is driven")
    tool("drive")
    keys(*[left] * 6, "Enter", "Enter")
    hand.whole("I(1) → II(2-3)")
    assert hand.lengths().keys() >= {"OA", "AC"}


def test_what_was_done_is_taken_back_and_done_again(
    gallery: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    scheme_hand.crank_rocker(hand)
    before = hand.lengths()
    hand.length("OA", "40 mm")
    tab.told("The drawing was scaled to OA = 40 mm: other lengths went with it.")
    larger = hand.lengths()
    assert float(larger["AB"].split()[0]) < float(before["AB"].split()[0])
    tab.page.locator("[data-tool=undo]").click()
    expect(tab.page.locator(".lengths input").first).to_have_value(before["OA"])
    assert hand.lengths() == before
    tab.page.locator("[data-tool=redo]").click()
    expect(tab.page.locator(".lengths input").first).to_have_value("40 mm")
    assert hand.lengths() == larger
    for _ in range(2):
        tab.page.locator("[data-tool=undo]").click()
        tab.page.wait_for_timeout(300)
    hand.says("say which link is driven")


def test_a_picture_lies_under_the_scheme_and_is_straightened(
    gallery: str, tab_of: Callable[..., Tab], tmp_path: Path
) -> None:
    from PIL import Image, ImageDraw

    picture = Image.new("RGB", (900, 500), "white")
    ink = ImageDraw.Draw(picture)
    ink.polygon([(100, 60), (820, 40), (860, 460), (60, 440)], outline="black", width=4)
    ink.line([(330, 150), (400, 200)], fill="black", width=5)
    file = tmp_path / "task.png"
    picture.save(file)
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    tab.page.locator("input[type=file]").set_input_files(str(file))
    tab.page.locator(".scheme-window canvas").wait_for()
    size = "(one) => [one.width, one.height]"
    assert tab.page.locator(".scheme-window canvas").evaluate(size) == [900, 500]
    tab.page.get_by_role("button", name="Straighten").click()
    box = tab.page.locator(".scheme-window canvas").bounding_box()
    share = box["width"] / 900
    for x, y in ((100, 60), (820, 40), (860, 460), (60, 440)):
        hand.click((box["x"] - hand.box["x"] + share * x, box["y"] - hand.box["y"] + share * y))
    expect(tab.page.locator(".scheme-window canvas")).to_have_count(1)
    width, height = tab.page.locator(".scheme-window canvas").evaluate(size)
    assert abs(width - 760) < 6
    assert abs(height - 400) < 6
    hand.acts = 0
    scheme_hand.shaper(hand)
    assert hand.acts <= MOST


@pytest.mark.parametrize("size", ["phone", "turned"])
def test_a_phone_draws_too(size: str, gallery: str, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of("draw", gallery=gallery, viewport=SIZES[size], has_touch=True)
    hand = SchemeHand(tab)
    hand.drag((100, 50), (60, 90))
    hand.take("support")
    hand.click((60, 90))
    hand.says("W = 1")
    hand.drag((100, 50), (260, 90))
    hand.says("W = 2")
    assert serious(tab.page) == []
    assert in_sight(tab.page) == []


def test_a_tool_waits_until_it_has_done_something(gallery: str, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    armed = tab.page.locator("[data-tool][aria-pressed=true]")
    hand.drag((250, 250), (300, 320))
    hand.take("support")
    # the pin that was just drawn does not look as if the tool were for it
    expect(tab.page.locator(".scheme-paper .pin.chosen")).to_have_count(0)
    tab.told("Click the pin that the frame holds.")
    hand.click((500, 100))
    tab.told("Click the pin that the frame holds.")
    hand.click((300, 320))
    hand.says("W = 1")
    expect(armed).to_have_count(0)
    hand.drag((250, 250), (520, 160))
    hand.says("W = 2")
    hand.click((150, 100))
    hand.take("point")
    hand.click((385, 205))
    tab.told("Click where the point of link 2 is.")
    expect(tab.page.locator(".scheme-paper .bar.chosen")).to_have_count(1)
    hand.click((385, 120))
    expect(tab.page.locator(".scheme-paper .bar[d$=Z]")).to_have_count(1)
    expect(armed).to_have_count(0)


def test_a_slider_has_its_mass_centre_at_its_pin(gallery: str, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    scheme_hand.shaper(hand)
    (x, y), (u, v) = hand.pin("B"), hand.pin("D")
    rod = ((x + u) / 2, (y + v) / 2)
    hand.click(rod)
    hand.take("centre")
    hand.click((u + 10, v + 5))  # in the box of the slider, the rod being chosen
    tab.page.locator(".scheme[aria-busy=false]").wait_for()
    hand.whole("I(1) → II(2-3) → II(4-5)")
    letters = tab.page.locator(".scheme-paper text.letter")
    expect(letters.filter(has_text="S")).to_have_count(0)
    hand.take("centre")
    hand.click(rod)
    expect(letters.filter(has_text="S")).to_have_text("S4")
    hand.whole("I(1) → II(2-3) → II(4-5)")
    tab.page.locator(".scheme[aria-busy=false]").wait_for()
    # the slider has kept its own
    text = tab.page.evaluate("sessionStorage.getItem('scheme')")
    assert json.loads(text)["text"].count("centre = ") == 2


def test_examples_of_entries_are_read_whole(scene: Path, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    SchemeHand.there(tab)
    tab.page.locator("[data-key=section]").select_option("load")
    tab.page.locator(".more summary").click()
    room = """(all) => all.filter((one) => one.offsetParent !== null && one.placeholder !== "").map((one) => {
      const pen = document.createElement('canvas').getContext('2d');
      pen.font = getComputedStyle(one).font;
      return [one.placeholder, one.clientWidth - pen.measureText(one.placeholder).width];
    })"""
    found = dict(tab.page.locator(".more input").evaluate_all(room))
    assert {"0 N", "190 N"} & {*found}, found
    assert min(found.values()) > 0, found


def test_letters_that_look_alike_are_one(gallery: str, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    letters = tab.page.locator(".scheme-paper text.letter")
    field = tab.page.locator("[data-key=letter]")
    hand.drag((250, 250), (300, 320))
    hand.click((300, 320))
    for typed, known in (
        ("\N{CYRILLIC CAPITAL LETTER ES}", "C"),
        ("\N{CYRILLIC CAPITAL LETTER A}", "A"),
    ):
        field.fill(typed)
        field.press("Enter")
        expect(field).to_have_value(known)
    expect(letters).to_have_text(["C", "A"])  # the pin that was A has the other's
    hand.drag((400, 100), (500, 100))
    expect(letters).to_have_text(["C", "A", "B", "D"])


def test_a_new_letter_looks_as_none_of_a_file(scene: Path, tab_of: Callable[..., Tab]) -> None:
    alike = {
        "A =": '"\N{CYRILLIC CAPITAL LETTER A}" =',
        "B =": '"\N{CYRILLIC CAPITAL LETTER VE}" =',
    }
    for one, other in alike.items():
        scene.write_text(scene.read_text("utf-8").replace(one, other), "utf-8")
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = SchemeHand.there(tab)
    hand.whole("I(1) → II(2-3)")
    hand.drag((40, 40), (80, 60))
    letters = tab.page.locator(".scheme-paper text.letter")
    expect(letters.filter(has_text="C")).to_have_count(1)
    expect(letters.filter(has_text="D")).to_have_count(1)
    # a pin that the file has not yet gets the letter of one that it has
    hand.click(hand.pin("D"))
    field = tab.page.locator("[data-key=letter]")
    field.fill("A")
    field.press("Enter")
    expect(field).to_have_value("\N{CYRILLIC CAPITAL LETTER A}")
    expect(letters.filter(has_text="D")).to_have_count(1)


def test_a_scene_that_is_there_is_drawn_on(scene: Path, tab_of: Callable[..., Tab]) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    assert scene.read_text("utf-8") == SMALL
    hand.length("AB", "0.32 m")
    tab.told("Drawn as the file says.")
    assert scene.read_text("utf-8") == SMALL.replace('"0.3 m"', '"0.32 m"')


def test_a_pin_dropped_on_another_is_joined_with_it(
    gallery: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    hand.drag((250, 250), (300, 320))
    hand.take("support")
    hand.click((300, 320))
    hand.drag((290, 240), (520, 160))  # begins near the crank's pin, and not on it
    hand.says("W = 4")
    hand.click((290, 240))
    tab.page.mouse.move(hand.box["x"] + 290, hand.box["y"] + 240)
    tab.page.mouse.down()
    tab.page.mouse.move(hand.box["x"] + 260, hand.box["y"] + 248)
    assert "joined with A" in tab.page.locator(".scheme-paper .says").text_content()
    tab.page.mouse.up()
    hand.says("W = 2")
    assert tab.page.locator(".scheme-paper .pin").count() == 3


def test_a_fault_of_the_scene_does_not_dress_the_labels(
    scene: Path, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of(f"s/{scene.parent.name}/#scheme")
    hand = begun(tab)
    tab.told("Drawn as the file says.")
    looks = """() => [...document.querySelectorAll(".scheme-tools span, .scheme-field span")]
      .map((one) => { const it = getComputedStyle(one); return `${it.color} ${it.fontWeight}`; })"""
    before = tab.page.evaluate(looks)
    scene.write_text(SMALL + '[hand]\nname = "nobody"\n', encoding="utf-8")
    tab.told("Faults: 1")
    assert len(before) > 10
    assert tab.page.evaluate(looks) == before
    hand.length("AB", "0.32 m")
    tab.told("Faults: 1")


def test_a_pin_dropped_on_one_of_its_own_link_is_said_why(
    gallery: str, tab_of: Callable[..., Tab]
) -> None:
    tab = tab_of("draw", gallery=gallery)
    hand = SchemeHand(tab)
    hand.drag((250, 250), (400, 250))
    hand.click((400, 250))
    hand.drag((400, 250), (250, 250))
    tab.told("One link has both B and A (1): they cannot become one pin.")
