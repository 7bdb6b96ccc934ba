"""A page as a person uses it: by the names that buttons, choices and drawings have, never by its program."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from graphic_tmm.language.catalogue import speaking

if TYPE_CHECKING:
    from playwright.sync_api import Page

NAMES = {
    "play": "Play",
    "plan": "Plan",
    "position": "Position",
    "first": "First picture",
    "next": "Next step",
    "previous": "Previous step",
    "last": "Last picture",
    "steps": "Steps",
    "sheets": "Sheets",
    "crank": "Crank",
    "lecture": "Lecture",
    "turning": "Motion",
    "mechanism": "Mechanism",
}
"""What a page calls what is pressed or chosen, in English."""
HELPERS = (Path(__file__).parent / "lesson.js").read_text(encoding="utf-8")
"""Functions that look at a page from within, as a person would with more patience."""


@cache
def names(language: str) -> Mapping[str, str]:
    """Return what a page in a language calls what is pressed or chosen."""
    speech = speaking(language)
    return {key: speech(name) for key, name in NAMES.items()}


class Played(NamedTuple):
    """A view as a page plays it: its title, how many pictures and stops were met, the last number told.

    ``lines``: of each stop the sentences and calculations told with it, ``readings``: all that was read off the
    drawing; ``address``: of its first stop.
    ``faults``: whatever no person should ever read.
    """

    title: str
    pictures: int
    stops: int
    count: str
    lines: list[list[str]]
    readings: list[str]
    address: str
    faults: list[str]
    tables: list[tuple[str, list[list[str]]]]


def walk(page: Page, language: str) -> list[Played]:
    """Play every plan in every position to its end, picture by picture."""
    return [Played(**one) for one in _called(page, "walk", language)]


def at_the_end(page: Page, language: str, address: str) -> dict[str, Any]:
    """Go to a view by its address and press "last"; return where its drawing stands and what it shows.

    The mechanism that is shown beside a plan is switched off: it is no part of the plan. What stands below the
    title of the plan (the page says that itself, and shows its scale higher) is not seen.
    """
    _called(page, "atTheEnd", language, address)
    beside = page.get_by_role("checkbox", name=names(language)["mechanism"], exact=True)
    if beside.count() and beside.first.is_visible():
        beside.first.set_checked(False)
    there = dict(_called(page, "atTheEnd", language, address))
    page.mouse.move(0, 0)  # what it stands on lights up
    lifted = page.locator(".stage g[transform] > .label")
    lifted.evaluate_all("(all) => all.forEach((one) => { one.style.visibility = 'hidden'; })")
    return there


def _called(page: Page, function: str, language: str, *arguments: object) -> Any:
    code = f"([names, ...rest]) => {{ {HELPERS}\nreturn {function}(names, ...rest); }}"
    return page.evaluate(code, [dict(names(language)), *arguments])
