"""A hand that draws a mechanism in the studio, and counts what it does: a click, or a drag, is an act."""

from __future__ import annotations

from typing import Any

from support.studios import Tab, expect

Spot = tuple[float, float]


class SchemeHand:
    """What a person does on the paper, at spots in dots from its upper left corner."""

    def __init__(self, tab: Tab, begins: str = "Draw a link") -> None:
        self.tab, self.page, self.acts = tab, tab.page, 0
        self.says(begins)
        self.box: Any = self.page.locator(".scheme-paper").bounding_box()

    @classmethod
    def there(cls, tab: Tab) -> SchemeHand:
        """A hand at a mechanism that is there."""
        return cls(tab, "W = 1")

    def says(self, text: str) -> None:
        """Wait until the line of the structure says something."""
        self.page.locator(".structure", has_text=text).wait_for()

    def _there(self, spot: Spot) -> Spot:
        return self.box["x"] + spot[0], self.box["y"] + spot[1]

    def drag(self, start: Spot, end: Spot) -> None:
        (x, y), (u, v) = self._there(start), self._there(end)
        self.page.mouse.move(x, y)
        self.page.mouse.down()
        self.page.mouse.move((x + u) / 2, (y + v) / 2)
        self.page.mouse.move(u, v)
        self.page.mouse.up()
        self.acts += 1

    def click(self, spot: Spot) -> None:
        self.page.mouse.click(*self._there(spot))
        self.acts += 1

    def take(self, tool: str) -> None:
        self.page.locator(f"[data-tool={tool}]").click()
        self.acts += 1

    def pin(self, letter: str) -> Spot:
        """Where a pin stands now."""
        found = self.page.evaluate(
            """(letter) => {
              const names = [...document.querySelectorAll(".scheme-paper text.letter")];
              const at = names.find((one) => one.textContent === letter)?.previousElementSibling;
              const box = at?.getBoundingClientRect();
              return box ? [box.x + box.width / 2, box.y + box.height / 2] : null;
            }""",
            letter,
        )
        return found[0] - self.box["x"], found[1] - self.box["y"]

    def whole(self, formula: str) -> None:
        """Wait until nothing is missing."""
        expect(self.page.locator(".formula")).to_have_text(formula)

    def length(self, label: str, text: str, shows: str = "") -> None:
        """Type a length; ``shows``: what stands in its field then, if not that."""
        row = self.page.locator(".scheme-field").filter(
            has=self.page.get_by_text(label, exact=True)
        )
        field = row.locator("input").first
        field.fill(text)
        field.press("Enter")
        self.page.locator(".scheme[aria-busy=false]").wait_for()
        expect(field).to_have_value(shows or text)

    def lengths(self) -> dict[str, str]:
        """The lengths as they are shown."""
        rows = self.page.locator(".lengths .scheme-field")
        found = rows.evaluate_all(
            """(rows) => rows.map((row) =>
              [row.querySelector('span').textContent, row.querySelector('input').value])"""
        )
        return dict(found)


def begun(tab: Tab) -> SchemeHand:
    """A hand over the scheme of the small scene, as soon as it is there."""
    hand = SchemeHand.there(tab)
    hand.whole("I(1) → II(2-3)")
    return hand


def shaper(hand: SchemeHand) -> None:
    """Crank, stone, rocker, rod and ram."""
    hand.drag((330, 150), (400, 200))
    hand.take("support")
    hand.click((400, 200))
    hand.drag((280, 70), (400, 330))
    hand.take("support")
    hand.click((400, 330))
    hand.take("stone")
    hand.click((330, 150))
    hand.click((370, 265))
    hand.drag(hand.pin("B"), (120, 80))
    hand.take("slider")
    hand.drag((120, 80), (60, 81))
    hand.take("drive")
    hand.click((365, 175))
    hand.whole("I(1) → II(2-3) → II(4-5)")


def crank_rocker(hand: SchemeHand) -> None:
    hand.drag((250, 250), (300, 320))
    hand.take("support")
    hand.click((300, 320))
    hand.drag((250, 250), (520, 160))
    hand.drag((520, 160), (600, 330))
    hand.take("support")
    hand.click((600, 330))
    hand.take("drive")
    hand.click((275, 285))
    hand.whole("I(1) → II(2-3)")


def swinging_cylinder(hand: SchemeHand) -> None:
    hand.drag((250, 250), (300, 320))
    hand.take("support")
    hand.click((300, 320))
    hand.take("cylinder")
    hand.drag((600, 330), (250, 250))
    hand.take("support")
    hand.click((600, 330))
    hand.take("drive")
    hand.click((275, 285))
    hand.whole("I(1) → II(2-3)")


def v_engine(hand: SchemeHand) -> None:
    hand.drag((440, 380), (420, 430))
    hand.take("support")
    hand.click((420, 430))
    hand.drag((440, 380), (300, 250))
    hand.take("slider")
    hand.drag((300, 250), (250, 200))
    hand.drag((440, 380), (560, 265))
    hand.take("slider")
    hand.drag((560, 265), (610, 215))
    hand.take("drive")
    hand.click((430, 405))
    hand.whole("I(1) → II(2-3) → II(4-5)")


def excavator(hand: SchemeHand) -> None:
    """A boom and a stick, each with a cylinder that drives it."""
    hand.drag((200, 380), (420, 180))
    hand.take("support")
    hand.click((200, 380))
    hand.take("cylinder")
    hand.drag((330, 400), (310, 280))
    hand.take("support")
    hand.click((330, 400))
    hand.drag((420, 180), (560, 330))
    hand.take("point")
    hand.click((490, 255))
    hand.click((385, 110))
    hand.take("cylinder")
    hand.drag((360, 235), hand.pin("E"))
    for spot in ((324, 360), (372, 172)):
        hand.take("drive")
        hand.click(spot)
    hand.whole("I(1-2), I(5-6) → II(2-3) → II(4-5)")


def parallel_cranks(hand: SchemeHand) -> None:
    """Three wheels and their rod; the third crank repeats what two hold."""
    hand.drag((200, 380), (260, 300))
    hand.take("support")
    hand.click((200, 380))
    hand.drag((260, 300), (660, 302))
    hand.drag((600, 380), (660, 302))
    hand.take("support")
    hand.click((600, 380))
    hand.drag((403, 380), (461, 301))
    hand.take("support")
    hand.click((403, 380))
    hand.take("drive")
    hand.click((230, 340))
    hand.says("links 1, 3, 4 go parallel: the tool makes link 4 passive")
    hand.take("passive")
    hand.click((432, 341))
    hand.whole("I(1) → II(2-3)")


def bell_crank(hand: SchemeHand) -> None:
    """A crank, a rod, and a lever of two arms that are welded at their pivot; the second moves a slider."""
    hand.drag((250, 250), (300, 320))
    hand.take("support")
    hand.click((300, 320))
    hand.drag((250, 250), (520, 200))
    hand.drag((520, 200), (600, 330))
    hand.take("support")
    hand.click((600, 330))
    hand.drag((600, 330), (700, 260))
    hand.drag((700, 260), (820, 400))
    hand.take("slider")
    hand.drag((820, 400), (820, 460))
    hand.take("drive")
    hand.click((275, 285))
    hand.says("or another link is driven, too")
    hand.take("weld")
    hand.click((600, 330))
    hand.whole("I(1) → II(2-3) → II(5-6)")
