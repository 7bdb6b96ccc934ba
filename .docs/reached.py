"""Whether every link, picture and anchor of a built site leads somewhere in it."""

from __future__ import annotations

from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit


class _Seen(HTMLParser):
    """What a page refers to, and the places in it that others may refer to."""

    def __init__(self) -> None:
        super().__init__()
        self.targets: list[str] = []
        self.places: set[str] = set()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Take what a tag refers to, and its name."""
        for name, value in attrs:
            if name in ("href", "src") and value and tag != "base":
                self.targets.append(value)
            elif name in ("id", "name") and value:
                self.places.add(value)


@cache
def _seen(page: Path) -> _Seen:
    found = _Seen()
    found.feed(page.read_text(encoding="utf-8"))
    return found


def lost(site: Path) -> list[str]:
    """Return a line for each reference of a site's pages that leads nowhere; others' sites are not asked."""
    _seen.cache_clear()
    faults = []
    for page in sorted(site.rglob("*.html")):
        if page.name == "404.html":  # it is served from anywhere
            continue
        for target in _seen(page).targets:
            parts = urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            there = (page.parent / unquote(parts.path)).resolve() if parts.path else page
            place = unquote(parts.fragment)
            known = there.exists() and there.is_relative_to(site)
            if not known or (
                place and there.suffix == ".html" and place not in _seen(there).places
            ):
                faults.append(f"{page.relative_to(site)}: {target} leads nowhere")
    return faults
