"""Every plan of every scene of the package plays in a browser: picture by picture, to the sheet's own view."""

from __future__ import annotations

from collections import Counter

import pytest
from support import pages
from support.gallery import ALL
from support.lesson import Played, walk


@pytest.fixture(scope="module")
def walked(browser, files):
    """Play all plans of a scene once: what was met, and what the page did that it must not."""
    from support.browser import Opened

    found: dict[str, tuple[list[Played], list[str]]] = {}

    def of(name: str) -> tuple[list[Played], list[str]]:
        if name not in found:
            tab = Opened(browser, files(name))
            tab.page.get_by_role("tab").first.wait_for()
            found[name] = walk(tab.page, pages.language(name)), tab.settle()
            tab.close()
        return found[name]

    return of


@pytest.mark.parametrize("name", ALL)
def test_the_pictures_are_those_that_the_log_tells(name: str, walked) -> None:
    met, faults = walked(name)
    due = Counter((one.title, len(one.pictures)) for one in pages.views(name, pages.language(name)))
    assert Counter((one.title, one.pictures) for one in met) == due
    assert [(one.title, one.count) for one in met if one.count != str(one.pictures)] == []
    assert faults == []


@pytest.mark.parametrize("name", ALL)
def test_nothing_is_seen_that_nobody_can_read(name: str, walked) -> None:
    met, _ = walked(name)
    assert [one.faults for one in met if one.faults] == []
    assert [one.address for one in met if not all(one.lines)] == []


@pytest.mark.parametrize("name", ALL)
def test_every_view_has_an_address_of_its_own(name: str, walked) -> None:
    met, _ = walked(name)
    assert [a for a, times in Counter(one.address for one in met).items() if times > 1] == []
